// SPDX-License-Identifier: MIT
// The second start, whose orbit is compared with the first one's. Alt and a drag sets it.
#include "render/system_of.h"
#include "ui/marks/ring_mark.h"

namespace versorium {
namespace {

constexpr float kComparedReach = 14;

std::optional<ScreenPoint> placeOfCompared(const ViewFrame& frame) {
    const std::vector<double>& state = frame.workspace().compared;
    const Scene& scene = frame.scene();
    if (state.empty() || !isDynamicalPlane(scene)) return std::nullopt;
    // On the line it lies as high as the ring.
    return frame.plane.at(state[0], mapOf(scene).dimension > 1
                                        ? state[1]
                                        : markerOf(frame.workspace(), frame.index())[1]);
}

void drawCompared(const ViewFrame& frame) {
    const std::optional<ScreenPoint> at = placeOfCompared(frame);
    if (!at) return;
    const float scale = frame.scale();
    drawMark(frame.list(), *at, 7 * scale, MarkShape::square, pinColour(1));
    drawText(frame.list(), {at->x + 10 * scale, at->y - 8 * scale}, pinColour(1), tr("second"));
}

std::optional<MarkHit> hitCompared(const ViewFrame& frame) {
    const std::optional<ScreenPoint> at = placeOfCompared(frame);
    if (!at || frame.away(*at) > kComparedReach * frame.scale()) return std::nullopt;
    return MarkHit{0, frame.away(*at)};
}

void moveCompared(const ViewFrame& frame) {
    frame.context.edit([&](Workspace& workspace) {
        std::vector<double>& state = workspace.compared;
        if (state.empty()) state = workspace.point;
        state[0] = frame.u();
        if (state.size() > 1) state[1] = frame.v();
    });
}

std::optional<Drag> pressCompared(const ViewFrame& frame) {
    const Pointer& pointer = frame.pointer;
    if (pointer.shift || pointer.ctrl || !isDynamicalPlane(frame.scene())) return std::nullopt;
    if (pointer.alt)
        moveCompared(frame);
    else if (onRing(frame) || !hitCompared(frame))
        return std::nullopt;
    return Drag{.mark = &comparedMark, .move = moveCompared};
}

}  // namespace

const Mark comparedMark{
    .name = [](const ViewFrame&, int) -> std::string { return tr("The second start"); },
    .draw = drawCompared,
    .hit = hitCompared,
    .press = pressCompared,
};

}  // namespace versorium
