// SPDX-License-Identifier: MIT
// The list of keys, with what the pointer does in a view.
#include "ui/controls/commands.h"
#include "ui/dialogs/dialogs.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

void row(const std::string& keys, const std::string& name, const std::string& help = {}) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(tr(std::string_view(keys)).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(tr(std::string_view(name)).c_str());
    if (!help.empty()) explainBy(help);
}

}  // namespace

void drawKeys(StudioContext& context) {
    if (!context.dialogs.keys) return;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    if (ImGui::Begin(named("Keys").c_str(), &context.dialogs.keys,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse)) {
        if (ImGui::BeginTable("keys", 2)) {
            for (const Command& command : commandsOf(context))
                if (command.chord) row(textOf(command.chord), command.title(), command.help);
            row(trLater("arrows"), trLater("Pan; with Shift: move the point by a pixel"));
            row(trLater("drag, wheel"), trLater("Pan, zoom at the pointer"));
            row(trLater("right drag"), trLater("Zoom to a box"));
            row(trLater("Ctrl click"), trLater("Put the point here"));
            row(trLater("Shift click"), trLater("Pin these parameters"));
            row(trLater("Alt drag"), trLater("The second start; p* beside the critical curve"));
            row(trLater("double click"), trLater("Go in; where roots are shown: add a root"));
            row(trLater("wheel on a root"), trLater("Its power, by 1 or with Shift by 0.1"));
            ImGui::EndTable();
        }
        if (ImGui::IsKeyPressed(ImGuiKey_Escape)) context.dialogs.keys = false;
    }
    ImGui::End();
}

void drawDialogs(StudioContext& context) {
    drawFind(context);
    drawGallery(context);
    drawCandidates(context);
    drawOpenFile(context);
    drawKeys(context);
    drawExport(context);
    drawTeacherDialog(context);
}

}  // namespace versorium
