// SPDX-License-Identifier: MIT
#include "io/jpeg_segments.h"

#include <string>

namespace versorium {
namespace {

using JpegBytes = std::span<const unsigned char>;

constexpr unsigned char kStartOfImage = 0xd8, kEndOfImage = 0xd9, kHuffmanTables = 0xc4,
                        kStartOfScan = 0xda;

// Markers that stand alone: stuffing, restarts, and a start or "temporary" that says nothing here.
bool standsAlone(unsigned char marker) {
    return marker <= 0x01 || (marker >= 0xd0 && marker <= kStartOfImage);
}

// Sixteen counts of codes, and as many values as they say together.
Status checkTables(JpegBytes tables) {
    while (!tables.empty()) {
        std::size_t codes = 0;
        for (std::size_t k = 1; k <= 16 && k < tables.size(); ++k) codes += tables[k];
        if (tables.size() < 17 + codes || codes > 256)
            return Status::data("the picture is damaged: a Huffman table of the JPEG claims " +
                                std::to_string(codes) + " codes");
        tables = tables.subspan(17 + codes);
    }
    return {};
}

// Where the data of a scan that begins at `at` ends: at a marker that is neither stuffing nor a
// restart.
std::size_t endOfScan(JpegBytes bytes, std::size_t at) {
    for (; at + 1 < bytes.size(); ++at) {
        const unsigned char next = bytes[at + 1];
        if (bytes[at] == 0xff && next != 0 && !(next >= 0xd0 && next <= 0xd7)) return at;
    }
    return bytes.size();
}

}  // namespace

Expected<std::vector<unsigned char>> checkedJpeg(JpegBytes bytes) {
    std::vector<unsigned char> checked{0xff, kStartOfImage};
    checked.reserve(bytes.size());
    std::size_t at = 2;
    while (true) {
        while (at + 1 < bytes.size() && (bytes[at] != 0xff || bytes[at + 1] == 0xff)) ++at;
        if (at + 1 >= bytes.size()) return checked;
        const unsigned char marker = bytes[at + 1];
        at += 2;
        if (standsAlone(marker)) continue;
        if (marker == kEndOfImage) {
            checked.insert(checked.end(), {0xff, kEndOfImage});
            return checked;
        }
        if (bytes.size() - at < 2) return checked;
        const std::size_t length = static_cast<std::size_t>(bytes[at]) << 8 | bytes[at + 1];
        if (length < 2 || length > bytes.size() - at) return checked;
        if (marker == kHuffmanTables)
            if (Status status = checkTables(bytes.subspan(at + 2, length - 2)); !status.ok())
                return status;
        const std::size_t stop =
            marker == kStartOfScan ? endOfScan(bytes, at + length) : at + length;
        checked.insert(checked.end(), {0xff, marker});
        checked.insert(checked.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                       bytes.begin() + static_cast<std::ptrdiff_t>(stop));
        at = stop;
    }
}

}  // namespace versorium
