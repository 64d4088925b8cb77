// SPDX-License-Identifier: MIT
#pragma once
// The signed distance of a shape given as pixels, negative inside, by the exact Euclidean distance
// transform: lower envelopes of parabolas along the columns and then along the rows (Felzenszwalb
// and Huttenlocher 2012), in time proportional to the number of pixels.
//
// The shape's boundary is taken to lie halfway between neighbouring pixel centres of which one is
// inside and the other is not: the value at a pixel's centre is the distance to the nearest centre
// of the other kind, less half a pixel. It is exact for straight edges along the axes, and to half
// a pixel elsewhere; neighbouring pixels across the boundary have ±½.

#include "base/status.h"
#include "geometry/grid.h"
#include "image/raster.h"
#include "jobs/job.h"

namespace versorium {

// The mask's first channel: inside where it is not 0. The grid's nodes are the pixel centres, its
// first row the picture's lowest one; lengths are such that the longer side of the whole picture,
// with the pixels' outer halves, goes from -½ to ½. A mask that is all inside or all outside has no
// boundary and is refused, and so is one of fewer than two pixels on a side.
Expected<Grid> imageDistance(const Raster<unsigned char>& mask, Job& job);

}  // namespace versorium
