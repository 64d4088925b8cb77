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

namespace versorium {
namespace {

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

}  // namespace

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
        info.x = {axisText(scene.slice.axes[0], words), centre[0] - halfWidth,
                  centre[0] + halfWidth};
        info.y = {axisText(scene.slice.axes[1], words), centre[1] - halfHeight,
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
    info.facts = sceneFacts(scene, *program, words);
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
    panel.x = {axisText(plot.parameter, words), plot.from, plot.to};
    panel.y = {axisText(stateComponent(info, plot.component), words), plot.low, plot.high};
    panel.facts = sceneFacts(scene, *program, words);
    panel.facts["transient"] = std::to_string(plot.transient);
    panel.facts["points"] = std::to_string(plot.points);
    panel.description =
        words.tr("Bifurcation diagram: the attractor of {1}, {2}, against {3} from {4} to {5}.",
                 {words.tr(info.title), words.tr(info.formula), plot.parameter,
                  plateNumber(plot.from, words), plateNumber(plot.to, words)});
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
    mark(words.tr("capture is certain below {1}", {plateNumber(profile->capture, words)}),
         profile->capture);
    if (profile->escape < program->escapeRadius)
        mark(words.tr("escape is certain above {1}", {plateNumber(profile->escape, words)}),
             profile->escape);
    PanelInfo info;
    info.aspect = spec.aspect;
    info.facts = sceneFacts(scene, *program, words);
    info.facts["capture"] = plateNumber(profile->capture, words);
    info.facts["escape"] = plateNumber(profile->escape, words);
    const std::initializer_list<std::string> said = {info.facts["shape"], plateNumber(to, words),
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
