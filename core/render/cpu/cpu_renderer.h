// SPDX-License-Identifier: MIT
#pragma once
// Turns scenes into pictures and fields on the CPU: threads, tiles, cancel and progress. The
// values never depend on threads or on how the picture is split.

#include "fields/evaluate.h"
#include "render/bind.h"
#include "render/colouring.h"
#include "render/cpu/averaged_map.h"
#include "render/cpu/kept_fields.h"
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

    // The same at coordinates along the axes of the scene's slice, one for each axis.
    Status measureAlong(const Scene& scene, const std::vector<std::vector<double>>& coordinates,
                        const std::vector<FieldName>& fields, const RenderOptions& options,
                        Job& job, std::vector<std::vector<double>>& rows);

    // From now on keeps up to so many bytes of what it measures for pictures: other colours of the
    // same orbits measure nothing, nor does `measure` where a pixel has one sample. The bytes of a
    // picture are the same as those of one that is measured.
    void keepFields(std::size_t bytes) { fields_.keepUpTo(bytes); }
    // How many pictures and rasters were measured so far.
    long long measurements() const { return measurements_; }
    // Whether the fields of the last picture are kept.
    bool keptLast() const { return keptLast_; }

    Binder& binder() { return binder_; }

  private:
    const AveragedMap* averagedOf(const Scene& scene, Size size) const;
    // Where a picture's fields come from: they are kept, or measured, and then perhaps kept.
    struct Source {
        std::shared_ptr<const FieldTiles> kept;
        std::vector<FieldName> fields;  // that are measured: the picture's and then others
        std::optional<FieldTiles> keeping;
    };
    Source sourceOf(const Scene& scene, Size size, const RenderOptions& options,
                    const ColourPass& pass, const OrbitProgram& program);

    std::shared_ptr<const AveragedMap> averaged_;
    Binder binder_;
    LayerImages layerImages_;
    KeptFields fields_;
    long long measurements_ = 0;
    bool keptLast_ = false;
};

}  // namespace versorium
