// SPDX-License-Identifier: MIT
#include "render/cpu/cpu_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/colouring.h"
#include "render/outline.h"
#include "scene/numbers.h"

namespace versorium {
namespace {

// Small scenes of every kind of colouring and of every algebra.
std::vector<Scene> smallScenes() {
    std::vector<Scene> scenes;
    for (const char* map : {"quadratic", "mandelbulb", "newton", "shape-modulus", "logistic"})
        scenes.push_back(sceneOf(*findMap(map)));
    Scene gradient = scenes[0];
    gradient.colour.rule = ColourRule::gradient;
    gradient.colour.attracted.finish = {0.4, 0.5, 0.6, 0.5};
    scenes.push_back(gradient);
    Scene versor = scenes[3];
    versor.colour.rule = ColourRule::versor;
    versor.colour.outline = SetName::solid;
    scenes.push_back(versor);
    Scene phase = scenes[2];
    phase.colour.rule = ColourRule::phase;
    scenes.push_back(phase);
    phase.colour.rule = ColourRule::domain;
    scenes.push_back(phase);
    Scene drawn = sceneOf(*findMap("shape-modulus-complex-rational"));
    drawn.shape.source = "polygon(-0.8, -0.7, 0.9, -0.6, 0.2, 0.8)";
    drawn.alphaOverSpace.discs = {{0.2, 0.3, 0, 0.5, 2}, {-0.3, 0, 0, 0.2, 50}};
    scenes.push_back(drawn);
    Scene mandelbrot = scenes[0];
    mandelbrot.slice.axes = {{{{"c.re", 1.0}}}, {{{"c.im", 1.0}}}};
    mandelbrot.criticalStart = 0;
    mandelbrot.colour.outline = SetName::membership;
    scenes.push_back(mandelbrot);
    for (Scene& scene : scenes) scene.iterations = std::min(scene.iterations, 60);
    return scenes;
}

Frame rendered(const Scene& scene, Size size, int threads = 1) {
    CpuRenderer renderer;
    Job job(threads);
    Frame frame;
    const Status status = renderer.render(scene, size, {}, job, frame);
    EXPECT_TRUE(status.ok()) << status.message();
    return frame;
}
bool sameBits(const Raster<float>& a, const Raster<float>& b) {
    return a.size() == b.size() &&
           std::memcmp(a.values().data(), b.values().data(), 4 * a.values().size()) == 0;
}

TEST(Renderer, DoesNotDependOnThreads) {
    for (const Scene& scene : smallScenes()) {
        const Frame one = rendered(scene, {75, 41});
        for (int threads : {2, 3, 7})
            EXPECT_TRUE(sameBits(rendered(scene, {75, 41}, threads).colour, one.colour))
                << scene.map << ", " << threads;
    }
}

// Tiles, sampling and slices add nothing: a pixel is the colour of the fields at its centre.
TEST(Renderer, APictureIsItsFieldsPixelByPixel) {
    for (Scene scene : smallScenes()) {
        scene.samples = 1;
        scene.colour.outline = SetName::none;
        const Size size{37, 33};
        const Frame frame = rendered(scene, size);
        CpuRenderer renderer;
        Job job(1);
        const Expected<OrbitProgram> program = renderer.binder().bind(scene, job);
        ASSERT_TRUE(program.ok());
        const Expected<ColourPass> pass = ColourPass::make(scene, *program);
        ASSERT_TRUE(pass.ok());
        const double pixel = scene.slice.height / size.height;
        for (int y = 0; y < size.height; y += 4)
            for (int x = 0; x < size.width; x += 3) {
                const double u = scene.slice.centre[0] + (x + 0.5 - 0.5 * size.width) * pixel;
                const double v = scene.slice.centre[1] + (0.5 * size.height - (y + 0.5)) * pixel;
                const double w = 0;
                const double* coordinates[3] = {&u, &v, &w};
                const auto values = evaluateFields(*program, 1, coordinates, pass->fields());
                const Colour colour = pass->colour(values, 1, 0);
                const float* found = &frame.colour.at(x, y);
                const double parts[4] = {colour.r, colour.g, colour.b, colour.a};
                for (int k = 0; k < 4; ++k)  // a float of a double, weighted with alpha and back
                    EXPECT_NEAR(found[k], colour.a > 0 || k == 3 ? parts[k] : 0, 1e-6)
                        << scene.map << " at " << x << ", " << y;
            }
    }
}

TEST(Renderer, MeasuresAtPixelCentres) {
    Scene scene = sceneOf(*findMap("quadratic"));
    scene.slice.centre = {0.25, -0.5};
    CpuRenderer renderer;
    Job job(2);
    std::vector<Raster<double>> rasters;
    const std::vector<FieldName> fields{FieldName::versor, FieldName::smoothEscape};
    ASSERT_TRUE(renderer.measure(scene, {35, 34}, fields, {}, job, rasters).ok());
    EXPECT_EQ(rasters[0].channels(), 2);
    // The plain affine map of z -> z² + c: the versor's angle is that of (u + iv)² + c.
    const auto& c = scene.parameters.at("c");
    std::vector<std::vector<double>> points;
    for (int y = 0; y < 34; ++y)
        for (int x = 0; x < 35; ++x) {
            const double pixel = scene.slice.height / 34;
            const double u = 0.25 + (x + 0.5 - 17.5) * pixel, v = -0.5 + (17 - y - 0.5) * pixel;
            const double re = u * u - v * v + c[0], im = 2 * u * v + c[1];
            EXPECT_NEAR(rasters[0].at(x, y, 0), re / std::hypot(re, im), 1e-12);
            EXPECT_NEAR(rasters[0].at(x, y, 1), im / std::hypot(re, im), 1e-12);
            points.push_back({u, v});
        }
    std::vector<std::vector<double>> rows;
    ASSERT_TRUE(renderer.measureAt(scene, points, fields, {}, job, rows).ok());
    ASSERT_EQ(rows.size(), points.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ASSERT_EQ(rows[i].size(), 3u);
        // The coordinates differ in their last bits, which 200 steps may amplify at the boundary.
        EXPECT_NEAR(rows[i][0], rasters[0].values()[2 * i], 1e-12);
    }
}

// Points are starting points, whatever the picture's plane: the parameters keep the scene's values.
TEST(Renderer, MeasuresAtPointsWithTheScenesParameters) {
    Scene julia = sceneOf(*findMap("quadratic"));
    julia.parameters["c"] = {-0.4, 0.3};
    Scene mandelbrot = julia;
    mandelbrot.slice.axes = {{{{"c.re", 1.0}}}, {{{"c.im", 1.0}}}};
    mandelbrot.slice.origin = {{"z.re", 0.125}};
    mandelbrot.criticalStart = 0;
    const std::vector<std::vector<double>> points{{0.1, 0.2}, {1.3, -0.4}, {0.5}};
    std::vector<std::vector<double>> one, two;
    CpuRenderer renderer;
    Job job(1);
    const std::vector<FieldName> fields{FieldName::squaredNorm, FieldName::imageModulus};
    ASSERT_TRUE(renderer.measureAt(julia, points, fields, {}, job, one).ok());
    ASSERT_TRUE(renderer.measureAt(mandelbrot, points, fields, {}, job, two).ok());
    EXPECT_EQ(one, two);
    EXPECT_NEAR(one[0][1], std::hypot(0.01 - 0.04 - 0.4, 0.04 + 0.3), 1e-14);
    // A fourth component, and components that are left out.
    Scene quaternion = sceneOf(*findMap("quaternion-quadratic"));
    quaternion.parameters["c"] = {0, 0, 0, 0};
    quaternion.start = {9, 9, 0.25, 0.5};
    ASSERT_TRUE(renderer
                    .measureAt(quaternion, {{0.1, 0.2, 0.3, 0.4}, {0.1, 0.2, 0.3}, {0.1, 0.2}},
                               {FieldName::imageModulus}, {}, job, one)
                    .ok());
    EXPECT_NEAR(one[0][0], 0.01 + 0.04 + 0.09 + 0.16, 1e-14);
    EXPECT_NEAR(one[1][0], 0.01 + 0.04 + 0.09 + 0.25, 1e-14);
    EXPECT_NEAR(one[2][0], 0.01 + 0.04 + 0.0625 + 0.25, 1e-14);
}

// Samples are averaged in linear light, colours weighted by alpha.
TEST(Renderer, AveragesInLinearLight) {
    for (Scene scene : smallScenes()) {
        scene.colour.outline = SetName::none;
        scene.samples = 3;
        const Frame coarse = rendered(scene, {14, 11});
        scene.samples = 1;
        const Frame fine = rendered(scene, {42, 33});
        for (int y = 0; y < 11; ++y)
            for (int x = 0; x < 14; ++x) {
                double sum[4] = {};
                for (int k = 0; k < 9; ++k) {
                    const float* p = &fine.colour.at(3 * x + k % 3, 3 * y + k / 3);
                    for (int c = 0; c < 3; ++c) sum[c] += p[c] * p[3];
                    sum[3] += p[3];
                }
                for (int c = 0; c < 4; ++c)
                    EXPECT_NEAR(coarse.colour.at(x, y, c),
                                c == 3       ? sum[3] / 9
                                : sum[3] > 0 ? sum[c] / sum[3]
                                             : 0,
                                1e-6);  // floats
            }
    }
}

// A straight border is crossed by as much white as the line is wide, however it is sampled.
TEST(Outline, IsAsWideAsItSays) {
    for (int perSide : {1, 2, 3, 4})
        for (double width : {1.0, 2.0, 2.5, 5.0})
            for (const bool upright : {true, false}) {
                const int pixels = 24;
                Raster<unsigned char> sides({pixels * perSide, pixels * perSide}, 1);
                for (int y = 0; y < sides.height(); ++y)
                    for (int x = 0; x < sides.width(); ++x)
                        sides.at(x, y) = (upright ? x : y) < pixels * perSide / 2;
                Raster<float> picture({pixels, pixels}, 4);
                for (int i = 0; i < pixels * pixels; ++i) picture.values()[4 * i + 3] = 1;
                drawOutline(sides, perSide, width, {1, 1, 1, 1}, picture);
                double across = 0;
                for (int i = 0; i < pixels; ++i)
                    across += upright ? picture.at(i, 12) : picture.at(12, i);
                // A sample's share is kept in 255ths.
                EXPECT_NEAR(across, width, 0.01) << width << " with " << perSide;
            }
}

// Around one lone sample: every pixel's share by its distance from the four sides' midpoints.
TEST(Outline, IsRoundAroundAPoint) {
    for (double width : {1.0, 3.0, 8.0, 13.5}) {
        Raster<unsigned char> sides({31, 31}, 1);
        sides.at(15, 15) = 1;
        Raster<float> picture({31, 31}, 4);
        drawOutline(sides, 1, width, {1, 1, 1, 1}, picture);
        for (int y = 0; y < 31; ++y)
            for (int x = 0; x < 31; ++x) {
                double nearest = HUGE_VAL;
                for (const auto& [mx, my] :
                     {std::pair{0.5, 0.0}, {-0.5, 0.0}, {0.0, 0.5}, {0.0, -0.5}})
                    nearest = std::min(nearest, std::hypot(x - 15 - mx, y - 15 - my));
                EXPECT_NEAR(picture.at(x, y, 3), std::clamp(0.5 * width + 0.5 - nearest, 0.0, 1.0),
                            0.0021)  // kept in 255ths
                    << x << ", " << y << ", width " << width;
            }
    }
}

TEST(Outline, LeavesATransparentPictureTransparent) {
    Raster<unsigned char> sides({8, 8}, 1);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 4; ++x) sides.at(x, y) = 1;
    Raster<float> picture({8, 8}, 4);
    drawOutline(sides, 1, 1, {1, 0.5, 0, 1}, picture);
    EXPECT_EQ(picture.at(0, 0, 3), 0);
    EXPECT_NEAR(picture.at(3, 4, 3), 0.5, 0.01);
    // Straight alpha: the line's colour is its own, not darkened by what is not there.
    EXPECT_EQ(picture.at(3, 4, 0), 1);
    EXPECT_EQ(picture.at(3, 4, 1), 0.5f);
}

TEST(Renderer, CancelStops) {
    const Scene scene = sceneOf(*findMap("quadratic"));
    CpuRenderer renderer;
    Frame frame;
    Job before(1);
    before.cancel();
    EXPECT_EQ(renderer.render(scene, {64, 64}, {}, before, frame).kind(), ErrorKind::cancelled);
    std::vector<Raster<double>> rasters;
    EXPECT_EQ(renderer.measure(scene, {64, 64}, {FieldName::period}, {}, before, rasters).kind(),
              ErrorKind::cancelled);
    std::vector<std::vector<double>> rows;
    EXPECT_EQ(renderer.measureAt(scene, {{0, 0}}, {FieldName::period}, {}, before, rows).kind(),
              ErrorKind::cancelled);
    // In the middle: no more tiles than threads are still finished.
    Job middle(1);
    int parts = 0;
    middle.onProgress = [&](double) {
        ++parts;
        middle.cancel();
    };
    EXPECT_EQ(renderer.render(scene, {512, 512}, {}, middle, frame).kind(), ErrorKind::cancelled);
    EXPECT_LE(parts, 2);
}

TEST(Renderer, RefusesSizes) {
    Scene scene = sceneOf(*findMap("quadratic"));
    CpuRenderer renderer;
    Frame frame;
    std::vector<Raster<double>> rasters;
    Job job(1);
    for (const Size size : {Size{0, 10}, Size{10, 0}, Size{-1, 10}, Size{32769, 1},
                            Size{1000000000, 1000000000}, Size{2147483647, 2147483647}}) {
        const Status status = renderer.render(scene, size, {}, job, frame);
        EXPECT_EQ(status.kind(), ErrorKind::usage);
        EXPECT_NE(status.message().find(std::to_string(size.width)), std::string::npos);
        EXPECT_EQ(renderer.measure(scene, size, {FieldName::period}, {}, job, rasters).kind(),
                  ErrorKind::usage);
    }
    scene.samples = 8;
    EXPECT_EQ(renderer.render(scene, {32768, 32768}, {}, job, frame).kind(), ErrorKind::usage);
}

TEST(Binder, FindsTheRadiusThatBoundsAJuliaSet) {
    Scene scene = sceneOf(*findMap("quadratic"));
    EXPECT_EQ(automaticRadius(scene), 2);
    scene.parameters["c"] = {-12, 0};
    EXPECT_DOUBLE_EQ(automaticRadius(scene), 4);  // the fixed point (1 + sqrt(49)) / 2
    scene.slice.axes = {{{{"c.re", 1.0}}}, {{{"c.im", 1.0}}}};
    EXPECT_EQ(automaticRadius(scene), 2);
}

TEST(Binder, SaysWhatIsWrongWithAShape) {
    Scene scene = sceneOf(*findMap("shape-modulus"));
    CpuRenderer renderer;
    Job job(1);
    for (const char* source : {"", "sphere(", "sphere(-1)", "cube(1)", "asset:00", "bunny2",
                               "star(1000000000, 1, 0.5)", "sphere(nan)", "sphere(1e308)"}) {
        scene.shape.source = source;
        const Expected<OrbitProgram> program = renderer.binder().bind(scene, job);
        ASSERT_FALSE(program.ok()) << source;
        EXPECT_EQ(program.status().message().substr(0, 5), "shape") << program.status().message();
    }
    const std::vector<unsigned char> junk(100, 'x');
    for (const char* name : {"a.f3d", "a.obj", "a.ply", "a.stl", "a.png", "a.txt", "a"}) {
        scene.assets.clear();
        scene.shape.source = addAsset(scene, {name, junk});
        EXPECT_FALSE(renderer.binder().bind(scene, job).ok()) << name;
    }
}

}  // namespace
}  // namespace versorium
