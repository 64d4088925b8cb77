// SPDX-License-Identifier: MIT
#include "plate/ticks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"

namespace versorium {
namespace {

std::string labels(const TickSet& set) {
    std::string all;
    for (const Tick& tick : set.ticks)
        if (!tick.label.empty()) all += (all.empty() ? "" : " ") + tick.label;
    return all;
}

// "−0.25" as a number.
double read(std::string label) {
    double sign = 1;
    if (label.starts_with("−")) {
        sign = -1;
        label = label.substr(std::string("−").size());
    }
    return sign * std::strtod(label.c_str(), nullptr);
}

TEST(Ticks, KnownAxes) {
    EXPECT_EQ(labels(linearTicks(-0.5, 0.5, 5)), "−0.4 −0.2 0.0 0.2 0.4");
    EXPECT_EQ(labels(linearTicks(-0.5, 0.5, 3)), "−0.5 0.0 0.5");
    EXPECT_EQ(labels(linearTicks(0, 100, 6)), "0 20 40 60 80 100");
    EXPECT_EQ(labels(linearTicks(-8, 8, 7, true)), "−8 −4 0 4 8");
    EXPECT_EQ(labels(linearTicks(1, -1, 3)), "−1 0 1");
    EXPECT_EQ(linearTicks(1, -1, 3).ticks[0].position, 1);
}

TEST(Ticks, DecadesAndTurns) {
    EXPECT_EQ(labels(scaleTicks({ScaleKind::log, 1e-5, 1e5}, 6)),
              "10^{−5} 10^{−3} 10^{−1} 10 10^{3} 10^{5}");
    EXPECT_EQ(labels(scaleTicks({ScaleKind::log, 2, 3}, 5)), "2.0 2.5 3.0");
    const double pi = 3.141592653589793;
    EXPECT_EQ(labels(scaleTicks({ScaleKind::cyclic, -pi, pi}, 5)), "−π −π/2 0 π/2 π");
    EXPECT_EQ(labels(scaleTicks({ScaleKind::cyclic, 0, 2 * pi}, 3)), "0 π 2π");
}

TEST(Ticks, DeepZoomsTellTheirOffset) {
    const TickSet set = linearTicks(-0.74364388703 - 1e-9, -0.74364388703 + 1e-9, 5);
    EXPECT_EQ(axisName("Re c", set, Words()), "(Re\u00a0c\u00a0+\u00a00.74364389) /\u00a010^{−9}");
    const TickSet huge = linearTicks(0, 5e7, 6);
    EXPECT_EQ(labels(huge), "0 1 2 3 4 5");
    EXPECT_EQ(axisName("N", huge, Words()), "N /\u00a010^{7}");
}

TEST(Ticks, LabelsSayTheValueAtTheirPlace) {
    Random random(5);
    for (int i = 0; i < 20000; ++i) {
        const double size = std::pow(10.0, random.uniform(-12, 12));
        const double span = size * std::pow(10.0, random.uniform(-9, 0));
        const double low = random.uniform(-size, size), high = low + span;
        const TickSet set = linearTicks(low, high, 2 + static_cast<int>(random.below(6)));
        for (const Tick& tick : set.ticks) {
            const double shown = read(tick.label) * std::pow(10.0, set.exponent) + read(set.offset);
            // Positions are good to the rounding of the ends, relative to the span.
            EXPECT_NEAR(low + tick.position * span, shown, 1e-8 * span + 4e-16 * std::abs(shown))
                << low << " " << high << " " << tick.label << " " << set.offset;
            EXPECT_LE(tick.label.size(), 12u) << low << " " << high;
        }
        EXPECT_LE(set.ticks.size(), 7u);
    }
}

TEST(Ticks, NothingStrangeHangsOrFails) {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
    for (const double low : {-inf, -1e308, -1.0, -5e-324, 0.0, 5e-324, 1.0, 1e308, inf, nan})
        for (const double high : {-inf, -1e308, -1.0, -5e-324, 0.0, 5e-324, 1.0, 1e308, inf, nan})
            for (const auto kind : {ScaleKind::linear, ScaleKind::log, ScaleKind::truncatedLog,
                                    ScaleKind::sqrt, ScaleKind::cyclic})
                for (const bool ends : {false, true})
                    for (const Tick& tick : scaleTicks({kind, low, high}, 7, ends).ticks)
                        EXPECT_TRUE(tick.position >= 0 && tick.position <= 1);
    EXPECT_TRUE(linearTicks(0.5, std::nextafter(0.5, 1), 5).ticks.empty());
}

TEST(Ticks, FittingLabelsKeepTheirDistance) {
    const auto extent = [](const std::string& label) { return 10.0 * label.size(); };
    for (double length = 1; length < 1000; length += 7) {
        const Scale scale{ScaleKind::linear, -12345, 54321};
        const auto ticks = fittingTicks(scale, 9, length, 5, extent).ticks;
        for (std::size_t i = 0; i + 1 < ticks.size(); ++i)
            EXPECT_GE(length * (ticks[i + 1].position - ticks[i].position),
                      0.5 * (extent(ticks[i].label) + extent(ticks[i + 1].label)) + 5);
    }
}

}  // namespace
}  // namespace versorium
