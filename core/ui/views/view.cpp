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

// Seconds of a frame for the graphics processor's pictures: half of it where frames are slow.
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

}  // namespace

void drawView(StudioContext& context, int view, ImVec2 low, ImVec2 high) {
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
    const ViewFrame frame = frameOf(context, view, size, pointer);  // what that has led to
    wantPicture(context, view, frame.plane.place, secondsOfFrame(context.workspace));
    drawViewParts(frame);

    if (pointer.over && state.drag.idle())
        probe(frame);
    else if (!pointer.over && context.probe.view == view)
        context.probe.text.clear(), context.probe.view = -1;
    for (const Mark* mark : marksByHand())
        if (mark->drawMenu) mark->drawMenu(frame);
    ImGui::PopID();
}

}  // namespace versorium
