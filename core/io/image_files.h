// SPDX-License-Identifier: MIT
#pragma once
// Pictures read from PNG, JPEG and BMP bytes, and pictures taken as shapes. The size is read and
// capped before anything is decoded.

#include <cstddef>
#include <span>

#include "base/status.h"
#include "image/raster.h"

namespace versorium {

inline constexpr std::size_t kImagePixels = std::size_t{64} << 20;
inline constexpr int kImageSide = 32768;

// Four channels, red, green, blue, alpha, as they stand in the file (not multiplied by alpha).
Expected<Raster<unsigned char>> readImage(std::span<const unsigned char> bytes);

struct MaskOptions {
    // A pixel is inside where its lightness, laid on white by its alpha, is below this share of
    // white: a dark figure on light paper.
    double threshold = 0.5;
    bool invert = false;   // a light figure on dark ground
    bool byAlpha = false;  // inside is what is opaque: its alpha is at least the threshold
};

// One channel: 1 inside, 0 outside. Lightness is 0.2126 R + 0.7152 G + 0.0722 B of the sRGB values.
Raster<unsigned char> shapeMask(const Raster<unsigned char>& image,
                                const MaskOptions& options = {});

}  // namespace versorium
