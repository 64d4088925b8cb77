// SPDX-License-Identifier: MIT
#pragma once
// The axis-parallel box around the inside of a shape, {φ <= 0}.

#include <array>

#include "shape/field.h"

namespace versorium {

struct ShapeBounds {
    std::array<double, 3> low{-0.5, -0.5, -0.5}, high{0.5, 0.5, 0.5};
    bool empty = false;  // no inside was found: the box is [-½, ½]³
};

// Over the plane z = 0 (dimensions 2) or space (3). Of a grid: the box of its nodes inside, to half
// a cell more. Of an analytic shape: a box around the inside, larger than the least one by about
// 1/16 of its size; an axis along which the shape does not end, or goes beyond ±16, is [-½, ½].
ShapeBounds boundsOf(const DistanceField& field, int dimensions);

}  // namespace versorium
