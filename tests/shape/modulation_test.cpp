// SPDX-License-Identifier: MIT
#include "shape/modulation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shape/radial_profile.h"

namespace versorium {
namespace {

std::shared_ptr<const DistanceField> fieldOf(const char* text) {
    return std::make_shared<const DistanceField>(*parseShape(text));
}

double at(const Modulation& modulation, double x, double y, double base) {
    return modulation.at(x, y, 0.0, base);
}

TEST(Modulation, ASecondShapeIsTheCubicOfItsDistance) {
    const Modulation m(ModulatingShape{fieldOf("disc(1)"), -0.2, 0.6, 300}, {}, true);
    for (double r : {0.0, 0.5, 0.8, 0.9, 1.2, 1.5, 1.6, 4.0}) {
        // The distance to the disc is r - 1.
        const double s = std::min(1.0, std::max(0.0, (r - 1 + 0.2) / 0.8));
        const double share = s * s * (3 - 2 * s);
        EXPECT_NEAR(at(m, r, 0, 10), 300 + (10 - 300) * share, 1e-10) << r;
    }
    // Exact where it is flat: outside nothing is touched.
    EXPECT_EQ(at(m, 1.7, 0, 0.1), 0.1);
    EXPECT_EQ(at(m, 0.1, 0, 0.1), 300);
}

TEST(Modulation, PaintedDiscsCoverOneAnother) {
    const Modulation m({}, {{0, 0, 0, 0.5, 20}, {0.25, 0, 0, 0.125, -3}}, true);
    EXPECT_NEAR(at(m, 0.25, 0, 7), -3, 1e-9);
    EXPECT_NEAR(at(m, 0, 0, 7), 20, 1e-2);  // a node need not lie there
    EXPECT_EQ(at(m, 0.51, 0, 7), 7);
    EXPECT_EQ(at(m, -3, 8, 0.1), 0.1);
    // Half a radius out: the cubic is 1/2 there.
    EXPECT_NEAR(at(m, -0.25, 0, 7), 0.5 * (20 + 7), 0.05);
    // No jump: over a hundredth of the radius, a cubic changes by at most 1.5 hundredths.
    for (double x = -0.6; x < 0.6; x += 0.005)
        EXPECT_LT(std::abs(at(m, x + 0.005, 0.01, 7) - at(m, x, 0.01, 7)), 1.5) << x;
}

TEST(Modulation, InSpaceDiscsAreBalls) {
    const Modulation m({}, {{0.1, 0.2, 0.3, 0.2, 50}}, false);
    EXPECT_NEAR(m.at(0.1, 0.2, 0.3, 4.0), 50, 1);
    EXPECT_EQ(m.at(0.1, 0.2, 0.55, 4.0), 4);
    const Modulation flat({}, {{0.1, 0.2, 0.3, 0.2, 50}}, true);
    EXPECT_NEAR(flat.at(0.1, 0.2, 7.0, 4.0), 50, 1);
}

TEST(Modulation, ItsRangeHoldsEveryValue) {
    const Modulation m(ModulatingShape{fieldOf("disc(1)"), 0, 1, 12},
                       {{0, 0, 0, 0.5, 20}, {0.3, 0, 0, 0.4, -3}}, true);
    const auto [low, high] = m.rangeFrom(7);
    EXPECT_EQ(low, -3);
    EXPECT_EQ(high, 20);
    for (int i = 0; i < 1000; ++i) {
        const double value = at(m, std::sin(i * 1.7), std::cos(i * 2.3), 7);
        EXPECT_GE(value, low);
        EXPECT_LE(value, high);
    }
}

TEST(Modulation, TheTrapIsProvedForEveryValue) {
    Job job(1);
    const auto captureOf = [&](const DistanceField& field, double alpha) {
        return radialProfile(field, {.alpha = alpha, .to = 2}, job)->capture;
    };
    const DistanceField plain(*parseShape("disc(0.6)"));
    DistanceField modulated = plain;
    const auto soft = std::make_shared<const Modulation>(
        std::nullopt, std::vector<PaintedDisc>{{0.4, 0, 0, 0.2, 2}}, true);
    modulated.modulate(soft, nullptr);
    // Where α is 2 somewhere, no ball is sure that would not be sure with 2 everywhere.
    EXPECT_GT(captureOf(plain, 20), captureOf(modulated, 20));
    EXPECT_LE(captureOf(modulated, 20), captureOf(plain, 2) + 1e-12);
}

}  // namespace
}  // namespace versorium
