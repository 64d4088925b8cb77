// SPDX-License-Identifier: MIT
#include "ui/session/motion.h"

#include <algorithm>

#include "scene/zoom_path.h"
#include "workspace/workspace.h"

namespace versorium {

SliceSpec between(const SliceSpec& from, const SliceSpec& to, double t) {
    if (t >= 1 || from.axes != to.axes || from.centre.size() != to.centre.size()) return to;
    const double eased = t <= 0 ? 0 : t * t * (3 - 2 * t);
    SliceSpec place = to;
    place.height = heightOnTheWay(from.height, to.height, eased);
    const double part = centreOnTheWay(from.height, to.height, eased);
    for (std::size_t k = 0; k < to.centre.size(); ++k) {
        place.centre[k] = from.centre[k] + (to.centre[k] - from.centre[k]) * part;
        place.centreLow[k] = from.centreLow[k] + (to.centreLow[k] - from.centreLow[k]) * part;
    }
    return place;
}

SliceSpec zoomed(const SliceSpec& slice, double factor, double u, double v) {
    SliceSpec place = slice;
    place.height = std::clamp(slice.height * factor, kLeastHeight, kMostHeight);
    const double real = place.height / slice.height;
    const double at[2] = {u, v};
    for (std::size_t k = 0; k < 2 && k < place.centre.size(); ++k)
        place.centre[k] = at[k] + (slice.centre[k] - at[k]) * real;
    return place;
}

SliceSpec shifted(const SliceSpec& slice, double u, double v) {
    SliceSpec place = slice;
    const double by[2] = {u, v};
    for (std::size_t k = 0; k < 2 && k < place.centre.size(); ++k) place.centre[k] += by[k];
    return place;
}

}  // namespace versorium
