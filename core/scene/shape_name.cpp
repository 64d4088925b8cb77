// SPDX-License-Identifier: MIT
#include "scene/shape_name.h"

#include "shape/outline.h"

namespace versorium {

std::string shapeName(const Scene& scene, const std::string& source) {
    constexpr std::string_view kAsset = "asset:";
    if (source.starts_with(kAsset)) {
        const auto asset = scene.assets.find(source.substr(kAsset.size()));
        return asset == scene.assets.end() ? "a file that is missing" : asset->second->name;
    }
    if (!isOutline(source)) return source;
    const auto corners = parseOutline(source);
    return corners ? "a drawing of " + std::to_string(corners->size()) + " corners" : source;
}

}  // namespace versorium
