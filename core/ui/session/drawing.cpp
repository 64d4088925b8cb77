// SPDX-License-Identifier: MIT
#include "ui/session/drawing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/shape_controls.h"
#include "shape/outline.h"
#include "ui/session/shape_change.h"
#include "ui/session/view_plane.h"

namespace versorium {
namespace {

constexpr float kCloses = 14;       // how near the first corner closes an outline, at scale 1
constexpr float kLeastStroke = 40;  // pixels that a freehand outline is wide at least, at scale 1
constexpr float kLeastMove = 2.5f;  // pixels between corners of a stroke
constexpr double kSmooth = 1.2;     // pixels that a simplified stroke may be off
constexpr double kDabs = 0.4;       // of the brush's radius, between two dabs of a stroke

float distance(ScreenPoint a, ScreenPoint b) { return std::hypot(a.x - b.x, a.y - b.y); }

ScreenPoint cornerAt(const ViewPlane& plane, const glm::dvec2& corner) {
    return plane.at(corner.x, corner.y);
}

// How far the corners since the press reach on the screen.
float strokeSize(const Drawing& drawing, const ViewPlane& plane) {
    ScreenPoint low{1e9f, 1e9f}, high{-1e9f, -1e9f};
    for (const glm::dvec2& corner : drawing.corners) {
        const ScreenPoint at = cornerAt(plane, corner);
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    return std::min(high.x - low.x, high.y - low.y);
}

void traceOutline(StudioContext& context, int view, const ViewPlane& plane,
                  const Pointer& pointer) {
    Drawing& drawing = context.drawing;
    const ScreenPoint mouse = pointer.at;
    const glm::dvec2 here(plane.u(mouse.x), plane.v(mouse.y));
    const float scale = context.scale;
    if (pointer.over && pointer.left) {
        context.welcome = false;
        context.player.animation.running = false;
        if (view != drawing.view) drawing.corners.clear();
        drawing.view = view;
        context.focus(view);
        if (drawing.corners.size() >= 3 &&
            distance(cornerAt(plane, drawing.corners[0]), mouse) < kCloses * scale)
            return finishOutline(context);
        drawing.corners.push_back(here);
        drawing.pressed = true;
        drawing.pressedAt = mouse;
        return;
    }
    if (view != drawing.view || !drawing.pressed) return;
    const bool dragged = distance(mouse, drawing.pressedAt) > kCloses * scale;
    if (pointer.held) {
        if (drawing.corners.size() < 4 * kMostOutlineCorners &&
            distance(cornerAt(plane, drawing.corners.back()), mouse) >= kLeastMove * scale)
            drawing.corners.push_back(here);
        return;
    }
    drawing.pressed = false;
    // A stroke closes the outline; a click, with the tremble of a finger, is one corner.
    if (drawing.corners.size() > 12 && strokeSize(drawing, plane) > kLeastStroke * scale &&
        (dragged || drawing.corners.size() > 40)) {
        drawing.corners = simplifyOutline(drawing.corners, kSmooth / plane.unit());
        return finishOutline(context);
    }
    while (!drawing.corners.empty() && drawing.corners.size() > 1 &&
           distance(cornerAt(plane, drawing.corners[drawing.corners.size() - 2]),
                    drawing.pressedAt) < kCloses * scale &&
           distance(cornerAt(plane, drawing.corners.back()), drawing.pressedAt) < kCloses * scale)
        drawing.corners.pop_back();
}

template <class AnyScene>
auto& paintedOf(AnyScene& scene, Drawing::Tool tool) {
    return tool == Drawing::Tool::alpha ? scene.alphaOverSpace : scene.betaOverSpace;
}

void dabAt(StudioContext& context, Drawing::Tool tool, const std::array<double, 3>& place) {
    const Drawing& drawing = context.drawing;
    const auto [x, y, z] = place;
    const double value = tool == Drawing::Tool::alpha ? drawing.alpha : drawing.beta;
    const auto full = [&](const Scene& scene) {
        return paintedOf(scene, tool).discs.size() >= kMostPaintedDiscs;
    };
    const std::vector<Scene>& views = context.workspace.views;
    if (!drawing.erases && std::any_of(views.begin(), views.end(), full))
        return context.say(
            "There are as many dabs as may be: erase some, or use a larger "
            "brush");
    context.edit([&, x = x, y = y, z = z](Workspace& workspace) {
        for (Scene& each : workspace.views) {
            auto& discs = paintedOf(each, tool).discs;
            if (drawing.erases)
                std::erase_if(discs, [&](const PaintedDisc& disc) {
                    const double far = std::hypot(disc.x - x, disc.y - y, disc.z - z);
                    return far < std::max(drawing.radius, 0.5 * disc.radius);
                });
            else
                discs.push_back({x, y, z, drawing.radius, value});
        }
    });
}

void dab(StudioContext& context, int view, double u, double v) {
    // Undo may have brought back a map without a shape, with the brush still in the hand.
    const OrbitProgram* program = context.bound.program(view);
    if (!program || !program->field) return;
    const Scene& scene = context.workspace.views[static_cast<std::size_t>(view)];
    dabAt(context, context.drawing.tool, shapePlace(scene, *program, u, v));
}

void paint(StudioContext& context, int view, const ViewPlane& plane, const Pointer& pointer) {
    Drawing& drawing = context.drawing;
    const glm::dvec2 here(plane.u(pointer.at.x), plane.v(pointer.at.y));
    if (pointer.over && pointer.left) {
        context.focus(view);
        context.player.animation.running = false;
        drawing.view = view;
        drawing.pressed = true;
        drawing.lastDab = here;
        dab(context, view, here.x, here.y);
        return;
    }
    if (!drawing.pressed || view != drawing.view) return;
    drawing.pressed = pointer.held;  // a quick stroke may end in the frame of its last move
    // Dabs at even distances, however fast the hand was.
    const double step = kDabs * drawing.radius;
    for (int k = 0; k < 200 && glm::distance(here, drawing.lastDab) >= step; ++k) {
        drawing.lastDab += step / glm::distance(here, drawing.lastDab) * (here - drawing.lastDab);
        dab(context, view, drawing.lastDab.x, drawing.lastDab.y);
    }
}

}  // namespace

void chooseTool(StudioContext& context, Drawing::Tool tool) {
    Drawing& drawing = context.drawing;
    const bool same = drawing.tool == tool;
    drawing.tool = same ? Drawing::Tool::none : tool;
    drawing.corners.clear();
    drawing.pressed = false;
    drawing.view = -1;
    context.player.animation.running = false;
    context.welcome = false;
    if (drawing.tool == Drawing::Tool::none) return;
    if (drawing.isBrush() && !mapOf(context.workspace.view()).info.field) {
        drawing.tool = Drawing::Tool::none;
        return context.say("This map has no α and β: draw a shape first (D)");
    }
    // On a phone one view is shown: the one that is drawn in.
    const Workspace& workspace = context.workspace;
    for (int k = static_cast<int>(workspace.views.size()) - 1;
         k >= 0 && !traitsOf(workspace.view()).shape; --k)
        if (traitsOf(workspace.views[static_cast<std::size_t>(k)]).shape) context.focus(k);
    context.host.announce(drawingHint(context));
    context.host.wake();
}

bool handleDrawing(StudioContext& context, int view, const ViewPlane& plane,
                   const Pointer& pointer) {
    Drawing& drawing = context.drawing;
    if (drawing.tool == Drawing::Tool::none) return false;
    const Scene& scene = context.workspace.views[static_cast<std::size_t>(view)];
    // A second finger moves the view, and the stroke is not meant.
    if (context.views[static_cast<std::size_t>(view)].drag.fingers) {
        drawing.corners.clear();
        drawing.pressed = false;
        return false;
    }
    if (scene.slice.axes.size() < 2) return false;
    if (pointer.rightDown) return false;
    if (drawing.tool == Drawing::Tool::outline) {
        traceOutline(context, view, plane, pointer);
        return true;
    }
    if (!traitsOf(scene).shape) return false;
    paint(context, view, plane, pointer);
    return true;
}

bool drawingKeys(StudioContext& context, const DrawingKeys& pressed) {
    Drawing& drawing = context.drawing;
    if (drawing.tool == Drawing::Tool::none) return false;
    if (pressed.escape) {
        chooseTool(context, drawing.tool);
        return true;
    }
    if (drawing.tool != Drawing::Tool::outline || drawing.corners.empty()) return false;
    if (pressed.enter) {
        finishOutline(context);
        return true;
    }
    if (pressed.back) {
        drawing.corners.pop_back();
        return true;
    }
    return false;
}

std::string drawingHint(const StudioContext& context) {
    switch (context.drawing.tool) {
        case Drawing::Tool::outline:
            return tr(
                "Draw an outline in one stroke, or click its corners and close it. Esc: stop");
        case Drawing::Tool::alpha:
            return tr("Paint: where you paint, α becomes {1}. Esc: the brush down",
                      {shownNumber(context.drawing.alpha, 4)});
        case Drawing::Tool::beta:
            return tr("Paint: where you paint, β becomes {1}. Esc: the brush down",
                      {shownNumber(context.drawing.beta, 4)});
        default:
            return {};
    }
}

void paintAtPoint(StudioContext& context, Drawing::Tool tool) {
    const OrbitProgram* program = context.bound.orbitProgram();
    if (!program || !program->field) return context.say("There is no shape to paint on");
    const Scene scene = orbitScene(context.workspace);
    const std::vector<double>& centre = scene.slice.centre;
    dabAt(context, tool, shapePlace(scene, *program, centre[0], centre.size() > 1 ? centre[1] : 0));
}

void finishOutline(StudioContext& context) {
    Drawing& drawing = context.drawing;
    std::vector<glm::dvec2> corners;
    corners.swap(drawing.corners);
    drawing.pressed = false;
    if (corners.size() < 3) return context.say("An outline has three corners at least");
    // The shape is looked up at x - shift.
    const Scene& scene = context.workspace.view();
    const MapInfo& info = mapOf(scene).info;
    if (info.field && info.algebra == Algebra::complex && traitsOf(scene).shape)
        for (glm::dvec2& corner : corners) {
            const std::array<double, 4> shift = shapeControls(scene).shift;
            corner -= glm::dvec2(shift[0], shift[1]);
        }
    Job job(1);
    Expected<std::vector<glm::dvec2>> placed = parseOutline(printOutline(corners));
    if (placed) placed = aroundOrigin(std::move(*placed), job);
    if (!placed) return context.report(placed.status());
    if (const Status status = setDrawnShape(context, printOutline(*placed)); !status.ok())
        return context.report(status);
    drawing.tool = Drawing::Tool::none;
    for (std::size_t k = 0; k < context.workspace.views.size(); ++k)
        if (traitsOf(context.workspace.views[k]).shape) context.focus(static_cast<int>(k));
    context.say("The Julia set of your shape. Turn α for detail, β to grow it");
}

}  // namespace versorium
