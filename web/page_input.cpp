// SPDX-License-Identifier: MIT
#include "page_input.h"

#include <emscripten/emscripten.h>

#include <cfloat>
#include <string_view>
#include <utility>

#include "imgui.h"

namespace {

bool came = false;

ImGuiIO& touched() {
    came = true;
    return ImGui::GetIO();
}

struct Key {
    std::string_view code;
    ImGuiKey key;
};

// KeyboardEvent.code, but for letters and digits, which are counted.
constexpr Key kKeys[] = {
    {"Tab", ImGuiKey_Tab},
    {"ArrowLeft", ImGuiKey_LeftArrow},
    {"ArrowRight", ImGuiKey_RightArrow},
    {"ArrowUp", ImGuiKey_UpArrow},
    {"ArrowDown", ImGuiKey_DownArrow},
    {"PageUp", ImGuiKey_PageUp},
    {"PageDown", ImGuiKey_PageDown},
    {"Home", ImGuiKey_Home},
    {"End", ImGuiKey_End},
    {"Insert", ImGuiKey_Insert},
    {"Delete", ImGuiKey_Delete},
    {"Backspace", ImGuiKey_Backspace},
    {"Space", ImGuiKey_Space},
    {"Enter", ImGuiKey_Enter},
    {"Escape", ImGuiKey_Escape},
    {"ControlLeft", ImGuiKey_LeftCtrl},
    {"ControlRight", ImGuiKey_RightCtrl},
    {"ShiftLeft", ImGuiKey_LeftShift},
    {"ShiftRight", ImGuiKey_RightShift},
    {"AltLeft", ImGuiKey_LeftAlt},
    {"AltRight", ImGuiKey_RightAlt},
    {"MetaLeft", ImGuiKey_LeftSuper},
    {"MetaRight", ImGuiKey_RightSuper},
    {"ContextMenu", ImGuiKey_Menu},
    {"Quote", ImGuiKey_Apostrophe},
    {"Comma", ImGuiKey_Comma},
    {"Minus", ImGuiKey_Minus},
    {"Period", ImGuiKey_Period},
    {"Slash", ImGuiKey_Slash},
    {"Semicolon", ImGuiKey_Semicolon},
    {"Equal", ImGuiKey_Equal},
    {"BracketLeft", ImGuiKey_LeftBracket},
    {"Backslash", ImGuiKey_Backslash},
    {"BracketRight", ImGuiKey_RightBracket},
    {"Backquote", ImGuiKey_GraveAccent},
    {"NumpadDecimal", ImGuiKey_KeypadDecimal},
    {"NumpadDivide", ImGuiKey_KeypadDivide},
    {"NumpadMultiply", ImGuiKey_KeypadMultiply},
    {"NumpadSubtract", ImGuiKey_KeypadSubtract},
    {"NumpadAdd", ImGuiKey_KeypadAdd},
    {"NumpadEnter", ImGuiKey_KeypadEnter},
};

ImGuiKey counted(ImGuiKey first, int step) { return static_cast<ImGuiKey>(first + step); }

ImGuiKey keyOf(std::string_view code) {
    const char last = code.empty() ? '\0' : code.back();
    const bool digit = last >= '0' && last <= '9';
    if (code.size() == 4 && code.starts_with("Key") && last >= 'A' && last <= 'Z')
        return counted(ImGuiKey_A, last - 'A');
    if (code.size() == 6 && code.starts_with("Digit") && digit)
        return counted(ImGuiKey_0, last - '0');
    if (code.size() == 7 && code.starts_with("Numpad") && digit)
        return counted(ImGuiKey_Keypad0, last - '0');
    if (code.size() == 2 && code[0] == 'F' && digit && last != '0')
        return counted(ImGuiKey_F1, last - '1');
    for (const Key& key : kKeys)
        if (key.code == code) return key.key;
    return ImGuiKey_None;
}

}  // namespace

bool versorium::takeInput() { return std::exchange(came, false); }

extern "C" {

EMSCRIPTEN_KEEPALIVE void page_move(float x, float y, int touch) {
    ImGuiIO& io = touched();
    io.AddMouseSourceEvent(touch ? ImGuiMouseSource_TouchScreen : ImGuiMouseSource_Mouse);
    io.AddMousePosEvent(x, y);
}
// The pointer left the canvas, or the last finger went up.
EMSCRIPTEN_KEEPALIVE void page_leave() { touched().AddMousePosEvent(-FLT_MAX, -FLT_MAX); }
EMSCRIPTEN_KEEPALIVE void page_button(int button, int down) {
    touched().AddMouseButtonEvent(button, down != 0);
}
// In steps of a wheel: positive is up and left, as ImGui counts.
EMSCRIPTEN_KEEPALIVE void page_wheel(float x, float y) { touched().AddMouseWheelEvent(x, y); }

EMSCRIPTEN_KEEPALIVE void page_modifiers(int control, int shift, int alt, int super) {
    ImGuiIO& io = touched();
    io.AddKeyEvent(ImGuiMod_Ctrl, control != 0);
    io.AddKeyEvent(ImGuiMod_Shift, shift != 0);
    io.AddKeyEvent(ImGuiMod_Alt, alt != 0);
    io.AddKeyEvent(ImGuiMod_Super, super != 0);
}
EMSCRIPTEN_KEEPALIVE void page_key(const char* code, int down) {
    const ImGuiKey key = keyOf(code);
    if (key != ImGuiKey_None) touched().AddKeyEvent(key, down != 0);
}
EMSCRIPTEN_KEEPALIVE void page_text(const char* text) { touched().AddInputCharactersUTF8(text); }
EMSCRIPTEN_KEEPALIVE void page_focus(int focused) { touched().AddFocusEvent(focused != 0); }

}  // extern "C"
