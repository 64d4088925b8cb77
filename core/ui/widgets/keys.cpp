// SPDX-License-Identifier: MIT
#include "ui/widgets/keys.h"

#include "imgui_internal.h"

namespace versorium {

ImGuiKeyChord modifiersOf(ImGuiKey key) {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    ImGuiKeyChord modifiers = context.IO.KeyMods;
    // From the end of the frame back to the press, every change of a modifier undone.
    for (int k = context.InputEventsTrail.Size - 1; k >= 0; --k) {
        const ImGuiInputEvent& event = context.InputEventsTrail[k];
        if (event.Type != ImGuiInputEventType_Key) continue;
        if (event.Key.Key == key && event.Key.Down) return modifiers;
        if (event.Key.Key & ImGuiMod_Mask_)
            modifiers = event.Key.Down ? modifiers & ~event.Key.Key : modifiers | event.Key.Key;
    }
    return context.IO.KeyMods;
}

}  // namespace versorium
