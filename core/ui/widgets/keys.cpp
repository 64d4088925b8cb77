// SPDX-License-Identifier: MIT
#include "ui/widgets/keys.h"

#include "imgui_internal.h"

namespace versorium {
namespace {

ImGuiKey keyNamed(const std::string& name) {
    // In the order of namedKeys().
    constexpr ImGuiKey kNamed[] = {ImGuiKey_Home,  ImGuiKey_Backspace, ImGuiKey_Delete,
                                   ImGuiKey_Space, ImGuiKey_PageUp,    ImGuiKey_PageDown};
    if (name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z')
        return static_cast<ImGuiKey>(ImGuiKey_A + (name[0] - 'A'));
    if (name.size() == 1 && name[0] >= '1' && name[0] <= '9')
        return static_cast<ImGuiKey>(ImGuiKey_1 + (name[0] - '1'));
    for (std::size_t k = 0; k < namedKeys().size(); ++k)
        if (name == namedKeys()[k]) return kNamed[k];
    return ImGuiKey_None;
}

bool isTyped(char sign) {
    // Where + needs Shift, the key alone is meant as well.
    for (const ImWchar typed : ImGui::GetIO().InputQueueCharacters)
        if (typed == static_cast<ImWchar>(sign) || (sign == '+' && typed == '=')) return true;
    return false;
}

}  // namespace

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

bool isPressed(const Chord& chord) {
    if (chord.isSign()) return isTyped(chord.key[0]);
    const ImGuiKey key = keyNamed(chord.key);
    const bool repeats = chord.command && (chord.key == "Z" || chord.key == "Y");
    if (key == ImGuiKey_None || !ImGui::IsKeyPressed(key, repeats)) return false;
    const ImGuiKeyChord held = modifiersOf(key);
    if (((held & (ImGuiMod_Ctrl | ImGuiMod_Super)) != 0) != chord.command) return false;
    return ((held & ImGuiMod_Shift) != 0) == chord.shift;
}

}  // namespace versorium
