// SPDX-License-Identifier: MIT
#include <cmath>

#include "commands/commands.h"
#include "commands/open.h"
#include "dynamics/critical_set.h"
#include "dynamics/manifolds.h"
#include "dynamics/planar_system.h"
#include "io/files.h"
#include "render/cpu/cpu_renderer.h"
#include "render/system_of.h"
#include "scene/numbers.h"

namespace versorium {
namespace {

// What the commands of this file share.
struct DynamicsRequest {
    SceneRequest source;
    std::string output = "-";
    std::vector<double> window;  // left, right, bottom, top
    int period = 1, across = 0;
    double length = 60;
    bool csv = false, json = false;
};

struct OpenedSystem {
    Scene scene;
    System system;
    Window window;
};

Expected<OpenedSystem> openSystem(const DynamicsRequest& request, Job& job) {
    Expected<OpenedScene> opened = openScene(request.source);
    if (!opened) return opened.status();
    Binder binder;
    Expected<System> system = systemOf(binder, opened->scene, job);
    if (!system) return system.status();
    Window window = dynamicalWindow(opened->scene);
    if (!request.window.empty()) {
        const std::size_t wanted = system->dimension() == 1 ? 2 : 4;
        if (request.window.size() != wanted)
            return Status::usage(
                "--window: " + std::string(wanted == 2 ? "LEFT,RIGHT" : "LEFT,RIGHT,BOTTOM,TOP") +
                " is expected for the map \"" + opened->scene.map + "\"");
        window.left = request.window[0], window.right = request.window[1];
        if (wanted == 4) window.bottom = request.window[2], window.top = request.window[3];
    }
    if (Status status = checkWindow(window, system->dimension()); !status.ok())
        return status.in("--window");
    return OpenedSystem{std::move(opened->scene), std::move(*system), window};
}

Json pointJson(const PlanePoint& point, int dimension) {
    Json json = Json::array({point[0]});
    if (dimension > 1) json.push_back(point[1]);
    return json;
}
std::string pointText(const PlanePoint& point, int dimension) {
    const std::string x = formatNumber(point[0], 10);
    return dimension == 1 ? x : "(" + x + ", " + formatNumber(point[1], 10) + ")";
}
std::string complexNumberText(const std::complex<double>& value) {
    const std::string re = formatNumber(value.real(), 8);
    if (value.imag() == 0) return re;
    return re + (value.imag() < 0 ? "-" : "+") + formatNumber(std::abs(value.imag()), 8) + "i";
}

// ---- cycles ----------------------------------------------------------------------------------

Json cycleJson(const PeriodicCycle& cycle, int dimension) {
    Json points = Json::array(), eigenvalues = Json::array();
    for (const PlanePoint& point : cycle.points) points.push_back(pointJson(point, dimension));
    for (const auto& value : cycle.eigenvalues)
        eigenvalues.push_back(Json::array({value.real(), value.imag()}));
    Json json{{"period", cycle.period},
              {"kind", wordOf(cycle.kind)},
              {"points", points},
              {"eigenvalues", eigenvalues},
              {"multiplier", nullptr}};
    if (cycle.multiplier)
        json["multiplier"] = Json::array({cycle.multiplier->real(), cycle.multiplier->imag()});
    return json;
}

std::string cyclesCsv(const CycleSearch& search, const MapKernels& map) {
    std::string text = "cycle,period,kind,n";
    for (int k = 0; k < map.dimension; ++k) text += "," + stateComponent(map.info, k);
    for (int k = 1; k <= map.dimension; ++k)
        text += ",eigenvalue" + std::to_string(k) + ".re,eigenvalue" + std::to_string(k) + ".im";
    text += "\n";
    for (std::size_t i = 0; i < search.cycles.size(); ++i) {
        const PeriodicCycle& cycle = search.cycles[i];
        for (std::size_t n = 0; n < cycle.points.size(); ++n) {
            text += std::to_string(i + 1) + "," + std::to_string(cycle.period) + "," +
                    wordOf(cycle.kind) + "," + std::to_string(n);
            for (std::size_t k = 0; k < static_cast<std::size_t>(map.dimension); ++k)
                text += "," + formatNumber(cycle.points[n][k]);
            for (const auto& value : cycle.eigenvalues)
                text += "," + formatNumber(value.real()) + "," + formatNumber(value.imag());
            text += "\n";
        }
    }
    return text;
}

std::string cyclesTable(const CycleSearch& search, int dimension) {
    std::string text = "period\tkind\teigenvalues\tpoints\n";
    for (const PeriodicCycle& cycle : search.cycles) {
        text += std::to_string(cycle.period) + "\t" + wordOf(cycle.kind) + "\t";
        if (cycle.multiplier)
            text += complexNumberText(*cycle.multiplier);
        else
            for (std::size_t k = 0; k < cycle.eigenvalues.size(); ++k)
                text += (k > 0 ? ", " : "") + complexNumberText(cycle.eigenvalues[k]);
        text += "\t";
        for (std::size_t n = 0; n < cycle.points.size(); ++n)
            text += (n > 0 ? "  " : "") + pointText(cycle.points[n], dimension);
        text += "\n";
    }
    if (search.cut) text += "there are more; a smaller --window shows the rest\n";
    return text;
}

Status printCycles(const DynamicsRequest& request, int threads) {
    Job job(threads);
    sayWarnings(job);
    Expected<OpenedSystem> opened = openSystem(request, job);
    if (!opened) return opened.status();
    Expected<CycleSearch> search = [&] {
        const ProgressLine progress(job, "cycles");
        return findCycles(opened->system, opened->window,
                          {.maxPeriod = request.period, .across = request.across}, job);
    }();
    if (!search) return search.status();
    const MapKernels& map = opened->system.map();
    if (request.json) {
        Json cycles = Json::array();
        for (const PeriodicCycle& cycle : search->cycles)
            cycles.push_back(cycleJson(cycle, map.dimension));
        return print(
            printJson(Json{{"map", opened->scene.map}, {"cut", search->cut}, {"cycles", cycles}}));
    }
    return print(request.csv ? cyclesCsv(*search, map) : cyclesTable(*search, map.dimension));
}

// ---- curves ----------------------------------------------------------------------------------

void appendCurves(std::string& csv, const std::string& name, const std::vector<Polyline>& curves) {
    for (std::size_t i = 0; i < curves.size(); ++i)
        for (const PlanePoint& point : curves[i])
            csv += name + "," + std::to_string(i + 1) + "," + formatNumber(point[0]) + "," +
                   formatNumber(point[1]) + "\n";
}
Json curvesJson(const std::vector<Polyline>& curves) {
    Json all = Json::array();
    for (const Polyline& curve : curves) {
        Json points = Json::array();
        for (const PlanePoint& point : curve) points.push_back(pointJson(point, 2));
        all.push_back(std::move(points));
    }
    return all;
}

Status writeManifolds(const DynamicsRequest& request, int threads) {
    Job job(threads);
    sayWarnings(job);
    Expected<OpenedSystem> opened = openSystem(request, job);
    if (!opened) return opened.status();
    Expected<CycleSearch> search =
        findCycles(opened->system, opened->window, {.maxPeriod = request.period}, job);
    if (!search) return search.status();
    std::string csv = "manifold,curve,x,y\n", why;
    Json saddles = Json::array();
    int count = 0;
    for (const PeriodicCycle& cycle : search->cycles) {
        if (cycle.kind != CycleKind::saddle || opened->system.dimension() != 2) continue;
        Expected<SaddleManifolds> both =
            manifoldsOf(opened->system, cycle, opened->window, {.length = request.length}, job);
        if (!both) return both.status();
        const std::string name = std::to_string(++count);
        appendCurves(csv, "unstable" + name, both->unstable.curves);
        if (both->stable) appendCurves(csv, "stable" + name, both->stable->curves);
        why = both->whyNoStable;
        saddles.push_back(
            Json{{"cycle", cycleJson(cycle, 2)},
                 {"unstable", curvesJson(both->unstable.curves)},
                 {"stable", both->stable ? curvesJson(both->stable->curves) : Json(nullptr)},
                 {"why_no_stable", both->whyNoStable}});
    }
    if (count == 0)
        return Status::usage("the map has no saddle of a period up to " +
                             std::to_string(request.period) +
                             " in the window; give another --period or --window");
    if (request.json)
        return writeFileAtomically(
            request.output, printJson(Json{{"map", opened->scene.map}, {"saddles", saddles}}));
    return writeFileAtomically(request.output, csv);
}

Status writeCriticalSet(const DynamicsRequest& request, int threads) {
    Job job(threads);
    sayWarnings(job);
    Expected<OpenedSystem> opened = openSystem(request, job);
    if (!opened) return opened.status();
    Expected<CriticalSet> set = criticalSet(
        opened->system, opened->window,
        {.across = request.across > 0 ? request.across : CriticalSetOptions{}.across}, job);
    if (!set) return set.status();
    if (request.json) {
        Json points = Json::array();
        for (const PlanePoint& point : set->points) points.push_back(pointJson(point, 2));
        return writeFileAtomically(request.output,
                                   printJson(Json{{"map", opened->scene.map},
                                                  {"curves", curvesJson(set->curves)},
                                                  {"points", points}}));
    }
    std::string csv = "kind,curve,x,y\n";
    appendCurves(csv, "curve", set->curves);
    for (std::size_t i = 0; i < set->points.size(); ++i)
        appendCurves(csv, "point", {{set->points[i]}});
    return writeFileAtomically(request.output, csv);
}

// ---- explain ---------------------------------------------------------------------------------

// The 30 coefficients, and names for those on the axes of the picture.
std::vector<std::string> slicedNames(const Scene& scene) {
    std::vector<std::string> names(kPlanarNumbers);
    for (const SliceAxis& axis : scene.slice.axes)
        for (const auto& [name, weight] : axis.terms)
            if (const auto ref = numberNamed(scene, name);
                ref && ref->kind == NumberKind::parameter)
                names[static_cast<std::size_t>(ref->index)] =
                    planarCoefficientName(static_cast<std::size_t>(ref->index));
    return names;
}

Status explain(const DynamicsRequest& request, int threads) {
    Job job(threads);
    sayWarnings(job);
    Expected<OpenedScene> opened = openScene(request.source);
    if (!opened) return opened.status();
    const Scene& scene = opened->scene;
    Binder binder;
    Expected<System> system = systemOf(binder, scene, job);
    if (!system) return system.status();
    Expected<CatalogueBadge> badge = catalogueBadgeOf(binder, scene, job);
    if (!badge) return badge.status();
    const MapInfo& info = system->map().info;
    Json json{{"map", scene.map}, {"title", std::string(info.title)}};
    std::string text = std::string(info.title) + ":";
    std::optional<ComplexPolynomial> polynomial;
    if (info.planarCoefficients) {
        const auto names = slicedNames(scene);
        for (int component = 0; component < 2; ++component) {
            const std::string formula = planarText(system->parameters(), component, names);
            json[component == 0 ? "g" : "h"] = formula;
            text += std::string(component == 0 ? "\n  g = " : "\n  h = ") + formula;
        }
        polynomial = complexPolynomialOf(system->parameters());
        json["complex"] = polynomial ? Json(complexText(*polynomial)) : Json(nullptr);
        if (polynomial) text += "\nAs a complex map: z \u21a6 " + complexText(*polynomial);
    } else {
        json["formula"] = std::string(info.formula);
        text += " " + std::string(info.formula);
    }
    Json points = Json::array();
    std::string list;
    const auto add = [&](const PlanePoint& point) {
        points.push_back(pointJson(point, system->dimension()));
        list += (list.empty() ? "" : "  ") + pointText(point, system->dimension());
    };
    for (const PlanePoint& point : criticalPointsOf(*system)) add(point);
    json["critical_points"] = points;
    if (!list.empty()) text += "\nCritical points: " + list;
    text += "\nCatalogue of Julia sets: " + badge->label + ". " + badge->sentence + "\n";
    json["catalogue"] =
        Json{{"answer", wordOf(badge->answer)},   {"label", badge->label},
             {"sentence", badge->sentence},       {"analytic", badge->analytic},
             {"conjugate", badge->conjugate},     {"critical_points", badge->criticalPoints},
             {"determinant", badge->determinant}, {"start", badge->start},
             {"start_moves", badge->startMoves}};
    return print(request.json ? printJson(json) : text);
}

}  // namespace

void addDynamicsCommands(CommandLine& line) {
    const auto request = std::make_shared<DynamicsRequest>();
    const auto add = [&](const char* name, const char* help, const char* examples) {
        CLI::App* command = line.add(name, help, examples);
        addSceneOptions(*command, request->source);
        command->add_flag("--json", request->json, "as JSON");
        return command;
    };
    const auto addWindow = [&](CLI::App* command) {
        command
            ->add_option("--window", request->window,
                         "LEFT,RIGHT[,BOTTOM,TOP]; else the scene's dynamical plane")
            ->delimiter(',');
    };
    const auto addPeriod = [&](CLI::App* command) {
        command->add_option("--period", request->period, "cycles up to this period")
            ->check(CLI::Range(1, kMostPeriod))
            ->capture_default_str();
    };
    const auto addOutput = [&](CLI::App* command) {
        command
            ->add_option("-o,--output", request->output,
                         "CSV or JSON file, or - for standard output")
            ->capture_default_str();
    };
    CLI::App* cycles = add(
        "cycles", "List fixed points and cycles of a map of the line or plane.",
        "  versorium cycles henon --period 4\n"
        "  versorium cycles logistic --set r=3.5 --period 4 --csv\n"
        "  versorium cycles julia --set c=-0.123,0.745 --period 3 --json\n"
        "Cycles are found by Newton's method from a grid, attracting or not. The eigenvalues are\n"
        "those of the Jacobian round the cycle; of a complex map, the multiplier.\n");
    addWindow(cycles);
    addPeriod(cycles);
    cycles->add_option("--across", request->across, "starts along each side of the window")
        ->check(CLI::Range(1, kMostStartsAcross));
    cycles->add_flag("--csv", request->csv, "comma-separated, a row for each point");
    line.run(cycles, [request, &line] { return printCycles(*request, line.threads); });

    CLI::App* manifolds =
        add("manifolds", "Compute stable and unstable manifolds of the saddles of a planar map.",
            "  versorium manifolds henon -o manifolds.csv\n"
            "  versorium manifolds henon --period 2 --window -2,2,-2,2 --json -o m.json\n");
    addWindow(manifolds);
    addPeriod(manifolds);
    manifolds->add_option("--length", request->length, "of each branch, in heights of the window")
        ->check(CLI::Range(0.01, 10000.0))
        ->capture_default_str();
    addOutput(manifolds);
    line.run(manifolds, [request, &line] { return writeManifolds(*request, line.threads); });

    CLI::App* critical =
        add("critical", "Compute the critical set of a map of the plane: where det J = 0.",
            "  versorium critical planar --set g.b2=-0.5 -o curve.csv\n"
            "  versorium critical cubic --json\n");
    addWindow(critical);
    critical->add_option("--across", request->across, "cells of the grid along the wider side")
        ->check(CLI::Range(8, 2048));
    addOutput(critical);
    line.run(critical, [request, &line] { return writeCriticalSet(*request, line.threads); });

    CLI::App* explained =
        add("explain",
            "Say what a scene's map is, and whether its picture is a catalogue of Julia sets.",
            "  versorium explain mandelbrot\n  versorium explain planar --set g.b2=-0.9\n");
    line.run(explained, [request, &line] { return explain(*request, line.threads); });
}

}  // namespace versorium
