// SPDX-License-Identifier: MIT
// Motions: what lies between key frames, what a recording keeps, and what is refused.
#include "scene/animation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace versorium {
namespace {

Animation example() {
    Animation animation;
    animation.scene = sceneOf(*findMap("quadratic"));
    animation.motion.keys = {{1, Easing::linear, {{"c.re", 0}, {"slice.height", 4}}},
                             {3, Easing::smooth, {{"c.re", 1}}},
                             {5, Easing::hold, {{"c.re", -1}, {"slice.height", 0.01}}},
                             {6, Easing::linear, {{"c.re", 2}}}};
    return animation;
}

TEST(AnimationTest, NumbersBetweenKeyFrames) {
    const Animation animation = example();
    const auto real = [&](double time) { return sceneAt(animation, time).parameters.at("c")[0]; };
    EXPECT_EQ(real(0), 0);
    EXPECT_EQ(real(1), 0);
    EXPECT_EQ(real(1.5), 0.25);
    EXPECT_EQ(real(3), 1);
    EXPECT_DOUBLE_EQ(real(3.5), 1 - 2 * (0.0625 * (3 - 0.5)));
    EXPECT_EQ(real(5.99), -1);
    EXPECT_EQ(real(6), 2);
    EXPECT_EQ(real(100), 2);
    // Halfway in time a zoom is halfway in powers of ten; key frames between do not disturb it.
    EXPECT_NEAR(sceneAt(animation, 3).slice.height, 0.2, 1e-12);
    EXPECT_EQ(sceneAt(animation, 8).slice.height, 0.01);
    EXPECT_EQ(animation.motion.frames(), 181);
}

TEST(AnimationTest, EverythingThatMovesHasANameAndARange) {
    Scene scene = sceneOf(*findMap("planar"));
    scene.layers.resize(2);
    const std::vector<std::string> names = movingNames(scene);
    EXPECT_EQ(names.size(), 30u + 2 + 2 + 3 + 10);
    for (const std::string& name : names) {
        const auto before = movingValue(scene, name);
        ASSERT_TRUE(before) << name;
        EXPECT_TRUE(setMovingValue(scene, name, *before + 1)) << name;
        const double wanted = name.ends_with("opacity") ? 1 : *before + 1;
        EXPECT_EQ(*movingValue(scene, name), wanted) << name;
        setMovingValue(scene, name, std::nan(""));
        EXPECT_EQ(*movingValue(scene, name), wanted) << name;
    }
    for (const char* name : {"layers[2].x", "layers[].x", "layers[0]", "slice.center[2]", "c.re",
                             "slice.center[-1]", "layers[99999999999].x", ""})
        EXPECT_FALSE(movingValue(scene, name)) << name;
}

// A hand that moves, rests, and zooms: the recording gives the same within its tolerance, with far
// fewer key frames than there were moments.
TEST(AnimationTest, ARecordingReproducesTheHand) {
    Scene scene = sceneOf(*findMap("quadratic"));
    Recorder recorder;
    const auto moved = [&](double t) {
        Scene now = scene;
        now.parameters["c"] = {t < 3 ? std::sin(t) : std::sin(3.0), -0.5};
        now.slice.height = t < 2 ? 4 : 4 * std::exp2(-3 * (t - 2));
        return now;
    };
    recorder.begin(moved(0), 100);
    for (double t = 1.0 / 60; t < 5; t += 1.0 / 60) recorder.take(moved(t), 100 + t);
    const auto motion = recorder.finish();
    ASSERT_TRUE(motion);
    EXPECT_LT(motion->keys.size(), 60u);
    for (const KeyFrame& key : motion->keys) EXPECT_FALSE(key.values.contains("c.im"));
    for (double t = 0; t < 4.9; t += 0.0173) {
        const Scene is = sceneAt({scene, *motion}, t), was = moved(t);
        EXPECT_NEAR(is.parameters.at("c")[0], was.parameters.at("c")[0], 0.006) << t;
        // The first step of the zoom falls between two moments.
        EXPECT_NEAR(std::log2(is.slice.height), std::log2(was.slice.height), 0.1) << t;
    }
    Recorder idle;
    idle.begin(scene, 0);
    idle.take(scene, 1);
    EXPECT_FALSE(idle.finish());
}

// A zoom from the whole set to 1e-8, with the target in its middle at the end.
TEST(AnimationTest, AZoomKeepsItsTargetInSight) {
    const Scene scene = sceneOf(*findMap("quadratic"));
    const double target[2] = {-0.743643887037151, 0.13182590420533};
    Motion motion;
    motion.keys.push_back({0, Easing::linear, {}});
    motion.keys[0].values = {
        {"slice.center[0]", -0.5}, {"slice.center[1]", 0}, {"slice.height", 3}};
    motion.keys.push_back({10, Easing::linear, {}});
    motion.keys[1].values = {
        {"slice.center[0]", target[0]}, {"slice.center[1]", target[1]}, {"slice.height", 1e-8}};
    for (Easing easing : {Easing::linear, Easing::smooth}) {
        motion.keys[0].easing = easing;
        for (int frame = 0; frame <= 100; ++frame) {
            const SliceSpec slice = sceneAt({scene, motion}, 0.1 * frame).slice;
            const double left = (slice.height - 1e-8) / (3 - 1e-8);
            for (std::size_t k = 0; k < 2; ++k) {
                const double start = k == 0 ? -0.5 : 0;
                // Nowhere farther from the middle, in picture heights, than at the beginning.
                EXPECT_LE(std::abs(slice.centre[k] - target[k]) / slice.height,
                          std::abs(start - target[k]) / 3 + 1e-7)
                    << frame;
                EXPECT_NEAR(slice.centre[k], target[k] + (start - target[k]) * left, 1e-15);
            }
        }
    }
    // The same where the height has key frames of its own on the way.
    motion.keys[0].easing = Easing::linear;
    motion.keys.insert(motion.keys.begin() + 1, KeyFrame{4, Easing::linear, {}});
    motion.keys[1].values = {{"slice.height", 1e-3}};
    for (int frame = 0; frame <= 100; ++frame) {
        const SliceSpec slice = sceneAt({scene, motion}, 0.1 * frame).slice;
        EXPECT_LE(std::abs(slice.centre[0] - target[0]) / slice.height, 0.2) << frame;
    }
    EXPECT_EQ(sceneAt({scene, motion}, 10).slice.centre[0], target[0]);
}

TEST(AnimationTest, ARecordedZoomIsExactInPictureHeights) {
    Scene scene = sceneOf(*findMap("quadratic"));
    const auto moved = [&](double t) {
        Scene now = scene;
        now.slice.height = 3 * std::exp2(-4 * t);
        const double left = now.slice.height / 3 + 0.2 * now.slice.height * std::sin(3 * t);
        now.slice.centre = {-0.74364388703 + 0.2 * left, 0.1318259042 - 0.13 * left};
        return now;
    };
    Recorder recorder;
    recorder.begin(moved(0), 0);
    for (double t = 1.0 / 60; t < 6; t += 1.0 / 60) recorder.take(moved(t), t);
    const auto motion = recorder.finish();
    ASSERT_TRUE(motion);
    EXPECT_LT(motion->keys.size(), 120u);
    for (double t = 0; t < 5.9; t += 0.0173) {
        const SliceSpec is = sceneAt({scene, *motion}, t).slice, was = moved(t).slice;
        for (std::size_t k = 0; k < 2; ++k)
            EXPECT_LT(std::abs(is.centre[k] - was.centre[k]) / was.height, 0.01) << t;
    }
}

TEST(AnimationTest, AsJsonAndBack) {
    const Animation animation = example();
    const Json json = animationToJson(animation);
    const Expected<Animation> again = animationFromJson(json);
    ASSERT_TRUE(again) << again.status().message();
    EXPECT_EQ(again->motion, animation.motion);
    EXPECT_EQ(animationToJson(*again), json);
}

TEST(AnimationTest, WhatIsWrongIsNamed) {
    const Json right = animationToJson(example());
    const auto refused = [&](const char* pointer, const Json& value, const char* says) {
        Json wrong = right;
        wrong[Json::json_pointer(pointer)] = value;
        const Expected<Animation> read = animationFromJson(wrong);
        ASSERT_FALSE(read) << pointer;
        EXPECT_NE(read.status().message().find(says), std::string::npos) << read.status().message();
    };
    refused("/keys/1/time", 0.5, "keys[1].time");
    refused("/keys/1/time", 1e9, "keys[1].time");
    refused("/keys/0/values/zebra", 1, "zebra");
    refused("/keys/0/values/c.re", "x", "keys[0].values.c.re");
    refused("/keys/0/easing", "bouncy", "easing");
    refused("/keys", Json::array(), "keys");
    refused("/frames_per_second", 0, "frames_per_second");
    refused("/scene/map", "zebra", "scene");
    refused("/versorium", 99, "newer");
    refused("/more", 1, "more");
}

// Foreign text of any kind: an animation, or a reason. Mutations of a right one reach deep.
TEST(AnimationTest, NoTextBreaksTheReader) {
    const std::string right = animationToJson(example()).dump();
    std::uint32_t random = 12345;
    const auto next = [&](std::size_t most) {
        random = random * 1664525u + 1013904223u;
        return (random >> 8) % most;
    };
    const char* const pieces[] = {"1e999", "-1",    "null",        "[]",           "{}",
                                  "\"\"",  ",",     ":",           "keys",         "NaN",
                                  "0.5",   "1e300", "layers[0].x", "slice.height", "\xff"};
    int read = 0;
    for (int round = 0; round < 10000; ++round) {
        std::string text = right;
        for (std::size_t k = 0; k < 1 + next(3); ++k) {
            const std::size_t at = next(text.size()), length = next(12);
            switch (next(3)) {
                case 0:
                    text.erase(at, length);
                    break;
                case 1:
                    text.insert(at, pieces[next(std::size(pieces))]);
                    break;
                default:
                    text.replace(at, std::min<std::size_t>(length, 4),
                                 pieces[next(std::size(pieces))]);
            }
            if (text.empty()) text = "0";
        }
        const Expected<Json> json = parseJson(text);
        if (!json) continue;
        const Expected<Animation> animation = animationFromJson(*json);
        if (!animation) {
            EXPECT_FALSE(animation.status().message().empty()) << text;
            continue;
        }
        ++read;
        for (const double time : {0.0, 1.7, 1e9}) {
            const Scene scene = sceneAt(*animation, time);
            EXPECT_TRUE(std::isfinite(scene.slice.height)) << text;
            EXPECT_TRUE(sceneFromJson(sceneToJson(scene)).ok()) << text;
        }
        EXPECT_GE(animation->motion.frames(), 1);
    }
    EXPECT_GT(read, 50);
}

}  // namespace
}  // namespace versorium
