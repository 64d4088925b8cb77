// SPDX-License-Identifier: MIT
#include "colour/srgb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/random.h"
#include "colour/measures.h"

namespace versorium {
namespace {

TEST(Srgb, EveryByteSurvivesTheRoundTrip) {
    for (int byte = 0; byte < 256; ++byte) {
        EXPECT_EQ(srgbByte(linearFromSrgb(byte / 255.0)), byte);
        EXPECT_EQ(srgbByte(static_cast<float>(linearFromSrgb(byte / 255.0))), byte);
    }
    EXPECT_EQ(srgbByte(-1), 0);
    EXPECT_EQ(srgbByte(2), 255);
    EXPECT_EQ(srgbByte(std::numeric_limits<double>::quiet_NaN()), 0);
    EXPECT_EQ(srgbByte(std::numeric_limits<double>::infinity()), 255);
}

TEST(Srgb, ByteIsTheRoundedTransfer) {
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const double linear = random.uniform();
        const double encoded = 255 * srgbFromLinear(linear);
        // Within half a step, and a little more where the two rounded functions meet.
        EXPECT_LE(std::abs(srgbByte(linear) - encoded), 0.5 + 1e-9);
    }
}

TEST(Srgb, TransferIsItsOwnInverse) {
    for (int i = -20; i <= 1000; ++i) {
        const double x = i / 1000.0;
        // The two branches of the standard meet only to about 1e-8.
        EXPECT_NEAR(srgbFromLinear(linearFromSrgb(x)), x, 1e-7);
    }
    // The standard's own example: encoded 0.5 is 21.4 % of the light.
    EXPECT_NEAR(linearFromSrgb(0.5), 0.21404114048223255, 1e-12);
}

TEST(Oklab, PublishedValues) {
    // Ottosson's definition: white is (1, 0, 0); D65 sums of the rounded matrices are 1 to 1e-7.
    const Oklab white = oklabFromColour({1, 1, 1});
    EXPECT_NEAR(white.lightness, 1, 1e-6);
    EXPECT_NEAR(white.a, 0, 1e-6);
    EXPECT_NEAR(white.b, 0, 1e-6);
    // Red as in CSS Color 4: oklab(0.62796 0.22486 0.12585), printed to five digits.
    const Oklab red = oklabFromColour({1, 0, 0});
    EXPECT_NEAR(red.lightness, 0.62796, 1e-5);
    EXPECT_NEAR(red.a, 0.22486, 1e-5);
    EXPECT_NEAR(red.b, 0.12585, 1e-5);
}

TEST(Oklab, RoundTrips) {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const Colour c{random.uniform(), random.uniform(), random.uniform()};
        const Oklab lab = oklabFromColour(c);
        const Colour back = colourFromOklab(oklabFromOklch(oklchFromOklab(lab)));
        // The published matrices have ten digits.
        EXPECT_NEAR(back.r, c.r, 1e-6);
        EXPECT_NEAR(back.g, c.g, 1e-6);
        EXPECT_NEAR(back.b, c.b, 1e-6);
    }
}

TEST(CieLightness, KnownPoints) {
    EXPECT_DOUBLE_EQ(cieLightness({0, 0, 0}), 0);
    EXPECT_NEAR(cieLightness({1, 1, 1}), 100, 1e-12);
    // 18 % grey is the middle of L*: 49.496 by the definition.
    EXPECT_NEAR(cieLightness({0.18, 0.18, 0.18}), 49.496, 1e-3);
}

TEST(Hex, ReadsAndWrites) {
    for (const char* text : {"#000000", "#1d3461", "#ffffff", "#12345678"}) {
        const auto colour = colourFromHex(text);
        ASSERT_TRUE(colour.ok());
        EXPECT_EQ(hexFromColour(*colour), text);
    }
    EXPECT_EQ(hexFromColour(*colourFromHex("#FA3")), "#ffaa33");
    for (const char* text : {"", "#", "red", "#12345", "#gggggg", "#1234567890"})
        EXPECT_FALSE(colourFromHex(text).ok()) << text;
}

}  // namespace
}  // namespace versorium
