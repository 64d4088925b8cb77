// SPDX-License-Identifier: MIT
// Averaged maps on the GPU: members are counted there as the CPU counts them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "../render/averaged_star.h"
#include "colour/srgb.h"
#include "gpu/gpu_picture.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {
namespace {

constexpr Size kSize{64, 48};
const std::vector<FieldName> kFields = {FieldName::meanMembership, FieldName::standardError};

Scene star(int count) {
    Scene scene = averagedStar(count);
    scene.colour.range = {0, 1};
    scene.colour.palette = "viridis";
    return scene;
}
Scene discs(int count) {
    Scene scene = sceneOf(*findMap("quadratic"));
    scene.samples = 1;
    scene.iterations = 40;
    scene.ensemble.count = count;
    scene.ensemble.discs.push_back({"c", -0.1, 0.6, 0.3});
    scene.colour.field = FieldName::meanMembership;
    scene.colour.interior = SetName::none;
    return scene;
}

std::vector<Raster<float>> onGraphics(const Scene& scene) {
    GpuDevice gpu;
    GpuPicture picture(gpu);
    std::vector<Raster<float>> rasters;
    Status status = picture.start(scene, kSize);
    EXPECT_TRUE(status.ok()) << status.message();
    status = picture.finish();
    EXPECT_TRUE(status.ok()) << status.message();
    status = picture.readFields(kFields, rasters);
    EXPECT_TRUE(status.ok()) << status.message();
    EXPECT_EQ(picture.members(), scene.ensemble.count);
    return rasters;
}

std::vector<Raster<double>> onProcessor(const Scene& scene) {
    CpuRenderer cpu;
    Job job(1);
    std::vector<Raster<double>> rasters;
    const Status status = cpu.measure(scene, kSize, kFields, {}, job, rasters);
    EXPECT_TRUE(status.ok()) << status.message();
    return rasters;
}

// Orbits of 24 bits come to another end than those of 53 where they pass a border nearer than their
// rounding, which each step makes larger by as much as the map expands there. That is seldom, and a
// point has other such members than its neighbour: so hardly any count differs by more than one
// or two, and the mean over the picture is hardly moved.
void compare(const Scene& scene) {
    const auto ours = onGraphics(scene);
    const auto theirs = onProcessor(scene);
    const double count = scene.ensemble.count;
    double sum = 0, signedSum = 0;
    int far = 0, between = 0;
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            const double mean = theirs[0].at(x, y);
            const double error = static_cast<double>(ours[0].at(x, y)) - mean;
            sum += std::abs(error);
            signedSum += error;
            far += std::abs(error) > 2.5 / count;
            between += mean > 0 && mean < 1;
            const double own = static_cast<double>(ours[0].at(x, y));
            EXPECT_NEAR(static_cast<double>(ours[1].at(x, y)),
                        std::sqrt(std::max(0.0, own * (1 - own)) / (count - 1)), 1e-4);
        }
    const double pixels = 1.0 * kSize.width * kSize.height;
    if (std::getenv("VERSORIUM_SHOW_SHARES"))
        std::printf("%-36s mean |error| %.5f, mean error %.5f, %.2f %% by more than 2 members\n",
                    scene.map.c_str(), sum / pixels, signedSum / pixels, 100 * far / pixels);
    EXPECT_GT(between, pixels / 40) << scene.map;
    EXPECT_LT(sum / pixels, 2e-4) << scene.map;
    EXPECT_LT(std::abs(signedSum / pixels), 1e-4) << scene.map;
    EXPECT_LE(far, pixels / 500) << scene.map;
}

TEST(GpuAveraged, RandomRoots) {
    compare(star(40));
    Scene solid = star(40);
    solid.ensemble.set = AveragedSet::solid;
    compare(solid);
    Scene several = star(40);
    several.ensemble.roots->draw.least = 2;
    several.ensemble.roots->draw.most = 9;
    several.ensemble.roots->draw.wholePowers = false;
    several.ensemble.ranges.push_back({"alpha", 5, 8});
    compare(several);
    // More members than there are rows of their roots at once.
    compare(star(300));
}

TEST(GpuAveraged, Quaternions) {
    Scene scene = sceneOf(*findMap("shape-modulus"));
    scene.shape.source = "sphere(0.8)";
    scene.slice.height = 3;
    scene.iterations = 6;
    scene.samples = 1;
    scene.ensemble.count = 20;
    scene.ensemble.roots.emplace();
    scene.colour.field = FieldName::meanMembership;
    scene.colour.interior = SetName::none;
    scene.parameters["alpha"] = {3};
    compare(scene);
}

TEST(GpuAveraged, NumbersFromDiscsAndRanges) {
    compare(discs(60));
    Scene set = *presetNamed("mandelbrot");
    set.samples = 1;
    set.iterations = 40;
    set.criticalStart.reset();
    set.start = {0, 0};
    set.ensemble.count = 30;
    set.ensemble.ranges.push_back({"z.re", -0.5, 0.5});
    set.colour.field = FieldName::meanMembership;
    set.colour.interior = SetName::none;
    compare(set);
}

TEST(GpuAveraged, GoesOnWhenTheEnsembleGrows) {
    GpuDevice gpu;
    GpuPicture picture(gpu);
    Scene scene = star(20);
    ASSERT_TRUE(picture.start(scene, kSize).ok());
    ASSERT_TRUE(picture.finish().ok());
    const long long draws = gpu.iterationDraws;
    // Other colours and the standard error count nothing.
    scene.colour.field = FieldName::standardError;
    scene.colour.contours = {0.05};
    ASSERT_TRUE(picture.recolour(scene).ok());
    EXPECT_EQ(picture.state(), GpuPicture::State::finished);
    EXPECT_NE(picture.texture(), 0u);
    EXPECT_EQ(gpu.iterationDraws, draws);
    scene.ensemble.count = 50;
    ASSERT_TRUE(picture.recolour(scene).ok());
    EXPECT_EQ(picture.state(), GpuPicture::State::iterating);
    ASSERT_TRUE(picture.finish().ok());
    EXPECT_EQ(picture.members(), 50);
    std::vector<Raster<float>> rasters;
    ASSERT_TRUE(picture.readFields(kFields, rasters).ok());
    EXPECT_EQ(rasters[0].values(), onGraphics(star(50))[0].values());
    scene.ensemble.count = 10;
    EXPECT_FALSE(picture.recolour(scene).ok());
    scene.colour.field = FieldName::escapeStep;
    EXPECT_FALSE(picture.recolour(scene).ok());
}

TEST(GpuAveraged, ColoursAndContoursAreThoseOfTheProcessor) {
    for (int samples : {1, 2}) {
        Scene scene = star(40);
        scene.samples = samples;
        scene.colour.contours = {0.25, 0.5, 0.75};
        GpuDevice gpu;
        GpuPicture picture(gpu);
        ASSERT_TRUE(picture.start(scene, kSize, {.samples = samples}).ok());
        ASSERT_TRUE(picture.finish().ok());
        Raster<unsigned char> ours;
        ASSERT_TRUE(picture.readPicture(ours).ok());
        CpuRenderer cpu;
        Job job(1);
        Frame frame;
        ASSERT_TRUE(cpu.render(scene, kSize, {}, job, frame).ok());
        const Raster<unsigned char> theirs = encodeSrgb(frame.colour);
        int differ = 0;
        for (int y = 0; y < kSize.height; ++y)
            for (int x = 0; x < kSize.width; ++x) {
                int most = 0;
                for (int c = 0; c < 3; ++c)
                    most = std::max(most, std::abs(ours.at(x, y, c) - theirs.at(x, y, c)));
                differ += most > 8;
            }
        // Where counts differ, a contour moves by a sample.
        EXPECT_LE(differ, kSize.width * kSize.height / 50) << samples;
    }
}

TEST(GpuAveraged, SaysWhatTheProcessorHasToCount) {
    GpuDevice gpu;
    GpuPicture picture(gpu);
    const auto refused = [&](const Scene& scene, const char* word) {
        const Status status = picture.start(scene, kSize);
        EXPECT_FALSE(status.ok()) << word;
        EXPECT_NE(status.message().find(word), std::string::npos) << status.message();
    };
    refused(star(kMostGpuMembers + 1), "24 bits");
    Scene inside = star(20);
    inside.colour.interior = SetName::membership;
    refused(inside, "beside the mean");
    Scene last = star(20);
    last.escapeTest = EscapeTest::last;
    refused(last, "last point");
    Scene none = star(20);
    none.ensemble = {};
    refused(none, "varies nothing");
}

}  // namespace
}  // namespace versorium
