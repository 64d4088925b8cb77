// SPDX-License-Identifier: MIT
#include "render/cpu/kept_fields.h"

#include <algorithm>

namespace versorium {
namespace {

bool has(const std::vector<FieldName>& fields, FieldName field) {
    return std::find(fields.begin(), fields.end(), field) != fields.end();
}

// Means are those of the solid set where the ensemble says so.
bool dependOnIso(const std::vector<FieldName>& fields) {
    return has(fields, FieldName::solid) || has(fields, FieldName::meanMembership) ||
           has(fields, FieldName::standardError);
}

// Whether all that the wanted one has, or shall have, stands in the other.
bool covers(const FieldTiles& one, const FieldTiles& wanted) {
    return one.key == wanted.key && (one.iso == wanted.iso || !dependOnIso(wanted.fields)) &&
           std::all_of(wanted.fields.begin(), wanted.fields.end(),
                       [&](FieldName field) { return has(one.fields, field); });
}

}  // namespace

std::size_t FieldTiles::bytes() const {
    std::size_t numbers = 0;
    for (const auto& tile : tiles)
        for (const auto& values : tile) numbers += values.size();
    return numbers * sizeof(double);
}

FieldTiles KeptFields::tilesFor(const Scene& scene, Size size, const RenderOptions& options,
                                std::vector<FieldName> fields) {
    Json orbits = sceneBody(scene);
    for (const char* other : {"colour", "layers", "aspect", "iso"}) orbits.erase(other);
    orbits["picture"] = {size.width, size.height, static_cast<int>(options.flavour),
                         options.shortcuts};
    return {orbits.dump(), scene.iso, std::move(fields), {}};
}

std::shared_ptr<const FieldTiles> KeptFields::find(const FieldTiles& wanted) {
    const auto found = std::find_if(kept_.begin(), kept_.end(),
                                    [&](const auto& one) { return covers(*one, wanted); });
    if (found == kept_.end()) return nullptr;
    std::rotate(found, found + 1, kept_.end());
    return kept_.back();
}

bool KeptFields::put(FieldTiles measured) {
    std::size_t sum = measured.bytes();
    if (sum > most_) return false;
    std::erase_if(kept_, [&](const auto& one) { return covers(measured, *one); });
    for (const auto& one : kept_) sum += one->bytes();
    while (sum > most_) {
        sum -= kept_.front()->bytes();
        kept_.erase(kept_.begin());
    }
    kept_.push_back(std::make_shared<const FieldTiles>(std::move(measured)));
    return true;
}

}  // namespace versorium
