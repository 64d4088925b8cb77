// SPDX-License-Identifier: MIT
// Which views a workspace has: their homes, their kinds, and how many there are.
#include <algorithm>
#include <utility>

#include "maps/critical.h"
#include "scene/parts.h"
#include "workspace/workspace.h"

namespace versorium {
namespace {

// A fit for a map whose parameter plane is not square: the wider of the two ranges decides.
constexpr double kParameterHeight = 3;

void shareWith(Scene& scene, const Scene& like) {
    scene.parameters = like.parameters;
    scene.lists = like.lists;
    keepShape(scene, like);
}

}  // namespace

Scene dynamicalView(const Scene& like) {
    Scene scene = sceneOf(mapOf(like));
    shareWith(scene, like);
    scene.iterations = like.iterations;
    scene.escapeRadius = like.escapeRadius;
    keepLook(scene, like);
    if (!like.criticalStart) scene.start = like.start;
    return scene;
}

Scene parameterView(const Scene& like) {
    Scene scene = dynamicalView(like);
    const MapKernels& map = mapOf(like);
    std::vector<std::string> names;
    std::vector<double> centre;
    int component = 0;
    const bool hasWide =
        std::any_of(map.info.parameters.begin(), map.info.parameters.end(),
                    [](const ParameterInfo& parameter) { return widthOf(parameter.kind) >= 2; });
    // A complex or quaternion parameter gives its first two components; else reals are joined:
    // those that are set come before those that are 0.
    for (std::string_view name : map.info.parameterAxes) {
        names.emplace_back(name);
        centre.push_back(0);
    }
    for (const bool zeros : {false, true}) {
        component = 0;
        for (const ParameterInfo& parameter : map.info.parameters) {
            const std::vector<double>& now = like.parameters.at(std::string(parameter.name));
            if (widthOf(parameter.kind) == 1 && parameter.kind == ParameterKind::real &&
                (now[0] == 0) == zeros && names.size() < 2 && !hasWide) {
                names.push_back(parameterComponent(map.info, component));
                centre.push_back(now[0]);
            }
            component += widthOf(parameter.kind);
        }
    }
    component = 0;
    for (const ParameterInfo& parameter : map.info.parameters) {
        const int width = widthOf(parameter.kind);
        for (int k = 0; k < 2 && width >= 2 && names.size() < 2; ++k) {
            names.push_back(parameterComponent(map.info, component + k));
            centre.push_back(0);
        }
        component += width;
    }
    if (names.size() < 2) return scene;
    scene.slice = {};
    for (std::size_t k = 0; k < 2; ++k) {
        scene.slice.axes.push_back({{{names[k], 1.0}}});
        scene.slice.centre.push_back(centre[k]);
        scene.slice.centreLow.push_back(0);
    }
    scene.slice.height = kParameterHeight;
    for (std::size_t k = 0; k < 2; ++k) scene.slice.centre[k] += map.info.parameterCentre[k];
    // A planar map may have a whole curve of critical points, or none: the origin, as A
    // section 4.2.
    if (map.info.algebra == Algebra::plane)
        scene.start.assign(2, 0.0);
    else if (hasCriticalPoints(map))
        scene.criticalStart = 0;
    return scene;
}

Scene homeView(ViewKind kind, const Scene& like) {
    switch (kind) {
        case ViewKind::parameters:
            return parameterView(like);
        case ViewKind::startingPoints:
            return dynamicalView(like);
    }
    return dynamicalView(like);
}

SliceSpec homeOf(const Scene& scene) {
    const SliceSpec there = homeView(viewKind(scene), scene).slice;
    SliceSpec place = scene.slice;
    if (there.axes == place.axes) {
        place.centre = there.centre;
        place.height = there.height;
    } else {
        std::fill(place.centre.begin(), place.centre.end(), 0.0);
        place.height = 4;
    }
    std::fill(place.centreLow.begin(), place.centreLow.end(), 0.0);
    return place;
}

int firstOfKind(const Workspace& workspace, ViewKind kind) {
    for (std::size_t k = 0; k < workspace.views.size(); ++k)
        if (viewKind(workspace.views[k]) == kind) return static_cast<int>(k);
    return -1;
}

int viewOfKind(const Workspace& workspace, ViewKind kind) {
    return viewKind(workspace.view()) == kind ? workspace.focused : firstOfKind(workspace, kind);
}

Workspace workspaceOf(const Scene& scene) {
    Workspace workspace;
    const ViewKind kind = viewKind(scene), beside = besideOf(kind);
    workspace.views = {scene, homeView(beside, scene)};
    if (beside < kind) {
        std::swap(workspace.views[0], workspace.views[1]);
        workspace.focused = 1;
    }
    workspace.point = scene.start;
    workspace.point.resize(static_cast<std::size_t>(mapOf(scene).dimension));
    return workspace;
}

void setViewCount(Workspace& workspace, int count) {
    if (workspace.analysis()) {
        const Scene spoken = workspace.views[workspace.speaker()];
        for (Scene& scene : workspace.views) scene.parameters = spoken.parameters;
        workspace.views.resize(static_cast<std::size_t>(std::min(count, 4)));
        workspace.focused = 0;
    }
    while (static_cast<int>(workspace.views.size()) < count) {
        const std::size_t size = workspace.views.size();
        workspace.views.push_back(size < 2 ? dynamicalView(workspace.views[0])
                                           : workspace.views[size - 2]);
    }
    if (count == 1) std::swap(workspace.views[0], workspace.view());
    workspace.views.resize(static_cast<std::size_t>(count));
    workspace.focused = std::min(workspace.focused, count - 1);
    if (count == 1) workspace.focused = 0;
    workspace.maximised = false;
    workspace.motionView = std::min(workspace.motionView, count - 1);
}

bool setAnalysis(Workspace& workspace) {
    if (workspace.analysis()) return true;
    const auto shownOrHome = [&](ViewKind kind, const Scene& alike) {
        const int shown = firstOfKind(workspace, kind);
        return shown < 0 ? homeView(kind, alike) : workspace.views[static_cast<std::size_t>(shown)];
    };
    Scene set = shownOrHome(ViewKind::parameters, workspace.views[0]);
    if (viewKind(set) != ViewKind::parameters || set.slice.axes.size() < 2) return false;
    const Scene like = shownOrHome(ViewKind::startingPoints, set);
    workspace.views.assign(1, std::move(set));
    workspace.views.resize(kAnalysisViews, like);
    workspace.maximised = false;
    // Where no pin is, a place beside the present one, as far as a quarter of the picture.
    constexpr double kPlaces[4][2] = {{0, 0}, {-1, 0.4}, {0.4, 1}, {-0.4, -1}};
    const std::array<double, 2> here = markerOf(workspace, 0);
    for (std::size_t k = 0; k < 4; ++k) {
        workspace.focused = static_cast<int>(k) + 1;
        const double step = 0.2 * workspace.views[0].slice.height;
        moveMarker(workspace, 0, here[0] + step * kPlaces[k][0], here[1] + step * kPlaces[k][1]);
        if (k < workspace.pins.size()) workspace.views[k + 1].parameters = workspace.pins[k];
    }
    workspace.pins.clear();
    workspace.focused = 1;
    workspace.motionView = 0;
    return true;
}

}  // namespace versorium
