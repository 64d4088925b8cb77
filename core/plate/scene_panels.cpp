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
std::string number(double value) {
    std::string text = formatNumber(value, 6);
    if (!text.empty() && text[0] == '-') text.replace(0, 1, "\u2212");
    return text;
}

std::string complexNumber(double re, double im) {
    if (im == 0) return number(re);
    const double size = im < 0 ? -im : im;
    const std::string imaginary = size == 1 ? "i" : number(size) + "i";
    if (re == 0) return (im < 0 ? "\u2212" : "") + imaginary;
    return number(re) + (im < 0 ? " \u2212 " : " + ") + imaginary;
}

std::string valueText(const ParameterInfo& parameter, const std::vector<double>& value) {
    if (parameter.kind == ParameterKind::complex) return complexNumber(value[0], value[1]);
    if (value.size() == 1) return number(value[0]);
    std::string text = "(";
    for (std::size_t k = 0; k < value.size(); ++k) text += (k > 0 ? ", " : "") + number(value[k]);
    return text + ")";
}

// "z.re" -> "Re z", "g.b1" -> "b_{1}^{g}", "q.w" -> "w", "roots[2].re" -> "Re roots_{2}".
std::string axisName(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) return name == "power" ? "exponent d" : name;
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

std::string axisLabel(const SliceAxis& axis) {
    std::string label;
    for (const auto& [name, weight] : axis.terms) {
        if (!label.empty()) label += weight < 0 ? " \u2212 " : " + ";
        const double size = label.empty() ? weight : weight < 0 ? -weight : weight;
        if (size != 1) label += number(size) + " ";
        label += axisName(name);
    }
    return label;
}

std::map<std::string, std::string> factsOf(const Scene& scene, const OrbitProgram& program) {
    std::map<std::string, std::string> facts;
    const MapInfo& info = program.map->info;
    facts["map"] = std::string(info.title);
    facts["iterations"] = std::to_string(scene.iterations);
    facts["escape_radius"] = number(program.escapeRadius);
    facts["height"] = number(scene.slice.height);
    facts["iso"] = number(scene.iso);
    facts["shape"] = shapeName(scene, scene.shape.source);
    for (const ParameterInfo& parameter : info.parameters) {
        const std::string name(parameter.name);
        facts[name] = valueText(parameter, scene.parameters.at(name));
    }
    for (int k = 0; k < program.map->parameters; ++k)
        facts[parameterComponent(info, k)] =
            number(numberValue(scene, {NumberKind::parameter, k, {}, 0, 0, 0}));
    for (int k = 0; k < program.map->dimension; ++k)
        facts[stateComponent(info, k)] = number(scene.start[static_cast<std::size_t>(k)]);
    for (const auto& [name, list] : scene.lists) facts[name] = std::to_string(list.roots.size());
    const EnsembleSpec& ensemble = scene.ensemble;
    facts["members"] = std::to_string(ensemble.count);
    facts["seed"] = std::to_string(ensemble.seed);
    if (ensemble.roots) {
        const RandomRoots& draw = ensemble.roots->draw;
        facts["drawn"] = std::to_string(draw.least) +
                         (draw.most > draw.least ? " to " + std::to_string(draw.most) : "");
        facts["powers"] = number(draw.lowPower) + " to " + number(draw.highPower);
    }
    return facts;
}

}  // namespace

std::string sceneSentence(const Scene& scene) {
    const MapInfo& info = mapOf(scene).info;
    std::string text = std::string(info.title) + ", " + std::string(info.formula);
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
        if (!sliced && !zero) values += ", " + name + " = " + valueText(parameter, value);
    }
    if (info.field) values += "; shape: " + shapeName(scene, scene.shape.source);
    for (const auto& [name, spec] :
         {std::pair{"alpha", &scene.alphaOverSpace}, std::pair{"beta", &scene.betaOverSpace}})
        if (info.field && spec->modulates())
            values += std::string(", ") + name + " differs over space" +
                      (spec->discs.empty() ? "" : " as painted");
    text += values + "; on the plane of ";
    for (std::size_t k = 0; k < scene.slice.axes.size(); ++k)
        text += (k > 0 ? " and " : "") + axisLabel(scene.slice.axes[k]);
    text += ", height " + number(scene.slice.height) + "; " + std::to_string(scene.iterations) +
            " iterations; ";
    text += scene.colour.rule == "gradient" ? "coloured by the escape step"
            : scene.colour.rule == "versor" ? "coloured by the versor"
            : scene.colour.rule == "phase"  ? "coloured by the argument"
            : scene.colour.rule == "domain" ? "coloured by the argument, with edges where the "
                                              "modulus is a power of 2 and the argument a multiple "
                                              "of π/6"
                                            : "coloured by the field " + scene.colour.field;
    if (scene.ensemble.varies())
        text += "; an ensemble of " + std::to_string(scene.ensemble.count) + " maps, seed " +
                std::to_string(scene.ensemble.seed);
    return text + ".";
}

Expected<PanelInfo> describeScene(CpuRenderer& renderer, const Scene& scene, Job& job) {
    Expected<OrbitProgram> program = renderer.binder().bind(scene, job);
    if (!program) return program.status();
    Expected<ColourPass> pass = ColourPass::make(scene, *program);
    if (!pass) return pass.status();
    PanelInfo info;
    info.aspect = scene.aspect;
    const double halfHeight = 0.5 * scene.slice.height, halfWidth = halfHeight * scene.aspect;
    if (scene.slice.axes.size() >= 2) {
        const auto& centre = scene.slice.centre;
        info.x = {axisLabel(scene.slice.axes[0]), centre[0] - halfWidth, centre[0] + halfWidth};
        info.y = {axisLabel(scene.slice.axes[1]), centre[1] - halfHeight, centre[1] + halfHeight};
    }
    const Colouring& colouring = scene.colour;
    if (colouring.rule == "versor") {
        info.versorKey = program->map->dimension == 4;
    } else if (colouring.rule != "gradient") {
        const FieldInfo& field = infoOf(pass->shown());
        const bool twoValued =
            field.field == FieldName::membership || field.field == FieldName::solid;
        if (twoValued)
            info.legend = {{pass->palette().at(1), "inside"}, {pass->palette().at(0), "outside"}};
        else
            info.bar = ColourBar{pass->scale().kind == ScaleKind::truncatedLog
                                     ? "ln of the " + std::string(field.label)
                                     : std::string(field.label),
                                 pass->scale(), pass->palette()};
        if (colouring.rule == "palette" && colouring.interior != "none" && !twoValued)
            info.legend.push_back({pass->palette().interior, colouring.interior == "solid"
                                                                 ? "solid set"
                                                                 : "members after N"});
    } else {
        info.legend = {{gradientColour(colouring.escaped, 0), "escapes at once"},
                       {gradientColour(colouring.escaped, 1), "escapes late"},
                       {gradientColour(colouring.attracted, 0), "attracted"}};
        if (!(colouring.attracted.start == colouring.attracted.finish))
            info.legend.back().text = "attracted at once",
            info.legend.push_back({gradientColour(colouring.attracted, 1), "attracted late"});
    }
    info.description = sceneSentence(scene);
    info.facts = factsOf(scene, *program);
    return info;
}

Expected<PanelInfo> describeDiagram(CpuRenderer& renderer, const Scene& scene,
                                    const DiagramPlot& plot, Job& job) {
    Expected<OrbitProgram> program =
        programAlong(renderer.binder(), scene, {{{plot.parameter, 1}}}, job);
    if (!program) return program.status();
    const MapInfo& info = program->map->info;
    if (plot.component >= program->map->dimension)
        return Status::usage("diagram.component: the map \"" + scene.map + "\" has points of " +
                             std::to_string(program->map->dimension) + " numbers");
    PanelInfo panel;
    panel.aspect = plot.aspect;
    panel.x = {axisName(plot.parameter), plot.from, plot.to};
    panel.y = {axisName(stateComponent(info, plot.component)), plot.low, plot.high};
    panel.facts = factsOf(scene, *program);
    panel.facts["transient"] = std::to_string(plot.transient);
    panel.facts["points"] = std::to_string(plot.points);
    panel.description = "Bifurcation diagram: the attractor of " + std::string(info.title) + ", " +
                        std::string(info.formula) + ", against " + plot.parameter + " from " +
                        number(plot.from) + " to " + number(plot.to) + ".";
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
                                                     const ProfilePlot& spec, Job& job) {
    Expected<RadialProfile> profile =
        shapeProfile(renderer.binder(), scene, spec.to, spec.radii, job);
    if (!profile) return profile.status();
    Expected<OrbitProgram> program = renderer.binder().bind(scene, job);
    if (!program) return program.status();
    const bool planar = program->map->dimension == 2;
    const double to = profile->radius.back();
    LinePlot plot;
    plot.aspect = spec.aspect;
    plot.x = {.name = "radius r", .low = 0, .high = to};
    plot.y.name = planar ? "on the circle |z| = r" : "on the sphere |q| = r";
    // r̂ grows without bound: the plot ends where φ does.
    double low = 0, high = to;
    for (double mean : profile->mean) {
        low = std::min(low, mean);
        high = std::max(high, mean);
    }
    plot.y.low = low - 0.05 * (high - low);
    plot.y.high = high;
    plot.lines = {{"mean of φ", "line", profile->radius, profile->mean},
                  {"r\u0302 = e^{α(mean φ−β)}", "line", profile->radius, profile->modulus},
                  {"r\u0302 = r", "line", {0, to}, {0, to}}};
    const auto mark = [&](const std::string& name, double radius) {
        if (radius > 0 && radius <= to)
            plot.lines.push_back({name, "line", {radius, radius}, {*plot.y.low, high}});
    };
    mark("capture is certain below " + number(profile->capture), profile->capture);
    if (profile->escape < program->escapeRadius)
        mark("escape is certain above " + number(profile->escape), profile->escape);
    PanelInfo info;
    info.aspect = spec.aspect;
    info.facts = factsOf(scene, *program);
    info.facts["capture"] = number(profile->capture);
    info.facts["escape"] = number(profile->escape);
    info.description = std::string("Mean of the distance field of ") + info.facts["shape"] +
                       (planar ? " over the circle" : " over the sphere") +
                       " of radius r against r from 0 to " + number(to) +
                       ". Capture is certain below " + number(profile->capture) +
                       ", escape above " + number(profile->escape) + ".";
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
                                             const PlateOverlay& overlay, Job& job) {
    std::vector<OverlayPart> parts = overlay.parts;
    if (!overlay.computed()) return parts;
    if (mapOf(scene).dimension != 2 || !isDynamicalPlane(scene))
        return Status::usage("only a plane of starting points has cycles and curves over it");
    Expected<System> system = systemOf(renderer.binder(), scene, job);
    if (!system) return system.status();
    const double half = 0.5 * scene.slice.height, across = half * scene.aspect;
    const double x = scene.slice.centre[0], y = scene.slice.centre[1];
    const Window window{x - across, x + across, y - half, y + half};
    const auto add = [&](const char* name, bool points, std::vector<Polyline> curves) {
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
    add("stable manifold", false, std::move(stable));
    add("unstable manifold", false, std::move(unstable));
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
        add(kind == CycleKind::attracting  ? "attracting cycle"
            : kind == CycleKind::saddle    ? "saddle"
            : kind == CycleKind::repelling ? "repelling cycle"
                                           : "neutral cycle",
            true, {points});
    }
    return parts;
}

PanelSource scenePanels(CpuRenderer& renderer, const Json& assets, Job& job, int panels) {
    PanelSource source;
    const auto drawn = std::make_shared<int>(0);
    source.describe = [&renderer, assets, &job](const Json& json) -> Expected<PanelInfo> {
        Expected<Scene> scene = sceneWithAssets(json, assets);
        if (!scene) return scene.status();
        return describeScene(renderer, *scene, job);
    };
    source.draw = [&renderer, assets, &job, panels, drawn](
                      const Json& json, Size pixels, double lineWidth) -> Expected<Raster<float>> {
        Expected<Scene> scene = sceneWithAssets(json, assets);
        if (!scene) return scene.status();
        job.setPart(static_cast<double>(*drawn) / panels,
                    std::min(1.0, static_cast<double>(*drawn + 1) / panels));
        ++*drawn;
        Frame frame;
        const RenderOptions options{.lineWidth = lineWidth};
        if (Status status = renderer.render(*scene, pixels, options, job, frame); !status.ok())
            return status;
        return std::move(frame.colour);
    };
    source.describeDiagram = [&renderer, assets, &job](
                                 const Json& json, const DiagramPlot& plot) -> Expected<PanelInfo> {
        Expected<Scene> scene = sceneWithAssets(json, assets);
        return scene ? describeDiagram(renderer, *scene, plot, job) : scene.status();
    };
    source.drawDiagram = [&renderer, assets, &job](const Json& json, const DiagramPlot& plot,
                                                   Size pixels) -> Expected<DiagramPicture> {
        Expected<Scene> scene = sceneWithAssets(json, assets);
        return scene ? drawDiagram(renderer, *scene, plot, pixels, job) : scene.status();
    };
    source.overlay = [&renderer, assets, &job](
                         const Json& json,
                         const PlateOverlay& overlay) -> Expected<std::vector<OverlayPart>> {
        Expected<Scene> scene = sceneWithAssets(json, assets);
        return scene ? overlayOf(renderer, *scene, overlay, job) : scene.status();
    };
    source.profile = [&renderer, assets, &job](
                         const Json& json,
                         const ProfilePlot& plot) -> Expected<std::pair<LinePlot, PanelInfo>> {
        Expected<Scene> scene = sceneWithAssets(json, assets);
        if (!scene) return scene.status();
        return plotProfile(renderer, *scene, plot, job);
    };
    source.locate = [assets](const Json& json,
                             const Json& otherJson) -> Expected<std::array<double, 2>> {
        Expected<Scene> scene = sceneWithAssets(json, assets);
        if (!scene) return scene.status();
        Expected<Scene> other = sceneWithAssets(otherJson, assets);
        return other ? locateScene(*scene, *other) : other.status();
    };
    return source;
}

}  // namespace versorium
