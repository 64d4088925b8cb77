// SPDX-License-Identifier: MIT
#include "scene/view_kind.h"

#include "i18n/language.h"
#include "scene/numbers.h"

namespace versorium {

ViewKind viewKind(const Scene& scene) {
    for (const SliceAxis& axis : scene.slice.axes)
        for (const auto& [name, weight] : axis.terms) {
            const std::optional<NumberRef> number = numberNamed(scene, name);
            if (!number || number->kind != NumberKind::state) return ViewKind::parameters;
        }
    return ViewKind::startingPoints;
}

const ViewTraits& traitsOf(ViewKind kind) {
    static constexpr ViewTraits kParameters{
        .title = trLater("Parameters"),
        .tab = trLater("Parameters"),
        .spoken =
            trLater("View {1}, parameters of {2}: height {3} around {4}. The ring is at {5}."),
        .orbit = false,
        .arrows = false,
        .circles = false,
        .shape = false,
        .starts = false,
        .pins = true,
        .ownStart = true};
    static constexpr ViewTraits kStartingPoints{
        .title = trLater("Starting points"),
        .tab = trLater("Points"),
        .spoken =
            trLater("View {1}, starting points of {2}: height {3} around {4}. The ring is at {5}."),
        .orbit = true,
        .arrows = true,
        .circles = true,
        .shape = true,
        .starts = true,
        .pins = false,
        .ownStart = false};
    switch (kind) {
        case ViewKind::parameters:
            return kParameters;
        case ViewKind::startingPoints:
            return kStartingPoints;
    }
    return kStartingPoints;
}

const ViewTraits& traitsOf(const Scene& scene) { return traitsOf(viewKind(scene)); }

ViewKind besideOf(ViewKind kind) {
    switch (kind) {
        case ViewKind::parameters:
            return ViewKind::startingPoints;
        case ViewKind::startingPoints:
            return ViewKind::parameters;
    }
    return ViewKind::parameters;
}

}  // namespace versorium
