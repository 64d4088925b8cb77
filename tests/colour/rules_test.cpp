// SPDX-License-Identifier: MIT
#include "colour/rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "colour/measures.h"
#include "colour/scale.h"

namespace versorium {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
const double kNan = std::nan("");

TEST(Scale, EndsAndMiddle) {
    EXPECT_DOUBLE_EQ((Scale{ScaleKind::linear, -2, 6}.position(2)), 0.5);
    // 10 is the geometric mean of 1 and 100; the logarithm is good to 2 ulp.
    EXPECT_NEAR((Scale{ScaleKind::log, 1, 100}.position(10)), 0.5, 1e-15);
    EXPECT_NEAR((Scale{ScaleKind::truncatedLog, -8, 8}.position(1)), 0.5, 1e-15);
    EXPECT_DOUBLE_EQ((Scale{ScaleKind::truncatedLog, -8, 8}.position(0)), 0);
    EXPECT_DOUBLE_EQ((Scale{ScaleKind::truncatedLog, -8, 8}.position(kInf)), 1);
    EXPECT_DOUBLE_EQ((Scale{ScaleKind::sqrt, -4, 4}.position(1)), 0.75);
    EXPECT_DOUBLE_EQ((Scale{ScaleKind::cyclic, 0, 4}.position(-1)), 0.75);
    EXPECT_DOUBLE_EQ((Scale{ScaleKind::linear, 6, -2}.position(6)), 0);
}

TEST(Scale, ValueIsTheInverseOfPosition) {
    for (const Scale& scale : {Scale{ScaleKind::linear, -2, 6}, Scale{ScaleKind::log, 1e-6, 1e3},
                               Scale{ScaleKind::sqrt, -4, 9}, Scale{ScaleKind::cyclic, -3, 3}})
        for (int k = 0; k < 64; ++k)
            // A logarithm of size 14 followed by an exponential: some 30 ulp.
            EXPECT_NEAR(scale.position(scale.value(k / 64.0)), k / 64.0, 1e-13);
}

TEST(Scale, StaysInTheUnitIntervalWhateverComes) {
    for (const auto kind :
         {ScaleKind::linear, ScaleKind::log, ScaleKind::truncatedLog, ScaleKind::sqrt})
        for (const double value : {-kInf, -1e308, -1.0, -5e-324, 0.0, 5e-324, 1.0, 1e308, kInf}) {
            const double t = Scale{kind, 0.5, 2}.position(value);
            EXPECT_TRUE(t >= 0 && t <= 1) << wordOf(kind) << " " << value;
        }
    EXPECT_TRUE(std::isnan(Scale{}.position(kNan)));
    EXPECT_FALSE((Scale{ScaleKind::log, 0, 1}.check().ok()));
    EXPECT_FALSE((Scale{ScaleKind::linear, 1, 1}.check().ok()));
    EXPECT_FALSE((Scale{ScaleKind::linear, 0, kInf}.check().ok()));
    EXPECT_FALSE(fromWord<ScaleKind>("logarithmic").has_value());
    EXPECT_EQ(*fromWord<ScaleKind>("truncated_log"), ScaleKind::truncatedLog);
}

TEST(Rules, Equation14) {
    const Gradient gradient{{0.2, 0.4, 0.6, 1}, {1, 0.8, 0, 0.5}, 2};
    // By hand at n/N = 1/4: 0.2 + 0.25 * 0.8 = 0.4, squared 0.16; and so on; alpha is not raised.
    const DisplayColour c = displayFromColour(bandedColour(gradient, 25, 100));
    EXPECT_NEAR(c.r, 0.16, 1e-7);  // through the sRGB transfer and back
    EXPECT_NEAR(c.g, 0.25, 1e-7);
    EXPECT_NEAR(c.b, 0.2025, 1e-7);
    EXPECT_DOUBLE_EQ(c.a, 0.875);
}

TEST(Rules, Equation15MeetsEquation14AcrossABand) {
    const double radius2 = 1e6, n = 10, iterations = 100;
    // An orbit that just reached β at step n counts n + 1; one that went far beyond counts n. The
    // next band begins there: what is left of the jump is the β/‖p‖ of the far end.
    EXPECT_DOUBLE_EQ(smoothedFraction(n, radius2, radius2, iterations),
                     bandedFraction(n + 1, iterations));
    EXPECT_NEAR(smoothedFraction(n, radius2 * radius2, radius2, iterations),
                bandedFraction(n, iterations), 1.1e-8);
}

TEST(Rules, Equation15NeverLeavesTheGradient) {
    const Gradient gradient{{0, 0, 0, 1}, {1, 1, 1, 1}, 0.3};
    for (const double norm : {0.0, 1e-300, 4.0, 1e300, kInf, kNan, -1.0}) {
        EXPECT_TRUE(inGamut(smoothedColour(gradient, 100, norm, 4, 100)));
        EXPECT_EQ(smoothedColour(gradient, 100, norm, 4, 100), (Colour{1, 1, 1, 1}));
    }
    EXPECT_TRUE(inGamut(gradientColour(gradient, kNan)));
    EXPECT_EQ(bandedFraction(5, 0), 0);
}

TEST(Rules, LogEscape) {
    EXPECT_EQ(logEscapePosition(0, 100), 0);
    EXPECT_EQ(logEscapePosition(100, 100), 1);
    EXPECT_EQ(logEscapePosition(-3, 100), 0);
    EXPECT_NEAR(logEscapePosition(9, 99), 0.5, 1e-15);  // ln 10 / ln 100
    EXPECT_TRUE(std::isnan(logEscapePosition(kNan, 100)));
}

TEST(Rules, VersorPoles) {
    EXPECT_EQ(hexFromColour(versorColour(1, -1, -1)), "#ff0000");
    EXPECT_EQ(hexFromColour(versorColour(0, 0, 0)), "#808080");
    EXPECT_EQ(hexFromColour(versorColour(-1, 1, 0)), "#00ff80");
    EXPECT_TRUE(inGamut(versorColour(kNan, kInf, -kInf)));
}

TEST(Rules, PhaseTurnsOnce) {
    const Palette palette = *paletteNamed("dusk");
    const double pi = 3.141592653589793;
    EXPECT_EQ(phaseColour(palette, 0), palette.at(0));
    EXPECT_LT(oklabDistance(phaseColour(palette, pi), phaseColour(palette, -pi)), 1e-9);
    EXPECT_EQ(phaseColour(palette, kNan), palette.undefined);
}

TEST(Rules, DomainColoursHaveEdgesAtPowersOfTwoAndTwelfthsOfATurn) {
    const Palette palette = *paletteNamed("dusk");
    const double pi = 3.141592653589793, angle = 0.3;
    // The same grey step at every power of two, whatever the argument.
    for (double modulus : {0.25, 1.0, 8.0}) {
        const Colour before = domainColour(palette, modulus * (1 - 1e-9), angle);
        const Colour past = domainColour(palette, modulus * (1 + 1e-9), angle);
        EXPECT_GT(before.r + before.g + before.b, 1.5 * (past.r + past.g + past.b)) << modulus;
        // Twice the modulus is the same colour.
        EXPECT_LT(oklabDistance(domainColour(palette, 1.37 * modulus, angle),
                                domainColour(palette, 2.74 * modulus, angle)),
                  1e-9);
    }
    const Colour before = domainColour(palette, 1.4, pi / 6 - 1e-9);
    const Colour past = domainColour(palette, 1.4, pi / 6 + 1e-9);
    EXPECT_GT(before.r + before.g + before.b, 1.1 * (past.r + past.g + past.b));
    EXPECT_EQ(domainColour(palette, 0, 1), (Colour{0, 0, 0, 1}));
    EXPECT_EQ(domainColour(palette, kInf, 1), (Colour{1, 1, 1, 1}));
    EXPECT_EQ(domainColour(palette, kNan, 1), palette.undefined);
}

}  // namespace
}  // namespace versorium
