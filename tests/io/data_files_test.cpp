// SPDX-License-Identifier: MIT
// Grids, roots and pictures as files.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "base/hash.h"
#include "base/random.h"
#include "io/byte_reader.h"
#include "io/grid_files.h"
#include "io/image_files.h"
#include "io/root_files.h"

namespace versorium {
namespace {

using Bytes = std::vector<unsigned char>;

Grid sampleGridOf(glm::ivec3 resolution) {
    Random random(4);
    Grid grid;
    grid.resolution = resolution;
    grid.values.resize(static_cast<std::size_t>(resolution.x * resolution.y * resolution.z));
    for (double& value : grid.values) value = random.uniform(-1, 1);
    return grid;
}

TEST(GridFiles, RoundTrip) {
    const Grid grid = sampleGridOf({3, 4, 5});
    for (const bool zFastest : {false, true}) {
        const Expected<Grid> read = readGrid(writeGrid(grid, {zFastest}), {zFastest});
        ASSERT_TRUE(read.ok()) << read.status().message();
        EXPECT_EQ(read->resolution, grid.resolution);
        EXPECT_EQ(read->values, grid.values);
    }
}

TEST(GridFiles, LayoutIsTheAuthors) {
    const Grid grid = sampleGridOf({3, 4, 5});
    const Bytes bytes = writeGrid(grid);
    ASSERT_EQ(bytes.size(), 12u + 48u + 8u * 60u);
    ByteReader reader(bytes);
    EXPECT_EQ(reader.read<std::int32_t>(), 3);
    EXPECT_EQ(reader.read<std::int32_t>(), 4);
    EXPECT_EQ(reader.read<std::int32_t>(), 5);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(reader.read<double>(), 0);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(reader.read<double>(), 1);
    EXPECT_EQ(reader.read<double>(), grid.at(0, 0, 0));
    EXPECT_EQ(reader.read<double>(), grid.at(1, 0, 0));
    // The other order is a mirror image: x and z change places.
    const Expected<Grid> mirrored = readGrid(bytes, {.zFastest = true});
    ASSERT_TRUE(mirrored.ok());
    EXPECT_EQ(mirrored->at(0, 0, 1), grid.at(1, 0, 0));
}

TEST(GridFiles, TheBoxOfASpatialGridIsTheUnitCube) {
    Grid grid = sampleGridOf({2, 2, 2});
    grid.minimum = glm::dvec3(-7);
    grid.maximum = glm::dvec3(11);
    const Expected<Grid> read = readGrid(writeGrid(grid));
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->minimum, glm::dvec3(-0.5));
    EXPECT_EQ(read->maximum, glm::dvec3(0.5));
    EXPECT_EQ(read->values, grid.values);
}

TEST(GridFiles, PlanarGridsKeepTheirBox) {
    Grid grid = sampleGridOf({6, 5, 1});
    grid.minimum = {-2, 1, 0};
    grid.maximum = {4, 2, 0};
    const Expected<Grid> read = readGrid(writeGrid(grid));
    ASSERT_TRUE(read.ok()) << read.status().message();
    EXPECT_TRUE(read->planar());
    EXPECT_EQ(read->minimum, grid.minimum);
    EXPECT_EQ(read->maximum, grid.maximum);
    EXPECT_EQ(read->values, grid.values);
}

TEST(GridFiles, LyingHeadersAreRefused) {
    const Bytes good = writeGrid(sampleGridOf({3, 4, 5}));
    const std::int32_t lies[] = {2147483647, -2147483647 - 1, -1, 0, 1, 4, 1 << 20, 1290};
    for (const std::int32_t lie : lies)
        for (unsigned mask = 1; mask < 8; ++mask) {
            Bytes bytes = good;
            for (unsigned axis = 0; axis < 3; ++axis)
                if ((mask >> axis & 1) != 0 && !(lie == 4 && axis == 1))
                    std::memcpy(bytes.data() + 4 * axis, &lie, 4);
            if (bytes == good) continue;
            EXPECT_FALSE(readGrid(bytes).ok()) << lie << " " << mask;
        }
    for (std::size_t size = 0; size < good.size(); ++size)
        EXPECT_FALSE(readGrid(std::span(good).first(size)).ok()) << size;
    Bytes longer = good;
    longer.push_back(0);
    EXPECT_FALSE(readGrid(longer).ok());
}

TEST(GridFiles, ValuesMustBeFinite) {
    Grid grid = sampleGridOf({2, 2, 2});
    grid.values[6] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(readGrid(writeGrid(grid)).status().message(),
              "value 7 of 8 of the grid is not a finite number");
}

RootList sampleRoots() {
    RootList list;
    list.roots = {{{0.1, -0.2, 0.3, 0}, 4}, {{0, 1, 0, 0}, 2.5}, {{-0.5, 0, 0, 0.25}, -1}};
    list.scale = 0.5;
    return list;
}

TEST(RootFiles, RoundTrips) {
    const RootList list = sampleRoots();
    const Expected<RootList> binary = readRoots(writeRootsBinary(list));
    ASSERT_TRUE(binary.ok()) << binary.status().message();
    EXPECT_EQ(*binary, list);
    const std::string text = " \n" + writeRootsJson(list);
    const std::string marked = "\xef\xbb\xbf\r\n" + std::string(text);
    EXPECT_TRUE(readRoots(Bytes(marked.begin(), marked.end())).ok());
    const Expected<RootList> json = readRoots(Bytes(text.begin(), text.end()));
    ASSERT_TRUE(json.ok()) << json.status().message();
    EXPECT_EQ(*json, list);
    // 123 is the code of the brace that begins a JSON text.
    RootList many;
    many.roots.resize(123);
    EXPECT_TRUE(readRoots(writeRootsBinary(many)).ok());
}

// The polynomial of the roots i and -i is q² + 1; its derivatives are 2q and 2.
TEST(RootFiles, WritesTheCoefficients) {
    RootList list;
    list.roots = {{{0, 1, 0, 0}, 1}, {{0, -1, 0, 0}, 7}};
    const Bytes bytes = writeRootsBinary(list);
    ByteReader reader(bytes);
    const double expected[] = {1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0};
    EXPECT_EQ(reader.read<std::int32_t>(), 2);
    EXPECT_EQ(reader.read<std::int32_t>(), 3);
    for (double value : expected) EXPECT_EQ(reader.read<double>(), value);
    EXPECT_EQ(reader.read<std::int32_t>(), 2);
    EXPECT_EQ(reader.read<double>(), 0);
    reader.skip(24);
    EXPECT_EQ(reader.read<double>(), 2);
    reader.skip(24);
    EXPECT_EQ(reader.read<std::int32_t>(), 1);
    EXPECT_EQ(reader.read<double>(), 2);
}

TEST(RootFiles, JsonDefaultsAndFaults) {
    const Expected<RootList> list =
        readRootsJson(R"({"roots":[{"q":[1,2]},{"q":[0,0,0,1],"power":3}]})");
    ASSERT_TRUE(list.ok()) << list.status().message();
    EXPECT_EQ(list->roots[0].q, (std::array<double, 4>{1, 2, 0, 0}));
    EXPECT_EQ(list->roots[0].power, 1);
    EXPECT_EQ(list->scale, 1);
    const auto faultOf = [](const char* text) {
        const Expected<RootList> read = readRootsJson(text);
        return read.ok() ? std::string() : read.status().message();
    };
    EXPECT_NE(faultOf(R"({"roots":[{"q":[1,2,3,4,5]}]})").find("roots[0].q"), std::string::npos);
    EXPECT_NE(faultOf(R"({"roots":[{"q":[1]},{"power":1}]})").find("roots[1].q"),
              std::string::npos);
    EXPECT_NE(faultOf(R"({"roots":[]})"), "");
    EXPECT_NE(faultOf(R"({"root":[]})"), "");
    EXPECT_NE(faultOf(R"({"roots":[3]})"), "");
    EXPECT_NE(faultOf("[]"), "");
    EXPECT_NE(faultOf(R"({"roots":[{"q":[1e200]}]})"), "");
}

TEST(RootFiles, LyingCountsAreRefused) {
    const Bytes good = writeRootsBinary(sampleRoots());
    // Each int32 of the file: n, the four blocks' counts, the powers' count.
    std::vector<std::size_t> places = {0, 4};
    for (std::size_t items : {4u, 3u, 2u, 3u}) places.push_back(places.back() + 4 + 32 * items);
    for (const std::size_t place : places)
        for (const std::int32_t lie :
             {2147483647, -2147483647 - 1, -1, 0, 7, 1000000, 67108864, 134217728}) {
            Bytes bytes = good;
            std::memcpy(bytes.data() + place, &lie, 4);
            EXPECT_FALSE(readRoots(bytes).ok()) << place << " " << lie;
        }
    for (std::size_t size = 0; size < good.size(); ++size)
        EXPECT_FALSE(readRoots(std::span(good).first(size)).ok()) << size;
}

// A PNG whose pixels stand in stored deflate blocks, as RFC 1950, 1951 and the PNG text say.
Bytes pngOf(std::uint32_t width, std::uint32_t height, const Bytes& rows) {
    const auto big = [](Bytes& bytes, std::uint32_t value) {
        for (int shift = 24; shift >= 0; shift -= 8)
            bytes.push_back(static_cast<unsigned char>(value >> shift));
    };
    Bytes png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    const auto chunk = [&](const char* type, const Bytes& data) {
        big(png, static_cast<std::uint32_t>(data.size()));
        const std::size_t start = png.size();
        png.insert(png.end(), type, type + 4);
        png.insert(png.end(), data.begin(), data.end());
        big(png, crc32(std::span(png).subspan(start)));
    };
    Bytes header;
    big(header, width);
    big(header, height);
    header.insert(header.end(), {8, 6, 0, 0, 0});
    chunk("IHDR", header);
    const auto length = static_cast<unsigned>(rows.size());
    Bytes data = {0x78,
                  0x01,
                  1,
                  static_cast<unsigned char>(length & 255),
                  static_cast<unsigned char>(length >> 8),
                  static_cast<unsigned char>(~length & 255),
                  static_cast<unsigned char>(~length >> 8 & 255)};
    data.insert(data.end(), rows.begin(), rows.end());
    std::uint32_t a = 1, b = 0;
    for (unsigned char byte : rows) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    big(data, b << 16 | a);
    chunk("IDAT", data);
    chunk("IEND", {});
    return png;
}

TEST(ImageFiles, ReadsPngAndThresholdsIt) {
    // Black, white, white without opacity; then grey 100, grey 200, black half opaque.
    const Bytes rows = {0, 0,   0,   0,   255, 255, 255, 255, 255, 0, 0, 0, 0,
                        0, 100, 100, 100, 255, 200, 200, 200, 255, 0, 0, 0, 120};
    const Expected<Raster<unsigned char>> image = readImage(pngOf(3, 2, rows));
    ASSERT_TRUE(image.ok()) << image.status().message();
    EXPECT_EQ(image->size(), (Size{3, 2}));
    EXPECT_EQ(image->channels(), 4);
    EXPECT_EQ(image->at(0, 1, 2), 100);
    EXPECT_EQ(image->at(2, 1, 3), 120);
    EXPECT_EQ(shapeMask(*image).values(), (Bytes{1, 0, 0, 1, 0, 0}));
    EXPECT_EQ(shapeMask(*image, {.invert = true}).values(), (Bytes{0, 1, 1, 0, 1, 1}));
    EXPECT_EQ(shapeMask(*image, {.threshold = 0.9}).values(), (Bytes{1, 0, 0, 1, 1, 1}));
}

TEST(ImageFiles, SizesAreCheckedBeforeDecoding) {
    const Bytes rows = {0, 0, 0, 0, 255};
    for (std::uint32_t side : {0u, 32769u, 65536u, 0x7fffffffu, 0xffffffffu})
        for (const bool wide : {false, true})
            EXPECT_FALSE(readImage(pngOf(wide ? side : 1, wide ? 1 : side, rows)).ok()) << side;
    EXPECT_FALSE(readImage(pngOf(16384, 16384, rows)).ok());
    EXPECT_FALSE(readImage({}).ok());
    EXPECT_FALSE(readImage(Bytes{'h', 'e', 'l', 'l', 'o'}).ok());
    Bytes torn = pngOf(1, 1, rows);
    torn.resize(torn.size() - 30);
    EXPECT_FALSE(readImage(torn).ok());
}

TEST(PackedGrid, ComesBackWithItsBox) {
    Grid grid;
    grid.resolution = {2, 3, 1};
    grid.minimum = {-1, 0, 0.5};
    grid.maximum = {1, 2, 0.5};
    grid.values = {1, -2, 0.25, 4, 1e-300, -0.0};
    std::vector<unsigned char> bytes = packGrid(grid);
    EXPECT_EQ(bytes.size() % 4, 0u);
    const Expected<Grid> again = unpackGrid(bytes);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->values, grid.values);
    EXPECT_EQ(again->resolution, grid.resolution);
    EXPECT_EQ(again->minimum, grid.minimum);
    EXPECT_EQ(again->maximum, grid.maximum);
    bytes.pop_back();
    EXPECT_FALSE(unpackGrid(bytes));
    for (std::size_t k = 0; k < 12; ++k) bytes[k] = 0xff;
    EXPECT_FALSE(unpackGrid(bytes));
}

}  // namespace
}  // namespace versorium
