// SPDX-License-Identifier: MIT
#pragma once
// A picture before it is a file: how it is computed, in what it is held, and which sizes it may
// have.

#include <vector>

#include "fields/field_names.h"
#include "image/raster.h"
#include "maps/orbit_batch.h"
#include "scene/scene.h"

namespace versorium {

struct RenderOptions {
    Flavour flavour = Flavour::exact;
    bool shortcuts = true;
    double lineWidth = 1;  // in pixels: of outlines of width 1
    // Measured beside what the picture needs, where fields are kept (CpuRenderer::keepFields).
    std::vector<FieldName> also = {};
};

// Linear light, straight alpha, four channels.
struct Frame {
    Raster<float> colour;
};

inline constexpr int kMostPixels = 32768;                  // along a side
inline constexpr long long kMostSamplesInAll = 1LL << 28;  // pixels times samples

// ErrorKind::usage for a size that makes no sense.
Status checkSize(const Scene& scene, Size size);

}  // namespace versorium
