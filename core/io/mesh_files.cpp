// SPDX-License-Identifier: MIT
#include "io/mesh_files.h"

#include "io/known_formats.h"
#include "io/mesh_parts.h"

namespace versorium {

Status finishMesh(const Mesh& mesh, const char* format) {
    if (mesh.triangles.empty())
        return Status::data(std::string("the ") + format +
                            " file has no faces; a surface of triangles is needed");
    return {};
}

Expected<Mesh> readMesh(std::span<const unsigned char> bytes, std::string_view name) {
    if (isPly(bytes)) return readPly(bytes);
    if (isBinaryStl(bytes) || isTextStl(bytes)) return readStl(bytes);
    if (isObj(bytes)) return readObj(bytes);
    if (Status status = foreignFault(bytes); !status.ok()) return status;
    if (hasEnding(name, {".obj"})) return readObj(bytes);
    if (hasEnding(name, {".ply"})) return readPly(bytes);
    if (hasEnding(name, {".stl"})) return readStl(bytes);
    return Status::data("not a mesh that can be read here; OBJ, PLY and STL can");
}

bool looksLikeMesh(std::span<const unsigned char> bytes) {
    return isPly(bytes) || isBinaryStl(bytes) || isTextStl(bytes) || isObj(bytes);
}

}  // namespace versorium
