// SPDX-License-Identifier: MIT
#pragma once
// The renderer on the processor: threads, tiles, cancel and progress.

#include "fields/evaluate.h"
#include "render/bind.h"
#include "render/cpu/averaged_map.h"
#include "render/layers.h"
#include "render/renderer.h"

namespace versorium {

class CpuRenderer final : public Renderer {
  public:
    Status render(const Scene& scene, Size size, const RenderOptions& options, Job& job,
                  Frame& frame) override;
    // The same with the members of the scene's ensemble that were counted so far, for this scene and
    // size; colours and layers may differ.
    Status render(const Scene& scene, Size size, const AveragedMap& averaged,
                  const RenderOptions& options, Job& job, Frame& frame);

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
    Status draw(const Scene& scene, Size size, const AveragedMap* averaged,
                const RenderOptions& options, Job& job, Frame& frame);

    Binder binder_;
    LayerImages layerImages_;
};

}  // namespace versorium
