// SPDX-License-Identifier: MIT
#include "scene/shape_name.h"

#include "base/embedded.h"
#include "shape/outline.h"
#include "shape/tree.h"

namespace versorium {
namespace {

constexpr std::string_view kAsset = "asset:";

}  // namespace

bool isBuiltInMesh(const std::string& source) {
    return !embedded("meshes/" + source + ".obj").empty();
}

Status checkShapeText(const std::string& source) {
    if (source.starts_with(kAsset) || isBuiltInMesh(source)) return {};
    if (isOutline(source)) return parseOutline(source).status();
    return parseShape(source).status();
}

std::string shapeName(const Scene& scene, const std::string& source) {
    if (source.starts_with(kAsset)) {
        const auto asset = scene.assets.find(source.substr(kAsset.size()));
        return asset == scene.assets.end() ? "a file that is missing" : asset->second->name;
    }
    if (!isOutline(source)) return source;
    const auto corners = parseOutline(source);
    return corners ? "a drawing of " + std::to_string(corners->size()) + " corners" : source;
}

}  // namespace versorium
