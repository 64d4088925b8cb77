// SPDX-License-Identifier: MIT
#include "render/root_region.h"

#include "scene/shape_controls.h"
#include "shape/bounds.h"

namespace versorium {

void takeShapeBox(const Scene& scene, const DistanceField& field, RandomRoots& roots) {
    const bool planar = mapOf(scene).info.algebra == Algebra::complex;
    const ShapeBounds bounds = boundsOf(field, planar ? 2 : 3);
    const ShapeControls controls = shapeControls(scene);
    roots.centre.fill(0);
    roots.half.fill(0);
    for (std::size_t k = 0; k < (planar ? 2 : 3); ++k) {
        const auto at = static_cast<std::size_t>(controls.seen[k]);
        roots.centre[at] = 0.5 * (bounds.low[k] + bounds.high[k]);
        roots.half[at] = 0.5 * (bounds.high[k] - bounds.low[k]);
    }
}

}  // namespace versorium
