// SPDX-License-Identifier: MIT
#include "lesson/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "dynamics/catalogue_badge.h"
#include "fields/evaluate.h"
#include "math/elementary.h"
#include "render/bind.h"
#include "render/shape_profile.h"
#include "scene/shape_controls.h"
#include "shape/outline.h"

namespace versorium {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::vector<const double*> middleOf(const Scene& scene) {
    std::vector<const double*> coordinates;
    for (const double& value : scene.slice.centre) coordinates.push_back(&value);
    return coordinates;
}

// A field of one orbit: that of the scene's own middle.
double measure(const Scene& scene, FieldName field) {
    const std::optional<OrbitProgram> program = programNow(scene);
    if (!program) return kUnknown;
    return evaluateFields(*program, 1, middleOf(scene).data(), std::vector<FieldName>{field})[0][0];
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

const Scene* viewOfStarts(const Workspace& workspace) {
    for (const Scene& scene : workspace.views)
        if (viewKind(scene) == ViewKind::startingPoints && scene.slice.axes.size() == 2)
            return &scene;
    return nullptr;
}

// The middles of kShareSide x kShareSide cells of a view.
struct Points {
    std::vector<double> u, v;
    explicit Points(const Scene& view) {
        const double height = view.slice.height;
        for (int i = 0; i < kShareSide * kShareSide; ++i) {
            const double x = (i % kShareSide + 0.5) / kShareSide - 0.5;
            const double y = (i / kShareSide + 0.5) / kShareSide - 0.5;
            u.push_back(view.slice.centre[0] + height * x);
            v.push_back(view.slice.centre[1] + height * y);
        }
    }
};

std::vector<double> membership(const OrbitProgram& program, const std::vector<double>& u,
                               const std::vector<double>& v) {
    const double* coordinates[] = {u.data(), v.data()};
    return evaluateFields(program, static_cast<int>(u.size()), coordinates,
                          std::vector<FieldName>{FieldName::membership})[0];
}

bool isComplex(const Scene& scene) { return mapOf(scene).info.algebra == Algebra::complex; }

// The distance field of a complex map, as the map looks into it: at z - shift.
struct PlaneField {
    OrbitProgram program;
    std::array<double, 4> shift;

    double at(double x, double y) const {
        return program.field->at(x - shift[0], y - shift[1], 0.0);
    }
};
std::optional<PlaneField> planeField(const Scene& scene) {
    if (!isComplex(scene) || !mapOf(scene).info.field) return {};
    std::optional<OrbitProgram> program = programNow(scene);
    if (!program || !program->field) return {};
    return PlaneField{std::move(*program), shapeControls(scene).shift};
}

const EnsembleSpec* ensembleOf(const Workspace& workspace) {
    for (const Scene& scene : workspace.views)
        if (scene.ensemble.varies()) return &scene.ensemble;
    return nullptr;
}

// Cells of the first view of starts: in the set, in the shape, in both, in either.
struct Cover {
    double set = 0, shape = 0, both = 0, either = 0;
};
std::optional<Cover> coverOf(const Workspace& workspace) {
    const Scene* view = viewOfStarts(workspace);
    if (!view) return {};
    const std::optional<PlaneField> field = planeField(*view);
    if (!field) return {};
    const Points points(*view);
    const std::vector<double> inside = membership(field->program, points.u, points.v);
    Cover cover;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const bool set = inside[i] == 1, shape = field->at(points.u[i], points.v[i]) < 0;
        cover.set += set;
        cover.shape += shape;
        cover.both += set && shape;
        cover.either += set || shape;
    }
    return cover;
}

}  // namespace

std::optional<OrbitProgram> programNow(const Scene& scene) {
    Binder binder;
    // The grid of an outline is small and made at once; those of meshes are not.
    if (const std::optional<Scene> missing = binder.missingGrid(scene);
        missing && !isOutline(missing->shape.source))
        return {};
    Job job(1);
    Expected<OrbitProgram> program = binder.bind(scene, job);
    if (!program) return {};
    return std::move(*program);
}

std::vector<std::vector<double>> orbitNow(const Workspace& workspace, int steps) {
    const Scene scene = orbitScene(workspace);
    const std::optional<OrbitProgram> program = programNow(scene);
    if (!program) return {};
    return orbitOf(*program, scene.slice.centre.data(), steps);
}

double ofOrbit(const Workspace& workspace, FieldName field) {
    return measure(orbitScene(workspace), field);
}

double ofCriticalOrbit(const Workspace& workspace, FieldName field) {
    return measure(criticalScene(workspace), field);
}

double endOfOrbit(const Workspace& workspace, std::size_t component) {
    const int steps = std::min(orbitScene(workspace).iterations, kMostEndSteps);
    const std::vector<std::vector<double>> orbit = orbitNow(workspace, steps);
    const bool whole = static_cast<int>(orbit.size()) == steps + 1;
    return whole && component < orbit.back().size() ? orbit.back()[component] : kUnknown;
}

double shareThatStays(const Workspace& workspace) {
    const Scene* view = viewOfStarts(workspace);
    const std::optional<OrbitProgram> program = view ? programNow(*view) : std::nullopt;
    if (!program) return kUnknown;
    const Points points(*view);
    double count = 0;
    for (const double one : membership(*program, points.u, points.v)) count += one;
    return count / (kShareSide * kShareSide);
}

double shareOfShape(const Workspace& workspace) {
    const std::optional<Cover> cover = coverOf(workspace);
    return cover ? cover->shape / (kShareSide * kShareSide) : kUnknown;
}

double agreementWithShape(const Workspace& workspace) {
    const std::optional<Cover> cover = coverOf(workspace);
    return cover && cover->either > 0 ? cover->both / cover->either : kUnknown;
}

double distanceAtStart(const Workspace& workspace) {
    const std::optional<PlaneField> field = planeField(orbitScene(workspace));
    return field ? field->at(workspace.point[0], workspace.point[1]) : kUnknown;
}

double meanDistanceAround(const Workspace& workspace) {
    const std::optional<PlaneField> field = planeField(orbitScene(workspace));
    if (!field) return kUnknown;
    const double radius = std::sqrt(workspace.point[0] * workspace.point[0] +
                                    workspace.point[1] * workspace.point[1]);
    double sum = 0;
    for (int k = 0; k < kCirclePoints; ++k) {
        const double angle = 2 * std::numbers::pi * k / kCirclePoints;
        sum += field->at(radius * versorium::cos(angle), radius * versorium::sin(angle));
    }
    return sum / kCirclePoints;
}

double captureRadius(const Workspace& workspace) {
    const Scene scene = orbitScene(workspace);
    if (!mapOf(scene).info.field) return kUnknown;
    const std::optional<OrbitProgram> program = programNow(scene);
    if (!program || !program->field) return kUnknown;
    RadialOptions options = radialOptions(scene, program->escapeRadius);
    options.radii = 257;
    options.points = 4 * kCirclePoints;
    options.outward = false;
    options.to = std::min(program->escapeRadius, 1.5 * shapeReach(*program->field, options));
    Job job(1);
    const Expected<RadialProfile> profile = radialProfile(*program->field, options, job);
    return profile ? profile->capture : kUnknown;
}

double cornersOfShape(const Workspace& workspace) {
    const Scene& scene = workspace.views[0];
    if (!mapOf(scene).info.field || !isOutline(scene.shape.source)) return 0;
    const auto corners = parseOutline(scene.shape.source);
    return corners ? static_cast<double>(corners->size()) : 0;
}

double membersCounted(const Workspace& workspace) {
    const EnsembleSpec* ensemble = ensembleOf(workspace);
    return ensemble ? ensemble->count : 0;
}

double memberShareAtStart(const Workspace& workspace) {
    const EnsembleSpec* ensemble = ensembleOf(workspace);
    if (!ensemble) return kUnknown;
    Scene scene = orbitScene(workspace);
    scene.ensemble = *ensemble;
    scene.ensemble.count = std::min(scene.ensemble.count, kMostMeasuredMembers);
    return measure(scene, FieldName::meanMembership);
}

double circlesThatEnd(const Workspace& workspace, CircleEnd end) {
    const Scene scene = orbitScene(workspace);
    const std::optional<OrbitProgram> program = isComplex(scene) ? programNow(scene) : std::nullopt;
    if (!program) return kUnknown;
    double count = 0;
    for (const Workspace::Circle& circle : workspace.circles) {
        std::vector<double> x, y;
        for (int k = 0; k < kCirclePoints; ++k) {
            const double angle = 2 * std::numbers::pi * k / kCirclePoints;
            x.push_back(circle.centre[0] + circle.radius * versorium::cos(angle));
            y.push_back(circle.centre[1] + circle.radius * versorium::sin(angle));
        }
        double stay = 0;
        for (const double one : membership(*program, x, y)) stay += one;
        const CircleEnd found = stay == kCirclePoints ? CircleEnd::captured
                                : stay == 0           ? CircleEnd::escapes
                                                      : CircleEnd::decided;
        count += found == end;
    }
    return count;
}

double isCatalogue(const Workspace& workspace) {
    const int at = firstOfKind(workspace, ViewKind::parameters);
    if (at < 0) return kUnknown;
    const Scene* view = &workspace.views[static_cast<std::size_t>(at)];
    if (view->slice.axes.size() != 2) return kUnknown;
    const std::optional<OrbitProgram> program = programNow(*view);
    if (!program) return kUnknown;
    const double half = view->slice.height / 2;
    const CatalogueBadge badge = catalogueBadge(*program, view->slice.centre.data(), half, half);
    return badge.answer == CatalogueAnswer::onlyCriticalOrbit;
}

double distanceToPin(const Workspace& workspace) {
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

}  // namespace versorium
