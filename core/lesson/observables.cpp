// SPDX-License-Identifier: MIT
#include "lesson/observables.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "fields/evaluate.h"
#include "maps/critical.h"
#include "render/bind.h"

namespace versorium {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr int kShareSide = 64;

std::optional<OrbitProgram> bound(const Scene& scene) {
    Binder binder;
    if (binder.missingGrid(scene)) return {};
    Job job(1);
    Expected<OrbitProgram> program = binder.bind(scene, job);
    if (!program) return {};
    return std::move(*program);
}

// A field of one orbit: that of the scene's own middle.
double measure(const Scene& scene, FieldName field) {
    const std::optional<OrbitProgram> program = bound(scene);
    if (!program) return kUnknown;
    std::vector<const double*> coordinates;
    std::vector<double> middle = scene.slice.centre;
    for (const double& value : middle) coordinates.push_back(&value);
    return evaluateFields(*program, 1, coordinates.data(), std::vector<FieldName>{field})[0][0];
}

// The orbit of the first critical point, at the numbers that are set now.
Scene criticalScene(const Workspace& workspace) {
    Scene scene = orbitScene(workspace);
    scene.criticalStart = 0;
    // Axes of the start mean nothing to it: the first parameter stays where it is.
    const MapInfo& info = mapOf(scene).info;
    scene.slice = {};
    for (int k = 0; k < 2; ++k) {
        const std::string name = parameterComponent(info, std::min(k, mapOf(scene).parameters - 1));
        if (k == 1 && scene.slice.axes[0].terms[0].first == name) break;
        scene.slice.axes.push_back({{{name, 1.0}}});
        scene.slice.centre.push_back(sharedNumber(workspace, name));
        scene.slice.centreLow.push_back(0);
    }
    return scene;
}

double share(const Workspace& workspace) {
    const auto view = std::find_if(workspace.views.begin(), workspace.views.end(),
                                   [](const Scene& scene) { return !showsParameters(scene); });
    if (view == workspace.views.end()) return kUnknown;
    const std::optional<OrbitProgram> program = bound(*view);
    if (!program || view->slice.axes.size() != 2) return kUnknown;
    std::vector<double> u, v;
    const double height = view->slice.height;
    for (int i = 0; i < kShareSide * kShareSide; ++i) {
        u.push_back(view->slice.centre[0] + height * ((i % kShareSide + 0.5) / kShareSide - 0.5));
        v.push_back(view->slice.centre[1] + height * ((i / kShareSide + 0.5) / kShareSide - 0.5));
    }
    const double* coordinates[] = {u.data(), v.data()};
    const std::vector<double> inside =
        evaluateFields(*program, kShareSide * kShareSide, coordinates,
                       std::vector<FieldName>{FieldName::membership})[0];
    double count = 0;
    for (double one : inside) count += one;
    return count / (kShareSide * kShareSide);
}

double pinDistance(const Workspace& workspace) {
    if (workspace.pins.empty()) return kUnknown;
    double sum = 0;
    const auto& now = workspace.views[workspace.speaker()].parameters;
    for (const auto& [name, value] : workspace.pins[0]) {
        const auto found = now.find(name);
        for (std::size_t k = 0; found != now.end() && k < value.size(); ++k)
            sum += (value[k] - found->second[k]) * (value[k] - found->second[k]);
    }
    return std::sqrt(sum);
}

double listSize(const Scene& scene, const char* list) {
    const auto found = scene.lists.find(list);
    return found == scene.lists.end() ? 0 : static_cast<double>(found->second.roots.size());
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
        {"escapes", [](W w) { return 1 - measure(orbitScene(w), FieldName::membership); }},
        {"captured", [](W w) { return measure(orbitScene(w), FieldName::membership); }},
        {"escape_step", [](W w) { return measure(orbitScene(w), FieldName::escapeStep); }},
        {"period", [](W w) { return measure(orbitScene(w), FieldName::period); }},
        {"lyapunov", [](W w) { return measure(orbitScene(w), FieldName::lyapunov); }},
        {"critical_period", [](W w) { return measure(criticalScene(w), FieldName::period); }},
        {"critical_escapes",
         [](W w) { return 1 - measure(criticalScene(w), FieldName::membership); }},
        {"share", share},
        {"pins", [](W w) { return static_cast<double>(w.pins.size()); }},
        {"circles", [](W w) { return static_cast<double>(w.circles.size()); }},
        {"pin_distance", pinDistance},
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
    return numberNamed(workspace.views[0], name) ? sharedNumber(workspace, name) : kUnknown;
}

std::string observableNames(const Workspace& workspace) {
    std::string names;
    for (const Observable& one : observables())
        if (isObservable(workspace, one.name)) names += std::string(one.name) + ", ";
    return names + "and the numbers of the map: " + numberNames(workspace.views[0]);
}

}  // namespace versorium
