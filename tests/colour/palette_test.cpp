// SPDX-License-Identifier: MIT
#include "colour/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "colour/measures.h"
#include "scene/scene.h"

namespace versorium {
namespace {

constexpr int kSamples = 512;
double place(int k) { return static_cast<double>(k) / kSamples; }

TEST(EveryPalette, MovesInSmallStepsWithinTheGamut) {
    for (const std::string& name : paletteNames()) {
        const Palette palette = *paletteNamed(name);
        if (palette.kind() == PaletteKind::qualitative) continue;
        for (int k = 0; k < kSamples; ++k) {
            // The longest way through OKLab, black to white, is 1; a palette may be three such ways
            // long before a step of one part in 512 could be seen (0.02).
            EXPECT_LT(oklabDistance(palette.at(place(k)), palette.at(place(k + 1))), 0.006)
                << name << " at " << place(k);
            EXPECT_TRUE(inGamut(palette.at(place(k)))) << name;
        }
    }
}

TEST(EveryPalette, SequentialLightnessIsMonotone) {
    for (const std::string& name : paletteNames()) {
        const Palette palette = *paletteNamed(name);
        if (palette.kind() != PaletteKind::sequential) continue;
        for (int k = 0; k < kSamples; ++k)
            EXPECT_LT(cieLightness(palette.at(place(k))), cieLightness(palette.at(place(k + 1))))
                << name << " at " << place(k);
    }
}

TEST(EveryPalette, DivergingArmsWeighTheSame) {
    for (const std::string& name : paletteNames()) {
        const Palette palette = *paletteNamed(name);
        if (palette.kind() != PaletteKind::diverging) continue;
        for (int k = 0; k <= kSamples / 2; ++k) {
            const Oklch low = oklchFromOklab(oklabFromColour(palette.at(place(k))));
            const Oklch high = oklchFromOklab(oklabFromColour(palette.at(place(kSamples - k))));
            // Equal by construction in OKLab, up to a slight clip at the gamut's border.
            EXPECT_NEAR(low.lightness, high.lightness, 0.005) << name;
            EXPECT_NEAR(low.chroma, high.chroma, 0.005) << name;
        }
        EXPECT_GT(cieLightness(palette.at(0.5)), 93) << name;
    }
}

TEST(EveryPalette, CyclesClose) {
    for (const std::string& name : paletteNames()) {
        const Palette palette = *paletteNamed(name);
        if (palette.kind() != PaletteKind::cyclic) continue;
        EXPECT_EQ(palette.stops().front().colour, palette.stops().back().colour);
        EXPECT_EQ(palette.at(0.0), palette.at(1.0));
        EXPECT_LT(oklabDistance(palette.at(0.25), palette.at(-3.75)), 1e-12);
        EXPECT_LT(oklabDistance(palette.at(0.9999), palette.at(0.0001)), 0.002);
    }
}

TEST(EveryPalette, InteriorIsNearlyBlackAndStandsOut) {
    for (const std::string& name : paletteNames())
        EXPECT_LT(cieLightness(paletteNamed(name)->interior), 5) << name;
}

TEST(EveryPalette, GoesThroughJsonUnchanged) {
    for (const std::string& name : paletteNames()) {
        const Palette palette = *paletteNamed(name);
        const std::string text = printJson(paletteToJson(palette));
        const auto read = paletteFromJson(*parseJson(text));
        ASSERT_TRUE(read.ok()) << read.status().message();
        EXPECT_EQ(printJson(paletteToJson(*read)), text);
    }
}

TEST(EveryPalette, TakesAnyNumber) {
    const double inf = std::numeric_limits<double>::infinity();
    for (const std::string& name : paletteNames()) {
        const Palette palette = *paletteNamed(name);
        for (const double value : {-inf, -1e300, -1.0, 0.0, 1.0, 2.0, 1e300, inf})
            EXPECT_TRUE(inGamut(palette.at(value))) << name << " " << value;
        EXPECT_EQ(palette.at(std::nan("")), palette.undefined);
    }
}

TEST(DefaultPalette, RisesFromTwentyToNinetyFive) {
    const Palette palette = *paletteNamed(Colouring{}.palette);
    EXPECT_EQ(palette.name(), "versorium");
    // "about L* 20 to 95" of the design.
    EXPECT_NEAR(cieLightness(palette.at(0)), 21, 2);
    EXPECT_NEAR(cieLightness(palette.at(1)), 95.5, 1.5);
    EXPECT_EQ(hexFromColour(palette.at(0.25)), "#1f6f8b");
    EXPECT_EQ(hexFromColour(palette.interior), "#0a0b0f");
}

TEST(Palette, MeetsThePublishedColoursBetweenItsStops) {
    // Published entries 100 and 200 of 255, which lie between the tabulated stops. Straight lines
    // between every 17th colour stay within two display steps.
    const auto near = [](const Colour& colour, int r, int g, int b) {
        EXPECT_NEAR(srgbByte(colour.r), r, 2);
        EXPECT_NEAR(srgbByte(colour.g), g, 2);
        EXPECT_NEAR(srgbByte(colour.b), b, 2);
    };
    near(paletteNamed("cividis")->at(100 / 255.0), 101, 104, 112);  // 0.394568 0.406236 0.438986
    near(paletteNamed("cividis")->at(200 / 255.0), 196, 180, 104);  // 0.769353 0.707035 0.408516
}

TEST(Palette, RefusesWhatIsWrong) {
    const auto fault = [](const char* text) {
        const auto palette = paletteFromJson(*parseJson(text));
        return palette.ok() ? std::string() : palette.status().message();
    };
    EXPECT_EQ(fault(R"({"stops": ["#000", "#fff"]})"), "");
    EXPECT_NE(fault(R"({"stops": ["#000"]})").find("stops"), std::string::npos);
    EXPECT_NE(fault(R"({"stops": ["#000", "white"]})").find("stops[1]"), std::string::npos);
    EXPECT_NE(fault(R"({"kind": "cyclic", "stops": ["#000", "#fff"]})").find("cycle"),
              std::string::npos);
    EXPECT_NE(fault(R"({"stops": ["#000", "#fff"], "shade": 1})").find("unknown key"),
              std::string::npos);
    EXPECT_NE(fault(R"({"stops": [{"position": 0, "colour": "#000"},
                                  {"position": 0.5, "colour": "#fff"}]})")
                  .find("the last one at 1"),
              std::string::npos);
    EXPECT_NE(paletteNamed("virdis").status().message().find("viridis"), std::string::npos);
}

}  // namespace
}  // namespace versorium
