// SPDX-License-Identifier: MIT
#pragma once
// Files that the build puts into the program (core/cmake/embed.cmake): fonts, plates, presets.

#include <span>
#include <string_view>
#include <vector>

namespace versorium {

// The bytes of the file embedded under this name, such as "fonts/DejaVuSans.ttf"; empty when there
// is none. They live as long as the program.
std::span<const unsigned char> embedded(std::string_view name);
// The same as text.
std::string_view embeddedText(std::string_view name);

// All names that begin with the prefix, such as "plates/", in alphabetical order.
std::vector<std::string_view> embeddedNames(std::string_view prefix = {});

// What the build generates.
namespace embedded_files {
struct EmbeddedFile {
    std::string_view name;
    std::span<const unsigned char> (*bytes)();
};
std::span<const EmbeddedFile> table();
}  // namespace embedded_files

}  // namespace versorium
