// SPDX-License-Identifier: MIT
// What becomes of circles, and the radii that decide alone.
#include "ui/session/circles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/shape_profile.h"
#include "render/system_of.h"
#include "ui/session/context.h"

namespace versorium {
namespace {

using Point = StatePlane::Point;

// Orbits of circles are followed no longer than this.
constexpr int kMostCircleSteps = 500;
// Moduli that differ by less are one: some thousand roundings.
constexpr double kSameModulus = 1e-12;

double normOf(const Point& x) {
    double sum = 0;
    for (double part : x) sum += part * part;
    return std::sqrt(sum);
}

std::string basinKey(const Scene& scene) {
    const Json json = sceneBody(scene);
    std::string key;
    for (const char* part : {"map", "parameters", "shape", "modulation", "escape_radius"})
        key += json.value(part, Json()).dump();
    return key;
}

}  // namespace

CircleStudy studyCircle(const System& system, const Workspace::Circle& circle,
                        const StatePlane& plane, int step, int iterations, double escapeRadius,
                        const Basins& basins, int points) {
    CircleStudy study;
    study.iterations = iterations;
    const auto [right, up] = plane.frame();
    study.least = study.low = std::numeric_limits<double>::infinity();
    int stay = 0;
    for (int k = 0; k < points; ++k) {
        const double angle = 2 * std::numbers::pi * k / points;
        Point x = circle.centre;
        for (std::size_t c = 0; c < 4; ++c)
            x[c] += circle.radius * (std::cos(angle) * right[c] + std::sin(angle) * up[c]);
        study.low = std::min(study.low, normOf(x));
        study.high = std::max(study.high, normOf(x));
        Point at = x, before = x;
        bool inside = normOf(x) <= escapeRadius;
        for (int n = 0; n < std::max(iterations, step + 1); ++n) {
            if (n == step) before = at;
            system.step(at.data());
            const double size = normOf(at);
            if (n == 0) {
                study.least = std::min(study.least, size);
                study.most = std::max(study.most, size);
            }
            if (n == step) study.to.push_back(at);
            if (n < iterations) inside = inside && size <= escapeRadius;
            if (n >= step && !inside) break;
        }
        study.from.push_back(before);
        study.member.push_back(inside);
        stay += inside ? 1 : 0;
    }
    study.stay = static_cast<double>(stay) / points;
    study.fate = stay == points ? CircleFate::captured
                 : stay == 0    ? CircleFate::escapes
                                : CircleFate::decided;
    study.oneModulus = study.most - study.least <= kSameModulus * study.most;
    study.certain = study.high <= basins.capture || study.low > basins.escape;
    return study;
}

std::string sentenceOf(const CircleStudy& study) {
    const std::string count = std::to_string(study.iterations);
    const std::string steps =
        study.iterations == 1 ? tr("{1} step", {count}) : tr("{1} steps", {count});
    const std::string points = std::to_string(study.from.size());
    switch (study.fate) {
        case CircleFate::captured:
            return study.certain
                       ? tr("captured for certain: it lies in the ball around 0 that keeps "
                            "every orbit, whatever d is")
                       : tr("captured: none of its {1} points escapes within {2}", {points, steps});
        case CircleFate::escapes:
            return study.certain
                       ? tr("escapes for certain: it lies where every orbit leaves, whatever d is")
                       : tr("escapes: all of its {1} points leave within {2}", {points, steps});
        default:
            return tr(study.oneModulus ? trLater("the versor decides: |f| is the same all along, "
                                                 "and {1} % of its points stay for {2}")
                                       : trLater("the versor decides: {1} % of its points stay for "
                                                 "{2}"),
                      {shownNumber(100 * study.stay, 3), steps});
    }
}

bool takesCircles(const Workspace& workspace) {
    const Algebra algebra = mapOf(workspace.views[0]).info.algebra;
    return algebra == Algebra::complex || algebra == Algebra::quaternion;
}

Basins studyBasins(StudioContext& context) {
    CircleStudies& studies = context.circles;
    const OrbitProgram* program = context.bound.orbitProgram();
    const Scene scene = orbitScene(context.workspace);
    if (!program || !program->field) return {0, std::numeric_limits<double>::infinity()};
    const std::string key = basinKey(scene);
    if (key == studies.basinsFor) return studies.basins;
    RadialOptions options = radialOptions(scene, program->escapeRadius);
    options.radii = 257;
    options.points = options.dimensions == 2 ? 1024 : 2048;
    options.to = std::min(program->escapeRadius, 1.5 * shapeReach(*program->field, options));
    Job job(1);
    const Expected<RadialProfile> profile = radialProfile(*program->field, options, job);
    studies.basinsFor = key;
    studies.basins =
        profile ? Basins{profile->capture, profile->escape} : Basins{0, program->escapeRadius};
    return studies.basins;
}

const std::vector<CircleStudy>& studyCircles(StudioContext& context, int view) {
    CircleStudies::OfView& studies = context.circles.views[static_cast<std::size_t>(view)];
    const bool fine = atRest(context);
    if (studies.revision == context.revision() && (studies.fine || !fine)) return studies.all;
    studies.all.clear();
    const Workspace& workspace = context.workspace;
    const std::optional<System> system = shownSystem(context);
    const Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    const std::optional<StatePlane> plane = statePlaneOf(scene);
    if (!system || !plane || !takesCircles(workspace)) return studies.all;
    studies.revision = context.revision();
    studies.fine = fine;
    const Basins basins = studyBasins(context);
    const double radius = scene.escapeRadius.value_or(automaticRadius(scene));
    for (const Workspace::Circle& circle : workspace.circles)
        studies.all.push_back(studyCircle(*system, circle, *plane, workspace.orbitAt,
                                          std::min(scene.iterations, kMostCircleSteps), radius,
                                          basins,
                                          fine ? CircleStudy::kPoints : CircleStudy::kFewPoints));
    return studies.all;
}

int circleViewOf(const Workspace& workspace) {
    if (!takesCircles(workspace)) return -1;
    if (statePlaneOf(workspace.view())) return workspace.focused;
    for (std::size_t k = 0; k < workspace.views.size(); ++k)
        if (statePlaneOf(workspace.views[k])) return static_cast<int>(k);
    return -1;
}

std::string describeCircles(StudioContext& context) {
    const int view = circleViewOf(context.workspace);
    if (view < 0 || context.workspace.circles.empty()) return {};
    const std::vector<CircleStudy>& all = studyCircles(context, view);
    std::string text;
    for (std::size_t k = 0; k < all.size(); ++k)
        text += " " + tr("Circle {1}: {2}.", {std::to_string(k + 1), sentenceOf(all[k])});
    return text;
}

void dropCircle(StudioContext& context) {
    const Workspace& workspace = context.workspace;
    if (!takesCircles(workspace)) return context.say("Circles are for complex and quaternion maps");
    if (workspace.circles.size() >= kMostCircles)
        return context.say(tr("There are {1} circles already: take one away first",
                              {std::to_string(kMostCircles)}));
    Point through{};
    std::copy_n(workspace.point.begin(), std::min<std::size_t>(4, workspace.point.size()),
                through.begin());
    double height = workspace.view().slice.height;
    if (const int view = context.probe.view; view >= 0) {
        const Scene& scene = workspace.views[static_cast<std::size_t>(view)];
        if (const auto plane = statePlaneOf(scene)) {
            through = plane->at(context.probe.u, context.probe.v);
            height = scene.slice.height;
        }
    }
    Workspace::Circle circle;
    circle.radius = normOf(through);
    if (!(circle.radius > 1e-3 * height)) circle.radius = 0.3 * height;
    context.edit([&](Workspace& changed) { changed.circles.push_back(circle); });
    context.circles.chosen = static_cast<int>(workspace.circles.size()) - 1;
}

void removeCircle(StudioContext& context, int circle) {
    if (circle < 0 || circle >= static_cast<int>(context.workspace.circles.size()))
        return context.say("Choose a circle first: click its line");
    context.edit(
        [&](Workspace& workspace) { workspace.circles.erase(workspace.circles.begin() + circle); });
    context.circles.chosen = -1;
}

}  // namespace versorium
