// SPDX-License-Identifier: MIT
#pragma once
// What a file that is to be a shape holds.

#include <span>
#include <string_view>

namespace versorium {

enum class ShapeFileKind { mesh, grid, picture };

// By content; where that fits none of them, by the ending of the name. A file that is none of them
// is a mesh, whose reader then says what is wrong.
ShapeFileKind shapeFileKindOf(std::span<const unsigned char> bytes, std::string_view name);

}  // namespace versorium
