// SPDX-License-Identifier: MIT
#include "io/palette_files.h"

#include <gtest/gtest.h>

namespace versorium {
namespace {

Expected<PaletteFile> read(std::string_view text, std::string_view name = "some/Fire.txt") {
    return readPaletteFile({reinterpret_cast<const unsigned char*>(text.data()), text.size()},
                           name);
}

void expectColours(const Expected<PaletteFile>& file, const std::vector<const char*>& colours,
                   const char* what) {
    ASSERT_TRUE(file.ok()) << what << ": " << file.status().message();
    const auto& stops = file->palette.stops();
    ASSERT_EQ(stops.size(), colours.size()) << what;
    for (std::size_t i = 0; i < stops.size(); ++i)
        EXPECT_EQ(hexFromColour(stops[i].colour), colours[i]) << what << " " << i;
}

TEST(PaletteFiles, TheSameThreeColoursInEveryListOfColours) {
    const std::vector<const char*> colours{"#000000", "#ff8000", "#ffffff"};
    const std::pair<const char*, const char*> files[] = {
        {"map", "0 0 0\n255 128 0 a comment\n 255 255 255\n"},
        {"map, CR", "0 0 0\r255 128 0\r255 255 255"},
        {"map, mark and CRLF",
         "\xef\xbb\xbf"
         "0 0 0\r\n255 128 0\r\n255 255 255\r\n"},
        {"gpl",
         "GIMP Palette\nName: Trial\nColumns: 3\n#\n  0   0   0\tBlack\n255 128   0\tOrange\n"
         "255 255 255\tWhite\n"},
        {"gpl, old, lower case", "gimp palette\n0 0 0\n255 128 0\n255 255 255\n"},
        {"pal", "JASC-PAL\r\n0100\r\n3\r\n0 0 0\r\n255 128 0\r\n255 255 255\r\n"},
        {"list", "#000000\n#ff8000\n#FFFFFF\n"},
        {"list on a line", "#000, #ff8000,#fff"},
        {"list without marks", "000000\nff8000\nffffff\n"},
        {"list as code", "[\"#000000\", \"#ff8000\", '#ffffff']"},
        {"list of 0x", "0x000000 0xff8000 0xFFFFFF"},
        {"list with comments", "; made by hand\n// so\n#000000\n# a remark\n#ff8000\n#ffffff\n"},
        {"own", "{\"stops\": [\"#000000\", \"#ff8000\", \"#ffffff\"]}"},
    };
    for (const auto& [what, text] : files) expectColours(read(text), colours, what);
    EXPECT_EQ(read(files[0].second, "some/Fire.map")->palette.name(), "Fire");
    EXPECT_EQ(read(files[3].second)->palette.name(), "Trial");
}

TEST(PaletteFiles, GimpGradientsRunThroughTheirMiddles) {
    const Expected<PaletteFile> file = read(
        "GIMP Gradient\nName: Two\n2\n"
        "0.000000 0.250000 0.500000 0 0 0 1 1 1 1 1 0 0 0 0\n"
        "0.500000 0.750000 1.000000 1 0 0 1 0 0 1 1 0 0\n");
    ASSERT_TRUE(file.ok()) << file.status().message();
    const Palette& palette = file->palette;
    EXPECT_EQ(palette.name(), "Two");
    // The mean of black and white as GIMP has it, in sRGB; stops meet there.
    EXPECT_NEAR(palette.at(0.25).g, linearFromSrgb(0.5), 1e-6);
    EXPECT_EQ(hexFromColour(palette.at(0)), "#000000");
    EXPECT_NEAR(palette.at(0.75).r, linearFromSrgb(0.5), 1e-6);
    EXPECT_NEAR(palette.at(0.75).b, linearFromSrgb(0.5), 1e-6);
    EXPECT_EQ(hexFromColour(palette.at(1)), "#0000ff");
    // The middle is where half of the way is done, wherever it lies and however it bends.
    for (const char* kind : {"0", "1", "2"}) {
        const Expected<PaletteFile> bent =
            read("GIMP Gradient\n1\n0 0.75 1 0 0 0 1 1 1 1 1 " + std::string(kind) + " 0\n");
        ASSERT_TRUE(bent.ok());
        EXPECT_NEAR(linearFromSrgb(0.5), bent->palette.at(0.75).g, 0.004) << kind;
    }
    // Round the circle of hues: from red to blue by green, or not.
    EXPECT_EQ(
        hexFromColour(read("GIMP Gradient\n1\n0 0.5 1 1 0 0 1 0 0 1 1 0 1\n")->palette.at(0.5)),
        "#00ff00");
    EXPECT_EQ(
        hexFromColour(read("GIMP Gradient\n1\n0 0.5 1 1 0 0 1 0 0 1 1 0 2\n")->palette.at(0.5)),
        "#ff00ff");
}

TEST(PaletteFiles, ColourTablesAreSpreadOverTheirValues) {
    for (const char* text :
         {"# COLOR_MODEL = RGB\n-10 0 0 0 30 255 128 0\n30 255 128 0 70 255 255 255\nB 0 0 0\n"
          "F 255 255 255\nN 1 2 3\n",
          "-10 0/0/0 30 255/128/0 L\n30 255/128/0 70 255/255/255 ; high\nN 1/2/3\n",
          "-10 black 30 #ff8000\n30 #ff8000 70 white\nN #010203\n",
          "# COLOR_MODEL = HSV\n-10 0 0 0 30 30.118 1 1\n30 30.118 1 1 70 0 0 1\nN 210 0.6667 "
          "0.01176\n"}) {
        const Expected<PaletteFile> file = read(text, "height.cpt");
        expectColours(file, {"#000000", "#ff8000", "#ff8000", "#ffffff"}, text);
        ASSERT_TRUE(file.ok());
        EXPECT_EQ(file->palette.stops()[1].position, 0.5);
        EXPECT_EQ(hexFromColour(file->palette.undefined), "#010203");
        EXPECT_FALSE(file->note.empty());
    }
}

TEST(PaletteFiles, UltraGradientsRunRoundACircle) {
    const Expected<PaletteFile> file = read(
        "Embers {\ngradient:\n  title=\"Embers\" smooth=no\n  index=100 color=255\n"
        "  index=300 color=16711680\nopacity:\n  smooth=no index=0 opacity=255\n}\nother {\n}\n",
        "a.ugr");
    ASSERT_TRUE(file.ok()) << file.status().message();
    EXPECT_EQ(file->palette.name(), "Embers");
    EXPECT_EQ(file->palette.kind(), PaletteKind::cyclic);
    EXPECT_EQ(hexFromColour(file->palette.at(0.25)), "#ff0000");
    EXPECT_EQ(hexFromColour(file->palette.at(0.75)), "#0000ff");
    EXPECT_EQ(hexFromColour(file->palette.at(0)), hexFromColour(file->palette.at(1)));
    EXPECT_NE(file->note.find("first gradient"), std::string::npos);
}

TEST(PaletteFiles, WhatIsWrongIsSaidWithItsLine) {
    const std::pair<const char*, const char*> wrong[] = {
        {"", "not a palette"},
        {"hello\n", "not a palette"},
        {"0 0 0\n", "1 colour; 2 to 1024"},
        {"0 0 0\n0 0 256\n", "line 2"},
        {"0 0 0\n\n0 0\n", "line 3"},
        {"#000000\n#12345\n", "line 2"},
        {"GIMP Palette\n0 0 0\nx y z\n", "line 3"},
        {"GIMP Gradient\n1\n0 0.5 1 0 0 0\n", "line 3"},
        {"GIMP Gradient\n1\n0.5 0.2 1 0 0 0 1 1 1 1 1 0 0\n", "line 3"},
        {"GIMP Gradient\n", "no segments"},
        {"0 0/0/0 1 1/2/x\n", "line 1"},
        {"5 0/0/0 1 255/255/255\n", "must rise"},
        {"x {\ngradient:\n}\n", "no line with index"},
        {"{\"stops\": 3}", "stops"},
        {"<svg>", "SVG"},
        {"GIF89a", "GIF"},
    };
    for (const auto& [text, message] : wrong) {
        const Expected<PaletteFile> file = read(text);
        ASSERT_FALSE(file.ok()) << text;
        EXPECT_NE(file.status().message().find(message), std::string::npos)
            << text << ": " << file.status().message();
    }
}

}  // namespace
}  // namespace versorium
