// SPDX-License-Identifier: MIT
#pragma once
// A regular grid of numbers over an axis-aligned box: values stand on the corner nodes, the first
// node on the box's minimum and the last on its maximum, x running fastest. A two-dimensional grid
// has resolution.z == 1 and a box of zero depth.

#include <cassert>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace versorium {

struct Grid {
    glm::ivec3 resolution{0};  // nodes along x, y, z
    glm::dvec3 minimum{-0.5};
    glm::dvec3 maximum{0.5};
    std::vector<double> values;  // resolution.x * resolution.y * resolution.z

    std::size_t index(int x, int y, int z = 0) const {
        assert(x >= 0 && x < resolution.x && y >= 0 && y < resolution.y && z >= 0 &&
               z < resolution.z);
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(resolution.y) +
                static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(resolution.x) +
               static_cast<std::size_t>(x);
    }
    double at(int x, int y, int z = 0) const { return values[index(x, y, z)]; }
    double& at(int x, int y, int z = 0) { return values[index(x, y, z)]; }
    bool planar() const { return resolution.z == 1; }
};

}  // namespace versorium
