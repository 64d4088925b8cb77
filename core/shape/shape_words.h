// SPDX-License-Identifier: MIT
#pragma once
// The words of the shape language: one row for each kind, used by the checks, the parser and the
// printer.

#include "shape/tree.h"

namespace versorium {

struct ShapeWord {
    ShapeKind kind;
    const char* name;
    const char* usage;
    int leastNumbers, mostNumbers;
    unsigned positive;                // bit i: the i-th number must be positive
    int leastChildren, mostChildren;  // most: -1 for any number
};

// In the order of ShapeKind.
inline constexpr ShapeWord kShapeWords[] = {
    {ShapeKind::disc, "disc", "disc(r)", 1, 1, 1, 0, 0},
    {ShapeKind::sphere, "sphere", "sphere(r)", 1, 1, 1, 0, 0},
    {ShapeKind::box, "box", "box(hx, hy[, hz])", 2, 3, 7, 0, 0},
    {ShapeKind::torus, "torus", "torus(R, r)", 2, 2, 3, 0, 0},
    {ShapeKind::capsule, "capsule", "capsule(half_length, r)", 2, 2, 3, 0, 0},
    {ShapeKind::star, "star", "star(points, outer, inner)", 3, 3, 7, 0, 0},
    {ShapeKind::heart, "heart", "heart(width)", 1, 1, 1, 0, 0},
    {ShapeKind::crescent, "crescent", "crescent(R, r, offset)", 3, 3, 7, 0, 0},
    {ShapeKind::halfSpace, "half_space", "half_space(nx, ny, nz, d)", 4, 4, 0, 0, 0},
    {ShapeKind::unionOf, "union", "union(a, b, …)", 0, 0, 0, 1, -1},
    {ShapeKind::intersection, "intersection", "intersection(a, b, …)", 0, 0, 0, 1, -1},
    {ShapeKind::difference, "difference", "difference(a, b)", 0, 0, 0, 2, 2},
    {ShapeKind::smoothUnion, "smooth_union", "smooth_union(k, a, b)", 1, 1, 1, 2, 2},
    {ShapeKind::translate, "translate", "translate(x, y[, z], a)", 2, 3, 0, 1, 1},
    {ShapeKind::rotate, "rotate", "rotate(angle, a)", 1, 1, 0, 1, 1},
    {ShapeKind::scale, "scale", "scale(s, a)", 1, 1, 1, 1, 1},
};

constexpr bool shapeWordsAreInOrder() {
    int expected = 0;
    for (const ShapeWord& word : kShapeWords)
        if (static_cast<int>(word.kind) != expected++) return false;
    return true;
}
static_assert(shapeWordsAreInOrder());

inline const ShapeWord& shapeWord(ShapeKind kind) { return kShapeWords[static_cast<int>(kind)]; }

}  // namespace versorium
