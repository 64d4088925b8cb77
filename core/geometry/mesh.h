// SPDX-License-Identifier: MIT
#pragma once
// An indexed triangle mesh: plain data, no normals, no materials.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace versorium {

struct Mesh {
    std::vector<glm::dvec3> vertices;
    // Indices into `vertices`, counter-clockwise seen from outside. Readers guarantee the range.
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace versorium
