// SPDX-License-Identifier: MIT
#pragma once
// Turns scenes into pictures and fields. The values never depend on threads or on how the picture
// is split.

#include <string>
#include <vector>

#include "fields/field_names.h"
#include "image/raster.h"
#include "jobs/job.h"
#include "maps/orbit_batch.h"
#include "scene/scene.h"

namespace versorium {

struct RenderOptions {
    Flavour flavour = Flavour::exact;
    bool shortcuts = true;
    double lineWidth = 1;  // in pixels: of outlines of width 1
};

// Linear light, straight alpha, four channels.
struct Frame {
    Raster<float> colour;
};

inline constexpr int kMostPixels = 32768;                  // along a side
inline constexpr long long kMostSamplesInAll = 1LL << 28;  // pixels times samples

// ErrorKind::usage for a size that makes no sense.
Status checkSize(const Scene& scene, Size size);

class Renderer {
  public:
    virtual ~Renderer() = default;
    virtual Status render(const Scene& scene, Size size, const RenderOptions& options, Job& job,
                          Frame& frame) = 0;
};

}  // namespace versorium
