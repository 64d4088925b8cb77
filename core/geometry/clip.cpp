// SPDX-License-Identifier: MIT
#include "geometry/clip.h"

#include <algorithm>

namespace versorium {

std::optional<SegmentPart> clipSegment(const std::array<double, 2>& start,
                                       const std::array<double, 2>& finish,
                                       const std::array<double, 2>& low,
                                       const std::array<double, 2>& high) {
    SegmentPart part;
    const double dx = finish[0] - start[0], dy = finish[1] - start[1];
    const double p[4] = {-dx, dx, -dy, dy};
    const double q[4] = {start[0] - low[0], high[0] - start[0], start[1] - low[1],
                         high[1] - start[1]};
    for (int k = 0; k < 4; ++k) {
        if (p[k] == 0) {
            if (!(q[k] >= 0)) return std::nullopt;
        } else if (p[k] < 0) {
            part.from = std::max(part.from, q[k] / p[k]);
        } else {
            part.to = std::min(part.to, q[k] / p[k]);
        }
    }
    if (!(part.from <= part.to)) return std::nullopt;
    return part;
}

}  // namespace versorium
