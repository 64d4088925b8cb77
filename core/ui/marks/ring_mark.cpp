// SPDX-License-Identifier: MIT
// The ring: dragged from near it, and with Ctrl from anywhere.
#include "ui/marks/ring_mark.h"

namespace versorium {
namespace {

constexpr float kRingSize = 9;

void movePoint(const ViewFrame& frame) {
    frame.context.edit(
        [&](Workspace& workspace) { moveMarker(workspace, frame.index(), frame.u(), frame.v()); });
}

void drawRing(const ViewFrame& frame) {
    if (frame.workspace().analysis() && frame.view == 0) return;
    drawMark(frame.list(), frame.ring, kRingSize * frame.scale(), MarkShape::ring,
             IM_COL32(255, 255, 255, 255));
}

std::optional<MarkHit> hitRing(const ViewFrame& frame) {
    const float distance = frame.away(frame.ring);
    if (distance > kPointReach * frame.scale()) return std::nullopt;
    return MarkHit{0, distance};
}

std::optional<Drag> pressRing(const ViewFrame& frame) {
    if (frame.pointer.shift) return std::nullopt;
    if (frame.pointer.ctrl) {
        movePoint(frame);
        return dragPoint(ringMark, 0);
    }
    if (showsPlaces(frame) || !hitRing(frame)) return std::nullopt;
    return dragPoint(ringMark, 0);
}

}  // namespace

bool onRing(const ViewFrame& frame) { return frame.away(frame.ring) <= kRingSize * frame.scale(); }

Drag dragPoint(const Mark& mark, int item) {
    return {.mark = &mark, .item = item, .move = movePoint};
}

bool showsPlaces(const ViewFrame& frame) { return frame.workspace().analysis() && frame.view == 0; }

const Mark ringMark{
    .name = [](const ViewFrame&, int) -> std::string { return tr("The ring"); },
    .draw = drawRing,
    .hit = hitRing,
    .press = pressRing,
    // A double click there goes nowhere.
    .doubleClick = [](const ViewFrame& frame) { return hitRing(frame).has_value(); },
};

}  // namespace versorium
