// SPDX-License-Identifier: MIT
#include "ui/session/shape_change.h"

#include <algorithm>
#include <cmath>

#include "geometry/random_roots.h"
#include "render/shape_profile.h"
#include "scene/shape_controls.h"
#include "scene/shape_name.h"
#include "shape/bounds.h"
#include "shape/outline.h"

namespace versorium {
namespace {

// What a scene of a map without a shape turns into: in the plane, or in space for a mesh.
constexpr const char* kPlanarPreset = "star";
constexpr const char* kSpatialPreset = "shape-modulus";

ShapeBounds boundsOfOutline(const std::vector<glm::dvec2>& corners) {
    ShapeBounds bounds;
    bounds.low = {1e300, 1e300, -0.5};
    bounds.high = {-1e300, -1e300, 0.5};
    for (const glm::dvec2& corner : corners)
        for (int k = 0; k < 2; ++k) {
            const auto at = static_cast<std::size_t>(k);
            bounds.low[at] = std::min(bounds.low[at], corner[k]);
            bounds.high[at] = std::max(bounds.high[at], corner[k]);
        }
    return bounds;
}

// Of a text that has been checked; a mesh fills the box around 0.
ShapeBounds boundsOfSource(const std::string& source) {
    if (isBuiltInMesh(source)) return {};
    if (isOutline(source)) return boundsOfOutline(*parseOutline(source));
    return boundsOf(DistanceField(*parseShape(source)), 2);
}

RootList rootsWithin(const ShapeBounds& bounds) {
    RandomRoots draw;
    for (std::size_t k = 0; k < 2; ++k) {
        draw.centre[k] = 0.5 * (bounds.low[k] + bounds.high[k]);
        draw.half[k] = 0.5 * (bounds.high[k] - bounds.low[k]);
    }
    draw.half[2] = draw.half[3] = 0;
    constexpr int kSeed = 5;  // as in the preset
    return randomRoots(draw, kSeed);
}

void frame(Scene& scene, const ShapeBounds& bounds) {
    constexpr double kMargin = 1.5;
    if (!traitsOf(scene).shape || scene.slice.centre.size() < 2) return;
    double size = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        scene.slice.centre[k] = 0.5 * (bounds.low[k] + bounds.high[k]);
        scene.slice.centreLow[k] = 0;
        size = std::max(size, bounds.high[k] - bounds.low[k]);
    }
    scene.slice.height = std::clamp(kMargin * size, kLeastHeight, kMostHeight);
}

Status change(StudioContext& context, const std::string& source, bool planar, bool framed) {
    if (source.starts_with("asset:")) return Status::usage("a file is opened by its name");
    if (Status status = checkShapeText(source); !status.ok()) return status;
    const MapInfo& info = mapOf(context.workspace.view()).info;
    const bool fits = info.field && (!planar || info.algebra == Algebra::complex);
    Workspace next = context.workspace;
    const ShapeBounds bounds = boundsOfSource(source);
    if (!fits) {
        Expected<Scene> scene = presetNamed(isBuiltInMesh(source) ? kSpatialPreset : kPlanarPreset);
        if (!scene) return scene.status();
        if (!isBuiltInMesh(source)) scene->lists["roots"] = rootsWithin(bounds);
        next = workspaceOf(*scene);
        next.maximised = context.workspace.maximised;
    }
    for (Scene& scene : next.views) {
        scene.shape.source = source;
        if (framed || !fits) frame(scene, bounds);
    }
    dropUnnamedAssets(next);
    if (fits) {
        context.edit([&](Workspace& w) { w = std::move(next); });
        context.welcome = false;
    } else {
        context.open(std::move(next));
    }
    return {};
}

}  // namespace

Status setShape(StudioContext& context, const std::string& source) {
    return change(context, source, false, false);
}

Status setDrawnShape(StudioContext& context, const std::string& source) {
    return change(context, source, true, true);
}

const std::vector<ShapeChoice>& shapeChoices() {
    static const std::vector<ShapeChoice> choices = {
        {trLater("disc"), "disc(0.6)"},
        {trLater("star"), "star(5, 0.9, 0.45)"},
        {trLater("heart"), "heart(1.3)"},
        {trLater("crescent"), "rotate(2.4, translate(0.25, 0, crescent(0.8, 0.65, 0.4)))"},
        {trLater("square"), "box(0.6, 0.6)"},
        {trLater("bar"), "box(0.9, 0.25)"},
        {trLater("two discs"),
         "smooth_union(0.2, translate(-0.4, 0, disc(0.5)), translate(0.5, 0, "
         "disc(0.35)))"},
        {trLater("sphere"), "sphere(0.35)"},
        {trLater("torus"), "torus(0.3, 0.13)"},
        {trLater("capsule"), "capsule(0.25, 0.15)"},
        {trLater("cube"), "box(0.3, 0.3, 0.3)"},
        {trLater("bunny"), "bunny"}};
    return choices;
}

std::array<double, 3> shapePlace(const Scene& scene, const OrbitProgram& program, double u,
                                 double v) {
    const double coordinates[3] = {u, v, 0};
    const ShapeControls controls = shapeControls(scene);
    const auto dimension = static_cast<std::size_t>(program.map->dimension);
    std::array<double, 3> place{};
    for (std::size_t k = 0; k < place.size(); ++k)
        if (const auto seen = static_cast<std::size_t>(controls.seen[k]); seen < dimension)
            place[k] = program.slice.at(seen, coordinates) - controls.shift[seen];
    return place;
}

namespace {

// A view of starting points of what is shown.
Scene pointsOf(const Workspace& workspace) {
    const int points = viewOfKind(workspace, ViewKind::startingPoints);
    return points < 0 ? homeView(ViewKind::startingPoints, workspace.view())
                      : workspace.views[static_cast<std::size_t>(points)];
}

}  // namespace

void showModulusAndVersor(StudioContext& context) {
    Workspace workspace = context.workspace;
    const Scene scene = pointsOf(workspace);
    const MapInfo& info = mapOf(scene).info;
    const bool complex = dimensionOf(info.algebra) == 2;
    setViewCount(workspace, 4);
    for (Scene& view : workspace.views) view = scene;
    const auto colours = [&](std::size_t view, FieldName field, const char* palette) {
        Colouring& colour = workspace.views[view].colour;
        colour = {};
        colour.field = field;
        colour.palette = palette;
        colour.interior = SetName::none;
        colour.outline = info.field ? SetName::solid : SetName::membership;
    };
    colours(0, FieldName::imageModulus, "blue-red");
    colours(1, FieldName::imageModulus, "hue");
    workspace.views[1].colour.rule = complex ? ColourRule::domain : ColourRule::versor;
    colours(2, FieldName::logModulus, "blue-red");
    colours(3, FieldName::membership, "grey");
    workspace.views[3].colour.outline = SetName::none;
    workspace.maximised = false;
    context.edit([&](Workspace& w) { w = std::move(workspace); });
    context.say(tr("r = |f|, {1}, log |f_n| and the members; outlined: {2}",
                   {complex ? tr("f by argument and modulus") : tr("versor d"),
                    info.field ? "log |f_n| < " + shownNumber(scene.iso, 4) : tr("the members")}));
}

void showAsPrinted(StudioContext& context) {
    if (!mapOf(context.workspace.view()).info.field)
        return context.say("S eq 2 needs a shape: draw one (D), or choose a shape modulus");
    Scene scene = pointsOf(context.workspace);
    context.edit([&](Workspace& w) {
        setViewCount(w, 2);
        for (int k = 0; k < 2; ++k) {
            scene.parameters[kAsPrinted] = {static_cast<double>(k)};
            w.views[static_cast<std::size_t>(k)] = scene;
        }
    });
    if (shapeControls(scene).beta == 0)
        context.say("With β = 0 both are the same: move β");
    else
        context.say("Left φ − β, as it must be; right φ + β, as S eq 2 prints it");
}

}  // namespace versorium
