// SPDX-License-Identifier: MIT
#include "ui/controls/controls.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "maps/critical.h"
#include "ui/controls/access.h"
#include "ui/controls/control_list.h"
#include "ui/session/ensemble_change.h"

namespace versorium {
namespace {

constexpr int kProbeIterations = 20000;

void collectMap(StudioContext& context, ControlList& all) {
    all.begin("Map");
    // Some maps share a title.
    const auto called = [](const MapInfo& info) {
        return std::string(info.title) + " (" + std::string(info.name) + ")";
    };
    std::vector<std::string> names;
    std::vector<std::string> shown;
    const auto also = [&](const MapInfo& info) {
        names.push_back(called(info));
        shown.push_back(tr(info.title) + " (" + std::string(info.name) + ")");
    };
    for (const MapKernels& map : catalogue()) also(map.info);
    if (context.workspace.views[0].formula) also(mapOf(context.workspace.views[0]).info);
    StudioContext* c = &context;
    all.choice(
        "map", "map", called(mapOf(context.workspace.views[0]).info), names,
        [c, called](const std::string& name) {
            for (const MapKernels& map : catalogue())
                if (called(map.info) == name) return c->newMap(std::string(map.info.name));
        },
        shown);
    const std::shared_ptr<const FormulaMap> typed = context.workspace.views[0].formula;
    all.text("formula", "formula of your own", typed ? typed->formula().text : std::string(),
             [c, typed](const std::string& text) {
                 if (text.empty() && !typed) return true;
                 const Status status = applyFormula(*c, text);
                 c->report(status);
                 if (status.ok()) c->welcome = false;
                 return status.ok();
             });
    if (typed)
        all.text("save formula", "name to save the formula under", "",
                 [c, typed](const std::string& name) {
                     if (name.empty()) return true;
                     const Status status = c->formulas.save(c->host, name, typed->formula().text);
                     status.ok() ? c->say(tr("The formula is saved as {1}", {name}))
                                 : c->report(status);
                     return status.ok();
                 });
    if (!context.formulas.all().empty()) {
        std::vector<std::string> saved;
        for (const SavedFormula& one : context.formulas.all()) saved.push_back(one.name);
        const auto chosen = [c](const std::string& name) {
            for (const SavedFormula& one : c->formulas.all())
                if (one.name == name) return c->report(applyFormula(*c, one.text));
        };
        all.choice("saved formula", "open a saved formula", "", saved, chosen, saved);
    }
    // Nothing is chosen: a preset is a beginning, not a state.
    std::vector<std::string> presets = presetNames();
    all.choice("preset", "open a preset", "", presets, [c](const std::string& name) {
        Expected<Scene> scene = presetNamed(name);
        if (!scene) return c->report(scene.status());
        c->open(workspaceOf(*scene));
    });
}

void collectParameters(StudioContext& context, ControlList& all) {
    all.begin("Parameters");
    StudioContext* c = &context;
    const MapInfo& info = mapOf(context.workspace.views[0]).info;
    std::vector<std::string> names;
    for (int k = 0; k < parameterSize(info); ++k) names.push_back(parameterComponent(info, k));
    for (const std::string& name : names) all.value(*propertyNamed(context.workspace.view(), name));
    std::vector<std::string> numbers{"none"};
    numbers.insert(numbers.end(), names.begin(), names.end());
    std::vector<std::string> shown = numbers;
    shown[0] = tr("none");
    const Player::Animation& moving = context.player.animation;
    const bool runs =
        moving.running && std::find(numbers.begin(), numbers.end(), moving.number) != numbers.end();
    all.choice(
        "animate", "number that is animated", runs ? moving.number : "none", numbers,
        [c](const std::string& name) {
            c->player.animation.running = false;
            if (name == "none") return;
            const double now = sharedNumber(c->workspace, name);
            c->player.animate(name, now - 1, now + 1);
        },
        shown);
    all.values({"animation.to_and_fro"});
    all.command("reset", "The map's own parameters", "", [c, &info] {
        c->edit([&](Workspace& w) {
            for (const ParameterInfo& parameter : info.parameters) {
                const auto* first = parameter.value.data();
                setSharedParameter(w, std::string(parameter.name),
                                   {first, first + widthOf(parameter.kind)});
            }
        });
    });
}

void collectOrbit(StudioContext& context, ControlList& all) {
    all.begin("Orbit");
    const Scene& scene = context.workspace.view();
    const MapKernels& map = mapOf(scene);
    for (int k = 0; k < map.dimension; ++k)
        all.value(*propertyNamed(scene, stateComponent(map.info, k)));
    all.values({"orbit_at", "arrows", "orbit_steps", "iterations", "escape_radius", "escape_test"});
}

void collectSlice(StudioContext& context, ControlList& all) {
    all.begin("Slice of the focused view");
    StudioContext* c = &context;
    const Scene& scene = context.workspace.view();
    const MapKernels& map = mapOf(scene);
    const std::vector<std::string> names = axisNames(scene);
    const std::size_t axes = std::min<std::size_t>(2, scene.slice.axes.size());
    for (std::size_t k = 0; k < axes; ++k) {
        const auto& terms = scene.slice.axes[k].terms;
        all.choice(
            "slice.axes[" + std::to_string(k) + "]", k == 0 ? "axis →" : "axis ↑",
            terms.size() == 1 ? terms[0].first : "", names,
            [c, k](const std::string& name) {
                c->edit([&](Workspace& w) { setAxis(w, k, name); });
            },
            names);
    }
    for (std::size_t k = 0; k < axes; ++k)
        all.values({k == 0 ? "slice.center[0]" : "slice.center[1]"});
    all.values({"slice.height", "samples"});
    if (hasCriticalPoints(map) && traitsOf(scene).ownStart)
        all.toggle("critical", "start at the critical point", scene.criticalStart.has_value(),
                   [c](bool on) {
                       c->edit([on](Workspace& w) {
                           w.view().criticalStart = on ? std::optional<int>(0) : std::nullopt;
                       });
                   });
    if (const auto start = startOf(context, context.workspace.focused);
        start && !scene.criticalStart) {
        const int view = context.workspace.focused;
        for (std::size_t k = 0; k < start->size(); ++k)
            all.number("start " + std::to_string(k),
                       "p*, " + stateComponent(map.info, static_cast<int>(k)), (*start)[k], 0.01,
                       -1e6, 1e6, [c, view, k, start](double value) {
                           std::vector<double> moved = *start;
                           if (moved[k] == value) return;
                           moved[k] = value;
                           setStart(*c, view, std::move(moved));
                       });
        if (map.dimension == 2)
            all.command("nearest", "p* to the nearest critical point", "", [c, view, start] {
                startAtNearest(*c, view, {(*start)[0], (*start)[1]});
            });
    }
}

void collectStudies(StudioContext& context, ControlList& all) {
    all.begin("Cycles, critical curve, diagram");
    StudioContext* c = &context;
    const Workspace& workspace = context.workspace;
    const MapKernels& map = mapOf(workspace.views[0]);
    if (map.dimension == 2) all.values({"study.critical_curve"});
    if (map.dimension <= 2) all.values({"study.cycles", "study.most_period"});
    if (map.dimension == 2) all.values({"study.manifolds"});
    all.toggle("compared", "second start to compare", !workspace.compared.empty(), [c](bool on) {
        if (on != c->workspace.compared.empty()) return;
        c->edit([on](Workspace& w) { w.compared = on ? w.point : std::vector<double>(); });
    });
    for (std::size_t k = 0; k < workspace.compared.size(); ++k)
        all.number("second " + std::to_string(k),
                   tr("second start {1}", {stateComponent(map.info, static_cast<int>(k))}),
                   workspace.compared[k], 0.01, -1e6, 1e6,
                   [c, k](double value) { c->edit([&](Workspace& w) { w.compared[k] = value; }); });
    if (map.parameters == 0) return;
    std::vector<std::string> names;
    for (int k = 0; k < map.parameters; ++k) names.push_back(parameterComponent(map.info, k));
    const Workspace::Diagram diagram = diagramOf(workspace);
    all.choice(
        "diagram number", "parameter of the bifurcation diagram", diagram.number, names,
        [c](const std::string& name) { c->edit([&](Workspace& w) { setDiagramNumber(w, name); }); },
        names);
    const double step = (diagram.right - diagram.left) / 40;
    for (const bool left : {true, false})
        all.number(left ? "diagram from" : "diagram to",
                   left ? "bifurcation diagram from" : "bifurcation diagram to",
                   left ? diagram.left : diagram.right, step, -1e6, 1e6,
                   [c, diagram, left](double value) {
                       Workspace::Diagram next = diagram;
                       (left ? next.left : next.right) = value;
                       const bool same = next == diagram;
                       if (!same && next.left < next.right)
                           c->edit([&](Workspace& w) { w.diagram = next; });
                   });
}

void collectColours(ControlList& all) {
    all.begin("Colours of the focused view");
    all.group("colour");
}

std::vector<ControlEntry> entriesOf(StudioContext& context) {
    ControlList all(context);
    collectMap(context, all);
    collectParameters(context, all);
    collectShape(context, all);
    collectVersor(context, all);
    collectOrbit(context, all);
    collectSlice(context, all);
    collectStudies(context, all);
    collectColours(all);
    collectEnsemble(context, all);
    collectLayers(context, all);
    collectMotion(context, all);
    collectWindow(context, all);
    collectLessons(context, all);
    collectCommands(context, all);
    return std::move(all.entries);
}

const char* kindName(ControlKind kind) {
    switch (kind) {
        case ControlKind::number:
            return "number";
        case ControlKind::choice:
            return "choice";
        case ControlKind::toggle:
            return "toggle";
        case ControlKind::colour:
            return "colour";
        case ControlKind::text:
            return "text";
        default:
            return "command";
    }
}

// What becomes of the orbit's starting point.
std::string fate(StudioContext& context) {
    const OrbitProgram* bound = context.bound.orbitProgram();
    if (!bound) return {};
    OrbitProgram program = *bound;
    program.iterations = std::min(program.iterations, kProbeIterations);
    const SliceSpec slice = orbitScene(context.workspace).slice;
    const double at[2] = {slice.centre[0], slice.centre.size() > 1 ? slice.centre[1] : 0};
    const double* coordinates[2] = {&at[0], &at[1]};
    const FieldName fields[] = {FieldName::membership, FieldName::escapeStep, FieldName::period};
    const auto values = evaluateFields(program, 1, coordinates, fields);
    if (values[0][0] != 1)
        return tr("; its orbit escapes at step {1}", {shownNumber(values[1][0], 8)});
    const std::string steps = std::to_string(program.iterations);
    if (values[2][0] == 0) return tr("; its orbit stays for {1} steps", {steps});
    return tr("; its orbit stays for {1} steps, drawn to a cycle of period {2}",
              {steps, shownNumber(values[2][0], 5)});
}

}  // namespace

std::vector<Control> controlsOf(StudioContext& context) {
    std::vector<Control> controls;
    for (ControlEntry& entry : entriesOf(context)) {
        const Access access = accessOf(context, entry.control.id);
        if (access == Access::hidden) continue;
        entry.control.locked = access == Access::locked;
        controls.push_back(std::move(entry.control));
    }
    return controls;
}

bool setControl(StudioContext& context, const std::string& name, const std::string& value) {
    const std::string id = pathOfOldName(name);
    if (accessOf(context, id) != Access::open) return false;
    for (const ControlEntry& entry : entriesOf(context))
        if (entry.control.id == id) return entry.set(value);
    return false;
}

std::string describeView(StudioContext& context, int view) {
    const Workspace& workspace = context.workspace;
    const auto index = static_cast<std::size_t>(view);
    const Scene& scene = workspace.views[index];
    const ViewTraits& traits = traitsOf(scene);
    const auto marker = markerOf(workspace, index);
    std::string middle, ring;
    for (std::size_t k = 0; k < std::min<std::size_t>(2, scene.slice.axes.size()); ++k) {
        const std::string name = (k ? " " : "") + scene.slice.axes[k].terms[0].first + " = ";
        middle += name + shownNumber(scene.slice.centre[k], 5);
        ring += name + shownNumber(marker[k], 5);
    }
    if (traits.orbit) ring += fate(context);
    std::string text = tr(traits.spoken, {std::to_string(view + 1), tr(mapOf(scene).info.title),
                                          shownNumber(scene.slice.height, 3), middle, ring});
    const std::string average = describeEnsemble(context, view);
    if (!average.empty()) text += " " + average;
    if (context.workspace.plot == PlotPanel::profile && traits.circles)
        text += " " + describeProfile(context);
    if (traits.circles) text += describeCircles(context);
    return text;
}

std::string controlsText(StudioContext& context) {
    Json controls = Json::array();
    for (const Control& control : controlsOf(context)) {
        Json entry{{"id", control.id},
                   {"group", control.group},
                   {"label", control.label},
                   {"kind", kindName(control.kind)},
                   {"value", control.value}};
        if (control.kind == ControlKind::number) entry["step"] = control.step;
        if (control.kind == ControlKind::choice) {
            entry["options"] = control.options;
            entry["shown"] = control.shown;
        }
        if (control.low < control.high) entry["range"] = {control.low, control.high};
        if (control.locked) entry["locked"] = true;
        controls.push_back(std::move(entry));
    }
    Json views = Json::array();
    const Workspace& workspace = context.workspace;
    for (int k = 0; k < static_cast<int>(workspace.views.size()); ++k) {
        const ViewState& state = context.views[static_cast<std::size_t>(k)];
        Json view{{"text", describeView(context, k)}};
        if (state.low.x < state.high.x) {
            view["low"] = {state.low.x, state.low.y};
            view["high"] = {state.high.x, state.high.y};
        }
        views.push_back(std::move(view));
    }
    return Json{{"controls", controls},
                {"views", views},
                {"focused", workspace.focused},
                {"language", languageNow().id},
                {"decimal", std::string(1, languageNow().decimal)}}
        .dump();
}

}  // namespace versorium
