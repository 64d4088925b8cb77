// SPDX-License-Identifier: MIT
#pragma once
// Triangle meshes read from OBJ (any face syntax, polygons cut into triangles), PLY (ASCII and
// binary of either byte order; properties that are no position and no face are skipped) and STL
// (binary and ASCII; corners with exactly equal coordinates become one vertex). Counts that the
// bytes cannot hold are refused before anything is allocated, indices outside the vertices and
// numbers that are not finite with the line or item where they stand.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/status.h"
#include "geometry/mesh.h"

namespace versorium {

inline constexpr std::size_t kMeshVertices = std::size_t{1} << 28;
inline constexpr std::size_t kMeshTriangles = std::size_t{1} << 28;

// A mesh without any face is refused.
Expected<Mesh> readObj(std::span<const unsigned char> bytes);
Expected<Mesh> readPly(std::span<const unsigned char> bytes);
Expected<Mesh> readStl(std::span<const unsigned char> bytes);

// Chooses by content; `name` (a path, may be empty) decides by its extension where that is open.
Expected<Mesh> readMesh(std::span<const unsigned char> bytes, std::string_view name = {});
// By content alone.
bool looksLikeMesh(std::span<const unsigned char> bytes);

}  // namespace versorium
