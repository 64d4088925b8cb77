// SPDX-License-Identifier: MIT
#pragma once
// The few functions of stb_image and stb_image_write that png.cpp needs, kept in one source so that
// their macros and warnings stay there. Allocation is capped: a stream that would unpack to more
// than kInflateLimit fails instead.

#include <cstddef>
#include <span>
#include <vector>

#include "image/raster.h"

namespace versorium::stb {

inline constexpr std::size_t kInflateLimit = std::size_t{512} << 20;

// A whole PNG file; empty when memory ran out.
std::vector<unsigned char> writePng(const Raster<unsigned char>& pixels);
// A zlib stream; empty when memory ran out.
std::vector<unsigned char> deflate(std::span<const unsigned char> bytes);
// Unpacks into `out` and returns how many bytes were written, or -1 when the stream is torn or
// holds more.
int inflate(std::span<const unsigned char> bytes, std::span<unsigned char> out);

}  // namespace versorium::stb
