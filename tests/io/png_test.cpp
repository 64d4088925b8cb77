// SPDX-License-Identifier: MIT
#include "io/png.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "base/random.h"
#include "io/image_files.h"

namespace versorium {
namespace {

Raster<unsigned char> noise(Size size, int channels) {
    Raster<unsigned char> pixels(size, channels);
    Random random(7);
    for (unsigned char& value : pixels.values()) value = static_cast<unsigned char>(random.next());
    return pixels;
}

std::vector<unsigned char> small() {
    const PngOptions options{.dotsPerInch = 300,
                             .texts = {{"scene", "{\"α\": 6}"}, {"plate", std::string(3000, 'x')}}};
    return *encodePng(noise({5, 4}, 3), options);
}

// Replaces the four bytes at `at`.
void patch(std::vector<unsigned char>& bytes, std::size_t at, std::uint32_t value) {
    for (std::size_t k = 0; k < 4; ++k)
        bytes[at + k] = static_cast<unsigned char>(value >> (24 - 8 * k));
}

TEST(Png, GivesBackWhatWasWritten) {
    for (const int channels : {1, 3, 4}) {
        const Raster<unsigned char> pixels = noise({37, 23}, channels);
        const auto bytes = encodePng(pixels);
        ASSERT_TRUE(bytes.ok());
        const auto read = readImage(*bytes);
        ASSERT_TRUE(read.ok()) << read.status().message();
        ASSERT_EQ(read->size(), pixels.size());
        for (int y = 0; y < 23; ++y)
            for (int x = 0; x < 37; ++x)
                for (int channel = 0; channel < 4; ++channel) {
                    const unsigned char expected = channel == 3 && channels < 4 ? 255
                                                   : channels == 1              ? pixels.at(x, y)
                                                                   : pixels.at(x, y, channel);
                    ASSERT_EQ(read->at(x, y, channel), expected);
                }
    }
}

TEST(Png, TextsTravelWholeWhateverTheirLength) {
    PngOptions options;
    for (const std::size_t length : {0u, 1u, 1023u, 1024u, 1025u, 70000u, 3000000u})
        options.texts.push_back({"text " + std::to_string(length), std::string(length, 'z')});
    std::string mixed;
    Random random(3);
    for (int i = 0; i < 40000; ++i) mixed += random.next() % 3 == 0 ? "ℍ" : "α";
    options.texts.push_back({"mixed", mixed});
    const auto bytes = encodePng(noise({2, 2}, 4), options);
    ASSERT_TRUE(bytes.ok());
    // The long texts are packed: 3 MB of one letter in far fewer bytes.
    EXPECT_LT(bytes->size(), 200000u);
    const auto texts = decodePngText(*bytes);
    ASSERT_TRUE(texts.ok()) << texts.status().message();
    EXPECT_EQ(*texts, options.texts);
}

// Where the chunk of a type is, or npos.
std::size_t chunkAt(const std::vector<unsigned char>& bytes, const char* type) {
    return std::string(bytes.begin(), bytes.end()).find(type);
}

TEST(Png, AsciiIsWrittenWhereEditorsKeepIt) {
    const Raster<unsigned char> dot({1, 1}, 3);
    const std::pair<std::string, const char*> texts[] = {{"{\"a\": 1}\n", "tEXt"},
                                                         {std::string(2000, 'a'), "tEXt"},
                                                         {std::string(100000, 'a'), "zTXt"},
                                                         {"{\"a\": \"\xc3\xa4\"}", "iTXt"}};
    for (const auto& [text, type] : texts) {
        const auto bytes = encodePng(dot, {.texts = {{"versorium", text}}});
        ASSERT_TRUE(bytes.ok());
        for (const char* other : {"tEXt", "zTXt", "iTXt"})
            EXPECT_EQ(chunkAt(*bytes, other) != std::string::npos, std::string(other) == type)
                << type;
        const auto read = decodePngText(*bytes);
        ASSERT_TRUE(read.ok()) << read.status().message();
        EXPECT_EQ(read->at(0).text, text);
    }
}

TEST(Png, TextsOfOtherProgramsAreLatin) {
    const Raster<unsigned char> dot({1, 1}, 3);
    auto bytes = *encodePng(dot, {.texts = {{"Author", "Zo.,"}}});
    const std::size_t at = chunkAt(bytes, "tEXt");
    bytes[at + 4 + 7 + 2] = 0xeb;  // e with two dots
    const auto data = std::span<const unsigned char>(bytes).subspan(at, 4 + 11);
    patch(bytes, at + 4 + 11, crc32(data));
    const auto texts = decodePngText(bytes);
    ASSERT_TRUE(texts.ok()) << texts.status().message();
    EXPECT_EQ(texts->at(0).text, "Zo\xc3\xab,");
}

TEST(Png, SameInputSameBytes) { EXPECT_EQ(small(), small()); }

TEST(Png, SaysItsResolution) {
    const auto bytes = small();
    const std::string text(bytes.begin(), bytes.end());
    const std::size_t at = text.find("pHYs");
    ASSERT_NE(at, std::string::npos);
    // 300 dots per inch are 300 / 0.0254 = 11811.02 per metre.
    EXPECT_EQ(bytes[at + 6] * 256 + bytes[at + 7], 11811);
    EXPECT_EQ(bytes[at + 12], 1);
    EXPECT_LT(text.find("IHDR"), text.find("sRGB"));
    EXPECT_LT(text.find("iTXt"), text.find("IDAT"));
}

TEST(Png, TornAnywhereIsRefused) {
    const auto whole = small();
    ASSERT_TRUE(decodePngText(whole).ok());
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const std::span<const unsigned char> part(whole.data(), length);
        const auto texts = decodePngText(part);
        ASSERT_FALSE(texts.ok()) << length;
        EXPECT_EQ(texts.status().kind(), ErrorKind::data);
        if (length > 0) {
            EXPECT_NE(texts.status().message().find("torn at byte " + std::to_string(length)),
                      std::string::npos);
        }
    }
}

TEST(Png, AnyWrongByteIsSeen) {
    const auto whole = small();
    for (std::size_t at = 0; at < whole.size(); ++at) {
        auto wrong = whole;
        wrong[at] ^= 0x40;
        EXPECT_FALSE(decodePngText(wrong).ok()) << at;
    }
    auto wrong = whole;
    wrong[40] ^= 1;  // inside sRGB, the first chunk after IHDR
    EXPECT_NE(decodePngText(wrong).status().message().find("CRC of the chunk at byte 33"),
              std::string::npos);
}

TEST(Png, LyingLengthsAreRefusedBeforeMemoryIsTaken) {
    for (const std::uint32_t lie : {0x7fffffffu, 0x80000000u, 0xffffffffu}) {
        auto bytes = small();
        patch(bytes, 33, lie);  // length of the chunk after IHDR
        EXPECT_FALSE(decodePngText(bytes).ok());
    }
}

TEST(Png, NotAPngIsSaid) {
    const std::string text = "GIF89a, as it happens";
    const std::span<const unsigned char> bytes(reinterpret_cast<const unsigned char*>(text.data()),
                                               text.size());
    EXPECT_EQ(decodePngText(bytes).status().message(), "not a PNG: the file begins otherwise");
    EXPECT_EQ(decodePngText({}).status().message(), "not a PNG: the file is empty");
}

TEST(Png, WhatNoPngCanCarryIsRefused) {
    const Raster<unsigned char> dot({1, 1}, 3);
    EXPECT_FALSE(encodePng(Raster<unsigned char>({0, 5}, 3)).ok());
    EXPECT_FALSE(encodePng(Raster<unsigned char>({1, 1}, 2)).ok());
    EXPECT_FALSE(encodePng(dot, {.texts = {{"", "x"}}}).ok());
    EXPECT_FALSE(encodePng(dot, {.texts = {{std::string(80, 'k'), "x"}}}).ok());
    EXPECT_FALSE(encodePng(dot, {.texts = {{"key", "\xff"}}}).ok());
}

}  // namespace
}  // namespace versorium
