// SPDX-License-Identifier: MIT
#pragma once
// Analytic shapes: a small immutable expression whose value is a signed distance, negative inside.
// It is written as text, such as "union(disc(0.3), translate(0.2, 0.1, box(0.1, 0.2)))", and has
// one evaluation for every number type (shape/distance.h). Lengths are in units of space, angles in
// radians, y points up. Shapes of the plane ignore z: in space they are prisms without end.
//
//   disc(r)                        sphere(r)                     capsule(half_length, r)  along y
//   box(hx, hy[, hz])  half sides  torus(R, r)  about z          half_space(nx, ny, nz, d)  n·p < d
//   star(points, outer, inner)     heart(width)                  crescent(R, r, offset)
//   union(a, b, …)                 intersection(a, b, …)         difference(a, b)
//   smooth_union(k, a, b)          translate(x, y[, z], a)       rotate(angle, a)  about z
//   scale(s, a)
//
// A star has its first point up; a heart is a square with two half-discs, centred by its box; a
// crescent is the disc R about 0 without the disc r about (offset, 0), whose circles must cross.
// Exactness: every shape of the first three lines is the exact distance. A union is exact outside
// where its parts are, an intersection inside, a difference a \ b inside where a is exact inside
// and b outside; elsewhere they are bounds: never more than the distance to the surface, right in
// sign. A smooth union is a bound everywhere. Moving keeps exactness. No value changes faster than
// the point moves (|∇| ≤ 1).

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace versorium {

enum class ShapeKind {
    disc,
    sphere,
    box,
    torus,
    capsule,
    star,
    heart,
    crescent,
    halfSpace,
    unionOf,
    intersection,
    difference,
    smoothUnion,
    translate,
    rotate,
    scale,
};

inline constexpr int kShapeDepth = 32;
inline constexpr int kShapeNodes = 1000;
inline constexpr double kShapeLargest = 1e6;    // of any number in a shape
inline constexpr double kShapeSmallest = 1e-6;  // of a length that must be positive
inline constexpr int kStarPoints = 1000;

class ShapeTree {
  public:
    // Checks how many numbers and children the kind takes, and their ranges.
    static Expected<ShapeTree> make(ShapeKind kind, std::vector<double> numbers,
                                    std::vector<ShapeTree> children = {});

    ShapeKind kind() const;
    // As written in the text, in its order.
    const std::vector<double>& numbers() const;
    const std::vector<ShapeTree>& children() const;
    // Numbers derived once from those above, for shape/distance.h; their meaning is stated there.
    const std::vector<double>& derived() const;
    int depth() const;
    int nodeCount() const;

    friend bool operator==(const ShapeTree& a, const ShapeTree& b);

  private:
    struct Node;
    explicit ShapeTree(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
    std::shared_ptr<const Node> node_;
};

// Where the value is the exact distance; where it is not, it is a bound.
struct ShapeExactness {
    bool outside = false;
    bool inside = false;
};
ShapeExactness exactness(const ShapeTree& shape);

// Blanks are free. Faults name the character, counted from 1, and what was expected there.
Expected<ShapeTree> parseShape(std::string_view text);
}  // namespace versorium
