// SPDX-License-Identifier: MIT
// What is drawn over a plane of starting points: cycles, manifolds, the critical curve, p* and the
// second start; and the hand that takes the last two.
#include <algorithm>
#include <cmath>

#include "render/system_of.h"
#include "ui/marks/study_marks.h"
#include "ui/session/context.h"

namespace versorium {
namespace {

constexpr ImU32 kHalo = IM_COL32(8, 10, 14, 210);
constexpr float kReach = 14;
constexpr ImU32 kStable = IM_COL32(86, 180, 233, 255), kUnstable = IM_COL32(240, 140, 70, 255);
constexpr ImU32 kCurve = IM_COL32(255, 255, 255, 235), kStart = IM_COL32(255, 222, 110, 255);

// ImGui's lists have 16-bit indices: beyond this many vertices a window draws no more curves.
constexpr int kMostVertices = 30000;

void drawCurve(ImDrawList& list, const ViewPlane& plane, const Polyline& curve, ImU32 colour,
               float width, bool halo) {
    // What the eye cannot tell apart need not be drawn.
    constexpr float kStep = 1.5f;
    std::vector<ImVec2> points;
    for (std::size_t k = 0; k < curve.size(); ++k) {
        const ImVec2 at = plane.at(curve[k][0], curve[k][1]);
        if (points.empty() || k + 1 == curve.size() ||
            std::abs(at.x - points.back().x) + std::abs(at.y - points.back().y) > kStep)
            points.push_back(at);
    }
    const int count = static_cast<int>(points.size());
    if (list.VtxBuffer.Size + 4 * count * (halo ? 2 : 1) > kMostVertices) return;
    if (halo) list.AddPolyline(points.data(), count, kHalo, 0, width * 2.4f);
    list.AddPolyline(points.data(), count, colour, 0, width);
}

PlanePoint planePoint(const Scene& scene, const std::vector<double>& state, double other) {
    return {state[0], mapOf(scene).dimension > 1 ? state[1] : other};
}

bool near(ImVec2 a, ImVec2 b, float reach) { return std::hypot(a.x - b.x, a.y - b.y) <= reach; }

// The starts of sets are drawn where they are single points that the hand may move: those that
// follow a critical point only beside the critical curve.
bool showsStart(const Workspace& workspace, int parameters) {
    if (parameters < 0) return false;
    return !workspace.views[static_cast<std::size_t>(parameters)].criticalStart ||
           workspace.study.criticalCurve;
}

std::optional<ImVec2> placeOfStart(StudioContext& context, int view, const ViewPlane& plane) {
    const Workspace& workspace = context.workspace;
    const Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    const int parameters = viewOfKind(workspace, ViewKind::parameters);
    if (!isDynamicalPlane(scene) || !traitsOf(scene).starts || !showsStart(workspace, parameters))
        return std::nullopt;
    const auto start = startOf(context, parameters);
    if (!start || start->size() < 2) return std::nullopt;
    return plane.at((*start)[0], (*start)[1]);
}

std::optional<ImVec2> placeOfCompared(const StudioContext& context, int view,
                                      const ViewPlane& plane) {
    const Workspace& workspace = context.workspace;
    const Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    if (workspace.compared.empty() || !isDynamicalPlane(scene)) return std::nullopt;
    const auto marker = markerOf(workspace, static_cast<std::size_t>(view));
    const PlanePoint at = planePoint(scene, workspace.compared, marker[1]);
    return plane.at(at[0], at[1]);
}

}  // namespace

ImU32 cycleColour(CycleKind kind) {
    switch (kind) {
        case CycleKind::attracting:
            return IM_COL32(95, 220, 170, 255);
        case CycleKind::repelling:
            return IM_COL32(255, 190, 90, 255);
        case CycleKind::saddle:
            return IM_COL32(255, 120, 110, 255);
        default:
            return IM_COL32(220, 220, 230, 255);
    }
}

void drawCycleMark(ImDrawList& list, ImVec2 at, float size, CycleKind kind) {
    const ImU32 colour = cycleColour(kind);
    switch (kind) {
        case CycleKind::attracting:
            list.AddCircleFilled(at, size + 1.5f, kHalo);
            list.AddCircleFilled(at, size, colour);
            break;
        case CycleKind::repelling:
            list.AddCircle(at, size, kHalo, 0, 5);
            list.AddCircle(at, size, colour, 0, 2);
            break;
        case CycleKind::saddle:
            for (const auto& [tint, width] : {std::pair{kHalo, 5.0f}, std::pair{colour, 2.2f}}) {
                list.AddLine({at.x - size, at.y - size}, {at.x + size, at.y + size}, tint, width);
                list.AddLine({at.x - size, at.y + size}, {at.x + size, at.y - size}, tint, width);
            }
            break;
        default:
            list.AddQuad({at.x, at.y - size}, {at.x + size, at.y}, {at.x, at.y + size},
                         {at.x - size, at.y}, kHalo, 5);
            list.AddQuad({at.x, at.y - size}, {at.x + size, at.y}, {at.x, at.y + size},
                         {at.x - size, at.y}, colour, 2);
    }
}

void drawStudyMarks(StudioContext& context, int view, const ViewPlane& plane, ImDrawList& list) {
    const Workspace& workspace = context.workspace;
    const Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    if (!isDynamicalPlane(scene)) return;
    const float scale = context.scale;
    const bool spoken = !workspace.analysis() || view == static_cast<int>(workspace.speaker());
    const bool flat = mapOf(scene).dimension == 2;
    if (workspace.study.criticalCurve && flat) {
        const CriticalSet& set = studyCritical(context, view);
        for (const Polyline& curve : set.curves)
            drawCurve(list, plane, curve, kCurve, 1.3f * scale, true);
        for (const PlanePoint& point : set.points) {
            const ImVec2 at = plane.at(point[0], point[1]);
            list.AddCircleFilled(at, 4.5f * scale, kHalo);
            list.AddCircleFilled(at, 2.8f * scale, kCurve);
        }
    }
    if (workspace.study.cycles && spoken) {
        const CycleStudy& study = studyCycles(context);
        if (workspace.study.manifolds)
            for (const SaddleManifolds& manifolds : study.manifolds) {
                if (manifolds.stable)
                    for (const Polyline& curve : manifolds.stable->curves)
                        drawCurve(list, plane, curve, kStable, 1.2f * scale, false);
                for (const Polyline& curve : manifolds.unstable.curves)
                    drawCurve(list, plane, curve, kUnstable, 1.2f * scale, false);
            }
        const double other = flat ? 0 : markerOf(workspace, static_cast<std::size_t>(view))[1];
        for (const PeriodicCycle& cycle : study.cycles)
            for (const PlanePoint& point : cycle.points) {
                if (list.VtxBuffer.Size > kMostVertices + 8000) break;
                drawCycleMark(list, plane.at(point[0], flat ? point[1] : other),
                              (cycle.period == 1 ? 5.5f : 4.0f) * scale, cycle.kind);
            }
    }
    if (const auto at = placeOfCompared(context, view, plane)) {
        drawMark(list, *at, 7 * scale, MarkShape::square, pinColour(1));
        drawText(list, {at->x + 10 * scale, at->y - 8 * scale}, pinColour(1), tr("second"));
    }
    if (const auto at = placeOfStart(context, view, plane)) {
        drawMark(list, *at, 8 * scale, MarkShape::diamond, kStart);
        drawText(list, {at->x + 11 * scale, at->y + 1 * scale}, kStart, "p*");
    }
}

bool takeStudyMark(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse,
                   bool alt) {
    Workspace& workspace = context.workspace;
    ViewState& state = context.views[static_cast<std::size_t>(view)];
    const Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    if (!isDynamicalPlane(scene)) return false;
    const float reach = kReach * context.scale;
    const int parameters = viewOfKind(workspace, ViewKind::parameters);
    if (alt && workspace.study.criticalCurve && mapOf(scene).dimension == 2 && parameters >= 0) {
        startAtNearest(context, parameters, {plane.u(mouse.x), plane.v(mouse.y)});
        state.drag = ViewState::Drag::none;
        return true;
    }
    if (alt) {
        state.drag = ViewState::Drag::compared;
        dragStudyMark(context, view, plane, mouse);
        return true;
    }
    const auto marker = markerOf(workspace, static_cast<std::size_t>(view));
    if (near(mouse, plane.at(marker[0], marker[1]), 9 * context.scale)) return false;
    if (const auto at = placeOfStart(context, view, plane); at && near(mouse, *at, reach)) {
        state.drag = ViewState::Drag::start;
        return true;
    }
    if (const auto at = placeOfCompared(context, view, plane); at && near(mouse, *at, reach)) {
        state.drag = ViewState::Drag::compared;
        return true;
    }
    return false;
}

void dragStudyMark(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse) {
    Workspace& workspace = context.workspace;
    const ViewState& state = context.views[static_cast<std::size_t>(view)];
    const double u = plane.u(mouse.x), v = plane.v(mouse.y);
    if (state.drag == ViewState::Drag::start) {
        const int parameters = viewOfKind(workspace, ViewKind::parameters);
        if (parameters < 0) return;
        std::vector<double> start = workspace.views[static_cast<std::size_t>(parameters)].start;
        start.resize(std::max<std::size_t>(2, start.size()));
        start[0] = u;
        start[1] = v;
        setStart(context, parameters, std::move(start));
    } else if (state.drag == ViewState::Drag::compared) {
        if (workspace.compared.empty()) workspace.compared = workspace.point;
        workspace.compared[0] = u;
        if (workspace.compared.size() > 1) workspace.compared[1] = v;
        context.touch();
    }
}

}  // namespace versorium
