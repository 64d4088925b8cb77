// SPDX-License-Identifier: MIT
#pragma once
// A polygon in space cut into triangles: a fan where all its triangles face the polygon's way, ear
// clipping (Meisters 1975) in the plane of Newell's normal elsewhere. A hole may be part of the
// list, joined to the outside by an edge that is run through twice. Lists that cross themselves
// have no right answer; they get triangles all the same, as many as their corners allow, in bounded
// time.

#include <cstdint>
#include <span>

#include "geometry/mesh.h"

namespace versorium {

// Adds n - 2 triangles for n corners, where corners that repeat the one before count once. Their
// sides in between meet in pairs, so that a closed mesh of polygons stays closed. Fewer than three
// corners give none. The corners are indices of the mesh's vertices.
void appendPolygon(std::span<const std::uint32_t> corners, Mesh& mesh);

}  // namespace versorium
