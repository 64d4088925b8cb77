// SPDX-License-Identifier: MIT
#include "plate/scene_panels.h"

#include <algorithm>
#include <memory>

#include "dynamics/bifurcation_diagram.h"
#include "dynamics/critical_set.h"
#include "dynamics/manifolds.h"
#include "io/document.h"
#include "render/colouring.h"
#include "render/shape_profile.h"
#include "render/system_of.h"
#include "scene/numbers.h"
#include "scene/shape_name.h"

namespace versorium {
namespace {

// With a true minus sign.
std::string number(double value, const Words& words) {
    std::string text = words.number(formatNumber(value, 6));
    if (!text.empty() && text[0] == '-') text.replace(0, 1, "\u2212");
    return text;
}

std::string complexNumber(double re, double im, const Words& words) {
    if (im == 0) return number(re, words);
    const double size = im < 0 ? -im : im;
    const std::string imaginary = size == 1 ? "i" : number(size, words) + "i";
    if (re == 0) return (im < 0 ? "\u2212" : "") + imaginary;
    return number(re, words) + (im < 0 ? " \u2212 " : " + ") + imaginary;
}

std::string valueText(const ParameterInfo& parameter, const std::vector<double>& value,
                      const Words& words) {
    if (parameter.kind == ParameterKind::complex) return complexNumber(value[0], value[1], words);
    if (value.size() == 1) return number(value[0], words);
    std::string text = "(";
    for (std::size_t k = 0; k < value.size(); ++k)
        text += (k > 0 ? words.separator() : "") + number(value[k], words);
    return text + ")";
}

// "z.re" -> "Re z", "g.b1" -> "b_{1}^{g}", "q.w" -> "w", "roots[2].re" -> "Re roots_{2}".
std::string axisName(const std::string& name, const Words& words) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) return name == "power" ? words.tr("exponent d") : name;
    std::string owner = name.substr(0, dot);
    const std::string part = name.substr(dot + 1);
    if (const std::size_t open = owner.find('['); open != std::string::npos)
        owner =
            owner.substr(0, open) + "_{" + owner.substr(open + 1, owner.find(']') - open - 1) + "}";
    if (part == "re") return "Re " + owner;
    if (part == "im") return "Im " + owner;
    if (owner == "g" || owner == "h") {
        if (part.size() == 2)
            return part.substr(0, 1) + "_{" + part.substr(1) + "}^{" + owner + "}";
        return part + "^{" + owner + "}";
    }
    if (owner == "q" || owner == "p") return part;
    return owner + "_{" + part + "}";
}

std::string axisLabel(const SliceAxis& axis, const Words& words) {
    std::string label;
    for (const auto& [name, weight] : axis.terms) {
        if (!label.empty()) label += weight < 0 ? " \u2212 " : " + ";
        const double size = label.empty() ? weight : weight < 0 ? -weight : weight;
        if (size != 1) label += number(size, words) + " ";
        label += axisName(name, words);
    }
    return label;
}

std::map<std::string, std::string> factsOf(const Scene& scene, const OrbitProgram& program,
                                           const Words& words) {
    std::map<std::string, std::string> facts;
    const MapInfo& info = program.map->info;
    facts["map"] = words.tr(info.title);
    facts["iterations"] = std::to_string(scene.iterations);
    facts["escape_radius"] = number(program.escapeRadius, words);
    facts["height"] = number(scene.slice.height, words);
    facts["iso"] = number(scene.iso, words);
    facts["shape"] = shapeName(scene, scene.shape.source);
    for (const ParameterInfo& parameter : info.parameters) {
        const std::string name(parameter.name);
        facts[name] = valueText(parameter, scene.parameters.at(name), words);
    }
    for (int k = 0; k < program.map->parameters; ++k)
        facts[parameterComponent(info, k)] =
            number(numberValue(scene, {NumberKind::parameter, k, {}, 0, 0, 0}), words);
    for (int k = 0; k < program.map->dimension; ++k)
        facts[stateComponent(info, k)] = number(scene.start[static_cast<std::size_t>(k)], words);
    for (const auto& [name, list] : scene.lists) facts[name] = std::to_string(list.roots.size());
    const EnsembleSpec& ensemble = scene.ensemble;
    facts["members"] = std::to_string(ensemble.count);
    facts["seed"] = std::to_string(ensemble.seed);
    if (ensemble.roots) {
        const RandomRoots& draw = ensemble.roots->draw;
        const auto range = [&](const std::string& least, const std::string& most) {
            return least == most ? least : words.tr("{1} to {2}", {least, most});
        };
        facts["drawn"] = range(std::to_string(draw.least), std::to_string(draw.most));
        facts["powers"] = range(number(draw.lowPower, words), number(draw.highPower, words));
    }
    return facts;
}

const char* cyclesCalled(CycleKind kind) {
    switch (kind) {
        case CycleKind::attracting:
            return trLater("attracting cycle");
        case CycleKind::saddle:
            return trLater("saddle");
        case CycleKind::repelling:
            return trLater("repelling cycle");
        default:
            return trLater("neutral cycle");
    }
}

// What the picture shows by its colours.
std::string colouringWords(const Colouring& colour, const Words& words) {
    if (colour.rule == ColourRule::gradient) return words.tr("coloured by the escape step");
    if (colour.rule == ColourRule::versor) return words.tr("coloured by the versor");
    if (colour.rule == ColourRule::phase) return words.tr("coloured by the argument");
    if (colour.rule == ColourRule::domain)
        return words.tr(
            "coloured by the argument, with edges where the modulus is a power of 2 and the "
            "argument a multiple of π/6");
    return words.tr("coloured by the field {1}", {std::string(wordOf(colour.field))});
}

}  // namespace

std::string sceneSentence(const Scene& scene, const Words& words) {
    const MapInfo& info = mapOf(scene).info;
    std::string text = words.tr(info.title) + ", " + words.tr(info.formula);
    std::string values;
    for (const ParameterInfo& parameter : info.parameters) {
        const std::string name(parameter.name);
        const auto& value = scene.parameters.at(name);
        bool zero = true;
        for (double part : value) zero = zero && part == 0;
        bool sliced = false;
        for (const SliceAxis& axis : scene.slice.axes)
            for (const auto& [term, weight] : axis.terms)
                sliced = sliced || term == name || term.starts_with(name + ".");
        if (!sliced && !zero)
            values += words.separator() + name + " = " + valueText(parameter, value, words);
    }
    if (info.field) values += "; " + words.tr("shape: {1}", {shapeName(scene, scene.shape.source)});
    for (const auto& [name, spec] :
         {std::pair{"alpha", &scene.alphaOverSpace}, std::pair{"beta", &scene.betaOverSpace}})
        if (info.field && spec->modulates())
            values += words.separator() +
                      (spec->discs.empty() ? words.tr("{1} differs over space", {name})
                                           : words.tr("{1} differs over space as painted", {name}));
    std::string axes;
    for (const SliceAxis& axis : scene.slice.axes) {
        const std::string label = axisLabel(axis, words);
        axes = axes.empty() ? label : words.tr("{1} and {2}", {axes, label});
    }
    text += values + "; " +
            words.tr("on the plane of {1}, height {2}", {axes, number(scene.slice.height, words)}) +
            "; " + words.tr("{1} iterations", {std::to_string(scene.iterations)}) + "; " +
            colouringWords(scene.colour, words);
    if (scene.ensemble.varies())
        text += "; " + words.tr("an ensemble of {1} maps, seed {2}",
                                {std::to_string(scene.ensemble.count),
                                 std::to_string(scene.ensemble.seed)});
    return text + ".";
}

Expected<PanelInfo> describeScene(CpuRenderer& renderer, const Scene& scene, const Words& words,
                                  Job& job) {
    Expected<OrbitProgram> program = renderer.binder().bind(scene, job);
    if (!program) return program.status();
    Expected<ColourPass> pass = ColourPass::make(scene, *program);
    if (!pass) return pass.status();
    PanelInfo info;
    info.aspect = scene.aspect;
    const double halfHeight = 0.5 * scene.slice.height, halfWidth = halfHeight * scene.aspect;
    if (scene.slice.axes.size() >= 2) {
        const auto& centre = scene.slice.centre;
        info.x = {axisLabel(scene.slice.axes[0], words), centre[0] - halfWidth,
                  centre[0] + halfWidth};
        info.y = {axisLabel(scene.slice.axes[1], words), centre[1] - halfHeight,
                  centre[1] + halfHeight};
    }
    const Colouring& colouring = scene.colour;
    if (colouring.rule == ColourRule::versor) {
        info.versorKey = program->map->dimension == 4;
    } else if (colouring.rule != ColourRule::gradient) {
        const FieldInfo& field = infoOf(pass->shown());
        const bool twoValued =
            field.field == FieldName::membership || field.field == FieldName::solid;
        if (twoValued)
            info.legend = {{pass->palette().at(1), words.tr("inside")},
                           {pass->palette().at(0), words.tr("outside")}};
        else
            info.bar = ColourBar{pass->scale().kind == ScaleKind::truncatedLog
                                     ? words.tr("ln of the {1}", {words.tr(field.label)})
                                     : words.tr(field.label),
                                 pass->scale(), pass->palette()};
        if (colouring.rule == ColourRule::palette && colouring.interior != SetName::none &&
            !twoValued)
            info.legend.push_back({pass->palette().interior, colouring.interior == SetName::solid
                                                                 ? words.tr("solid set")
                                                                 : words.tr("members after N")});
    } else {
        info.legend = {{gradientColour(colouring.escaped, 0), words.tr("escapes at once")},
                       {gradientColour(colouring.escaped, 1), words.tr("escapes late")},
                       {gradientColour(colouring.attracted, 0), words.tr("attracted")}};
        if (!(colouring.attracted.start == colouring.attracted.finish)) {
            info.legend.back().text = words.tr("attracted at once");
            info.legend.push_back(
                {gradientColour(colouring.attracted, 1), words.tr("attracted late")});
        }
    }
    info.description = sceneSentence(scene, words);
    info.facts = factsOf(scene, *program, words);
    return info;
}

Expected<PanelInfo> describeDiagram(CpuRenderer& renderer, const Scene& scene,
                                    const DiagramPlot& plot, const Words& words, Job& job) {
    Expected<OrbitProgram> program =
        programAlong(renderer.binder(), scene, {{{plot.parameter, 1}}}, job);
    if (!program) return program.status();
    const MapInfo& info = program->map->info;
    if (plot.component >= program->map->dimension)
        return Status::usage("diagram.component: the map \"" + scene.map + "\" has points of " +
                             std::to_string(program->map->dimension) + " numbers");
    PanelInfo panel;
    panel.aspect = plot.aspect;
    panel.x = {axisName(plot.parameter, words), plot.from, plot.to};
    panel.y = {axisName(stateComponent(info, plot.component), words), plot.low, plot.high};
    panel.facts = factsOf(scene, *program, words);
    panel.facts["transient"] = std::to_string(plot.transient);
    panel.facts["points"] = std::to_string(plot.points);
    panel.description =
        words.tr("Bifurcation diagram: the attractor of {1}, {2}, against {3} from {4} to {5}.",
                 {words.tr(info.title), words.tr(info.formula), plot.parameter,
                  number(plot.from, words), number(plot.to, words)});
    return panel;
}

Expected<DiagramPicture> drawDiagram(CpuRenderer& renderer, const Scene& scene,
                                     const DiagramPlot& plot, Size pixels, Job& job) {
    const Expected<OrbitProgram> program =
        programAlong(renderer.binder(), scene, {{{plot.parameter, 1}}}, job);
    if (!program) return program.status();
    const DiagramOptions options{.left = plot.from,
                                 .right = plot.to,
                                 .low = plot.low,
                                 .high = plot.high,
                                 .component = plot.component,
                                 .transient = plot.transient,
                                 .points = plot.points,
                                 .across = plot.across};
    BifurcationDiagram diagram(pixels);
    if (Status status = fillDiagram(*program, options, 0, pixels.width, job, diagram); !status.ok())
        return status;
    return DiagramPicture{inkOf(diagram, options), std::move(diagram.periods)};
}

Expected<std::pair<LinePlot, PanelInfo>> plotProfile(CpuRenderer& renderer, const Scene& scene,
                                                     const ProfilePlot& spec, const Words& words,
                                                     Job& job) {
    Expected<RadialProfile> profile =
        shapeProfile(renderer.binder(), scene, spec.to, spec.radii, job);
    if (!profile) return profile.status();
    Expected<OrbitProgram> program = renderer.binder().bind(scene, job);
    if (!program) return program.status();
    const bool planar = program->map->dimension == 2;
    const double to = profile->radius.back();
    LinePlot plot;
    plot.aspect = spec.aspect;
    plot.x = {.name = words.tr("radius r"), .low = 0, .high = to};
    plot.y.name = planar ? words.tr("on the circle |z| = r") : words.tr("on the sphere |q| = r");
    // r̂ grows without bound: the plot ends where φ does.
    double low = 0, high = to;
    for (double mean : profile->mean) {
        low = std::min(low, mean);
        high = std::max(high, mean);
    }
    plot.y.low = low - 0.05 * (high - low);
    plot.y.high = high;
    plot.lines = {
        {words.tr("mean of φ"), "line", profile->radius, profile->mean},
        {words.tr("r\u0302 = e^{α(mean φ−β)}"), "line", profile->radius, profile->modulus},
        {"r\u0302 = r", "line", {0, to}, {0, to}}};
    const auto mark = [&](const std::string& name, double radius) {
        if (radius > 0 && radius <= to)
            plot.lines.push_back({name, "line", {radius, radius}, {*plot.y.low, high}});
    };
    mark(words.tr("capture is certain below {1}", {number(profile->capture, words)}),
         profile->capture);
    if (profile->escape < program->escapeRadius)
        mark(words.tr("escape is certain above {1}", {number(profile->escape, words)}),
             profile->escape);
    PanelInfo info;
    info.aspect = spec.aspect;
    info.facts = factsOf(scene, *program, words);
    info.facts["capture"] = number(profile->capture, words);
    info.facts["escape"] = number(profile->escape, words);
    const std::initializer_list<std::string> said = {info.facts["shape"], number(to, words),
                                                     info.facts["capture"], info.facts["escape"]};
    info.description =
        planar ? words.tr(
                     "Mean of the distance field of {1} over the circle of radius r against r "
                     "from 0 to {2}. Capture is certain below {3}, escape above {4}.",
                     said)
               : words.tr(
                     "Mean of the distance field of {1} over the sphere of radius r against r "
                     "from 0 to {2}. Capture is certain below {3}, escape above {4}.",
                     said);
    return std::pair{std::move(plot), std::move(info)};
}

Expected<std::array<double, 2>> locateScene(const Scene& scene, const Scene& other) {
    std::array<double, 2> at{};
    for (std::size_t k = 0; k < 2; ++k) {
        if (k >= scene.slice.axes.size())
            return Status::data("a picture with two axes is expected under marks");
        const auto& [name, weight] = scene.slice.axes[k].terms.front();
        const auto ref = numberNamed(other, name);
        if (!ref)
            return Status::data("the map \"" + other.map + "\" has no number named \"" + name +
                                "\"");
        const auto origin = scene.slice.origin.find(name);
        const double start = origin == scene.slice.origin.end() ? 0 : origin->second;
        at[k] = (numberValue(other, *ref) - start) / weight;
    }
    return at;
}

Expected<std::vector<OverlayPart>> overlayOf(CpuRenderer& renderer, const Scene& scene,
                                             const PlateOverlay& overlay, const Words& words,
                                             Job& job) {
    std::vector<OverlayPart> parts = overlay.parts;
    if (!overlay.computed()) return parts;
    if (mapOf(scene).dimension != 2 || !isDynamicalPlane(scene))
        return Status::usage("only a plane of starting points has cycles and curves over it");
    Expected<System> system = systemOf(renderer.binder(), scene, job);
    if (!system) return system.status();
    const double half = 0.5 * scene.slice.height, across = half * scene.aspect;
    const double x = scene.slice.centre[0], y = scene.slice.centre[1];
    const Window window{x - across, x + across, y - half, y + half};
    const auto add = [&](const std::string& name, bool points, std::vector<Polyline> curves) {
        if (!curves.empty() && !curves[0].empty())
            parts.push_back({name, points, std::move(curves)});
    };
    CycleSearch found;
    if (const int period = std::max(overlay.cycles, overlay.manifolds); period > 0) {
        Expected<CycleSearch> search = findCycles(*system, window, {.maxPeriod = period}, job);
        if (!search) return search.status();
        found = *std::move(search);
    }
    std::vector<Polyline> stable, unstable;
    for (const PeriodicCycle& cycle : found.cycles) {
        if (cycle.kind != CycleKind::saddle || cycle.period > overlay.manifolds) continue;
        Expected<SaddleManifolds> both =
            manifoldsOf(*system, cycle, window, {.length = overlay.length}, job);
        if (!both) return both.status();
        unstable.insert(unstable.end(), both->unstable.curves.begin(), both->unstable.curves.end());
        if (both->stable)
            stable.insert(stable.end(), both->stable->curves.begin(), both->stable->curves.end());
    }
    add(words.tr("stable manifold"), false, std::move(stable));
    add(words.tr("unstable manifold"), false, std::move(unstable));
    if (overlay.criticalSet) {
        Expected<CriticalSet> set = criticalSet(*system, window, {}, job);
        if (!set) return set.status();
        const bool isolated = set->curves.empty();
        add("det J = 0", isolated, isolated ? std::vector<Polyline>{set->points} : set->curves);
    }
    for (CycleKind kind :
         {CycleKind::attracting, CycleKind::saddle, CycleKind::repelling, CycleKind::neutral}) {
        Polyline points;
        for (const PeriodicCycle& cycle : found.cycles)
            if (cycle.kind == kind && cycle.period <= overlay.cycles)
                for (const PlanePoint& point : cycle.points)
                    if (window.contains(point[0], point[1])) points.push_back(point);
        add(words.tr(cyclesCalled(kind)), true, {points});
    }
    return parts;
}

PanelSource scenePanels(CpuRenderer& renderer, const Words& words, Job& job, int panels) {
    PanelSource source;
    const auto drawn = std::make_shared<int>(0);
    source.describe = [&renderer, words, &job](const Scene& scene) {
        return describeScene(renderer, scene, words, job);
    };
    source.draw = [&renderer, &job, panels, drawn](const Scene& scene, Size pixels,
                                                   double lineWidth) -> Expected<Raster<float>> {
        job.setPart(static_cast<double>(*drawn) / panels,
                    std::min(1.0, static_cast<double>(*drawn + 1) / panels));
        ++*drawn;
        Frame frame;
        const RenderOptions options{.lineWidth = lineWidth};
        if (Status status = renderer.render(scene, pixels, options, job, frame); !status.ok())
            return status;
        return std::move(frame.colour);
    };
    source.describeDiagram = [&renderer, words, &job](const Scene& scene, const DiagramPlot& plot) {
        return describeDiagram(renderer, scene, plot, words, job);
    };
    source.drawDiagram = [&renderer, &job](const Scene& scene, const DiagramPlot& plot,
                                           Size pixels) {
        return drawDiagram(renderer, scene, plot, pixels, job);
    };
    source.overlay = [&renderer, words, &job](const Scene& scene, const PlateOverlay& overlay) {
        return overlayOf(renderer, scene, overlay, words, job);
    };
    source.profile = [&renderer, words, &job](const Scene& scene, const ProfilePlot& plot) {
        return plotProfile(renderer, scene, plot, words, job);
    };
    source.locate = locateScene;
    return source;
}

}  // namespace versorium
