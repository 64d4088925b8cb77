// SPDX-License-Identifier: MIT
#include "ui/widgets/shown_number.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "i18n/language.h"
#include "imgui.h"
#include "imgui_internal.h"

namespace versorium {
namespace {

std::string formatted(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// Only the number of a format such as "%.2f s".
std::string numberOf(const char* format) {
    char number[32];
    return ImParseFormatTrimDecorations(format, number, sizeof number);
}

// The field while somebody types. ImGui's own reads numbers as C does, with points alone.
bool typedNumber(const char* label, ImGuiID id, double& value, const char* format) {
    ImGuiWindow& window = *ImGui::GetCurrentWindow();
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImVec2 words = ImGui::CalcTextSize(label, nullptr, true);
    const ImVec2 low = window.DC.CursorPos;
    const ImRect field{
        low, ImVec2(low.x + ImGui::CalcItemWidth(), low.y + words.y + 2 * style.FramePadding.y)};
    ImRect whole = field;
    if (words.x > 0) whole.Max.x += style.ItemInnerSpacing.x + words.x;
    ImGui::ItemSize(whole, style.FramePadding.y);
    if (!ImGui::ItemAdd(whole, id, &field, ImGuiItemFlags_Inputable)) return false;
    char text[64];
    std::snprintf(text, sizeof text, "%s",
                  withDecimalSign(formatted(numberOf(format).c_str(), value)).c_str());
    const bool edited = ImGui::TempInputText(
        field, id, label, text, sizeof text,
        ImGuiInputTextFlags_AutoSelectAll |
            static_cast<ImGuiInputTextFlags>(ImGuiInputTextFlags_NoMarkEdited));
    if (words.x > 0)
        ImGui::RenderText(
            ImVec2(field.Max.x + style.ItemInnerSpacing.x, field.Min.y + style.FramePadding.y),
            label);
    const std::optional<double> read = parseShownNumber(text);
    if (!edited || !read || *read == value) return false;
    value = *read;
    ImGui::MarkItemEdited(id);
    return true;
}

// Typing may begin with this frame: ImGui then wants the format itself.
bool mayBeginTyping(ImGuiID id) {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    const ImGuiIO& io = context.IO;
    return (io.MouseClicked[0] && (io.KeyCtrl || io.MouseClickedCount[0] == 2)) ||
           context.NavActivateId == id;
}

// What ImGui put into the field in the first frame has a point.
void showDecimalSign(ImGuiID id) {
    ImGuiInputTextState* state = ImGui::GetInputTextState(id);
    if (!state) return;
    const auto sign = static_cast<ImWchar>(languageNow().decimal);
    for (ImWchar& letter : state->TextW)
        if (letter == '.') letter = sign;
    std::replace(state->InitialTextA.begin(), state->InitialTextA.end(), '.',
                 languageNow().decimal);
    state->TextAIsValid = false;
}

}  // namespace

bool dragNumber(const char* label, double& value, double speed, const char* format, double low,
                double high) {
    const ImGuiID id = ImGui::GetID(label);
    const bool bounded = low < high;
    double next = value;
    bool changed = false;
    if (ImGui::TempInputIsActive(id)) {
        changed = typedNumber(label, id, next, format);
        if (bounded) next = std::clamp(next, low, high);
    } else {
        const bool point = languageNow().decimal == '.' || mayBeginTyping(id);
        const std::string shown =
            point ? std::string(format) : withDecimalSign(formatted(format, value));
        changed = ImGui::DragScalar(label, ImGuiDataType_Double, &next, static_cast<float>(speed),
                                    bounded ? &low : nullptr, bounded ? &high : nullptr,
                                    shown.c_str(), bounded ? ImGuiSliderFlags_AlwaysClamp : 0);
        // A text without a format leaves the rounding to us.
        if (changed && !point)
            next = parseShownNumber(formatted(numberOf(format).c_str(), next)).value_or(next);
        if (ImGui::TempInputIsActive(id)) showDecimalSign(id);
    }
    if (!changed || !std::isfinite(next) || next == value) return false;
    value = next;
    return true;
}

}  // namespace versorium
