// SPDX-License-Identifier: MIT
#pragma once
// The signed distance of a closed polygon, negative inside, sampled to a planar grid: the exact
// distance to the nearest side, with the sign from counting how the sides wind around the point.

#include <glm/vec2.hpp>
#include <vector>

#include "base/status.h"
#include "geometry/grid.h"
#include "jobs/job.h"

namespace versorium {

// Closed rings of corners; the side from the last corner to the first is meant too. Rings of fewer
// than two corners have no sides.
struct Polygon {
    std::vector<std::vector<glm::dvec2>> rings;
};

enum class FillRule {
    evenOdd,  // inside where a ray crosses an odd number of sides
    nonzero,  // inside where the sides wind around the point, in whichever direction
};

struct PolygonDistanceOptions {
    FillRule rule = FillRule::evenOdd;
    int width = 256;  // nodes, 2 to kPolygonNodes
    int height = 256;
    glm::dvec2 minimum{-0.5};
    glm::dvec2 maximum{0.5};
};

inline constexpr int kPolygonNodes = 16384;
inline constexpr std::size_t kPolygonSides = std::size_t{1} << 24;

Expected<Grid> polygonDistance(const Polygon& polygon, const PolygonDistanceOptions& options,
                               Job& job);

}  // namespace versorium
