// SPDX-License-Identifier: MIT
#include "ui/keyboard.h"

#include <algorithm>

#include "imgui.h"
#include "ui/controls/commands.h"
#include "ui/session/context.h"
#include "ui/widgets/keys.h"

namespace versorium {
namespace {

// Arrows pan; with Shift they nudge the point by a pixel's worth.
void nudge(StudioContext& context) {
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(key, true) ? 1 : 0; };
    const int right = pressed(ImGuiKey_RightArrow) - pressed(ImGuiKey_LeftArrow);
    const int up = pressed(ImGuiKey_UpArrow) - pressed(ImGuiKey_DownArrow);
    if (right == 0 && up == 0) return;
    const bool shift = ImGui::GetIO().KeyShift;
    if (!shift) return context.pan(context.workspace.focused, 0.1 * right, 0.1 * up);
    const auto view = static_cast<std::size_t>(context.workspace.focused);
    const ViewState& state = context.views[view];
    // The shorter side shows the slice's height.
    const double pixel =
        context.workspace.view().slice.height /
        std::max(1.0f, std::min(state.high.x - state.low.x, state.high.y - state.low.y));
    context.edit([&](Workspace& w) {
        const auto marker = markerOf(w, view);
        moveMarker(w, view, marker[0] + right * pixel, marker[1] + up * pixel);
    });
}

}  // namespace

void handleKeys(StudioContext& context) {
    if (ImGui::GetIO().WantTextInput) return;
    // Chords with the command key hold everywhere; a dialog or a tool takes the others.
    std::vector<Command> pressed;
    for (Command& command : commandsOf(context))
        if (command.chord && isPressed(command.chord) && command.available())
            pressed.push_back(std::move(command));
    for (const Command& command : pressed)
        if (command.chord.command) return command.run();
    if (isPressed({"Y", true})) return void(runCommand(context, "redo"));
    const DrawingKeys drawing{.enter = ImGui::IsKeyPressed(ImGuiKey_Enter, false) ||
                                       ImGui::IsKeyPressed(ImGuiKey_KeypadEnter, false),
                              .back = ImGui::IsKeyPressed(ImGuiKey_Backspace),
                              .escape = ImGui::IsKeyPressed(ImGuiKey_Escape, false)};
    if (context.dialogOpen() || drawingKeys(context, drawing)) return;
    for (const Command& command : pressed) command.run();
    nudge(context);
}

}  // namespace versorium
