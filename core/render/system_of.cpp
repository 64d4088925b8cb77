// SPDX-License-Identifier: MIT
#include "render/system_of.h"

#include <algorithm>

#include "scene/numbers.h"

namespace versorium {

bool isDynamicalPlane(const Scene& scene) {
    const MapKernels& map = mapOf(scene);
    const std::size_t wanted = map.dimension == 1 ? 1 : 2;
    if (scene.slice.axes.size() < wanted) return false;
    for (std::size_t k = 0; k < wanted; ++k) {
        const auto& terms = scene.slice.axes[k].terms;
        if (terms.size() != 1 || terms[0].second != 1 ||
            terms[0].first != stateComponent(map.info, static_cast<int>(k)))
            return false;
    }
    return true;
}

Expected<OrbitProgram> fixedProgram(Binder& binder, const Scene& scene, Job& job) {
    Expected<OrbitProgram> program = binder.bind(scene, job);
    if (!program) return program.status();
    const MapKernels& map = *program->map;
    Slice& slice = program->slice;
    const auto fix = [&](std::size_t number, const NumberRef& ref) {
        if (slice.varies(number)) slice.origin[number] = numberValue(scene, ref);
    };
    std::size_t number = 0;
    for (int k = 0; k < map.dimension; ++k) fix(number++, {NumberKind::state, k, {}, 0, 0, 0});
    for (int k = 0; k < map.parameters; ++k) fix(number++, {NumberKind::parameter, k, {}, 0, 0, 0});
    for (const auto& own : program->overrides) {
        const RootList::Root& root =
            program->lists[static_cast<std::size_t>(own.list)][static_cast<std::size_t>(own.item)];
        if (slice.varies(number))
            slice.origin[number] =
                own.component == 4 ? root.power : root.q[static_cast<std::size_t>(own.component)];
        ++number;
    }
    for (auto& axis : slice.axes) std::fill(axis.begin(), axis.end(), 0.0);
    return program;
}

Expected<System> systemOf(Binder& binder, const Scene& scene, Job& job) {
    Expected<OrbitProgram> program = fixedProgram(binder, scene, job);
    if (!program) return program.status();
    return System(*program);
}

Expected<OrbitProgram> programAlong(Binder& binder, const Scene& scene, const SliceAxis& axis,
                                    Job& job) {
    for (const auto& [name, weight] : axis.terms) {
        const auto ref = numberNamed(scene, name);
        if (!ref)
            return Status::usage("the map \"" + scene.map + "\" has no number named \"" + name +
                                 "\"; it has " + numberNames(scene));
        if (ref->kind == NumberKind::state)
            return Status::usage("\"" + name + "\" is a start; a parameter is expected, one of " +
                                 numberNames(scene));
    }
    if (axis.terms.empty()) return Status::usage("the name of a parameter is expected");
    // The ring's values become the scene's own, and the axis takes the place of the slice.
    Scene along = scene;
    along.slice.axes = {axis};
    along.slice.origin.clear();
    along.slice.centre = along.slice.centreLow = {0};
    return binder.bind(along, job);
}

Expected<CatalogueBadge> catalogueBadgeOf(Binder& binder, const Scene& scene, Job& job) {
    Expected<OrbitProgram> program = binder.bind(scene, job);
    if (!program) return program.status();
    double centre[3] = {};
    for (std::size_t k = 0; k < scene.slice.centre.size(); ++k) centre[k] = scene.slice.centre[k];
    const double half = 0.5 * scene.slice.height;
    return catalogueBadge(*program, centre, half * scene.aspect, half);
}

Window dynamicalWindow(const Scene& scene) {
    const MapInfo& info = mapOf(scene).info;
    double x = info.homeCentre[0], y = info.homeCentre[1], height = info.homeHeight;
    if (isDynamicalPlane(scene)) {
        x = scene.slice.centre[0];
        y = scene.slice.centre.size() > 1 ? scene.slice.centre[1] : 0;
        height = scene.slice.height;
    }
    const double half = 0.5 * height, across = half * std::max(1.0, scene.aspect);
    return {x - across, x + across, y - half, y + half};
}

}  // namespace versorium
