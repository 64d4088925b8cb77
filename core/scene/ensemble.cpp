// SPDX-License-Identifier: MIT
#include "scene/ensemble.h"

#include <algorithm>

#include "scene/numbers.h"
#include "scene/scene.h"

namespace versorium {

Status checkEnsemble(const Scene& scene) {
    const EnsembleSpec& ensemble = scene.ensemble;
    const MapInfo& info = mapOf(scene).info;
    const std::string drawn = ensemble.roots ? ensemble.roots->list : "";
    if (ensemble.roots && !scene.lists.contains(drawn))
        return Status::data("ensemble.roots.list: the map \"" + scene.map +
                            "\" has no list of roots named \"" + drawn + "\"");
    if (ensemble.roots && ensemble.roots->shapeBox && !info.field)
        return Status::data("ensemble.roots.half: the map \"" + scene.map +
                            "\" has no shape whose box could be taken; give half extents");
    const auto ofDrawnList = [&](const std::string& name) {
        const auto ref = numberNamed(scene, name);
        return ensemble.roots && ref && ref->kind == NumberKind::list && ref->list == drawn;
    };
    std::vector<std::string> names;
    for (const EnsembleRange& range : ensemble.ranges) names.push_back(range.name);
    for (const EnsembleDisc& disc : ensemble.discs) {
        names.push_back(disc.name + ".re");
        names.push_back(disc.name + ".im");
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string& name = names[i];
        if (!numberNamed(scene, name))
            return Status::data("ensemble: the map \"" + scene.map + "\" has no number named \"" +
                                name + "\"; it has " + numberNames(scene));
        if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), name) !=
            names.begin() + static_cast<std::ptrdiff_t>(i))
            return Status::data("ensemble: \"" + name + "\" is drawn twice");
        if (ofDrawnList(name))
            return Status::data("ensemble: \"" + name + "\" is of a list that is drawn itself");
    }
    for (const SliceAxis& axis : scene.slice.axes)
        for (const auto& [name, weight] : axis.terms)
            if (ofDrawnList(name) || std::find(names.begin(), names.end(), name) != names.end())
                return Status::data("ensemble: \"" + name +
                                    "\" is on an axis of the picture and cannot be drawn as well");
    for (const auto& [name, value] : scene.slice.origin)
        if (ofDrawnList(name))
            return Status::data("ensemble: \"" + name +
                                "\" of slice.origin is of a list that is drawn at random");
    return {};
}

void keepEnsembleFitting(Scene& scene) {
    EnsembleSpec& ensemble = scene.ensemble;
    std::erase_if(ensemble.ranges,
                  [&](const EnsembleRange& range) { return isOnAxis(scene.slice, range.name); });
    std::erase_if(ensemble.discs, [&](const EnsembleDisc& disc) {
        return isOnAxis(scene.slice, disc.name + ".re") || isOnAxis(scene.slice, disc.name + ".im");
    });
    if (!checkEnsemble(scene).ok()) ensemble.roots.reset();
}

}  // namespace versorium
