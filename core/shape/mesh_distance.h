// SPDX-License-Identifier: MIT
#pragma once
// A triangle mesh turned into a cubic grid of signed distances, negative inside (shape/mesh_field.h
// says how distance and sign are found). The mesh is centred and scaled uniformly, so that with the
// padding the grid's box is exactly [-½, ½]³; the distances are those of the scaled mesh.

#include <cstddef>
#include <glm/vec3.hpp>

#include "base/status.h"
#include "geometry/grid.h"
#include "geometry/mesh.h"
#include "jobs/job.h"

namespace versorium {

struct MeshDistanceOptions {
    int resolution = 100;  // nodes along each axis, 2 to kMeshDistanceNodes
    // Free cells around the mesh on its longest side, ≥ 0. Two keep the surface, and the cells
    // that a gradient needs, off the border.
    double padding = 2;
    // False: the mesh is taken as it stands and padding is not used.
    bool normalise = true;
};

inline constexpr int kMeshDistanceNodes = 1024;

struct MeshDistance {
    Grid grid;
    // A point p of the mesh is at (p - centre) · scale in the grid.
    glm::dvec3 centre{0};
    double scale = 1;
    bool closed = true;                // no side without its partner
    bool turned = false;               // the mesh had its inside out
    std::size_t droppedTriangles = 0;  // without area
    // Nodes whose winding number lies between ¼ and ¾: near a hole, or between turned faces, where
    // nobody can say what is inside. Those on the surface do not count.
    std::size_t uncertainNodes = 0;
};

// The values do not depend on the number of threads. Fails with ErrorKind::usage for options out of
// range, ErrorKind::data for a mesh without triangles or with vertices that are not finite.
Expected<MeshDistance> meshDistance(const Mesh& mesh, const MeshDistanceOptions& options, Job& job);

}  // namespace versorium
