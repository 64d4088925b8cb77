// SPDX-License-Identifier: MIT
// p*, where the orbits of a set of parameters start, on planes of starting points. With Alt it goes
// to the point of the critical curve that is nearest to the pointer, where that is drawn.
#include "render/system_of.h"
#include "ui/marks/ring_mark.h"

namespace versorium {
namespace {

constexpr ImU32 kStart = IM_COL32(255, 222, 110, 255);
constexpr float kStartReach = 14;

// Drawn where it is a single point that the hand may move: one that follows a critical point only
// beside the critical curve.
std::optional<ScreenPoint> placeOfStart(const ViewFrame& frame) {
    const Workspace& workspace = frame.workspace();
    const Scene& scene = frame.scene();
    const int parameters = viewOfKind(workspace, ViewKind::parameters);
    if (!isDynamicalPlane(scene) || !traitsOf(scene).starts || parameters < 0) return std::nullopt;
    if (workspace.views[static_cast<std::size_t>(parameters)].criticalStart &&
        !workspace.study.criticalCurve)
        return std::nullopt;
    const auto start = startOf(frame.context, parameters);
    if (!start || start->size() < 2) return std::nullopt;
    return frame.plane.at((*start)[0], (*start)[1]);
}

void drawStart(const ViewFrame& frame) {
    const std::optional<ScreenPoint> at = placeOfStart(frame);
    if (!at) return;
    const float scale = frame.scale();
    drawMark(frame.list(), *at, 8 * scale, MarkShape::diamond, kStart);
    drawText(frame.list(), {at->x + 11 * scale, at->y + 1 * scale}, kStart, "p*");
}

std::optional<MarkHit> hitStart(const ViewFrame& frame) {
    const std::optional<ScreenPoint> at = placeOfStart(frame);
    if (!at || frame.away(*at) > kStartReach * frame.scale()) return std::nullopt;
    return MarkHit{0, frame.away(*at)};
}

void moveStart(const ViewFrame& frame) {
    const int parameters = viewOfKind(frame.workspace(), ViewKind::parameters);
    if (parameters < 0) return;
    std::vector<double> start = frame.workspace().views[static_cast<std::size_t>(parameters)].start;
    start.resize(std::max<std::size_t>(2, start.size()));
    start[0] = frame.u();
    start[1] = frame.v();
    setStart(frame.context, parameters, std::move(start));
}

std::optional<Drag> pressStart(const ViewFrame& frame) {
    const Pointer& pointer = frame.pointer;
    const Scene& scene = frame.scene();
    if (pointer.shift || pointer.ctrl || !isDynamicalPlane(scene)) return std::nullopt;
    if (pointer.alt) {
        const int parameters = viewOfKind(frame.workspace(), ViewKind::parameters);
        if (!frame.workspace().study.criticalCurve || mapOf(scene).dimension != 2 || parameters < 0)
            return std::nullopt;
        startAtNearest(frame.context, parameters, {frame.u(), frame.v()});
        return Drag{};
    }
    if (onRing(frame) || !hitStart(frame)) return std::nullopt;
    return Drag{.mark = &startMark, .move = moveStart};
}

}  // namespace

const Mark startMark{
    .name = [](const ViewFrame&, int) -> std::string { return tr("The start p*"); },
    .draw = drawStart,
    .hit = hitStart,
    .press = pressStart,
};

}  // namespace versorium
