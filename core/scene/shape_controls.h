// SPDX-License-Identifier: MIT
#pragma once
// How a map with a shape looks it up: the values in a scene of the parameters that come before
// those of the inner map (maps/shape_modulus.h). The shape is seen at x = q - shift, by three of
// the components.

#include <array>

#include "scene/scene.h"

namespace versorium {

// Each view's own: two views show S eq 2 as it is meant and as printed.
inline constexpr const char* kAsPrinted = "as_printed";

struct ShapeControls {
    double alpha = 0, beta = 0;
    bool asPrinted = false;         // φ + β in place of φ - β
    std::array<double, 4> shift{};  // as many components as a state has; the others are 0
    std::array<int, 3> seen{0, 1,
                            2};  // components of the state; those that it lacks are never seen

    // The shift of the components that are seen; 0 where there is none.
    std::array<double, 3> seenShift() const;
};
// Of a scene of a map with a field.
ShapeControls shapeControls(const Scene& scene);

}  // namespace versorium
