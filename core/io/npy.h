// SPDX-License-Identifier: MIT
#pragma once
// Rasters as NumPy's .npy files (format 1.0): little-endian float64 in C order, shape (height,
// width) or (height, width, channels), the top row first.

#include <vector>

#include "image/raster.h"

namespace versorium {

std::vector<unsigned char> writeNpy(const Raster<double>& raster);

}  // namespace versorium
