// SPDX-License-Identifier: MIT
#pragma once
// The plane of starting points that a view shows, in the numbers of the state:
//   x(u, v) = base + u axis₀ + v axis₁.
// Points of the state that do not lie in it are projected orthogonally.

#include <array>
#include <optional>

#include "scene/scene.h"

namespace versorium {

struct StatePlane {
    using Point = std::array<double, 4>;

    int dimension = 2;
    Point base{};
    std::array<Point, 2> axis{};

    Point at(double u, double v) const;
    // The coordinates of the nearest point of the plane.
    std::array<double, 2> coordinates(const Point& x) const;
    double distance(const Point& x) const;
    // Two orthonormal directions that span it, the first one along axis₀.
    std::array<Point, 2> frame() const;
};

// Nothing where the view shows anything else than a plane of starting points, or where its axes run
// along one line.
std::optional<StatePlane> statePlaneOf(const Scene& scene);

}  // namespace versorium
