// SPDX-License-Identifier: MIT
#include "scene/shape_controls.h"

#include <algorithm>

namespace versorium {
namespace {

// The component that a value of `drop` leaves out, as shape_modulus::placeOf has it.
int droppedBy(double drop) {
    if (drop == 0) return 0;
    return drop <= 1 ? 1 : drop <= 2 ? 2 : 3;
}

}  // namespace

std::array<double, 3> ShapeControls::seenShift() const {
    std::array<double, 3> result{};
    for (std::size_t k = 0; k < result.size(); ++k)
        result[k] = shift[static_cast<std::size_t>(seen[k])];
    return result;
}

ShapeControls shapeControls(const Scene& scene) {
    assert(mapOf(scene).info.field);
    ShapeControls controls;
    controls.alpha = scene.parameters.at("alpha")[0];
    controls.beta = scene.parameters.at("beta")[0];
    controls.asPrinted = scene.parameters.at(kAsPrinted)[0] != 0;
    const std::vector<double>& shift = scene.parameters.at("shift");
    std::copy(shift.begin(), shift.end(), controls.shift.begin());
    const auto drop = scene.parameters.find("drop");
    const int dropped = drop == scene.parameters.end() ? 3 : droppedBy(drop->second[0]);
    std::size_t next = 0;
    for (int k = 0; k < 4 && next < 3; ++k)
        if (k != dropped) controls.seen[next++] = k;
    return controls;
}

}  // namespace versorium
