// SPDX-License-Identifier: MIT
#include "ui/workspace.h"

#include <algorithm>
#include <cmath>

#include "maps/critical.h"

namespace versorium {
namespace {

// A fit for a map whose parameter plane is not square: the wider of the two ranges decides.
constexpr double kParameterHeight = 3;

void shareWith(Scene& scene, const Scene& like) {
    scene.parameters = like.parameters;
    scene.lists = like.lists;
    scene.shape = like.shape;
    scene.assets = like.assets;
}

bool isState(const Scene& scene, const std::string& name) {
    const std::optional<NumberRef> number = numberNamed(scene, name);
    return number && number->kind == NumberKind::state;
}

double originOf(const SliceSpec& slice, const std::string& name) {
    const auto found = slice.origin.find(name);
    return found == slice.origin.end() ? 0 : found->second;
}

}  // namespace

Scene dynamicalView(const Scene& like) {
    Scene scene = sceneOf(mapOf(like));
    shareWith(scene, like);
    scene.iterations = like.iterations;
    scene.escapeRadius = like.escapeRadius;
    scene.colour = like.colour;
    scene.aspect = like.aspect;
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
    if (map.info.formula == "z^2 + c") scene.slice.centre[0] = -0.65;
    if (hasCriticalPoints(map)) scene.criticalStart = 0;
    return scene;
}

SliceSpec homeOf(const Scene& scene) {
    const SliceSpec there =
        showsParameters(scene) ? parameterView(scene).slice : dynamicalView(scene).slice;
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

bool showsParameters(const Scene& scene) {
    for (const SliceAxis& axis : scene.slice.axes)
        for (const auto& [name, weight] : axis.terms)
            if (!isState(scene, name)) return true;
    return false;
}

Workspace workspaceOf(const Scene& scene) {
    Workspace workspace;
    const bool parameters = showsParameters(scene);
    workspace.views = {parameters ? scene : parameterView(scene),
                       parameters ? dynamicalView(scene) : scene};
    workspace.focused = parameters ? 0 : 1;
    workspace.point = scene.start;
    workspace.point.resize(static_cast<std::size_t>(mapOf(scene).dimension));
    return workspace;
}

void setViewCount(Workspace& workspace, int count) {
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
}

double sharedNumber(const Workspace& workspace, const std::string& name) {
    const Scene& scene = workspace.views[0];
    const std::optional<NumberRef> number = numberNamed(scene, name);
    if (!number) return 0;
    if (number->kind == NumberKind::state)
        return workspace.point[static_cast<std::size_t>(number->index)];
    return numberValue(scene, *number);
}

void setSharedNumber(Workspace& workspace, const std::string& name, double value) {
    if (!std::isfinite(value)) return;
    const std::optional<NumberRef> number = numberNamed(workspace.views[0], name);
    if (!number) return;
    if (number->kind == NumberKind::state)
        workspace.point[static_cast<std::size_t>(number->index)] = value;
    for (Scene& scene : workspace.views) setNumber(scene, *number, value);
}

void setSharedParameter(Workspace& workspace, const std::string& name,
                        const std::vector<double>& value) {
    for (Scene& scene : workspace.views) scene.parameters[name] = value;
}

std::array<double, 2> markerOf(const Workspace& workspace, std::size_t view) {
    const SliceSpec& slice = workspace.views[view].slice;
    std::array<double, 2> marker{};
    for (std::size_t k = 0; k < std::min<std::size_t>(2, slice.axes.size()); ++k) {
        // The term of the largest weight says where on the axis the numbers are.
        const auto& terms = slice.axes[k].terms;
        const auto term = std::max_element(terms.begin(), terms.end(), [](auto& a, auto& b) {
            return std::abs(a.second) < std::abs(b.second);
        });
        if (term == terms.end() || term->second == 0) continue;
        marker[k] =
            (sharedNumber(workspace, term->first) - originOf(slice, term->first)) / term->second;
    }
    return marker;
}

void moveMarker(Workspace& workspace, std::size_t view, double u, double v) {
    const SliceSpec slice = workspace.views[view].slice;
    const double coordinates[2] = {u, v};
    std::map<std::string, double> values;
    for (std::size_t k = 0; k < std::min<std::size_t>(2, slice.axes.size()); ++k)
        for (const auto& [name, weight] : slice.axes[k].terms) {
            const auto start = values.try_emplace(name, originOf(slice, name)).first;
            start->second += weight * coordinates[k];
        }
    for (const auto& [name, value] : values) setSharedNumber(workspace, name, value);
}

double shownHeight(const Scene& view, double aspect) {
    return view.slice.height / std::min(1.0, aspect);
}

Scene pictureScene(const Scene& view, double aspect) {
    Scene scene = view;
    scene.slice.height = shownHeight(view, aspect);
    for (const SliceAxis& axis : view.slice.axes)
        for (const auto& [name, weight] : axis.terms) {
            const std::optional<NumberRef> number = numberNamed(view, name);
            // The map's own power is the degree that escape times are smoothed with.
            if (number && number->kind != NumberKind::list && name != "power")
                setNumber(scene, *number, 0);
        }
    return scene;
}

Scene orbitScene(const Workspace& workspace) {
    Scene scene = dynamicalView(workspace.views[0]);
    scene.criticalStart.reset();
    scene.start = workspace.point;
    scene.iterations = workspace.view().iterations;
    const MapInfo& info = mapOf(scene).info;
    scene.slice = {};
    for (int k = 0; k < std::min(2, dimensionOf(info.algebra)); ++k) {
        scene.slice.axes.push_back({{{stateComponent(info, k), 1.0}}});
        scene.slice.centre.push_back(workspace.point[static_cast<std::size_t>(k)]);
        scene.slice.centreLow.push_back(0);
    }
    if (scene.slice.axes.size() == 1) {
        const std::string name = parameterComponent(info, 0);
        scene.slice.axes.push_back({{{name, 1.0}}});
        scene.slice.centre.push_back(sharedNumber(workspace, name));
        scene.slice.centreLow.push_back(0);
    }
    return scene;
}

std::array<double, 4> bordersOf(const Scene& scene, double aspect) {
    const SliceSpec& slice = scene.slice;
    const auto middle = [&](std::size_t k) {
        return k < slice.centre.size() ? slice.centre[k] + slice.centreLow[k] : 0.0;
    };
    const double tall = 0.5 * shownHeight(scene, aspect), wide = tall * aspect;
    return {middle(0) - wide, middle(0) + wide, middle(1) - tall, middle(1) + tall};
}

bool setBorder(Scene& scene, int border, double value, double aspect) {
    const std::array<double, 4> old = bordersOf(scene, aspect);
    const auto axis = static_cast<std::size_t>(border / 2);
    if (axis >= scene.slice.centre.size()) return false;
    const double other = old[static_cast<std::size_t>(border ^ 1)];
    const double length = border % 2 == 0 ? other - value : value - other;
    const double height = (axis == 0 ? length / aspect : length) * std::min(1.0, aspect);
    if (!(height >= kLeastHeight && height <= kMostHeight)) return false;
    scene.slice.centre[axis] = 0.5 * (value + other);
    scene.slice.centreLow[axis] = 0;
    scene.slice.height = height;
    return true;
}

std::vector<std::string> axisNames(const Scene& scene) {
    const MapKernels& map = mapOf(scene);
    std::vector<std::string> names;
    for (int k = 0; k < map.dimension; ++k) names.push_back(stateComponent(map.info, k));
    for (int k = 0; k < map.parameters; ++k) names.push_back(parameterComponent(map.info, k));
    return names;
}

void setAxis(Workspace& workspace, std::size_t axis, const std::string& name) {
    SliceSpec& slice = workspace.view().slice;
    const std::size_t other = 1 - axis;
    const std::vector<std::pair<std::string, double>> wanted{{name, 1.0}};
    if (other < slice.axes.size() && slice.axes[other].terms == wanted) {
        std::swap(slice.axes[0], slice.axes[1]);
        std::swap(slice.centre[0], slice.centre[1]);
    } else {
        slice.axes[axis].terms = wanted;
        slice.centre[axis] = sharedNumber(workspace, name);
    }
    slice.origin.clear();
    if (!showsParameters(workspace.view())) workspace.view().criticalStart.reset();
}

void History::record(const Workspace& workspace) {
    if (workspaceToJson(workspace) == workspaceToJson(now())) return;
    states_.resize(at_ + 1);
    states_.push_back(workspace);
    if (states_.size() > kMost) states_.erase(states_.begin());
    at_ = states_.size() - 1;
}

}  // namespace versorium
