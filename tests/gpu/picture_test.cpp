// SPDX-License-Identifier: MIT
// How a picture is made on the GPU, whatever it shows.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "gpu/gpu_picture.h"
#include "headless_context.h"
#include "render/bind.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {
namespace {

constexpr Size kSize{64, 48};
const std::vector<FieldName> kFields = {FieldName::escapeStep, FieldName::smoothEscape,
                                        FieldName::squaredNorm, FieldName::argument};

Scene mandelbrot() { return *presetNamed("mandelbrot"); }

void finish(GpuPicture& picture, double budget = 0.05) {
    for (int i = 0; i < 100000 && !picture.advance(budget); ++i) {
    }
    ASSERT_EQ(picture.state(), GpuPicture::State::finished) << picture.status().message();
}

std::vector<Raster<float>> fieldsOf(GpuPicture& picture) {
    std::vector<Raster<float>> rasters;
    const Status status = picture.readFields(kFields, rasters);
    EXPECT_TRUE(status.ok()) << status.message();
    return rasters;
}

Raster<unsigned char> pixelsOf(GpuPicture& picture) {
    Raster<unsigned char> pixels;
    const Status status = picture.readPicture(pixels);
    EXPECT_TRUE(status.ok()) << status.message();
    return pixels;
}

void expectSameBits(const std::vector<Raster<float>>& one,
                    const std::vector<Raster<float>>& other) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t f = 0; f < one.size(); ++f) {
        ASSERT_EQ(one[f].values().size(), other[f].values().size());
        EXPECT_EQ(0, std::memcmp(one[f].values().data(), other[f].values().data(),
                                 one[f].values().size() * sizeof(float)))
            << infoOf(kFields[f]).name;
    }
}

// Where the two differ by more than 2 of 255 somewhere in a pixel, in percent. Escape steps at the
// edge of the set differ by the 24 bits, and each shows.
double differing(const Raster<unsigned char>& one, const Raster<unsigned char>& other) {
    const std::size_t pixels = one.values().size() / 4;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        bool differs = false;
        for (std::size_t c = 0; c < 4; ++c)
            differs = differs || std::abs(one.values()[4 * i + c] - other.values()[4 * i + c]) > 2;
        count += differs;
    }
    return 100.0 * static_cast<double>(count) / static_cast<double>(pixels);
}

TEST(GpuPicture, ColoursAreThoseOfTheProcessor) {
    for (const ColourRule rule : {ColourRule::palette, ColourRule::gradient, ColourRule::versor,
                                  ColourRule::phase, ColourRule::domain})
        for (int samples : {1, 2}) {
            Scene scene = mandelbrot();
            scene.slice.centreLow[0] += 1e-3;
            scene.iterations = 60;
            scene.samples = samples;
            scene.colour = {};
            scene.colour.rule = rule;
            GpuDevice gpu;
            GpuPicture picture(gpu);
            const Status status = picture.start(scene, kSize, {.samples = samples});
            ASSERT_TRUE(status.ok()) << status.message();
            finish(picture);
            CpuRenderer cpu;
            Job job(1);
            Frame frame;
            ASSERT_TRUE(cpu.render(scene, kSize, {}, job, frame).ok());
            EXPECT_LE(differing(pixelsOf(picture), encodeSrgb(frame.colour)), 2.0)
                << wordOf(rule) << " with " << samples;
        }
}

TEST(GpuPicture, InFewPixelsIsThePictureThere) {
    Scene scene = mandelbrot();
    GpuDevice gpu;
    GpuPicture picture(gpu);
    Raster<unsigned char> small;
    EXPECT_FALSE(picture.readSmall({4, 3}, small).ok());
    ASSERT_TRUE(picture.start(scene, {60, 45}).ok());
    finish(picture);
    ASSERT_TRUE(picture.readSmall({4, 3}, small).ok());
    const Raster<unsigned char> whole = pixelsOf(picture);
    // The pixel in the middle of each, 15 to a side.
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x)
            for (int c = 0; c < 4; ++c)
                EXPECT_EQ(small.at(x, y, c), whole.at(15 * x + 7, 15 * y + 7, c)) << x << " " << y;
}

TEST(GpuPicture, RecolouringDoesNotIterate) {
    GpuDevice gpu;
    GpuPicture picture(gpu);
    Scene scene = mandelbrot();
    ASSERT_TRUE(picture.start(scene, kSize).ok());
    finish(picture);
    const auto before = pixelsOf(picture);
    const long long draws = gpu.iterationDraws;
    scene.colour = {};
    scene.colour.rule = ColourRule::gradient;
    ASSERT_TRUE(picture.recolour(scene).ok());
    EXPECT_TRUE(picture.advance(0.01));
    EXPECT_NE(before.values(), pixelsOf(picture).values());
    EXPECT_EQ(draws, gpu.iterationDraws);
}

TEST(GpuPicture, SplittingChangesNothing) {
    GpuDevice gpu;
    GpuPicture once(gpu), often(gpu);
    const Scene scene = mandelbrot();
    ASSERT_TRUE(once.start(scene, kSize).ok());
    finish(once, 5);
    ASSERT_TRUE(often.start(scene, kSize).ok());
    for (int i = 0; i < 3; ++i) often.advance(0);
    EXPECT_LT(often.progress(), 1);
    finish(often, 0);
    expectSameBits(fieldsOf(once), fieldsOf(often));
}

TEST(GpuPicture, StartsAnewInTheMiddle) {
    GpuDevice gpu;
    GpuPicture picture(gpu), fresh(gpu);
    Scene slow = mandelbrot();
    slow.iterations = 100000;
    ASSERT_TRUE(picture.start(slow, kSize).ok());
    picture.advance(0.01);
    EXPECT_EQ(picture.state(), GpuPicture::State::iterating);
    ASSERT_TRUE(picture.start(mandelbrot(), kSize).ok());
    EXPECT_EQ(picture.progress(), 0);
    finish(picture);
    ASSERT_TRUE(fresh.start(mandelbrot(), kSize).ok());
    finish(fresh);
    expectSameBits(fieldsOf(picture), fieldsOf(fresh));
}

TEST(GpuPicture, ComesBackAfterALostContext) {
    GpuDevice gpu;
    GpuPicture picture(gpu);
    ASSERT_TRUE(picture.start(mandelbrot(), kSize).ok());
    finish(picture);
    const auto before = pixelsOf(picture);
    for (int i = 0; i < 5; ++i) {
        loseHeadlessContext();
        gpu.forget();
        EXPECT_EQ(picture.texture(), 0U);
        ASSERT_EQ(makeHeadlessContext(), "");
        finish(picture);
        EXPECT_EQ(before.values(), pixelsOf(picture).values());
    }
}

TEST(GpuPicture, SaysWhatTheProcessorHasToDraw) {
    GpuDevice gpu;
    GpuPicture picture(gpu);
    const auto refused = [&](const Scene& scene, const char* word) {
        const Status status = picture.start(scene, kSize);
        EXPECT_FALSE(status.ok()) << word;
        EXPECT_NE(status.message().find(word), std::string::npos) << status.message();
        EXPECT_TRUE(picture.advance(0.01));
    };
    Scene deep = mandelbrot();
    deep.slice.height = 1e-6;
    refused(deep, "32 bits are not enough here");
    Scene distance = mandelbrot();
    distance.colour.field = FieldName::distance;
    refused(distance, "distance");
    Scene outlined = mandelbrot();
    outlined.colour.outline = SetName::membership;
    refused(outlined, "outline");
    Scene mesh = sceneOf(*findMap("shape-modulus"));
    mesh.shape.source = "bunny";
    refused(mesh, "grid");
    // Bound already, it is drawn.
    mesh.shape.resolution = 16;
    Binder binder;
    Job job(1);
    const Expected<OrbitProgram> program = binder.bind(mesh, job);
    ASSERT_TRUE(program.ok());
    const Status status = picture.start(mesh, *program, kSize);
    ASSERT_TRUE(status.ok()) << status.message();
    finish(picture);
    std::vector<Raster<float>> ours;
    std::vector<Raster<double>> theirs;
    CpuRenderer cpu;
    ASSERT_TRUE(picture.readFields({FieldName::imageModulus}, ours).ok());
    ASSERT_TRUE(cpu.measure(mesh, kSize, {FieldName::imageModulus}, {}, job, theirs).ok());
    int differ = 0;
    for (std::size_t i = 0; i < ours[0].values().size(); ++i)
        differ += !(std::abs(theirs[0].values()[i] - static_cast<double>(ours[0].values()[i])) <=
                    1e-3 * std::max(1.0, theirs[0].values()[i]));
    EXPECT_LE(differ, kSize.width * kSize.height / 100);
}

}  // namespace
}  // namespace versorium
