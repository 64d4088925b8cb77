// SPDX-License-Identifier: MIT
#pragma once
// What kind of file bytes are, by how they begin, and what a file's name says. The names of formats
// that are not read here are known so that a message can name them.

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "base/status.h"

namespace versorium {

// PNG, JPEG or BMP, the pictures that are read here.
bool looksLikePicture(std::span<const unsigned char> bytes);
bool isPng(std::span<const unsigned char> bytes);

// "a GIF picture", "a glTF file": a known format that nothing here reads; empty for all else.
std::string foreignFormat(std::span<const unsigned char> bytes);
// "this is a GIF picture, which is not read here; save it as PNG". Ok where it is none of them.
Status foreignFault(std::span<const unsigned char> bytes);

// Whether a name ends so, whatever the case of its letters; endings are in small ones.
bool hasEnding(std::string_view name, std::initializer_list<std::string_view> endings);

// What a shape may be made of. "wedge (1).OBJ" is a file's name, "polygon(0, 0, 1, 0, 0, 1)" none.
bool namesMesh(std::string_view name);
bool namesGrid(std::string_view name);
bool namesPicture(std::string_view name);
// Any of these three, or a format that is refused by its name.
bool namesShapeFile(std::string_view name);

}  // namespace versorium
