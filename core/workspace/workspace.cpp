// SPDX-License-Identifier: MIT
#include "workspace/workspace.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "scene/parts.h"

namespace versorium {
namespace {

bool isState(const Scene& scene, const std::string& name) {
    const std::optional<NumberRef> number = numberNamed(scene, name);
    return number && number->kind == NumberKind::state;
}

double originOf(const SliceSpec& slice, const std::string& name) {
    const auto found = slice.origin.find(name);
    return found == slice.origin.end() ? 0 : found->second;
}

}  // namespace

double sharedNumber(const Workspace& workspace, const std::string& name) {
    const Scene& spoken = workspace.views[workspace.speaker()];
    const std::optional<NumberRef> number = numberNamed(spoken, name);
    if (!number) return 0;
    if (number->kind == NumberKind::state)
        return workspace.point[static_cast<std::size_t>(number->index)];
    return numberValue(isOfView(spoken, *number) ? workspace.view() : spoken, *number);
}

void setSharedNumber(Workspace& workspace, const std::string& name, double value) {
    if (!std::isfinite(value)) return;
    const std::optional<NumberRef> number = numberNamed(workspace.views[0], name);
    if (!number) return;
    if (number->kind == NumberKind::state)
        workspace.point[static_cast<std::size_t>(number->index)] = value;
    else if (isOfView(workspace.views[0], *number))
        return setNumber(workspace.view(), *number, value);
    else if (workspace.analysis() && isOnAxis(workspace.views[0].slice, name))
        return setNumber(workspace.views[workspace.speaker()], *number, value);
    for (Scene& scene : workspace.views) setNumber(scene, *number, value);
}

void setSharedParameter(Workspace& workspace, const std::string& name,
                        const std::vector<double>& value) {
    const MapInfo& info = mapOf(workspace.views[0]).info;
    int component = 0;
    for (const ParameterInfo& parameter : info.parameters) {
        const int width = widthOf(parameter.kind);
        for (int k = 0; k < width && name == parameter.name; ++k)
            setSharedNumber(workspace, parameterComponent(info, component + k),
                            value[static_cast<std::size_t>(k)]);
        component += width;
    }
}

std::array<double, 2> markerOf(const Scene& numbers, const SliceSpec& slice) {
    std::array<double, 2> marker{};
    for (std::size_t k = 0; k < std::min<std::size_t>(2, slice.axes.size()); ++k) {
        // The term of the largest weight says where on the axis the numbers are.
        const auto& terms = slice.axes[k].terms;
        const auto term = std::max_element(terms.begin(), terms.end(), [](auto& a, auto& b) {
            return std::abs(a.second) < std::abs(b.second);
        });
        if (term == terms.end() || term->second == 0) continue;
        const std::optional<NumberRef> number = numberNamed(numbers, term->first);
        if (!number) continue;
        marker[k] = (numberValue(numbers, *number) - originOf(slice, term->first)) / term->second;
    }
    return marker;
}

std::array<double, 2> markerOf(const Workspace& workspace, std::size_t view) {
    Scene numbers = workspace.views[workspace.speaker()];
    numbers.start = workspace.point;
    return markerOf(numbers, workspace.views[view].slice);
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
            const bool degree = name == mapOf(view).info.degreeParameter;
            if (number && number->kind != NumberKind::list && !degree) setNumber(scene, *number, 0);
        }
    return scene;
}

Scene orbitScene(const Workspace& workspace) {
    Scene scene = dynamicalView(workspace.views[workspace.speaker()]);
    for (const ParameterInfo& parameter : mapOf(scene).info.parameters)
        if (parameter.ofView) {
            const std::string name(parameter.name);
            scene.parameters[name] = workspace.view().parameters.at(name);
        }
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

Scene movingScene(const Workspace& workspace) {
    Scene scene = workspace.views[static_cast<std::size_t>(workspace.motionView)];
    scene.parameters = workspace.views[workspace.speaker()].parameters;
    scene.start = workspace.point;
    return scene;
}

void showMotion(Workspace& workspace, double time) {
    for (const auto& [name, value] : valuesAt(workspace.motion, time))
        if (numberNamed(workspace.views[0], name))
            setSharedNumber(workspace, name, value);
        else
            setMovingValue(workspace.views[static_cast<std::size_t>(workspace.motionView)], name,
                           value);
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

void dropUnnamedAssets(Workspace& workspace) {
    std::set<std::string> named;
    for (const Scene& scene : workspace.views) named.merge(namedAssets(scene));
    for (Scene& scene : workspace.views) dropAssetsExcept(scene, named);
}

std::string addSharedAsset(Workspace& workspace, Asset asset) {
    std::size_t bytes = asset.bytes.size();
    for (const auto& [hash, known] : workspace.views[0].assets) bytes += known->bytes.size();
    if (bytes > kMostAssetBytes) return {};
    const std::string source = addAsset(workspace.views[0], std::move(asset));
    for (Scene& scene : workspace.views) scene.assets = workspace.views[0].assets;
    return source;
}

std::vector<std::string> axisNames(const Scene& scene) {
    const MapKernels& map = mapOf(scene);
    std::vector<std::string> names;
    for (int k = 0; k < map.dimension; ++k) names.push_back(stateComponent(map.info, k));
    for (int k = 0; k < map.parameters; ++k) names.push_back(parameterComponent(map.info, k));
    return names;
}

void makeAxis(Workspace& workspace, std::size_t axis, const std::string& name) {
    int view = viewOfKind(workspace, ViewKind::parameters);
    if (view < 0) {
        view = 0;
        Scene& first = workspace.views[0];
        const Scene before = first;
        first = parameterView(before);
        if (first.slice.axes.size() < 2) first.slice = before.slice;
        // Its starting point stands still now, where it was.
        first.start = workspace.point;
    }
    const int focused = std::exchange(workspace.focused, view);
    setAxis(workspace, axis, name);
    workspace.focused = focused;
    if (!workspace.analysis()) return;
    const SliceSpec& slice = workspace.views[0].slice;
    for (const std::string& other : axisNames(workspace.views[0]))
        if (!isState(workspace.views[0], other) && !isOnAxis(slice, other))
            setSharedNumber(workspace, other, sharedNumber(workspace, other));
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
    if (!traitsOf(workspace.view()).ownStart) workspace.view().criticalStart.reset();
    keepEnsembleFitting(workspace.view());
}

void History::record(const Workspace& workspace) {
    if (workspaceKey(workspace) == workspaceKey(now())) return;
    states_.resize(at_ + 1);
    states_.push_back(workspace);
    if (states_.size() > kMost) states_.erase(states_.begin());
    at_ = states_.size() - 1;
}

}  // namespace versorium
