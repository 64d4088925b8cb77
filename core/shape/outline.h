// SPDX-License-Identifier: MIT
#pragma once
// An outline in the plane as the text of a shape, "polygon(x1, y1, x2, y2, …)": what is drawn by
// hand. It is closed from the last corner to the first. Where it crosses itself, a point is inside
// if the outline winds around it. Unlike analytic shapes (shape/tree.h) it becomes a grid of signed
// distances before it is looked into, so that a look costs the same however many corners it has.

#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "geometry/grid.h"
#include "jobs/job.h"

namespace versorium {

inline constexpr std::size_t kMostOutlineCorners = 4096;
inline constexpr double kLargestOutline = 1e5;  // of any coordinate

// Whether a shape's text is meant as an outline.
bool isOutline(std::string_view text);
// ErrorKind::data where it is not three to kMostOutlineCorners corners that do not lie on a line.
Expected<std::vector<glm::dvec2>> parseOutline(std::string_view text);
// Coordinates to about 1/20000 of the outline's size: finer than a hand draws or a grid holds.
std::string printOutline(const std::vector<glm::dvec2>& corners);

// Leaves out corners that lie within `tolerance` of the line between others (Ramer, Douglas,
// Peucker); the first and the last one stay.
std::vector<glm::dvec2> simplifyOutline(const std::vector<glm::dvec2>& corners, double tolerance);

// Moved, and scaled where it is much smaller or larger than 1, so that the origin lies well inside:
// what a shape modulus needs. An outline that does already stays as it is.
Expected<std::vector<glm::dvec2>> aroundOrigin(std::vector<glm::dvec2> corners, Job& job);

// The signed distance on a grid of `nodes` along the longer side of a box that leaves a quarter of
// the outline's size free around it. ErrorKind::data where the outline holds no node.
Expected<Grid> outlineDistance(const std::vector<glm::dvec2>& corners, int nodes, Job& job);

}  // namespace versorium
