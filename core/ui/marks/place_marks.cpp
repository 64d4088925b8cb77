// SPDX-License-Identifier: MIT
// The four places of an analysis: in its first view, and the mark of each in the corner of its own.
#include "ui/marks/ring_mark.h"

namespace versorium {
namespace {

ScreenPoint placeOf(const ViewFrame& frame, int k) {
    const std::vector<Scene>& views = frame.workspace().views;
    const auto at = markerOf(views[static_cast<std::size_t>(k)], views[0].slice);
    return frame.plane.at(at[0], at[1]);
}

// The item is the view of the place.
std::optional<MarkHit> hitPlace(const ViewFrame& frame) {
    if (!showsPlaces(frame)) return std::nullopt;
    std::optional<MarkHit> nearest;
    float reach = kPointReach * frame.scale();
    for (int k = 1; k < kAnalysisViews; ++k) {
        const float distance = frame.away(placeOf(frame, k));
        if (distance > reach) continue;
        reach = distance;
        nearest = MarkHit{k, distance};
    }
    return nearest;
}

void drawPlaces(const ViewFrame& frame) {
    const Workspace& workspace = frame.workspace();
    if (!workspace.analysis()) return;
    const float scale = frame.scale();
    ImDrawList& list = frame.list();
    for (int k = 1; k < kAnalysisViews; ++k) {
        const auto shape = static_cast<MarkShape>(k - 1);
        const float size = 8 * scale;
        const ScreenPoint corner{frame.plane.high.x - 18 * scale, frame.plane.low.y + 18 * scale};
        if (frame.view == k) drawMark(list, corner, size, shape, pinColour(k - 1));
        if (frame.view != 0) continue;
        const ScreenPoint place = placeOf(frame, k);
        if (static_cast<int>(workspace.speaker()) == k)
            list.AddCircle(place, 14 * scale, IM_COL32(255, 255, 255, 220), 0, 1.5f);
        drawMark(list, place, size, shape, pinColour(k - 1));
        drawText(list, {place.x + 11 * scale, place.y - 20 * scale}, pinColour(k - 1),
                 std::to_string(k));
    }
}

// The view of the place that is pressed; with Ctrl the marked place comes to the pointer.
std::optional<int> focusOfPlace(const ViewFrame& frame) {
    if (!showsPlaces(frame)) return std::nullopt;
    if (const auto hit = hitPlace(frame)) return hit->item;
    if (frame.pointer.ctrl) return static_cast<int>(frame.workspace().speaker());
    return std::nullopt;
}

std::optional<Drag> pressPlace(const ViewFrame& frame) {
    if (frame.pointer.shift || frame.pointer.ctrl) return std::nullopt;
    const std::optional<MarkHit> hit = hitPlace(frame);
    if (!hit) return std::nullopt;
    return dragPoint(placeMark, hit->item);
}

}  // namespace

const Mark placeMark{
    .name = [](const ViewFrame&, int item) { return tr("Place {1}", {std::to_string(item)}); },
    .draw = drawPlaces,
    .hit = hitPlace,
    .press = pressPlace,
    .focus = focusOfPlace,
};

}  // namespace versorium
