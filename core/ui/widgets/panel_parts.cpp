// SPDX-License-Identifier: MIT
#include "ui/widgets/panel_parts.h"

#include "i18n/language.h"
#include "imgui.h"
#include "ui/widgets/help.h"

namespace versorium {
namespace {

bool chooseFrom(const char* label, const char* control, std::string& value,
                const std::vector<std::string>& words, const char* empty, bool translated) {
    const auto shown = [&](const std::string& word) {
        if (word.empty()) return std::string(tr(empty));
        return translated ? tr(std::string_view(word)) : word;
    };
    bool changed = false;
    labelled(label);
    const std::string id = std::string("##") + label;
    const bool open = ImGui::BeginCombo(id.c_str(), shown(value).c_str());
    if (!open) explain(control);
    if (open) {
        for (const std::string& word : words) {
            const bool now = word == value;
            if (ImGui::Selectable((shown(word) + "###" + word).c_str(), now) && !now) {
                value = word;
                changed = true;
            }
            if (now) ImGui::SetItemDefaultFocus();
        }
        ImGui::EndCombo();
    }
    return changed;
}

}  // namespace

std::string named(const char* english) { return std::string(tr(english)) + "###" + english; }

void heading(const char* text) {
    ImGui::Spacing();
    ImGui::TextDisabled("%s", tr(text));
    ImGui::Separator();
}

bool section(const char* text, bool inUse) {
    ImGui::Spacing();
    if (inUse) ImGui::SetNextItemOpen(true, ImGuiCond_Once);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    const bool open =
        ImGui::TreeNodeEx(named(text).c_str(),
                          ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
    ImGui::PopStyleColor();
    explain("section");
    ImGui::Separator();
    return open;
}

void sameLineIfRoom(float wide) {
    const float end = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + wide;
    if (end <= ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x) ImGui::SameLine();
}

bool rowButton(const char* text, const char* control) {
    sameLineIfRoom(ImGui::CalcTextSize(tr(text)).x + 2 * ImGui::GetStyle().FramePadding.x);
    const bool pressed = ImGui::Button(tr(text));
    explain(control);
    return pressed;
}

void labelled(const char* label) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr(label));
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetStyle().WindowPadding.x + ImGui::GetFontSize() * 6.8f);
    ImGui::SetNextItemWidth(-1);
}

bool choose(const char* label, const char* control, std::string& value,
            const std::vector<std::string>& words, const char* empty) {
    return chooseFrom(label, control, value, words, empty, true);
}

bool chooseName(const char* label, const char* control, std::string& value,
                const std::vector<std::string>& names, const char* empty) {
    return chooseFrom(label, control, value, names, empty, false);
}

}  // namespace versorium
