// SPDX-License-Identifier: MIT
#include "ui/views/view.h"

#include <algorithm>
#include <cmath>

#include "ui/marks/mark.h"
#include "ui/views/view_drawing.h"
#include "ui/views/view_input.h"
#include "ui/views/view_wants.h"

namespace versorium {
namespace {

// Seconds of a frame for the GPU's pictures: half of it where frames are slow.
constexpr double kLeastBudget = 0.012, kMostBudget = 0.05;

// What each of the views that are shown has of it.
double secondsOfFrame(const Workspace& workspace) {
    const std::size_t shown = workspace.maximised ? 1 : workspace.views.size();
    const double half = 0.5 * static_cast<double>(ImGui::GetIO().DeltaTime);
    return std::clamp(half, kLeastBudget, kMostBudget) / static_cast<double>(shown);
}

// In pixels of the screen, which may be finer than the window's.
Size sizeOf(ImVec2 low, ImVec2 high) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    return {static_cast<int>(std::lround((high.x - low.x) * scale.x)),
            static_cast<int>(std::lround((high.y - low.y) * scale.y))};
}

// An edit may have left fewer views than there were when the window began to draw them, as a shape
// that is drawn in the last one of four does; the next frame draws those that there are.
bool isThere(const StudioContext& context, int view) {
    return view < static_cast<int>(context.workspace.views.size());
}

// The state as the hand has left it becomes a picture.
void showView(const ViewFrame& frame) {
    StudioContext& context = frame.context;
    wantPicture(context, frame.view, frame.plane.place, secondsOfFrame(context.workspace));
    drawViewParts(frame);
    if (frame.pointer.over && frame.state().drag.idle())
        probe(frame);
    else if (!frame.pointer.over && context.probe.view == frame.view)
        context.probe.text.clear(), context.probe.view = -1;
    for (const Mark* mark : marksByHand())
        if (mark->drawMenu) mark->drawMenu(frame);
}

}  // namespace

void drawView(StudioContext& context, int view, ImVec2 low, ImVec2 high) {
    if (!isThere(context, view)) return;
    ViewState& state = context.views[static_cast<std::size_t>(view)];
    state.low = low;
    state.high = high;
    const Size size = sizeOf(low, high);
    if (size.width < 8 || size.height < 8) return;
    ImGui::SetCursorScreenPos(low);
    ImGui::PushID(view);
    ImGui::InvisibleButton("view", {high.x - low.x, high.y - low.y},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const Pointer pointer = readPointer(ImGui::IsItemHovered(), ImGui::IsItemActive());
    context.buttonDown = ImGui::IsAnyMouseDown();

    takeInput(frameOf(context, view, size, pointer));
    if (isThere(context, view)) showView(frameOf(context, view, size, pointer));
    ImGui::PopID();
}

}  // namespace versorium
