// SPDX-License-Identifier: MIT
#include "ui/session/studies.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "maps/critical.h"
#include "render/system_of.h"
#include "ui/session/context.h"

namespace versorium {
namespace {

constexpr double kRest = 0.15;                           // seconds without a change
constexpr double kMovingBudget = 0.006, kBudget = 0.03;  // seconds of a search
constexpr double kColumnBudget = 0.004;                  // of a frame's columns
constexpr std::size_t kMostSaddles = 4;                  // that get their manifolds
constexpr int kMovingPeriod = 4;

class Stopwatch {
  public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }

  private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// On this thread; cancelled between two of its parts once its time is over.
class TimedJob : public Job {
  public:
    explicit TimedJob(double budget) : Job(1) {
        onProgress = [this, budget](double) {
            if (watch_.seconds() > budget) cancel();
        };
    }

  private:
    Stopwatch watch_;
};

StudyKey keyOf(const StudioContext& context, const System& system) {
    return {&system.map(), context.workspace.views[0].formula, system.parameters()};
}

void append(std::vector<double>& numbers, const Window& window) {
    numbers.insert(numbers.end(), {window.left, window.right, window.bottom, window.top});
}

}  // namespace

bool atRest(const StudioContext& context) {
    return !context.buttonDown && !context.player.moves() && !context.gliding() &&
           (!context.edited.unrecorded() || context.host.now() - context.edited.editedAt() > kRest);
}

std::optional<System> shownSystem(StudioContext& context) {
    const OrbitProgram* program = context.bound.orbitProgram();
    if (!program) return std::nullopt;
    const Scene scene = orbitScene(context.workspace);
    const double at[3] = {scene.slice.centre[0],
                          scene.slice.centre.size() > 1 ? scene.slice.centre[1] : 0, 0};
    return System(*program, at);
}

int dynamicalViewOf(const Workspace& workspace) {
    if (isDynamicalPlane(workspace.view())) return workspace.focused;
    for (std::size_t k = 0; k < workspace.views.size(); ++k)
        if (isDynamicalPlane(workspace.views[k])) return static_cast<int>(k);
    return -1;
}

Window windowOf(const StudioContext& context, int view) {
    const Workspace& workspace = context.workspace;
    if (view < 0) {
        const Scene scene = dynamicalView(workspace.views[0]);
        return dynamicalWindow(scene);
    }
    const auto borders =
        bordersOf(workspace.views[static_cast<std::size_t>(view)], context.aspect(view));
    return {borders[0], borders[1], borders[2], borders[3]};
}

const CycleStudy& studyCycles(StudioContext& context) {
    CycleStudy& study = context.studies.cycles;
    const Workspace::Study& wanted = context.workspace.study;
    const std::optional<System> system = shownSystem(context);
    if (!system || system->dimension() > 2) {
        study = {};
        study.problem = trLater("Cycles are found for maps of the line and of the plane.");
        return study;
    }
    const Window window = windowOf(context, dynamicalViewOf(context.workspace));
    std::vector<double> of{static_cast<double>(wanted.mostPeriod)};
    append(of, window);
    const bool rest = atRest(context);
    if (StudyKey key = keyOf(context, *system); !(study.system == key)) {
        study = {};
        study.system = std::move(key);
        study.of = of;
    } else if (study.of != of && rest) {
        // What was found is still there until there is a new list.
        study.of = of;
        study.across = 0;
        study.finished = study.coarse = false;
        study.manifolds.clear();
        study.saddlesDone = 0;
    }
    if (!rest) {
        context.host.wakeAfter(kRest);
        if (study.across != 0 || !study.cycles.empty() || study.finished) return study;
        TimedJob job(kMovingBudget);
        const CycleOptions options{.maxPeriod = std::min(wanted.mostPeriod, kMovingPeriod),
                                   .across = system->dimension() == 1 ? 60 : 8};
        Expected<CycleSearch> found = findCycles(*system, window, options, job);
        if (found) study.cycles = std::move(found->cycles);
        return study;
    }
    if (!study.finished) {
        const int most = system->dimension() == 1 ? std::min(200 + 60 * wanted.mostPeriod, 1000)
                                                  : std::min(20 + 4 * wanted.mostPeriod, 96);
        const int across = study.across == 0 ? most / 6 + 2 : std::min(most, 2 * study.across);
        TimedJob job(kBudget);
        Expected<CycleSearch> found =
            findCycles(*system, window, {.maxPeriod = wanted.mostPeriod, .across = across}, job);
        study.problem.clear();
        if (found) {
            study.cycles = std::move(found->cycles);
            study.across = across;
            study.finished = across >= most;
        } else {
            study.finished = true;
            study.coarse = found.status().kind() == ErrorKind::cancelled;
            if (!study.coarse)
                study.problem = found.status().message();
            else if (study.across == 0)
                study.problem = trLater("Too slow here: take a lower period.");
        }
        context.host.wake();
    } else if (wanted.manifolds && study.saddlesDone < study.cycles.size() &&
               study.manifolds.size() < kMostSaddles) {
        const PeriodicCycle& cycle = study.cycles[study.saddlesDone++];
        if (cycle.kind == CycleKind::saddle && system->dimension() == 2) {
            Job job(1);
            const ManifoldOptions options{
                .spacing = 1.0 / 250, .length = 12, .mostPoints = 5000 / cycle.period + 500};
            Expected<SaddleManifolds> curves = manifoldsOf(*system, cycle, window, options, job);
            if (curves) study.manifolds.push_back(std::move(*curves));
        }
        context.host.wake();
    }
    return study;
}

const CriticalSet& studyCritical(StudioContext& context, int view) {
    CriticalStudy& study = context.studies.critical[static_cast<std::size_t>(view)];
    const OrbitProgram* program = context.bound.program(view);
    if (!program || program->map->dimension != 2) return study.set = {};
    const System system(*program);
    const Window window = windowOf(context, view);
    StudyKey key = keyOf(context, system);
    append(key.numbers, window);
    const bool rest = atRest(context);
    const int across = rest ? 160 : 40;
    if (!rest) context.host.wakeAfter(kRest);
    if (study.key == key && study.across >= across) return study.set;
    study.key = std::move(key);
    study.across = across;
    TimedJob job(kBudget);
    Expected<CriticalSet> set = criticalSet(system, window, {.across = across}, job);
    if (set)
        study.set = std::move(*set);
    else if (!rest)
        study.set = {};
    return study.set;
}

const CatalogueBadge* studyBadge(StudioContext& context, int view) {
    BadgeStudy& study = context.studies.badges[static_cast<std::size_t>(view)];
    if (study.revision != context.revision()) {
        if (!atRest(context)) {
            context.host.wakeAfter(kRest);
        } else if (const OrbitProgram* program = context.bound.program(view)) {
            const Window window = windowOf(context, view);
            const double centre[3] = {0.5 * (window.left + window.right),
                                      0.5 * (window.bottom + window.top), 0};
            study.badge =
                catalogueBadge(*program, centre, 0.5 * window.width(), 0.5 * window.height());
            study.revision = context.revision();
        }
    }
    return study.badge ? &*study.badge : nullptr;
}

const std::vector<std::vector<double>>& comparedOrbit(StudioContext& context) {
    Studies& studies = context.studies;
    if (studies.comparedRevision == context.revision()) return studies.compared;
    studies.comparedRevision = context.revision();
    studies.compared.clear();
    const Workspace& workspace = context.workspace;
    const OrbitProgram* program = context.bound.orbitProgram();
    if (workspace.compared.empty() || !program) return studies.compared;
    OrbitProgram second = *program;
    const Scene scene = orbitScene(workspace);
    double at[3] = {workspace.compared[0],
                    scene.slice.centre.size() > 1 ? scene.slice.centre[1] : 0, 0};
    if (workspace.compared.size() > 1) at[1] = workspace.compared[1];
    for (std::size_t k = 2; k < workspace.compared.size(); ++k)
        second.slice.origin[k] = workspace.compared[k];
    return studies.compared = orbitOf(second, at, workspace.orbitSteps);
}

std::optional<std::vector<double>> startOf(StudioContext& context, int view) {
    if (view < 0) return std::nullopt;
    const Scene& scene = context.workspace.views[static_cast<std::size_t>(view)];
    const MapKernels& map = mapOf(scene);
    if (!traitsOf(scene).ownStart) return std::nullopt;
    for (const SliceAxis& axis : scene.slice.axes)
        for (const auto& [name, weight] : axis.terms)
            if (const auto number = numberNamed(scene, name);
                number && number->kind == NumberKind::state)
                return std::nullopt;
    if (!scene.criticalStart) return scene.start;
    const std::optional<System> system = shownSystem(context);
    if (!system) return std::nullopt;
    std::vector<double> point(static_cast<std::size_t>(map.dimension));
    if (!criticalPoint(map, *scene.criticalStart, system->parameters().data(),
                       system->environment(), point.data()))
        return std::nullopt;
    return point;
}

void setStart(StudioContext& context, int view, std::vector<double> start) {
    if (std::any_of(start.begin(), start.end(), [](double x) { return !std::isfinite(x); })) return;
    context.edit([&](Workspace& workspace) {
        Scene& scene = workspace.views[static_cast<std::size_t>(view)];
        scene.criticalStart.reset();
        scene.start = std::move(start);
    });
}

void startAtNearest(StudioContext& context, int view, PlanePoint near) {
    const std::optional<System> system = shownSystem(context);
    if (view < 0 || !system || system->dimension() != 2) return;
    // As far as the picture shows it, and round the point.
    Window window = windowOf(context, dynamicalViewOf(context.workspace));
    window.left = std::min(window.left, near[0] - 0.1);
    window.right = std::max(window.right, near[0] + 0.1);
    window.bottom = std::min(window.bottom, near[1] - 0.1);
    window.top = std::max(window.top, near[1] + 0.1);
    Job job(1);
    const Expected<CriticalSet> set = criticalSet(*system, window, {.across = 160}, job);
    if (!set) return context.report(set.status());
    const std::optional<PlanePoint> found = nearestCriticalPoint(*system, *set, near);
    if (!found) return context.say("There is no point with det J = 0 in the picture");
    setStart(context, view, {(*found)[0], (*found)[1]});
}

void nextAxis(StudioContext& context, const std::string& name) {
    Studies& studies = context.studies;
    const std::string now = axisSign(context.workspace, name);
    if (!now.empty()) {
        studies.newestAxis = now == "→" ? 0 : 1;
        return;
    }
    studies.newestAxis = 1 - studies.newestAxis;
    context.edit([&](Workspace& workspace) {
        makeAxis(workspace, static_cast<std::size_t>(studies.newestAxis), name);
    });
}

const char* axisSign(const Workspace& workspace, const std::string& name) {
    const int view = viewOfKind(workspace, ViewKind::parameters);
    if (view < 0) return "";
    const auto& axes = workspace.views[static_cast<std::size_t>(view)].slice.axes;
    for (std::size_t k = 0; k < std::min<std::size_t>(2, axes.size()); ++k)
        if (axes[k].terms.size() == 1 && axes[k].terms[0].first == name) return k ? "↑" : "→";
    return "";
}

DiagramStudy& studyDiagram(StudioContext& context, Size size) {
    DiagramStudy& study = context.studies.diagram;
    const Workspace& workspace = context.workspace;
    const Workspace::Diagram wanted = diagramOf(workspace);
    const Scene scene = diagramScene(workspace);
    const MapKernels& map = mapOf(scene);
    StudyKey key{&map, scene.formula, {wanted.left, wanted.right}};
    key.numbers.push_back(size.width);
    key.numbers.push_back(size.height);
    int component = 0, along = -1;
    for (const ParameterInfo& parameter : map.info.parameters)
        for (const double value : scene.parameters.at(std::string(parameter.name))) {
            const bool runs = parameterComponent(map.info, component) == wanted.number;
            if (runs) along = component;
            key.numbers.push_back(runs ? 0 : value);
            ++component;
        }
    key.numbers.push_back(along);
    if (!scene.criticalStart)
        key.numbers.insert(key.numbers.end(), workspace.point.begin(), workspace.point.end());
    if (!(study.key == key)) {
        study.key = std::move(key);
        study.filled = study.textured = 0;
        study.diagram.reset();
        study.program.reset();
        study.problem.clear();
        Job job(1);
        Expected<OrbitProgram> program =
            programAlong(context.bound.binder(), scene, {{{wanted.number, 1.0}}}, job);
        if (!program) {
            study.problem = program.status().message();
        } else {
            study.program = std::move(*program);
            study.options = {.left = wanted.left,
                             .right = wanted.right,
                             .transient = 600,
                             .points = 600,
                             .across = 1};
            fitDiagramHeight(*study.program, study.options);
            study.diagram.emplace(size);
        }
    }
    const Stopwatch watch;
    while (study.diagram && study.filled < size.width && watch.seconds() < kColumnBudget) {
        Job job(1);
        const int count = std::min(4, size.width - study.filled);
        const Status status =
            fillDiagram(*study.program, study.options, study.filled, count, job, *study.diagram);
        if (!status.ok()) {
            study.problem = status.message();
            study.diagram.reset();
            break;
        }
        study.filled += count;
    }
    if (study.diagram && study.filled < size.width) context.host.wake();
    return study;
}

void fitDiagram(StudioContext& context) {
    constexpr int kColumns = 400, kSteps = 200;
    const Workspace& workspace = context.workspace;
    const std::string number = diagramNumber(workspace);
    const Workspace::Diagram usual = usualDiagram(workspace, number);
    Job job(1);
    const Expected<OrbitProgram> program =
        programAlong(context.bound.binder(), diagramScene(workspace), {{{number, 1.0}}}, job);
    if (!program) return context.report(program.status());
    const double step = (usual.right - usual.left) / kColumns;
    double left = INFINITY, right = -INFINITY;
    for (int k = 0; k < kColumns; ++k) {
        const double at[3] = {usual.left + step * (k + 0.5), 0, 0};
        if (orbitOf(*program, at, kSteps).size() <= kSteps) continue;
        left = std::min(left, at[0]);
        right = std::max(right, at[0]);
    }
    if (!(left <= right)) return context.say("The orbit escapes everywhere in this range");
    context.edit([&](Workspace& changed) {
        changed.diagram = {number, left - 2 * step, right + 2 * step};
    });
}

}  // namespace versorium
