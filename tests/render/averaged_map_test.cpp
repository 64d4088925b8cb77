// SPDX-License-Identifier: MIT
#include "render/cpu/averaged_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "fields/ensemble.h"
#include "render/averaged_star.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {
namespace {

Scene starScene(int count, int seed = 1) {
    Scene scene = averagedStar(count, seed);
    scene.colour.contours = {0.25, 0.5, 0.75};
    return scene;
}

std::vector<Raster<double>> measured(const Scene& scene, Size size, int threads,
                                     bool shortcuts = true) {
    CpuRenderer renderer;
    Job job(threads);
    std::vector<Raster<double>> rasters;
    const Status status =
        renderer.measure(scene, size, {FieldName::meanMembership, FieldName::standardError},
                         {.shortcuts = shortcuts}, job, rasters);
    EXPECT_TRUE(status.ok()) << status.message();
    return rasters;
}

AveragedMap counted(const Scene& scene, Size size, const std::vector<int>& portions,
                    int threads = 1) {
    AveragedMap map = *AveragedMap::make(scene, size);
    Binder binder;
    Job job(threads);
    for (int portion : portions)
        EXPECT_TRUE(map.add(binder, static_cast<std::uint64_t>(portion), {}, job).ok());
    return map;
}

constexpr Size kSmall{40, 36};

// A slice with two axes has two coordinates: what stands behind them is not looked at.
TEST(AveragedMap, TakesACoordinateForEachAxisAndNoMore) {
    Binder binder;
    Job job(1);
    const OrbitProgram program = *binder.bind(starScene(20), job);
    ASSERT_EQ(program.slice.axes.size(), 2u);
    const double u = 0.9, v = 0.3;
    const auto nowhere = reinterpret_cast<const double*>(~std::uintptr_t{7});
    const double* coordinates[] = {&u, &v, nowhere};
    const FieldName field[] = {FieldName::meanMembership};
    const double mean = evaluateFields(program, 1, coordinates, field)[0][0];
    EXPECT_GE(mean, 0);
    EXPECT_LE(mean, 1);
}

TEST(AveragedMap, IsTheMeanOfItsMembersOneByOne) {
    for (const AveragedSet set : {AveragedSet::membership, AveragedSet::solid}) {
        Scene scene = starScene(20);
        scene.ensemble.set = set;
        const Raster<double> mean = counted(scene, kSmall, {20}).mean();
        Binder binder;
        Job job(1);
        OrbitProgram program = *binder.bind(scene, job);
        const auto ensemble = program.ensemble;
        Raster<double> sum(kSmall, 1);
        const double pixel = scene.slice.height / kSmall.height;
        for (std::uint64_t k = 0; k < 20; ++k) {
            ensemble->choose(k, program);
            for (int y = 0; y < kSmall.height; ++y)
                for (int x = 0; x < kSmall.width; ++x) {
                    const double u = (x + 0.5 - 0.5 * kSmall.width) * pixel;
                    const double v = (0.5 * kSmall.height - y - 0.5) * pixel, w = 0;
                    const double* coordinates[3] = {&u, &v, &w};
                    const FieldName field[] = {findField(wordOf(set))->field};
                    sum.at(x, y) +=
                        evaluateFields(program, 1, coordinates, field, {.shortcuts = false})[0][0];
                }
        }
        int between = 0;
        for (int y = 0; y < kSmall.height; ++y)
            for (int x = 0; x < kSmall.width; ++x) {
                EXPECT_EQ(mean.at(x, y), sum.at(x, y) / 20) << wordOf(set) << " " << x << " " << y;
                between += mean.at(x, y) > 0 && mean.at(x, y) < 1;
            }
        EXPECT_GT(between, 20);
    }
}

TEST(AveragedMap, IsTheSameForAnyPortionsThreadsAndShortcuts) {
    const Scene scene = starScene(30);
    const auto whole = measured(scene, kSmall, 1);
    EXPECT_EQ(measured(scene, kSmall, 3, false)[0].values(), whole[0].values());
    const AveragedMap map = counted(scene, kSmall, {1, 16, 0, 13}, 3);
    EXPECT_EQ(map.members(), 30u);
    EXPECT_EQ(map.mean().values(), whole[0].values());
    EXPECT_EQ(map.standardError().values(), whole[1].values());
    EXPECT_NE(measured(starScene(30, 2), kSmall, 1)[0].values(), whole[0].values());
}

// The two halves of an ensemble differ by as much as their standard errors say. Neighbouring pixels
// see the same members, so the mean is taken over several seeds.
TEST(AveragedMap, HasTheBinomialErrorItClaims) {
    double sum = 0;
    int count = 0;
    for (int seed = 1; seed <= 12; ++seed) {
        const Raster<double> first = counted(starScene(100, seed), {32, 32}, {100}).mean();
        const Raster<double> both = counted(starScene(200, seed), {32, 32}, {200}).mean();
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const double a = first.at(x, y), mean = both.at(x, y), b = 2 * mean - a;
                if (mean < 0.1 || mean > 0.9) continue;
                const double variance = 2 * mean * (1 - mean) / 100;
                sum += (a - b) * (a - b) / variance;
                ++count;
            }
    }
    ASSERT_GT(count, 300);
    // Some dozens of independent differences at least: their RMS is 1 to within a quarter.
    EXPECT_NEAR(std::sqrt(sum / count), 1, 0.25);
}

TEST(AveragedMap, GoesOnFromAFile) {
    const Scene scene = starScene(24);
    const std::vector<unsigned char> bytes = counted(scene, kSmall, {10}).save();
    AveragedMap map = *AveragedMap::make(scene, kSmall);
    ASSERT_TRUE(map.restore(bytes).ok());
    EXPECT_EQ(map.members(), 10u);
    Binder binder;
    Job job(2);
    ASSERT_TRUE(map.add(binder, 14, {}, job).ok());
    EXPECT_EQ(map.save(), counted(scene, kSmall, {24}).save());

    // Other colours and another goal are the same map; other seeds, sizes and damage are refused.
    Scene recoloured = starScene(99);
    recoloured.colour.palette = "fire";
    AveragedMap other = *AveragedMap::make(recoloured, kSmall);
    EXPECT_TRUE(other.restore(bytes).ok());
    AveragedMap wrong = *AveragedMap::make(starScene(24, 2), kSmall);
    EXPECT_EQ(wrong.restore(bytes).kind(), ErrorKind::data);
    AveragedMap larger = *AveragedMap::make(scene, {41, 36});
    EXPECT_EQ(larger.restore(bytes).kind(), ErrorKind::data);
    for (std::size_t cut : {std::size_t{0}, std::size_t{9}, std::size_t{80}, bytes.size() - 1})
        EXPECT_EQ(map.restore({bytes.data(), cut}).kind(), ErrorKind::data);
    std::vector<unsigned char> damaged = bytes;
    damaged.back() = 255;
    EXPECT_NE(map.restore(damaged).message().find("damaged"), std::string::npos);
    EXPECT_EQ(map.members(), 24u);
}

TEST(AveragedMap, CancelledKeepsWhatItHad) {
    AveragedMap map = counted(starScene(24), kSmall, {10});
    const auto before = map.save();
    Binder binder;
    Job job(1);
    job.cancel();
    EXPECT_EQ(map.add(binder, 5, {}, job).kind(), ErrorKind::cancelled);
    EXPECT_EQ(map.save(), before);
}

TEST(AveragedMap, PicturesOfCountsAreThoseOfTheScene) {
    Scene scene = starScene(18);
    scene.samples = 2;
    CpuRenderer plain, given;
    Job job(1);
    Frame expected, shown;
    ASSERT_TRUE(plain.render(scene, kSmall, {}, job, expected).ok());
    given.useAveraged(std::make_shared<const AveragedMap>(counted(scene, kSmall, {18})));
    ASSERT_TRUE(given.render(scene, kSmall, {}, job, shown).ok());
    EXPECT_EQ(std::memcmp(expected.colour.values().data(), shown.colour.values().data(),
                          4 * shown.colour.values().size()),
              0);
    // The contours are drawn.
    Scene bare = scene;
    bare.colour.contours.clear();
    ASSERT_TRUE(given.render(bare, kSmall, {}, job, shown).ok());
    EXPECT_NE(expected.colour.values(), shown.colour.values());
}

// c uniform in a disc of radius 0.2 around 0: every set of it is a quasidisc around 0 that holds
// the disc of radius 1/2 (Re of the multiplier at the attracting point), and none holds |z| > 1.2.
TEST(AveragedMap, OfNumbersFromDiscsAndRanges) {
    Scene scene = sceneOf(*findMap("quadratic"));
    scene.samples = 1;
    scene.ensemble.count = 50;
    scene.ensemble.discs.push_back({"c", 0, 0, 0.2});
    Raster<double> mean = counted(scene, {48, 48}, {50}).mean();
    EXPECT_EQ(mean.at(24, 24), 1);
    EXPECT_EQ(mean.at(0, 24), 0);
    // The line: with c.im 0 and c.re in [-0.1, 0.1] the point z = 1 + small is in the set where
    // (1 + sqrt(1 - 4 c))/2 reaches it: the share of such c is known.
    Scene range = sceneOf(*findMap("quadratic"));
    range.parameters["c"] = {0, 0};
    range.ensemble.count = 4000;
    range.ensemble.ranges.push_back({"c.re", -0.1, 0.1});
    Binder binder;
    Job job(1);
    const OrbitProgram program = *binder.bind(range, job);
    const double u = 1.02, v = 0, w = 0;
    const double* coordinates[3] = {&u, &v, &w};
    const FieldName fields[] = {FieldName::meanMembership, FieldName::standardError};
    const auto values = evaluateFields(program, 1, coordinates, fields);
    // Fixed point β(c) >= u: c <= u - u², -0.0204, of a range from -0.1 to 0.1.
    EXPECT_NEAR(values[0][0], (0.1 - 0.0204) / 0.2, 4 * values[1][0]);
    EXPECT_NEAR(values[1][0], std::sqrt(values[0][0] * (1 - values[0][0]) / 3999), 1e-15);
}

TEST(AveragedMap, WithoutAnEnsembleTheMeanIsTheMembership) {
    Scene scene = starScene(10);
    scene.ensemble = {};
    CpuRenderer renderer;
    Job job(1);
    std::vector<Raster<double>> rasters;
    ASSERT_TRUE(renderer
                    .measure(scene, kSmall, {FieldName::meanMembership, FieldName::membership}, {},
                             job, rasters)
                    .ok());
    EXPECT_EQ(rasters[0].values(), rasters[1].values());
    EXPECT_EQ(AveragedMap::make(scene, kSmall).status().kind(), ErrorKind::usage);
}

TEST(EnsembleJson, ComesBackAndRefusesNonsense) {
    Scene scene = starScene(77, 5);
    scene.ensemble.roots->shapeBox = false;
    scene.ensemble.roots->draw.arrangement = RootArrangement::spread;
    scene.ensemble.ranges.push_back({"alpha", 4, 9});
    scene.ensemble.discs.push_back({"shift", 0, 0.1, 0.2});
    const Expected<Scene> back = sceneFromJson(sceneToJson(scene));
    ASSERT_TRUE(back.ok()) << back.status().message();
    EXPECT_EQ(back->ensemble, scene.ensemble);
    EXPECT_EQ(back->colour, scene.colour);
    EXPECT_FALSE(sceneToJson(sceneOf(*findMap("quadratic"))).contains("ensemble"));

    const auto fault = [](const char* map, const char* ensemble) {
        Json json{{"map", map}, {"ensemble", *parseJson(ensemble)}};
        return sceneFromJson(json).status().message();
    };
    const auto has = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_TRUE(has(fault("quadratic", R"({"count": 0})"), "ensemble.count"));
    EXPECT_TRUE(has(fault("quadratic", R"({"roots": {}})"), "no list"));
    EXPECT_TRUE(has(fault("newton", R"({"roots": {}})"), "half"));
    EXPECT_TRUE(has(fault("newton", R"({"roots": {"half": [1, 1], "count": [1.5, 2]}})"), "whole"));
    EXPECT_TRUE(has(fault("quadratic", R"({"ranges": [{"name": "k"}]})"), "\"k\""));
    EXPECT_TRUE(has(fault("quadratic", R"({"ranges": [{"name": "z.re"}]})"), "axis"));
    EXPECT_TRUE(has(fault("quadratic", R"({"discs": [{"name": "c"}],
                    "ranges": [{"name": "c.im"}]})"),
                    "twice"));
}

}  // namespace
}  // namespace versorium
