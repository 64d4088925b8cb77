// SPDX-License-Identifier: MIT
#pragma once
// PNG (ISO/IEC 15948) in memory: pictures out with their resolution and with texts that carry the
// state which made them, and these texts in (pictures: io/image_files.h). The same picture and
// texts always give the same bytes. What is read is foreign: every length is checked before
// anything is allocated.

#include <span>
#include <string>
#include <vector>

#include "base/status.h"
#include "image/raster.h"

namespace versorium {

// A text that travels inside a picture: as a tEXt chunk where it is ASCII (zTXt from 64 KiB on),
// since image editors keep these, and as iTXt elsewhere.
struct PngText {
    std::string keyword;  // 1 to 79 printable ASCII characters, no space at either end
    std::string text;     // UTF-8 without zero bytes
    friend bool operator==(const PngText&, const PngText&) = default;
};

struct PngOptions {
    double dotsPerInch = 0;  // 0: the file does not say how large it is
    std::vector<PngText> texts;
};

// No more than this many bytes are ever unpacked from, or packed into, one text.
inline constexpr std::size_t kPngTextLimit = std::size_t{64} << 20;
// Bytes of samples of a picture that is written (the encoder counts in 32 bits).
inline constexpr long long kPngByteLimit = 1LL << 29;

// The file's bytes. Samples are sRGB, 8 bits, grey, RGB or RGBA with straight alpha (1, 3 or 4
// channels). Fails with ErrorKind::usage on a size or a text that no PNG can carry.
Expected<std::vector<unsigned char>> encodePng(const Raster<unsigned char>& pixels,
                                               const PngOptions& options = {});

// All texts in the order of the file, of tEXt, zTXt and iTXt chunks. Every CRC is checked. Fails
// with ErrorKind::data.
Expected<std::vector<PngText>> decodePngText(std::span<const unsigned char> bytes);

}  // namespace versorium
