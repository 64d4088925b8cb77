// SPDX-License-Identifier: MIT
#include "lesson/observables.h"

#include <functional>
#include <limits>

#include "lesson/measures.h"
#include "maps/critical.h"
#include "render/bind.h"

namespace versorium {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

double listSize(const Scene& scene, const char* list) {
    const auto found = scene.lists.find(list);
    return found == scene.lists.end() ? 0 : static_cast<double>(found->second.roots.size());
}

// Its middle's components, then its radius.
double ofFirstCircle(const Workspace& workspace, std::size_t number) {
    if (workspace.circles.empty()) return kNoValue;
    const Workspace::Circle& circle = workspace.circles[0];
    return number < 2 ? circle.centre[number] : circle.radius;
}

struct Observable {
    const char* name;
    std::function<double(const Workspace&)> value;
};

const std::vector<Observable>& observables() {
    using W = const Workspace&;
    static const std::vector<Observable> all = {
        {"iterations", [](W w) { return static_cast<double>(w.views[0].iterations); }},
        {"escape_radius",
         [](W w) { return w.views[0].escapeRadius.value_or(automaticRadius(w.views[0])); }},
        {"orbit_at", [](W w) { return static_cast<double>(w.orbitAt); }},
        {"orbit_steps", [](W w) { return static_cast<double>(w.orbitSteps); }},
        {"height", [](W w) { return w.view().slice.height; }},
        {"center.x", [](W w) { return w.view().slice.centre[0]; }},
        {"center.y",
         [](W w) { return w.view().slice.centre.size() > 1 ? w.view().slice.centre[1] : 0.0; }},
        {"escapes", [](W w) { return 1 - ofOrbit(w, FieldName::membership); }},
        {"captured", [](W w) { return ofOrbit(w, FieldName::membership); }},
        {"escape_step", [](W w) { return ofOrbit(w, FieldName::escapeStep); }},
        {"period", [](W w) { return ofOrbit(w, FieldName::period); }},
        {"lyapunov", [](W w) { return ofOrbit(w, FieldName::lyapunov); }},
        {"end.x", [](W w) { return endOfOrbit(w, 0); }},
        {"end.y", [](W w) { return endOfOrbit(w, 1); }},
        {"critical_period", [](W w) { return ofCriticalOrbit(w, FieldName::period); }},
        {"critical_escapes", [](W w) { return 1 - ofCriticalOrbit(w, FieldName::membership); }},
        {"catalogue", isCatalogue},
        {"share", shareThatStays},
        {"shape_share", shareOfShape},
        {"fit", agreementWithShape},
        {"corners", cornersOfShape},
        {"phi", distanceAtStart},
        {"mean_phi", meanDistanceAround},
        {"capture_radius", captureRadius},
        {"mean_membership", memberShareAtStart},
        {"members", membersCounted},
        {"circles", [](W w) { return static_cast<double>(w.circles.size()); }},
        {"circles_captured", [](W w) { return circlesThatEnd(w, CircleEnd::captured); }},
        {"circles_escaping", [](W w) { return circlesThatEnd(w, CircleEnd::escapes); }},
        {"circles_decided", [](W w) { return circlesThatEnd(w, CircleEnd::decided); }},
        {"circle.x", [](W w) { return ofFirstCircle(w, 0); }},
        {"circle.y", [](W w) { return ofFirstCircle(w, 1); }},
        {"circle.radius", [](W w) { return ofFirstCircle(w, 2); }},
        {"pins", [](W w) { return static_cast<double>(w.pins.size()); }},
        {"pin_distance", distanceToPin},
        {"roots", [](W w) { return listSize(w.views[0], "roots"); }},
        {"poles", [](W w) { return listSize(w.views[0], "poles"); }},
    };
    return all;
}

const Observable* observableNamed(const std::string& name) {
    for (const Observable& one : observables())
        if (one.name == name) return &one;
    return nullptr;
}

}  // namespace

bool isObservable(const Workspace& workspace, const std::string& name) {
    if (name.starts_with("critical_") && !hasCriticalPoints(mapOf(workspace.views[0])))
        return false;
    return observableNamed(name) || numberNamed(workspace.views[0], name);
}

double observe(const Workspace& workspace, const std::string& name) {
    if (const Observable* one = observableNamed(name)) return one->value(workspace);
    return numberNamed(workspace.views[0], name) ? sharedNumber(workspace, name) : kNoValue;
}

std::string observableNames(const Workspace& workspace) {
    std::string names;
    for (const Observable& one : observables())
        if (isObservable(workspace, one.name)) names += std::string(one.name) + ", ";
    return names + "and the numbers of the map: " + numberNames(workspace.views[0]);
}

}  // namespace versorium
