// SPDX-License-Identifier: MIT
#pragma once
// What is wrong with a mesh as a closed surface. Corners at the same place count as one; a side is
// a pair of corners that follow each other in a triangle.

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace versorium {

struct MeshReport {
    std::size_t openSides = 0;         // of an odd number of triangles: a border, or a third sheet
    std::size_t turnedSides = 0;       // of triangles that do not run through it back and forth
    std::size_t doubledTriangles = 0;  // with the corners of another one before
    std::size_t emptyTriangles = 0;    // without area
    bool turned = false;               // it encloses a negative volume: its inside is out

    bool sound() const {
        return openSides + turnedSides + doubledTriangles + emptyTriangles == 0 && !turned;
    }
    friend bool operator==(const MeshReport&, const MeshReport&) = default;
};

// In time n log n. All corners must be indices of vertices.
MeshReport reportOf(const Mesh& mesh);

// One sentence for each fault, with what was done about it or what to do.
std::vector<std::string> warningsOf(const MeshReport& report);

}  // namespace versorium
