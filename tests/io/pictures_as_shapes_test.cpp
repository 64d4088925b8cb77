// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "io/byte_reader.h"
#include "io/exif.h"
#include "io/image_files.h"
#include "io/jpeg_segments.h"
#include "io/known_formats.h"
#include "io/shape_file_kind.h"

namespace versorium {
namespace {

// 3 wide, 2 high; each pixel its own value.
Raster<unsigned char> numbered() {
    Raster<unsigned char> image({3, 2}, 1);
    for (int k = 0; k < 6; ++k)
        image.values()[static_cast<std::size_t>(k)] = static_cast<unsigned char>(k);
    return image;
}

TEST(Exif, EightOrientationsShowOnePicture) {
    // What a camera stores so that turning it gives 0 1 2 / 3 4 5 (JEITA CP-3451: where the 0th
    // row and the 0th column of the stored picture are).
    const std::pair<Size, std::vector<unsigned char>> stored[] = {
        {{3, 2}, {0, 1, 2, 3, 4, 5}},  // top, left
        {{3, 2}, {2, 1, 0, 5, 4, 3}},  // top, right
        {{3, 2}, {5, 4, 3, 2, 1, 0}},  // bottom, right
        {{3, 2}, {3, 4, 5, 0, 1, 2}},  // bottom, left
        {{2, 3}, {0, 3, 1, 4, 2, 5}},  // left, top
        {{2, 3}, {2, 5, 1, 4, 0, 3}},  // right, top: the 0th row is the right side
        {{2, 3}, {5, 2, 4, 1, 3, 0}},  // right, bottom
        {{2, 3}, {3, 0, 4, 1, 5, 2}},  // left, bottom
    };
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const auto& [size, values] = stored[orientation - 1];
        Raster<unsigned char> image(size, 1);
        std::copy(values.begin(), values.end(), image.values().begin());
        const Raster<unsigned char> shown = upright(std::move(image), orientation);
        EXPECT_EQ(shown.size().width, 3) << orientation;
        EXPECT_EQ(shown.values(), numbered().values()) << orientation;
    }
    EXPECT_EQ(upright(numbered(), 0).values(), numbered().values());
    EXPECT_EQ(upright(numbered(), 9).values(), numbered().values());
}

std::vector<unsigned char> exifBlock(int orientation, bool big) {
    std::vector<unsigned char> bytes;
    const auto add = [&](auto value) {
        std::vector<unsigned char> raw;
        appendLittleEndian(raw, value);
        if (big) std::reverse(raw.begin(), raw.end());
        bytes.insert(bytes.end(), raw.begin(), raw.end());
    };
    bytes = big ? std::vector<unsigned char>{'M', 'M'} : std::vector<unsigned char>{'I', 'I'};
    add(std::uint16_t{42});
    add(std::uint32_t{8});
    add(std::uint16_t{2});
    for (const auto& [tag, value] : {std::pair<int, int>{0x0100, 7}, {0x0112, orientation}}) {
        add(static_cast<std::uint16_t>(tag));
        add(std::uint16_t{3});
        add(std::uint32_t{1});
        add(static_cast<std::uint16_t>(value));
        add(std::uint16_t{0});
    }
    return bytes;
}

TEST(Exif, IsFoundInJpegAndPngOfBothByteOrders) {
    for (const bool big : {false, true})
        for (int orientation = 0; orientation <= 9; ++orientation) {
            const int expected = orientation >= 1 && orientation <= 8 ? orientation : 1;
            const auto exif = exifBlock(orientation, big);
            std::vector<unsigned char> jpeg{0xff, 0xd8, 0xff, 0xe0, 0,   4,
                                            'x',  'y',  0xff, 0xff, 0xe1};
            const auto length = exif.size() + 8;
            jpeg.push_back(static_cast<unsigned char>(length >> 8));
            jpeg.push_back(static_cast<unsigned char>(length));
            for (const char c : {'E', 'x', 'i', 'f', '\0', '\0'})
                jpeg.push_back(static_cast<unsigned char>(c));
            jpeg.insert(jpeg.end(), exif.begin(), exif.end());
            EXPECT_EQ(exifOrientation(jpeg), expected);
            std::vector<unsigned char> png{0x89, 'P',  'N', 'G',
                                           '\r', '\n', 26,  '\n',
                                           0,    0,    0,   static_cast<unsigned char>(exif.size()),
                                           'e',  'X',  'I', 'f'};
            png.insert(png.end(), exif.begin(), exif.end());
            png.resize(png.size() + 4);
            EXPECT_EQ(exifOrientation(png), expected);
            // Cut anywhere it is a picture as stored, and nothing is read beyond its end.
            for (std::size_t cut = 0; cut < jpeg.size(); ++cut)
                (void)exifOrientation(std::span(jpeg).first(cut));
            for (std::size_t cut = 0; cut < png.size(); ++cut)
                (void)exifOrientation(std::span(png).first(cut));
            // A chunk that leaves no room for its checksum.
            png[11] = static_cast<unsigned char>(exif.size() + 1);
            png[12] = 'x';
            EXPECT_EQ(exifOrientation(png), 1);
        }
}

TEST(JpegSegments, FalseHuffmanTablesReachNoDecoder) {
    std::vector<unsigned char> jpeg{0xff, 0xd8, 0xff, 0xc4, 0, 19, 0};
    for (int k = 0; k < 16; ++k) jpeg.push_back(k == 3 ? 255 : 0);
    EXPECT_FALSE(checkedJpeg(jpeg).ok()) << "leaves its segment";
    jpeg[4] = 2;
    jpeg[5] = 19;
    jpeg[12] = 255;  // 510 codes, and the bytes are there
    jpeg.resize(600);
    EXPECT_FALSE(checkedJpeg(jpeg).ok());
    EXPECT_FALSE(readImage(jpeg).ok());
    jpeg.insert(jpeg.begin(), 40, 0xff);
    EXPECT_FALSE(readImage(jpeg).ok());
}

TEST(JpegSegments, AScanNeedsItsTables) {
    // One component with table 0 of each kind; the Huffman tables have one code, of one bit.
    const std::vector<unsigned char> frame{0xff, 0xc0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0};
    const std::vector<unsigned char> scan{0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0, 0x00, 0xff, 0xd9};
    const auto huffman = [](unsigned char kind) {
        std::vector<unsigned char> table{0xff, 0xc4, 0, 20, kind, 1};
        table.resize(22);
        return table;
    };
    std::vector<unsigned char> quant{0xff, 0xdb, 0, 67, 0};
    quant.resize(69, 1);
    for (int missing = 0; missing < 4; ++missing) {
        std::vector<unsigned char> jpeg{0xff, 0xd8};
        const auto add = [&](const std::vector<unsigned char>& part) {
            jpeg.insert(jpeg.end(), part.begin(), part.end());
        };
        if (missing != 1) add(quant);
        add(frame);
        if (missing != 2) add(huffman(0x00));
        if (missing != 3) add(huffman(0x10));
        add(scan);
        EXPECT_EQ(checkedJpeg(jpeg).ok(), missing == 0) << missing;
        EXPECT_EQ(readImage(jpeg).ok(), missing == 0) << missing;
    }
}

TEST(JpegSegments, WhatStandsBetweenThemIsDropped) {
    const std::vector<unsigned char> plain{0xff, 0xd8, 0xff, 0xe1, 0,    4,    'a',  'b',
                                           0xff, 0xda, 0,    6,    0,    0,    0,    0,
                                           0x12, 0xff, 0,    0xff, 0xd3, 0x34, 0xff, 0xd9};
    EXPECT_EQ(*checkedJpeg(plain), plain);
    std::vector<unsigned char> padded = plain;
    padded.insert(padded.begin() + 8, {'x', 0xff, 0xff});
    padded.push_back('y');
    EXPECT_EQ(*checkedJpeg(padded), plain);
    for (std::size_t cut = 2; cut < plain.size(); ++cut)
        EXPECT_TRUE(checkedJpeg(std::span(plain).first(cut)).ok());
}

TEST(ShapeMask, OpacityAndInversionMakeOutlinesOfLogos) {
    // White on a transparent ground, black on a transparent ground, black on white.
    Raster<unsigned char> image({4, 1}, 4);
    const unsigned char pixels[4][4] = {
        {255, 255, 255, 255}, {255, 255, 255, 0}, {0, 0, 0, 255}, {0, 0, 0, 0}};
    for (int x = 0; x < 4; ++x)
        for (int c = 0; c < 4; ++c) image.at(x, 0, c) = pixels[x][c];
    const auto maskOf = [&](const MaskOptions& options) {
        const auto mask = shapeMask(image, options);
        return std::vector<int>(mask.values().begin(), mask.values().end());
    };
    EXPECT_EQ(maskOf({}), (std::vector<int>{0, 0, 1, 0}));
    EXPECT_EQ(maskOf({.invert = true}), (std::vector<int>{1, 1, 0, 1}));
    EXPECT_EQ(maskOf({.byAlpha = true}), (std::vector<int>{1, 0, 1, 0}));
    EXPECT_EQ(maskOf({.invert = true, .byAlpha = true}), (std::vector<int>{0, 1, 0, 1}));
}

TEST(KnownFormats, NamesOfFilesWhateverTheirCase) {
    for (const char* name : {"wedge (1).obj", "WEDGE.OBJ", "a b.Stl", "M.PNG", "~/x.JPEG", "g.F3D",
                             "a(b,c).ply", "logo.gif", "x.SVG"})
        EXPECT_TRUE(namesShapeFile(name)) << name;
    for (const char* name : {"polygon(0, 0, 1, 0, 0, 1)", "sphere(0.35)", "bunny", ".obj", "obj",
                             "", "half_space(1, 0, 0, 0.5)"})
        EXPECT_FALSE(namesShapeFile(name)) << name;
}

TEST(KnownFormats, ContentDecidesWhatAShapeIsMadeOf) {
    const auto kindOf = [](std::string_view text, const char* name) {
        return shapeFileKindOf({reinterpret_cast<const unsigned char*>(text.data()), text.size()},
                               name);
    };
    EXPECT_EQ(kindOf("\xff\xd8\xff\xe1", "a.obj"), ShapeFileKind::picture);
    EXPECT_EQ(kindOf("v 0 0 0\n", "a.png"), ShapeFileKind::mesh);
    EXPECT_EQ(kindOf("solid\nfacet\n", "a.f3d"), ShapeFileKind::mesh);
    EXPECT_EQ(kindOf("BM and more words than a header", "a.obj"), ShapeFileKind::mesh);
    std::vector<unsigned char> grid;
    for (const int n : {2, 2}) appendLittleEndian(grid, n);
    for (int k = 0; k < 8; ++k) appendLittleEndian(grid, 1.0);
    EXPECT_EQ(shapeFileKindOf(grid, "a.png"), ShapeFileKind::grid);
}

}  // namespace
}  // namespace versorium
