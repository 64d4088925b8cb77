// SPDX-License-Identifier: MIT
#include "io/exif.h"

#include <cstdint>

#include "io/byte_reader.h"
#include "io/known_formats.h"
#include "io/text_scanner.h"

namespace versorium {
namespace {

using ExifBytes = std::span<const unsigned char>;

constexpr int kStored = 1;
constexpr std::uint16_t kOrientationTag = 0x0112, kShort = 3;

// Of a TIFF header and its first directory.
int orientationOfTiff(ExifBytes tiff) {
    const std::string_view start = textOf(tiff).substr(0, 2);
    if (start != "II" && start != "MM") return kStored;
    const bool big = start == "MM";
    ByteReader reader(tiff, big);
    reader.skip(4);
    const auto offset = reader.read<std::uint32_t>();
    if (reader.failed() || offset > tiff.size()) return kStored;
    ByteReader directory(tiff.subspan(offset), big);
    const int entries = directory.read<std::uint16_t>();
    for (int k = 0; k < entries && !directory.failed(); ++k) {
        const auto tag = directory.read<std::uint16_t>(), type = directory.read<std::uint16_t>();
        directory.skip(4);
        const int value = directory.read<std::uint16_t>();
        directory.skip(2);
        if (tag != kOrientationTag || directory.failed()) continue;
        return type == kShort && value >= 1 && value <= 8 ? value : kStored;
    }
    return kStored;
}

// The first block of the picture whose marker is `wanted`: FF, marker, a length that counts itself.
int orientationOfJpeg(ExifBytes bytes) {
    constexpr std::string_view kExif("Exif\0\0", 6);
    std::size_t at = 2;
    while (at + 4 <= bytes.size() && bytes[at] == 0xff) {
        const unsigned char marker = bytes[at + 1];
        if (marker == 0xff) {  // fills up
            ++at;
            continue;
        }
        if (marker == 0xda || marker == 0xd9) break;  // the picture's data, or its end
        const std::size_t length = static_cast<std::size_t>(bytes[at + 2]) << 8 | bytes[at + 3];
        if (length < 2 || length > bytes.size() - at - 2) break;
        const ExifBytes block = bytes.subspan(at + 4, length - 2);
        if (marker == 0xe1 && textOf(block).starts_with(kExif))
            return orientationOfTiff(block.subspan(kExif.size()));
        at += 2 + length;
    }
    return kStored;
}

int orientationOfPng(ExifBytes bytes) {
    ByteReader reader(bytes, true);
    reader.skip(8);
    while (!reader.failed() && reader.remaining() >= 12) {
        const auto length = reader.read<std::uint32_t>();
        const std::string_view type = textOf(bytes).substr(reader.position(), 4);
        reader.skip(4);
        if (length > reader.remaining() || type == "IEND") break;
        if (type == "eXIf") return orientationOfTiff(bytes.subspan(reader.position(), length));
        reader.skip(std::size_t{length} + 4);
    }
    return kStored;
}

}  // namespace

int exifOrientation(ExifBytes bytes) {
    if (isPng(bytes)) return orientationOfPng(bytes);
    return textOf(bytes).starts_with("\xff\xd8") ? orientationOfJpeg(bytes) : kStored;
}

Raster<unsigned char> upright(Raster<unsigned char> stored, int orientation) {
    if (orientation <= 1 || orientation > 8) return stored;
    const int width = stored.width(), height = stored.height();
    // 5 to 8 change rows and columns; 2, 3, 7 and 8 run along what is then a row from its end; 3,
    // 4, 6 and 7 along a column.
    const bool across = orientation >= 5;
    const Size size = across ? Size{height, width} : Size{width, height};
    Raster<unsigned char> shown(size, stored.channels());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            int column = across ? y : x, row = across ? x : y;
            if (orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8)
                column = width - 1 - column;
            if (orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7)
                row = height - 1 - row;
            for (int c = 0; c < stored.channels(); ++c)
                shown.at(x, y, c) = stored.at(column, row, c);
        }
    return shown;
}

}  // namespace versorium
