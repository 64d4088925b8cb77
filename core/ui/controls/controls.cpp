// SPDX-License-Identifier: MIT
#include "ui/controls/controls.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "maps/critical.h"
#include "ui/controls/access.h"
#include "ui/controls/control_list.h"
#include "ui/panels/roots_panel.h"
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

// The range of a parameter's slider, as in the inspector.
std::array<double, 2> sliderOf(const Workspace& workspace, const ParameterInfo& parameter,
                               const std::string& name) {
    if (const auto own = workspace.ranges.find(name); own != workspace.ranges.end())
        return own->second;
    if (widthOf(parameter.kind) == 1) return {parameter.low, parameter.high};
    return {std::max(parameter.low, -2.0), std::min(parameter.high, 2.0)};
}

void collectParameters(StudioContext& context, ControlList& all) {
    all.begin("Parameters");
    StudioContext* c = &context;
    const MapInfo& info = mapOf(context.workspace.views[0]).info;
    int component = 0;
    for (const ParameterInfo& parameter : info.parameters) {
        const bool whole = parameter.kind == ParameterKind::whole;
        for (int k = 0; k < widthOf(parameter.kind); ++k) {
            const std::string name = parameterComponent(info, component++);
            all.number(
                name, name, sharedNumber(context.workspace, name),
                whole ? 1 : (parameter.high - parameter.low) / 400, -1e6, 1e6,
                [c, name, whole](double value) {
                    setSharedNumber(c->workspace, name, whole ? std::round(value) : value);
                },
                sliderOf(context.workspace, parameter, name));
        }
    }
    std::vector<std::string> numbers{"none"};
    for (int k = 0; k < component; ++k) numbers.push_back(parameterComponent(info, k));
    std::vector<std::string> shown = numbers;
    shown[0] = tr("none");
    const StudioContext::Animation& moving = context.animation;
    const bool runs =
        moving.running && std::find(numbers.begin(), numbers.end(), moving.number) != numbers.end();
    all.choice(
        "animate", "number that is animated", runs ? moving.number : "none", numbers,
        [c](const std::string& name) {
            c->animation.running = false;
            if (name == "none") return;
            const double now = sharedNumber(c->workspace, name);
            c->animate(name, now - 1, now + 1);
        },
        shown);
    all.toggle("animate-to-and-fro", "the animation runs to and fro", moving.toAndFro,
               [c](bool on) { c->animation.toAndFro = on; });
    all.command("reset", "The map's own parameters", "", [c, &info] {
        for (const ParameterInfo& parameter : info.parameters) {
            const auto* first = parameter.value.data();
            setSharedParameter(c->workspace, std::string(parameter.name),
                               {first, first + widthOf(parameter.kind)});
        }
        c->touch();
    });
}

void collectOrbit(StudioContext& context, ControlList& all) {
    all.begin("Orbit");
    StudioContext* c = &context;
    const Scene& scene = context.workspace.view();
    const MapKernels& map = mapOf(scene);
    for (int k = 0; k < map.dimension; ++k) {
        const std::string name = stateComponent(map.info, k);
        all.number(
            name, tr("starting point {1}", {name}), sharedNumber(context.workspace, name), 0.01,
            -1e6, 1e6, [c, name](double value) { setSharedNumber(c->workspace, name, value); },
            map.dimension == 1 ? std::array<double, 2>{0, 1} : std::array<double, 2>{-2, 2});
    }
    all.number("marked step", "step that is marked", context.workspace.orbitAt, 1, 0,
               kMostOrbitSteps,
               [c](double value) { c->stepOrbit(static_cast<int>(value) - c->workspace.orbitAt); },
               {0, static_cast<double>(std::max(1, context.workspace.orbitSteps))});
    all.toggle("arrows", "arrows from points to their images", context.workspace.arrows,
               [c](bool on) { c->workspace.arrows = on; });
    all.number("steps", "steps that are drawn", context.workspace.orbitSteps, 1, 0, 1000,
               [c](double value) { c->workspace.orbitSteps = static_cast<int>(value); });
    all.number("iterations", "max iterations N", scene.iterations, 50, 1, 1000000,
               [c](double value) { c->workspace.view().iterations = static_cast<int>(value); },
               {1, 1000});
    const double radius = scene.escapeRadius.value_or(automaticRadius(scene));
    if (std::isfinite(radius))
        all.number("radius", "escape radius", radius, 0.5, 1e-6, 1e6,
                   [c](double value) { c->workspace.view().escapeRadius = value; });
    all.choice("escape test", "which points of an orbit may escape", scene.escapeTest,
               {"first", "last"},
               [c](const std::string& word) { c->workspace.view().escapeTest = word; });
}

void collectSlice(StudioContext& context, ControlList& all) {
    all.begin("Slice of the marked view");
    StudioContext* c = &context;
    const Scene& scene = context.workspace.view();
    const MapKernels& map = mapOf(scene);
    const std::vector<std::string> names = axisNames(scene);
    const std::size_t axes = std::min<std::size_t>(2, scene.slice.axes.size());
    for (std::size_t k = 0; k < axes; ++k) {
        const auto& terms = scene.slice.axes[k].terms;
        all.choice(
            "axis" + std::to_string(k), k == 0 ? "axis to the right" : "axis upwards",
            terms.size() == 1 ? terms[0].first : "", names,
            [c, k](const std::string& name) { setAxis(c->workspace, k, name); }, names);
    }
    for (std::size_t k = 0; k < axes; ++k)
        all.number("centre" + std::to_string(k),
                   tr("centre, {1}", {scene.slice.axes[k].terms[0].first}), scene.slice.centre[k],
                   scene.slice.height / 20, -1e6, 1e6, [c, k](double value) {
                       c->workspace.view().slice.centre[k] = value;
                       c->workspace.view().slice.centreLow[k] = 0;
                   });
    all.number("height", "height that is shown", scene.slice.height, scene.slice.height / 10, 1e-13,
               1e6, [c](double value) { c->workspace.view().slice.height = value; });
    all.number("samples", "samples along a pixel", scene.samples, 1, 1, kMostSamples,
               [c](double value) { c->workspace.view().samples = static_cast<int>(value); });
    if (hasCriticalPoints(map) && showsParameters(scene))
        all.toggle("critical", "start at the critical point", scene.criticalStart.has_value(),
                   [c](bool on) {
                       std::optional<int>& start = c->workspace.view().criticalStart;
                       if (on)
                           start = 0;
                       else
                           start.reset();
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
    Workspace& workspace = context.workspace;
    const MapKernels& map = mapOf(workspace.views[0]);
    if (map.dimension == 2)
        all.toggle("critical curve", "critical curve det J = 0", workspace.study.criticalCurve,
                   [c](bool on) { c->workspace.study.criticalCurve = on; });
    if (map.dimension <= 2) {
        all.toggle("cycles", "fixed points and cycles", workspace.study.cycles,
                   [c](bool on) { c->workspace.study.cycles = on; });
        all.number("most period", "period of cycles, at most", workspace.study.mostPeriod, 1, 1,
                   kMostShownPeriod,
                   [c](double value) { c->workspace.study.mostPeriod = static_cast<int>(value); });
    }
    if (map.dimension == 2)
        all.toggle("manifolds", "manifolds of saddles", workspace.study.manifolds,
                   [c](bool on) { c->workspace.study.manifolds = on; });
    all.toggle("compared", "second start to compare", !workspace.compared.empty(), [c](bool on) {
        if (on != c->workspace.compared.empty()) return;
        c->workspace.compared = on ? c->workspace.point : std::vector<double>();
    });
    for (std::size_t k = 0; k < workspace.compared.size(); ++k)
        all.number("second " + std::to_string(k),
                   tr("second start {1}", {stateComponent(map.info, static_cast<int>(k))}),
                   workspace.compared[k], 0.01, -1e6, 1e6,
                   [c, k](double value) { c->workspace.compared[k] = value; });
    if (map.parameters == 0) return;
    std::vector<std::string> names;
    for (int k = 0; k < map.parameters; ++k) names.push_back(parameterComponent(map.info, k));
    const Workspace::Diagram diagram = diagramOf(workspace);
    all.choice(
        "diagram number", "parameter of the bifurcation diagram", diagram.number, names,
        [c](const std::string& name) { setDiagramNumber(c->workspace, name); }, names);
    const double step = (diagram.right - diagram.left) / 40;
    for (const bool left : {true, false})
        all.number(left ? "diagram from" : "diagram to",
                   left ? "bifurcation diagram from" : "bifurcation diagram to",
                   left ? diagram.left : diagram.right, step, -1e6, 1e6,
                   [c, diagram, left](double value) {
                       Workspace::Diagram next = diagram;
                       (left ? next.left : next.right) = value;
                       const bool same = next == diagram;
                       if (!same && next.left < next.right) c->workspace.diagram = next;
                   });
}

void collectGradient(ControlList& all, const std::string& name, Gradient& gradient) {
    all.colour(name + " fast", tr("{1}: colour of the fast", {tr(name.c_str())}), gradient.start);
    all.colour(name + " slow", tr("{1}: colour of the slow", {tr(name.c_str())}), gradient.finish);
    all.number(name + " exponent", tr("{1}: colour exponent", {tr(name.c_str())}),
               gradient.exponent, 0.1, 0.01, 100,
               [&gradient](double value) { gradient.exponent = value; });
}

void collectColours(StudioContext& context, ControlList& all) {
    all.begin("Colours of the marked view");
    Colouring& colour = context.workspace.view().colour;
    const auto word = [&](const char* id, const char* label, std::string& value,
                          const std::vector<std::string>& options) {
        all.choice(id, label, value, options,
                   [&value](const std::string& wanted) { value = wanted; });
    };
    word("rule", "colour by", colour.rule, {"palette", "gradient", "versor", "phase", "domain"});
    if (colour.rule == "palette") {
        std::vector<std::string> fields;
        for (const FieldInfo& field : allFields())
            if (field.field != FieldName::versor) fields.emplace_back(field.name);
        all.choice("field", "field", colour.field, fields, [&colour](const std::string& name) {
            colour.field = name;
            colour.range.clear();
            colour.scale.clear();
        });
        const std::string own = trLater("the field's own");
        all.choice("scale", "scale", colour.scale.empty() ? own : colour.scale,
                   {own, "linear", "log", "truncated_log", "sqrt", "cyclic"},
                   [&colour, own](const std::string& name) {
                       colour.scale = name == own ? std::string() : name;
                   });
        all.toggle("interior", "the set in its own colour", colour.interior == "membership",
                   [&colour](bool on) { colour.interior = on ? "membership" : "none"; });
    }
    if (colour.rule == "palette" || colour.rule == "phase" || colour.rule == "domain") {
        word("palette", "palette", colour.palette, paletteNames());
        all.toggle("reverse", "reversed", colour.reverse,
                   [&colour](bool on) { colour.reverse = on; });
    }
    if (colour.rule == "gradient") {
        collectGradient(all, "escaped", colour.escaped);
        collectGradient(all, "attracted", colour.attracted);
        word("smoothing", "smoothing", colour.smoothing, {"none", "ratio", "log-log"});
    }
    word("outline", "outline", colour.outline, {"none", "membership", "solid"});
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
    collectColours(context, all);
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
    const OrbitProgram* bound = context.orbitProgram();
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

bool setControl(StudioContext& context, const std::string& id, const std::string& value) {
    if (accessOf(context, id) != Access::open) return false;
    for (const ControlEntry& entry : entriesOf(context))
        if (entry.control.id == id) return entry.set(value);
    return false;
}

std::string describeView(StudioContext& context, int view) {
    const Workspace& workspace = context.workspace;
    const auto index = static_cast<std::size_t>(view);
    const Scene& scene = workspace.views[index];
    const bool parameters = showsParameters(scene);
    const auto marker = markerOf(workspace, index);
    std::string middle, ring;
    for (std::size_t k = 0; k < std::min<std::size_t>(2, scene.slice.axes.size()); ++k) {
        const std::string name = (k ? " " : "") + scene.slice.axes[k].terms[0].first + " = ";
        middle += name + shownNumber(scene.slice.centre[k], 5);
        ring += name + shownNumber(marker[k], 5);
    }
    if (!parameters) ring += fate(context);
    std::string text =
        tr(parameters
               ? trLater("View {1}, parameters of {2}: height {3} around {4}. The ring is at {5}.")
               : trLater("View {1}, starting points of {2}: height {3} around {4}. The ring is at "
                         "{5}."),
           {std::to_string(view + 1), tr(mapOf(scene).info.title),
            shownNumber(scene.slice.height, 3), middle, ring});
    const std::string average = describeEnsemble(context, view);
    if (!average.empty()) text += " " + average;
    if (context.workspace.strip == StudioContext::Strip::profile && !parameters)
        text += " " + describeProfile(context);
    if (!parameters) text += describeCircles(context);
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
