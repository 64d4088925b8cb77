// SPDX-License-Identifier: MIT
// OBJ, PLY and STL: a mesh whose corners exist, or a message.
#include <cmath>
#include <cstddef>

#include "io/mesh_files.h"
#include "io/shape_file_kind.h"
#include "shape/mesh_report.h"

using namespace versorium;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::span<const unsigned char> bytes(data, size);
    (void)shapeFileKindOf(bytes, "a.obj");
    for (const Expected<Mesh>& mesh :
         {readMesh(bytes), readObj(bytes), readPly(bytes), readStl(bytes)}) {
        if (!mesh) {
            if (mesh.status().message().empty()) __builtin_trap();
            continue;
        }
        for (const auto& triangle : mesh->triangles)
            for (const std::uint32_t corner : triangle)
                if (corner >= mesh->vertices.size()) __builtin_trap();
        for (const glm::dvec3& vertex : mesh->vertices)
            if (!std::isfinite(vertex.x + vertex.y + vertex.z) &&
                std::abs(vertex.x) + std::abs(vertex.y) + std::abs(vertex.z) < 1e300)
                __builtin_trap();
        (void)warningsOf(reportOf(*mesh));
    }
    return 0;
}
