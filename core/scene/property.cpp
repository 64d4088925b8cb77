// SPDX-License-Identifier: MIT
#include "scene/property.h"

namespace versorium {

std::string_view ValueInfo::shortName() const {
    const std::string_view whole = path;
    const std::size_t dot = whole.rfind('.');
    return dot == std::string_view::npos ? whole : whole.substr(dot + 1);
}

bool ValueInfo::isCalled(std::string_view name) const {
    return name == path || (!alias.empty() && name == alias);
}

std::string joined(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + key;
}

}  // namespace versorium
