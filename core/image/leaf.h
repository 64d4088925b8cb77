// SPDX-License-Identifier: MIT
#pragma once
// A leaf, drawn by the program: a picture to lay behind fractals (A Fig 3) that needs no file.

#include "image/raster.h"

namespace versorium {

// `side` x `side` pixels, at least 16; four channels: linear light, straight alpha, transparent
// beside the leaf. The leaf stands upright and fills the height.
Raster<float> leafImage(int side);

}  // namespace versorium
