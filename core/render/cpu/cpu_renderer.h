// SPDX-License-Identifier: MIT
#pragma once
// Turns scenes into pictures and fields on the processor: threads, tiles, cancel and progress. The
// values never depend on threads or on how the picture is split.

#include "fields/evaluate.h"
#include "render/bind.h"
#include "render/cpu/averaged_map.h"
#include "render/frame.h"
#include "render/layers.h"

namespace versorium {

class CpuRenderer {
  public:
    Status render(const Scene& scene, Size size, const RenderOptions& options, Job& job,
                  Frame& frame);
    // From now on pictures of this map's scene and size, in whatever colours, show the members that
    // it has counted instead of counting all; so do measurements where a pixel has one sample.
    // Null: no longer.
    void useAveraged(std::shared_ptr<const AveragedMap> averaged) {
        averaged_ = std::move(averaged);
    }

    // Fields at pixel centres as numbers, one raster each, channels side by side.
    Status measure(const Scene& scene, Size size, const std::vector<FieldName>& fields,
                   const RenderOptions& options, Job& job, std::vector<Raster<double>>& rasters);

    // Fields at given points: each point has up to four numbers, which take the place of the first
    // components of the start (the rest keep the scene's). rows[i] are the values of point i.
    Status measureAt(const Scene& scene, const std::vector<std::vector<double>>& points,
                     const std::vector<FieldName>& fields, const RenderOptions& options, Job& job,
                     std::vector<std::vector<double>>& rows);

    Binder& binder() { return binder_; }

  private:
    const AveragedMap* averagedOf(const Scene& scene, Size size) const;

    std::shared_ptr<const AveragedMap> averaged_;
    Binder binder_;
    LayerImages layerImages_;
};

}  // namespace versorium
