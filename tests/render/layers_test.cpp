// SPDX-License-Identifier: MIT
// Images behind and in front of a picture, and pictures of motions.
#include <gtest/gtest.h>

#include <cmath>

#include "colour/srgb.h"
#include "image/leaf.h"
#include "io/png.h"
#include "render/movie.h"

namespace versorium {
namespace {

// A picture of which nothing is inside, in one colour with this alpha.
Scene plain(double alpha) {
    Scene scene = sceneOf(*findMap("quadratic"));
    scene.slice.centre = {100, 0};
    scene.colour.rule = ColourRule::gradient;
    scene.colour.escaped.start = scene.colour.escaped.finish = {1, 0, 0, alpha};
    scene.samples = 1;
    return scene;
}
Raster<float> drawn(const Scene& scene, Size size) {
    CpuRenderer renderer;
    Job job(1);
    Frame frame;
    const Status status = renderer.render(scene, size, {}, job, frame);
    EXPECT_TRUE(status.ok()) << status.message();
    return frame.colour;
}
void expectColour(const Raster<float>& picture, int x, int y, std::array<double, 4> wanted) {
    for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(picture.at(x, y, c), wanted[static_cast<std::size_t>(c)], 2e-3)
            << x << " " << y << " " << c;
}

// Four squares of 2 x 2 pixels: red and green above, blue and half transparent white below.
Asset fourSquares() {
    constexpr unsigned char values[4][4] = {
        {255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 255, 128}};
    Raster<unsigned char> image({4, 4}, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            for (int c = 0; c < 4; ++c) image.at(x, y, c) = values[y / 2 * 2 + x / 2][c];
    return {"four.png", *encodePng(image)};
}

TEST(LayersTest, SheetsAreMixedInLinearLight) {
    Scene scene = plain(0.25);
    scene.layers = {{.sources = {"#0000ff"}}};
    expectColour(drawn(scene, {3, 2}), 1, 1, {0.25, 0, 0.75, 1});
    scene.layers.push_back({.sources = {"#00ff00"}, .front = true, .opacity = 0.5});
    expectColour(drawn(scene, {3, 2}), 2, 0, {0.125, 0.5, 0.375, 1});
    // Nothing behind: alpha stays.
    scene.layers = {{.sources = {"#00ff00"}, .front = true, .opacity = 0.5}};
    expectColour(drawn(scene, {3, 2}), 0, 0, {0.2, 0.8, 0, 0.625});
}

TEST(LayersTest, AnImageLiesWhereItIsPut) {
    Scene scene = plain(0);
    Layer layer;
    layer.sources = {addAsset(scene, fourSquares())};
    layer.scale = 0.5;
    layer.x = 0.25;
    layer.y = -0.25;
    scene.layers = {layer};
    // In a picture of 40 x 40 it is 20 pixels high, with its middle at (30, 30).
    const Raster<float> picture = drawn(scene, {40, 40});
    expectColour(picture, 24, 24, {1, 0, 0, 1});
    expectColour(picture, 36, 24, {0, 1, 0, 1});
    expectColour(picture, 24, 36, {0, 0, 1, 1});
    expectColour(picture, 36, 36, {1, 1, 1, 128 / 255.0});
    EXPECT_EQ(picture.at(10, 10, 3), 0);
    // As small as a pixel it is the mean of its own: of each colour's light, and of alpha.
    scene.layers[0] = {.sources = layer.sources, .scale = 1.0 / 3};
    const Raster<float> small = drawn(scene, {3, 3});
    const double alpha = (3 + 128 / 255.0) / 4, mean = (1 + 128 / 255.0) / 4 / alpha;
    expectColour(small, 1, 1, {mean, mean, mean, alpha});
}

TEST(LayersTest, FramesFollowOneAnother) {
    Scene scene = plain(0);
    scene.layers = {{.sources = {"#ff0000", "#00ff00", "#0000ff"}}};
    const auto channel = [&](double frame) {
        scene.layers[0].frame = frame;
        const Raster<float> picture = drawn(scene, {1, 1});
        for (int c = 0; c < 3; ++c)
            if (picture.at(0, 0, c) > 0.9f) return c;
        return -1;
    };
    EXPECT_EQ(channel(0), 0);
    EXPECT_EQ(channel(1.9), 1);
    EXPECT_EQ(channel(5), 2);
    EXPECT_EQ(channel(-1), 2);
}

TEST(LayersTest, TheLeafIsALeaf) {
    const Raster<float> leaf = leafImage(64);
    EXPECT_EQ(leaf.at(0, 0, 3), 0);
    EXPECT_EQ(leaf.at(32, 30, 3), 1);
    double green = 0, red = 0, covered = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            covered += leaf.at(x, y, 3);
            red += leaf.at(x, y, 0);
            green += leaf.at(x, y, 1);
        }
    EXPECT_GT(green, 1.5 * red);
    EXPECT_NEAR(covered / (64 * 64), 0.4, 0.1);
}

TEST(LayersTest, RefusalsSayWhat) {
    Scene scene = plain(1);
    scene.layers = {{.sources = {"asset:00"}}};
    CpuRenderer renderer;
    Job job(1);
    Frame frame;
    EXPECT_NE(renderer.render(scene, {2, 2}, {}, job, frame).message().find("asset:00"),
              std::string::npos);
    scene.layers = {{.sources = {addAsset(scene, {"no.png", {1, 2, 3}})}}};
    EXPECT_NE(renderer.render(scene, {2, 2}, {}, job, frame).message().find("no.png"),
              std::string::npos);
    Json json = sceneToJson(plain(1));
    json["layers"] = Json::array({Json{{"source", "zebra"}}});
    EXPECT_NE(sceneFromJson(json).status().message().find("layers[0].source"), std::string::npos);
    json["layers"] = Json::array({Json{{"opacity", 2}}});
    EXPECT_NE(sceneFromJson(json).status().message().find("layers[0].opacity"), std::string::npos);
}

TEST(MovieTest, TheProgramsOwnAreRight) {
    ASSERT_GE(animationNames().size(), 2u);
    for (const std::string& name : animationNames()) {
        const auto movie = animationNamed(name);
        ASSERT_TRUE(movie) << movie.status().message();
        EXPECT_GT(movie->animation.motion.frames(), 100) << name;
    }
    EXPECT_NE(animationNamed("zebra").status().message().find("leaf"), std::string::npos);
}

// Every frame is the picture of its scene, carries it, and stands whole in the archive.
TEST(MovieTest, FramesAndTheirArchive) {
    Movie movie;
    movie.animation.scene = plain(0.5);
    movie.animation.scene.layers = {{.sources = {addAsset(movie.animation.scene, fourSquares())}}};
    movie.animation.motion.framesPerSecond = 2;
    movie.animation.motion.keys = {{0, Easing::linear, {{"layers[0].x", 0}}},
                                   {1, Easing::linear, {{"layers[0].x", 1}}}};
    movie.options.size = {16, 12};
    ASSERT_EQ(movie.animation.motion.frames(), 3);
    CpuRenderer renderer;
    Job job(1);
    const auto archive = renderArchive(renderer, movie, job);
    ASSERT_TRUE(archive) << archive.status().message();
    EXPECT_EQ(job.progress(), 1);
    for (int frame = 0; frame < 3; ++frame) {
        const auto png = renderFrame(renderer, movie, frame, job);
        ASSERT_TRUE(png);
        EXPECT_NE(std::search(archive->begin(), archive->end(), png->begin(), png->end()),
                  archive->end());
        const auto document = documentFromBytes(*png);
        ASSERT_TRUE(document);
        EXPECT_EQ(documentToJson(*document), documentToJson(frameDocument(movie, frame)));
        const auto scene = sceneWithAssets(document->body, document->assets);
        ASSERT_TRUE(scene);
        EXPECT_EQ(scene->layers[0].x, 0.5 * frame);
        EXPECT_TRUE(scene->assets.contains(scene->layers[0].sources[0].substr(6)));
    }
    const Document document = documentOfMovie(movie);
    const auto again = movieFromDocument(document);
    ASSERT_TRUE(again) << again.status().message();
    EXPECT_EQ(documentToJson(documentOfMovie(*again)), documentToJson(document));
}

}  // namespace
}  // namespace versorium
