// SPDX-License-Identifier: MIT
#pragma once
// Which way up a photograph is shown. Cameras store the sensor's rows and say in the Exif block
// (JEITA CP-3451) how they are to be turned; everybody who shows the picture turns it.

#include <span>

#include "image/raster.h"

namespace versorium {

// The orientation of a JPEG's APP1 or a PNG's eXIf block: 1 to 8, where 1 is as stored; 1 also
// where there is none or none that can be read.
int exifOrientation(std::span<const unsigned char> bytes);

// The picture as it is shown.
Raster<unsigned char> upright(Raster<unsigned char> stored, int orientation);

}  // namespace versorium
