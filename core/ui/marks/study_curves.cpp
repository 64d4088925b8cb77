// SPDX-License-Identifier: MIT
// What core/ui/session/studies.h finds, drawn on planes of starting points: cycles, manifolds of
// saddles and the critical curve.
#include <cmath>

#include "render/system_of.h"
#include "ui/marks/mark.h"
#include "ui/marks/shapes.h"

namespace versorium {
namespace {

constexpr ImU32 kCurveHalo = IM_COL32(8, 10, 14, 210);
constexpr ImU32 kStable = IM_COL32(86, 180, 233, 255), kUnstable = IM_COL32(240, 140, 70, 255);
constexpr ImU32 kCurve = IM_COL32(255, 255, 255, 235);

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
    if (halo) list.AddPolyline(points.data(), count, kCurveHalo, 0, width * 2.4f);
    list.AddPolyline(points.data(), count, colour, 0, width);
}

void drawCritical(const ViewFrame& frame) {
    const float scale = frame.scale();
    ImDrawList& list = frame.list();
    const CriticalSet& set = studyCritical(frame.context, frame.view);
    for (const Polyline& curve : set.curves)
        drawCurve(list, frame.plane, curve, kCurve, 1.3f * scale, true);
    for (const PlanePoint& point : set.points) {
        const ImVec2 at = frame.plane.at(point[0], point[1]);
        list.AddCircleFilled(at, 4.5f * scale, kCurveHalo);
        list.AddCircleFilled(at, 2.8f * scale, kCurve);
    }
}

void drawCycles(const ViewFrame& frame, bool flat) {
    const float scale = frame.scale();
    ImDrawList& list = frame.list();
    const CycleStudy& study = studyCycles(frame.context);
    if (frame.workspace().study.manifolds)
        for (const SaddleManifolds& manifolds : study.manifolds) {
            if (manifolds.stable)
                for (const Polyline& curve : manifolds.stable->curves)
                    drawCurve(list, frame.plane, curve, kStable, 1.2f * scale, false);
            for (const Polyline& curve : manifolds.unstable.curves)
                drawCurve(list, frame.plane, curve, kUnstable, 1.2f * scale, false);
        }
    const double other = flat ? 0 : markerOf(frame.workspace(), frame.index())[1];
    for (const PeriodicCycle& cycle : study.cycles)
        for (const PlanePoint& point : cycle.points) {
            if (list.VtxBuffer.Size > kMostVertices + 8000) break;
            drawCycleMark(list, frame.plane.at(point[0], flat ? point[1] : other),
                          (cycle.period == 1 ? 5.5f : 4.0f) * scale, cycle.kind);
        }
}

void drawStudies(const ViewFrame& frame) {
    const Scene& scene = frame.scene();
    if (!isDynamicalPlane(scene)) return;
    const bool flat = mapOf(scene).dimension == 2;
    const Workspace::Study& study = frame.workspace().study;
    if (study.criticalCurve && flat) drawCritical(frame);
    if (study.cycles && frame.spoken()) drawCycles(frame, flat);
}

}  // namespace

const Mark studyMark{.draw = drawStudies};

}  // namespace versorium
