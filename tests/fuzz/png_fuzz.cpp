// SPDX-License-Identifier: MIT
// PNGs with texts, and pictures. The checksums are put right first: a changed file would otherwise
// end at the first of them.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/hash.h"
#include "io/exif.h"
#include "io/image_files.h"
#include "io/png.h"

using namespace versorium;

namespace {

void rightChecksums(std::vector<unsigned char>& bytes) {
    std::size_t at = 8;
    while (at + 12 <= bytes.size()) {
        std::size_t length = 0;
        for (std::size_t k = 0; k < 4; ++k) length = length << 8 | bytes[at + k];
        if (length > bytes.size() - at - 12) return;
        const std::uint32_t sum = crc32(std::span(bytes).subspan(at + 4, length + 4));
        for (std::size_t k = 0; k < 4; ++k)
            bytes[at + 8 + length + k] = static_cast<unsigned char>(sum >> (24 - 8 * k));
        at += 12 + length;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    std::vector<unsigned char> bytes(data, data + size);
    rightChecksums(bytes);
    const Expected<std::vector<PngText>> texts = decodePngText(bytes);
    if (!texts && texts.status().message().empty()) __builtin_trap();
    (void)exifOrientation(bytes);
    const Expected<Raster<unsigned char>> image = readImage(bytes);
    if (!image) return 0;
    if (image->channels() != 4) __builtin_trap();
    (void)shapeMask(*image, {.threshold = 0.5, .byAlpha = true});
    if (texts && image->values().size() < 1000000 &&
        !encodePng(*image, {.dotsPerInch = 300, .texts = *texts}))
        __builtin_trap();
    return 0;
}
