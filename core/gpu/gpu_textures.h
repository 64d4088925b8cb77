// SPDX-License-Identifier: MIT
#pragma once
// Textures that are read texel by texel, and frames to draw into them.

#include <initializer_list>

#include "gpu/gpu_device.h"
#include "image/raster.h"

namespace versorium::gpu {

// Bound to unit 0; the nearest texel, and nothing beyond the edge.
GLuint makeTexture(GLenum kind);
GLuint makeTarget(GLenum format, Size size);
// `complete` stays false once a frame cannot be drawn into.
GLuint makeFrame(std::initializer_list<GLuint> textures, bool& complete);
// Texels lie without gaps in memory, whatever the context was used for before.
void plainUnpacking();

}  // namespace versorium::gpu
