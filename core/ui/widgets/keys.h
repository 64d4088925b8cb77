// SPDX-License-Identifier: MIT
#pragma once
// Which modifiers were held when a key went down. Between two frames a fast hand may press a key
// and let the modifier go before the key: ImGui then reports a press in a frame at whose end the
// modifier is up, and Ctrl Z would be a mere z.

#include "imgui.h"
#include "ui/widgets/chord.h"

namespace versorium {

// ImGuiMod_Ctrl, ImGuiMod_Shift, … together: at the moment of the press where `key` was pressed in
// this frame, else as they are now.
ImGuiKeyChord modifiersOf(ImGuiKey key);

// Whether a chord was pressed in this frame, or goes on being pressed where that repeats it (signs,
// and chords with the command key that undo and redo).
bool isPressed(const Chord& chord);

}  // namespace versorium
