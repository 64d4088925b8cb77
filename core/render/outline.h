// SPDX-License-Identifier: MIT
#pragma once
// The boundary of a set as a line of a given width (S5: "outlined in white").

#include "colour/srgb.h"
#include "image/raster.h"

namespace versorium {

// `sides` says for every sample whether it is in the set; there are perSide samples along each side
// of a pixel of `picture` (linear, straight alpha). The line runs where neighbours differ and is
// `width` pixels wide, however many samples there are.
void drawOutline(const Raster<unsigned char>& sides, int perSide, double width,
                 const Colour& colour, Raster<float>& picture);

}  // namespace versorium
