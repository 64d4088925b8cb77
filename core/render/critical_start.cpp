// SPDX-License-Identifier: MIT
#include "render/critical_start.h"

#include <algorithm>
#include <cmath>

#include "fields/lanes_of_orbits.h"

namespace versorium {

Status checkCriticalStart(const Scene& scene, const OrbitProgram& program) {
    if (!program.critical) return {};
    constexpr int kPlaces = 9;
    const std::size_t axes = scene.slice.axes.size();
    double places[3][kPlaces] = {};
    const double* rows[3] = {places[0], places[1], places[2]};
    for (std::size_t axis = 0; axis < std::min<std::size_t>(axes, 3); ++axis)
        for (int i = 0; i < kPlaces; ++i) {
            const int step = axis == 0 ? i % 3 - 1 : axis == 1 ? i / 3 - 1 : 0;
            places[axis][i] = scene.slice.centre[axis] + 0.5 * step * scene.slice.height;
        }
    OrbitLanes lanes(program, kPlaces, rows, {});
    const std::vector<double>& first = lanes.state(0);
    if (!std::all_of(first.begin(), first.begin() + kPlaces,
                     [](double value) { return std::isnan(value); }))
        return {};
    return Status::data("start: the map has no critical point number " +
                        std::to_string(*program.critical) +
                        " here; \"versorium formula\" lists those of a formula, and numbers may "
                        "stand in its place, such as --set start=0,0");
}

}  // namespace versorium
