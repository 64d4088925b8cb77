// SPDX-License-Identifier: MIT
#include "io/mesh_files.h"

#include <cctype>

#include "io/mesh_parts.h"

namespace versorium {
namespace {

std::string lowerExtension(std::string_view name) {
    const std::size_t point = name.rfind('.');
    std::string extension;
    if (point == std::string_view::npos) return extension;
    for (char c : name.substr(point))
        extension += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

bool beginsWith(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

}  // namespace

Status finishMesh(const Mesh& mesh, const char* format) {
    if (mesh.triangles.empty())
        return Status::data(std::string("the ") + format +
                            " file has no faces; a surface of triangles is needed");
    return {};
}

Expected<Mesh> readMesh(std::span<const unsigned char> bytes, std::string_view name) {
    const std::string_view text = textOf(bytes);
    if (beginsWith(text, "ply\n") || beginsWith(text, "ply\r")) return readPly(bytes);
    if (isBinaryStl(bytes)) return readStl(bytes);
    const std::string extension = lowerExtension(name);
    if (extension == ".obj") return readObj(bytes);
    if (extension == ".ply") return readPly(bytes);
    if (extension == ".stl" || beginsWith(text, "solid")) return readStl(bytes);
    if (text.find("\nv ") != std::string_view::npos || beginsWith(text, "v "))
        return readObj(bytes);
    return Status::data("not a mesh that can be read here; OBJ, PLY and STL can");
}

}  // namespace versorium
