// SPDX-License-Identifier: MIT
#include "base/embedded.h"

namespace versorium {

std::span<const unsigned char> embedded(std::string_view name) {
    for (const auto& file : embedded_files::table())
        if (file.name == name) return file.bytes();
    return {};
}

std::string_view embeddedText(std::string_view name) {
    const auto bytes = embedded(name);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<std::string_view> embeddedNames(std::string_view prefix) {
    std::vector<std::string_view> names;
    for (const auto& file : embedded_files::table())
        if (file.name.starts_with(prefix)) names.push_back(file.name);
    return names;
}

}  // namespace versorium
