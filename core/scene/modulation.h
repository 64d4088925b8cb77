// SPDX-License-Identifier: MIT
#pragma once
// α and β over space, as a scene says it (shape/modulation.h says what it comes to): a second shape
// within which the number tends to another value, and discs of other values painted over it.
// Everywhere else the number is the scene's parameter.

#include <string>
#include <vector>

#include "base/status.h"
#include "shape/modulation.h"

namespace versorium {

struct Scene;

struct ModulationSpec {
    std::string shape;          // like ShapeSpec::source; empty: none
    double from = 0, to = 0.1;  // distances to that shape, from < to: `value` up to `from`
    double value = 100;
    std::vector<PaintedDisc> discs;  // in the order in which they were painted
    bool modulates() const { return !shape.empty() || !discs.empty(); }
    friend bool operator==(const ModulationSpec&, const ModulationSpec&) = default;
};

inline constexpr std::size_t kMostPaintedDiscs = 2000;
inline constexpr double kLargestModulated = 1e9;  // of any value of α and β

// That the map has α and β, and that the second shapes can be read.
Status checkModulation(const Scene& scene);

}  // namespace versorium
