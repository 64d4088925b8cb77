// SPDX-License-Identifier: MIT
#include "ui/session/flash_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "ui/headless_gui.h"

namespace versorium {
namespace {

using Lights = FlashGuard::Lights;

Lights all(float light) {
    Lights lights;
    lights.fill(light);
    return lights;
}

// The first `count` cells are of this light, the others of the other.
Lights some(std::size_t count, float light, float others) {
    Lights lights = all(others);
    std::fill_n(lights.begin(), count, light);
    return lights;
}

// How often what is shown turned between dark and bright within any second.
int mostTurns(const std::vector<std::pair<double, float>>& shown) {
    std::vector<double> turns;
    for (std::size_t k = 1; k < shown.size(); ++k)
        if (shown[k].second != shown[k - 1].second) turns.push_back(shown[k].first);
    std::size_t most = 0;
    for (std::size_t k = 0; k < turns.size(); ++k) {
        std::size_t end = k;
        while (end < turns.size() && turns[end] < turns[k] + 1) ++end;
        most = std::max(most, end - k);
    }
    return static_cast<int>(most);
}

TEST(FlashGuard, ShowsNoMoreThanThreeFlashesASecond) {
    for (const double rate : {2.0, 7.0, 30.0, 60.0}) {
        FlashGuard guard;
        std::vector<std::pair<double, float>> shown;
        for (int k = 0; k < 4 * rate; ++k) {
            const float light = k % 2 == 0 ? 0.05F : 0.7F;
            if (guard.admit(all(light), k / rate)) shown.emplace_back(k / rate, light);
        }
        EXPECT_LE(mostTurns(shown), 2 * FlashGuard::kMostFlashes) << rate << " pictures a second";
        // What does not flash that often is shown whole, and what does is shown as often as may be.
        if (rate == 2) {
            EXPECT_EQ(shown.size(), 8u);
        } else if (rate > 7) {
            EXPECT_EQ(mostTurns(shown), 2 * FlashGuard::kMostFlashes);
        }
    }
}

TEST(FlashGuard, LetsPassWhatIsNoFlash) {
    FlashGuard slow, small, faint, bright;
    for (int k = 0; k < 120; ++k) {
        const double now = k / 60.0;
        const bool odd = k % 2 == 1;
        EXPECT_TRUE(slow.admit(all(static_cast<float>(k) / 120), now)) << "one way, at " << now;
        EXPECT_TRUE(small.admit(some(27, odd ? 1.0F : 0.0F, 0.3F), now)) << "a quarter of the view";
        EXPECT_TRUE(faint.admit(all(odd ? 0.29F : 0.2F), now)) << "less than a tenth";
        EXPECT_TRUE(bright.admit(all(odd ? 1.0F : 0.85F), now)) << "never dark";
    }
}

TEST(FlashGuard, CountsACellHoweverItsLightGoesOnBetweenTurns) {
    FlashGuard guard;
    int refused = 0;
    for (int k = 0; k < 120; ++k) {
        // Up in four steps, down in four: 7.5 flashes a second.
        const int step = k % 8 < 4 ? k % 8 : 8 - k % 8;
        refused += !guard.admit(some(28, static_cast<float>(step) / 4, 0), k / 60.0);
    }
    EXPECT_GT(refused, 20);
}

TEST(FlashGuard, MeasuresTheMeanLightOfCells) {
    // White on the left half, black on the right one; and one sRGB grey of known luminance.
    const Size size{120, 90};
    std::vector<unsigned char> rgba(4u * 120 * 90, 255);
    for (int y = 0; y < size.height; ++y)
        for (int x = 60; x < size.width; ++x)
            std::fill_n(&rgba[4u * static_cast<std::size_t>(y * size.width + x)], 3, 0);
    const Lights halves = lightsOf(rgba, size);
    for (std::size_t k = 0; k < halves.size(); ++k)
        EXPECT_EQ(halves[k], k % FlashGuard::kColumns < FlashGuard::kColumns / 2 ? 1.0F : 0.0F);
    // IEC 61966-2-1: 188 of 255 is a relative luminance of 0.5029.
    const std::vector<unsigned char> grey(4u * 5 * 3, 188);
    for (const float light : lightsOf(grey, {5, 3})) EXPECT_NEAR(light, 0.5029, 1e-3);
}

// A picture of one colour for whatever is asked.
void answer(SilentHost& host, LivePicture& picture, unsigned char grey) {
    ASSERT_FALSE(host.requests.empty());
    WorkAnswer given = answerTo(host.requests.back().id, host.requests.back().job);
    auto& result = std::get<PictureResult>(given.result);
    result.rgba.assign(4u * static_cast<std::size_t>(result.size.width * result.size.height), grey);
    result.seconds = 0.001;
    picture.take(std::move(given));
}

// The most turns in any second of a picture that is dark and bright by turns, thirty times a
// second for two seconds.
int turnsShown(bool moves) {
    SilentHost host;
    LivePicture picture;
    const Scene scene = sceneOf(*findMap("quadratic"));
    const std::string orbits = "orbits";
    const auto want = [&](int k) {
        const std::string text = "scene " + std::to_string(k);
        picture.want(host, {}, 0,
                     {scene, text, orbits, nullptr, viewportOf(scene, {48, 36}), moves && k < 60});
    };
    std::vector<std::pair<double, float>> shown;
    for (int k = 0; k < 60; ++k) {
        host.time = k / 30.0;
        want(k);
        const int before = picture.pictures();
        const bool dark = k % 2 == 0;
        answer(host, picture, dark ? 20 : 220);
        if (picture.pictures() > before) shown.emplace_back(host.time, dark ? 0.0F : 1.0F);
    }
    // Whatever moved has come to rest: the last picture comes, with all its refinements.
    for (int k = 0; k < 100 && !picture.finished(); ++k) {
        host.time += 0.1;
        want(60);
        if (picture.waiting()) answer(host, picture, 220);
    }
    EXPECT_TRUE(picture.finished());
    EXPECT_FALSE(picture.held());
    return mostTurns(shown);
}

TEST(LivePictures, OfWhatMovesByItselfDoNotFlash) {
    EXPECT_EQ(turnsShown(true), 2 * FlashGuard::kMostFlashes);
    // What the user's own hand does is shown as it comes.
    EXPECT_GE(turnsShown(false), 29);
}

}  // namespace
}  // namespace versorium
