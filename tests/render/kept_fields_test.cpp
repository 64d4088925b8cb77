// SPDX-License-Identifier: MIT
// Recolouring measures nothing, and no byte shows it.
#include "render/cpu/kept_fields.h"

#include <gtest/gtest.h>

#include <cstring>

#include "render/cpu/cpu_renderer.h"
#include "render/picture.h"

namespace versorium {
namespace {

constexpr Size kSize{50, 36};
constexpr std::size_t kPlenty = std::size_t{64} << 20;

std::vector<float> drawn(CpuRenderer& renderer, const Scene& scene,
                         const RenderOptions& options = {}) {
    Job job(2);
    Frame frame;
    const Status status = renderer.render(scene, kSize, options, job, frame);
    EXPECT_TRUE(status.ok()) << status.message();
    return frame.colour.values();
}

Scene withOtherColours(Scene scene) {
    scene.colour.palette = "fire";
    scene.colour.reverse = true;
    scene.colour.scale = ScaleKind::linear;
    scene.colour.range = {0, 40};
    scene.colour.contours = {3, 7};
    scene.layers.push_back({.sources = {"#204060"}});
    return scene;
}

TEST(KeptFields, OfAllPresetsGiveThePicturesOfAFreshRenderer) {
    CpuRenderer keeps, fresh;
    keeps.keepFields(kPlenty);
    long long expected = 0;
    for (const Flavour flavour : {Flavour::exact, Flavour::fast})
        for (const std::string& name : presetNames()) {
            Scene scene = *presetNamed(name);
            scene.iterations = std::min(scene.iterations, 60);
            scene.samples = 2;
            if (scene.ensemble.varies()) scene.ensemble.count = 20;
            const Scene other = withOtherColours(scene);
            const RenderOptions options{.flavour = flavour};
            EXPECT_EQ(drawn(keeps, scene, options), drawn(fresh, scene, options)) << name;
            EXPECT_TRUE(keeps.keptLast()) << name;
            EXPECT_EQ(drawn(keeps, other, options), drawn(fresh, other, options)) << name;
            EXPECT_EQ(keeps.measurements(), ++expected) << name;
        }
}

TEST(KeptFields, EverythingElseIsMeasured) {
    Scene scene = *presetNamed("mandelbrot");
    scene.samples = 1;
    CpuRenderer renderer;
    renderer.keepFields(kPlenty);
    long long expected = 0;
    const auto measuredAnew = [&](const Scene& own, const RenderOptions& options = {}) {
        drawn(renderer, own, options);
        return renderer.measurements() == ++expected;
    };
    EXPECT_TRUE(measuredAnew(scene));
    Scene other = scene;
    other.slice.height *= 1.01;
    EXPECT_TRUE(measuredAnew(other));
    other = scene;
    other.iterations += 1;
    EXPECT_TRUE(measuredAnew(other));
    other = scene;
    other.samples = 2;
    EXPECT_TRUE(measuredAnew(other));
    other = scene;
    other.colour.field = FieldName::logModulus;
    EXPECT_TRUE(measuredAnew(other));
    EXPECT_TRUE(measuredAnew(scene, {.flavour = Flavour::fast}));
    // The level of the solid set matters where it is shown.
    other = scene;
    other.iso = 0.5;
    drawn(renderer, other);
    EXPECT_EQ(renderer.measurements(), expected) << "iso of no solid set";
    scene.colour.interior = SetName::solid;
    EXPECT_TRUE(measuredAnew(scene));
    scene.iso = 0.5;
    EXPECT_TRUE(measuredAnew(scene));
}

TEST(KeptFields, WhatIsTooLargeIsNotKept) {
    Scene scene = *presetNamed("mandelbrot");
    scene.samples = 1;
    CpuRenderer renderer;
    // Two fields of this picture, and not three pictures of them.
    const std::size_t picture = 2 * sizeof(double) * kSize.width * kSize.height;
    renderer.keepFields(2 * picture);
    std::vector<Scene> scenes;
    for (int k = 0; k < 3; ++k) {
        scenes.push_back(scene);
        scenes.back().slice.height /= k + 1;
        drawn(renderer, scenes.back());
    }
    EXPECT_EQ(renderer.measurements(), 3);
    drawn(renderer, scenes[2]);
    drawn(renderer, scenes[1]);
    EXPECT_EQ(renderer.measurements(), 3);
    drawn(renderer, scenes[0]);
    EXPECT_EQ(renderer.measurements(), 4) << "the oldest went";
    scene.samples = 2;
    drawn(renderer, scene);
    EXPECT_FALSE(renderer.keptLast());
    drawn(renderer, scenes[0]);
    EXPECT_EQ(renderer.measurements(), 5) << "what is not kept pushes nothing out";
}

// A picture and the numbers saved beside it are measured once.
TEST(KeptFields, ServeThePictureAndItsFieldFiles) {
    for (const char* name : {"mandelbrot", "star", "henon"}) {
        Scene scene = *presetNamed(name);
        scene.samples = 1;
        scene.iterations = std::min(scene.iterations, 80);
        const std::vector<FieldName> saved = {FieldName::escapeStep, FieldName::squaredNorm,
                                              FieldName::versor};
        CpuRenderer once, twice;
        Job job(2);
        once.keepFields(kPlenty);
        const auto one = renderPicture(once, scene, {.size = kSize, .also = saved}, job);
        const auto two = renderPicture(twice, scene, {.size = kSize}, job);
        ASSERT_TRUE(one.ok() && two.ok());
        EXPECT_EQ(*one, *two) << name;
        std::vector<Raster<double>> ours, theirs;
        ASSERT_TRUE(once.measure(scene, kSize, saved, {}, job, ours).ok());
        ASSERT_TRUE(twice.measure(scene, kSize, saved, {}, job, theirs).ok());
        EXPECT_EQ(once.measurements(), 1);
        EXPECT_EQ(twice.measurements(), 2);
        for (std::size_t f = 0; f < saved.size(); ++f) {
            ASSERT_EQ(ours[f].values().size(), theirs[f].values().size());
            // Bit for bit: NaN is the canonical one.
            EXPECT_EQ(std::memcmp(ours[f].values().data(), theirs[f].values().data(),
                                  ours[f].values().size() * sizeof(double)),
                      0)
                << name;
        }
    }
}

}  // namespace
}  // namespace versorium
