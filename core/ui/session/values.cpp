// SPDX-License-Identifier: MIT
#include "ui/session/values.h"

#include <algorithm>
#include <cmath>

#include "scene/numbers.h"
#include "ui/session/context.h"
#include "ui/session/studio_properties.h"

namespace versorium {
namespace {

// Another field has another range: what was stretched for the one before goes.
void forgetRange(Colouring& colour) {
    colour.range.clear();
    colour.scale.reset();
}

Status setInAll(Workspace& workspace, const SceneProperty& property, const Json& value) {
    std::vector<Scene> views = workspace.views;
    for (Scene& scene : views)
        if (Status status = setProperty(scene, property, value); !status.ok()) return status;
    workspace.views = std::move(views);
    return {};
}

// Names of values of older versions, with their paths now.
const std::map<std::string, std::string, std::less<>>& oldNames() {
    static const std::map<std::string, std::string, std::less<>> names = [] {
        std::map<std::string, std::string, std::less<>> all;
        const Workspace workspace = workspaceOf(sceneOf(
            *findMapWhere([](const MapInfo& info) { return info.field && !info.lists.empty(); })));
        for (const SceneProperty& property : propertiesOf(workspace.views[0]))
            if (!property.alias.empty()) all.emplace(property.alias, property.path);
        for (const WorkspaceProperty& property : propertiesOf(workspace))
            if (!property.alias.empty()) all.emplace(property.alias, property.path);
        for (const StudioProperty& property : studioProperties())
            if (!property.alias.empty()) all.emplace(property.alias, property.path);
        return all;
    }();
    return names;
}

}  // namespace

namespace {

Status setIn(Workspace& workspace, const SceneProperty& property, const Json& value) {
    if (numberNamed(workspace.views[0], property.path)) {
        double number = 0;
        const Status status = readNumber(value, property.low, property.high, number);
        if (!status.ok()) return status.in(property.path);
        if (property.kind == ValueKind::whole) number = std::round(number);
        setSharedNumber(workspace, property.path, number);
    } else if (property.shared) {
        if (Status status = setInAll(workspace, property, value); !status.ok()) return status;
        dropUnnamedAssets(workspace);
    } else {
        if (Status status = setProperty(workspace.view(), property, value); !status.ok())
            return status;
        Colouring& colour = workspace.view().colour;
        if (property.path == "colour.field") forgetRange(colour);
        if (property.path == "colour.contours")
            std::sort(colour.contours.begin(), colour.contours.end());
    }
    return {};
}

Status setIn(Workspace& workspace, const WorkspaceProperty& property, const Json& value) {
    if (Status status = property.set(workspace, value, property.path); !status.ok()) return status;
    workspace.orbitSteps = std::max(workspace.orbitSteps, workspace.orbitAt);
    return {};
}

template <class P>
Status setAny(StudioContext& context, const P& property, const Json& value) {
    Status status = context.edit([&](Workspace& w) { return setIn(w, property, value); });
    if (status.ok()) context.welcome = false;
    return status;
}

}  // namespace

Status setValue(StudioContext& context, const SceneProperty& property, const Json& value) {
    return setAny(context, property, value);
}

Status setValue(StudioContext& context, const WorkspaceProperty& property, const Json& value) {
    return setAny(context, property, value);
}

std::string pathOfOldName(const std::string& name) {
    const auto old = oldNames().find(name);
    return old == oldNames().end() ? name : old->second;
}

bool namesValue(std::string_view name, std::string_view path) {
    if (name == path) return true;
    // "circles[0].centre1" of older versions.
    if (const std::size_t at = name.find("].centre"); at != std::string_view::npos) {
        const std::string now =
            std::string(name.substr(0, at)) + "].center[" + std::string(name.substr(at + 8)) + "]";
        return now == path;
    }
    if (path.size() > name.size() && path.starts_with(name) &&
        (path[name.size()] == '.' || path[name.size()] == '['))
        return true;
    const auto old = oldNames().find(name);
    if (old != oldNames().end() && old->second == path) return true;
    for (std::string_view section : {"slice.", "shape.", "colour.", "ensemble."})
        if (path.starts_with(section) && path.substr(section.size()) == name) return true;
    return false;
}

bool namesControl(const MapInfo& info, const std::string& name, const std::string& id) {
    if (name != "point") return namesValue(name, id);
    for (int k = 0; k < dimensionOf(info.algebra); ++k)
        if (stateComponent(info, k) == id) return true;
    return false;
}

}  // namespace versorium
