// SPDX-License-Identifier: MIT
// Find: all that has a name, by any part of it.
#include <algorithm>
#include <cctype>

#include "ui/controls/commands.h"
#include "ui/dialogs/dialogs.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

// Every word of the question stands in the name.
bool matches(const std::string& name, const std::string& question) {
    const std::string whole = lower(name);
    std::size_t at = 0;
    const std::string words = lower(question);
    while (at < words.size()) {
        const std::size_t end = std::min(words.find(' ', at), words.size());
        if (whole.find(words.substr(at, end - at)) == std::string::npos) return false;
        at = end + 1;
    }
    return true;
}

}  // namespace

void drawFind(StudioContext& context) {
    static char question[128];
    const std::string window = named("Find");
    if (context.dialogs.find && !ImGui::IsPopupOpen(window.c_str())) {
        question[0] = 0;
        ImGui::OpenPopup(window.c_str());
    }
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos({screen.GetCenter().x, screen.Pos.y + screen.Size.y * 0.12f},
                            ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSize(
        {std::min(620.0f * context.scale, screen.Size.x * 0.94f), screen.Size.y * 0.62f});
    if (!ImGui::BeginPopupModal(window.c_str(), &context.dialogs.find, ImGuiWindowFlags_NoResize))
        return;
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    const bool enter =
        ImGui::InputTextWithHint("##question", tr("a map, a preset, a command"), question,
                                 sizeof question, ImGuiInputTextFlags_EnterReturnsTrue);
    explain("question");
    const std::vector<Command> entries = findable(context, question);
    const Command* chosen = nullptr;
    bool first = true;
    ImGui::BeginChild("entries");
    for (const Command& entry : entries) {
        const std::string title = entry.title();
        if (!matches(title + " " + entry.label + " " + entry.also, question)) continue;
        ImGui::PushID(entry.id.c_str());
        ImGui::BeginDisabled(!entry.available());
        const bool picked = ImGui::Selectable(title.c_str(), first && question[0] != 0);
        ImGui::EndDisabled();
        explainBy(entry.help);
        ImGui::PopID();
        if (entry.chord) {
            ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::GetFontSize() * 6);
            ImGui::TextDisabled("%s", textOf(entry.chord).c_str());
        }
        if (picked || (enter && first && entry.available())) chosen = &entry;
        first = false;
    }
    if (first) ImGui::TextDisabled("%s", tr("Nothing has this name."));
    ImGui::EndChild();
    if (chosen || ImGui::IsKeyPressed(ImGuiKey_Escape)) {
        context.dialogs.find = false;
        ImGui::CloseCurrentPopup();
    }
    if (chosen) chosen->run();
    ImGui::EndPopup();
}

}  // namespace versorium
