// SPDX-License-Identifier: MIT
#include "ui/views/view_input.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/marks/mark.h"

namespace versorium {
namespace {

constexpr double kWheel = 0.8;   // by which a step of the wheel zooms
constexpr double kLeastBox = 8;  // pixels along a side of a box that is zoomed to

// Of the view's centre, along its axes.
void moveCentre(SliceSpec& slice, double right, double up) {
    slice.centre[0] += right;
    if (slice.centre.size() > 1) slice.centre[1] += up;
}

Drag panView() {
    return {.move = [](const ViewFrame& frame) {
        frame.state().glide.reset();
        const ScreenPoint moved = frame.pointer.moved;
        const double unit = frame.plane.unit();
        frame.context.edit([&](Workspace& workspace) {
            moveCentre(workspace.views[frame.index()].slice, -moved.x / unit, moved.y / unit);
        });
    }};
}

void zoomToBox(const ViewFrame& frame, const ScreenPoint& from) {
    const ScreenPoint to = frame.pointer.at;
    const double wide = std::abs(to.x - from.x), tall = std::abs(to.y - from.y);
    if (!(wide > kLeastBox && tall > kLeastBox)) return;
    StudioContext& context = frame.context;
    const ViewPlane& plane = frame.plane;
    context.remember(frame.view);
    const double u = plane.u(0.5f * (to.x + from.x)), v = plane.v(0.5f * (to.y + from.y));
    const double factor =
        std::max(tall / (plane.high.y - plane.low.y), wide / (plane.high.x - plane.low.x));
    context.edit([&](Workspace& workspace) {
        SliceSpec& slice = workspace.views[frame.index()].slice;
        slice.centre[0] = u;
        if (slice.centre.size() > 1) slice.centre[1] = v;
        std::fill(slice.centreLow.begin(), slice.centreLow.end(), 0.0);
    });
    context.zoom(frame.view, factor, u, v);
}

Drag boxFrom(const ScreenPoint& from) {
    return {.release = [from](const ViewFrame& frame) { zoomToBox(frame, from); },
            .draw =
                [from](const ViewFrame& frame) {
                    frame.list().AddRect(from, frame.pointer.at,
                                         themes()[frame.context.theme].accent, 0, 0, 2);
                }};
}

// A root's, or a zoom at the pointer.
void takeWheel(const ViewFrame& frame) {
    const Pointer& pointer = frame.pointer;
    // Some systems turn the wheel sideways while Shift is down.
    const float wheel = pointer.wheel != 0 ? pointer.wheel : pointer.shift ? pointer.sideways : 0;
    if (!pointer.over || wheel == 0) return;
    for (const Mark* mark : marksByHand())
        if (mark->wheel && mark->wheel(frame, wheel)) return;
    if (pointer.wheel != 0)
        frame.context.zoom(frame.view, std::pow(kWheel, static_cast<double>(pointer.wheel)),
                           frame.u(), frame.v());
}

bool takeTool(const ViewFrame& frame) {
    for (const Mark* mark : marksByHand())
        if (mark->tool && mark->tool(frame)) return true;
    return false;
}

Drag pressLeft(const ViewFrame& frame) {
    for (const Mark* mark : marksByHand()) {
        if (!mark->press) continue;
        std::optional<Drag> drag = mark->press(frame);
        if (!drag) continue;
        if (drag->mark && drag->mark->name)
            frame.context.host.announce(drag->mark->name(frame, drag->item));
        return std::move(*drag);
    }
    frame.context.remember(frame.view);
    return panView();
}

Drag pressRight(const ViewFrame& frame) {
    for (const Mark* mark : marksByHand())
        if (mark->openMenu && mark->openMenu(frame)) return {};
    return boxFrom(frame.pointer.at);
}

// The view that commands act on from now on.
int focusOf(const ViewFrame& frame) {
    for (const Mark* mark : marksByHand())
        if (mark->focus)
            if (const std::optional<int> view = mark->focus(frame)) return *view;
    return frame.view;
}

void takePress(const ViewFrame& frame) {
    StudioContext& context = frame.context;
    context.focus(focusOf(frame));
    context.welcome = false;
    context.player.animation.running = context.player.animation.running && !frame.pointer.left;
    frame.state().drag = frame.pointer.right ? pressRight(frame) : pressLeft(frame);
}

void takeDoubleClick(const ViewFrame& frame) {
    for (const Mark* mark : marksByHand())
        if (mark->doubleClick && mark->doubleClick(frame)) return;
    frame.context.remember(frame.view);
    frame.context.zoom(frame.view, 0.5, frame.u(), frame.v(), true);
}

}  // namespace

Pointer readPointer(bool over, bool held) {
    const ImGuiIO& io = ImGui::GetIO();
    return {.at = io.MousePos,
            .moved = io.MouseDelta,
            .over = over,
            .held = held,
            .left = ImGui::IsMouseClicked(0),
            .right = ImGui::IsMouseClicked(1),
            .twice = ImGui::IsMouseDoubleClicked(0),
            .rightDown = ImGui::IsMouseDown(1),
            .shift = io.KeyShift,
            .ctrl = io.KeyCtrl,
            .alt = io.KeyAlt,
            .wheel = io.MouseWheel,
            .sideways = io.MouseWheelH};
}

void takeInput(const ViewFrame& frame) {
    const Pointer& pointer = frame.pointer;
    ViewState& state = frame.state();
    takeWheel(frame);
    if (takeTool(frame)) {
        state.drag = {};
        return;
    }
    if (pointer.over && (pointer.left || pointer.right)) takePress(frame);
    if (pointer.over && pointer.twice) takeDoubleClick(frame);
    if (!pointer.held) {
        // What a release does may be the end of this drag's own functions.
        const Drag ended = std::exchange(state.drag, {});
        if (ended.release) ended.release(frame);
        return;
    }
    if (pointer.moved.x == 0 && pointer.moved.y == 0) return;
    if (state.drag.move) state.drag.move(frame);
}

}  // namespace versorium
