// SPDX-License-Identifier: MIT
#include "render/root_region.h"

#include <algorithm>

#include "shape/bounds.h"

namespace versorium {

void takeShapeBox(const Scene& scene, const DistanceField& field, RandomRoots& roots) {
    const bool planar = mapOf(scene).info.algebra == Algebra::complex;
    const ShapeBounds bounds = boundsOf(field, planar ? 2 : 3);
    int dropped = 3;
    if (const auto drop = scene.parameters.find("drop"); drop != scene.parameters.end())
        dropped = static_cast<int>(std::clamp(drop->second[0], 0.0, 3.0));
    roots.centre.fill(0);
    roots.half.fill(0);
    std::size_t next = 0;
    for (int k = 0; k < (planar ? 2 : 4); ++k) {
        if (k == dropped) continue;
        const auto at = static_cast<std::size_t>(k);
        roots.centre[at] = 0.5 * (bounds.low[next] + bounds.high[next]);
        roots.half[at] = 0.5 * (bounds.high[next] - bounds.low[next]);
        ++next;
    }
}

}  // namespace versorium
