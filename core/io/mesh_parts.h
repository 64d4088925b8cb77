// SPDX-License-Identifier: MIT
#pragma once
// What the readers of mesh_files.h share.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "geometry/mesh.h"
#include "io/text_scanner.h"

namespace versorium {

// Refuses a mesh without faces; `format` names the file's kind.
Status finishMesh(const Mesh& mesh, const char* format);

// True when the length is exactly the one that a binary STL's triangle count asks for.
bool isBinaryStl(std::span<const unsigned char> bytes);
// True when the bytes begin as an ASCII STL does, whatever the case of its letters.
bool isTextStl(std::span<const unsigned char> bytes);
// True when a line of the text is a vertex of an OBJ file, "v x y z".
bool isObj(std::span<const unsigned char> bytes);
// True when the first word is "ply".
bool isPly(std::span<const unsigned char> bytes);

}  // namespace versorium
