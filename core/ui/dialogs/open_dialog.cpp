// SPDX-License-Identifier: MIT
// A list of files, where the host has no dialog of its own.
#include <algorithm>

#include "ui/dialogs/dialogs.h"
#include "ui/session/context.h"
#include "ui/session/open_file.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

void enter(StudioContext& context, const std::string& path) {
    FileList& list = context.panels.of<FileList>();
    Expected<Folder> folder = context.host.listFolder(path);
    list.problem = folder ? "" : folder.status().message();
    if (!folder) return;
    list.folder = std::move(*folder);
    std::erase_if(list.folder.entries,
                  [](const FolderEntry& entry) { return !entry.isFolder && !mayOpen(entry.name); });
    list.chosen = 0;
    list.typed = list.folder.path;
}

// True when a file was opened.
bool take(StudioContext& context, const FolderEntry& entry) {
    const std::string& here = context.panels.of<FileList>().folder.path;
    const std::string path = (here == "/" ? here : here + "/") + entry.name;
    if (entry.isFolder) {
        enter(context, path);
        return false;
    }
    const Status status = openFile(context, path);
    context.panels.of<FileList>().problem = status.message();
    return status.ok();
}

bool takeTyped(StudioContext& context) {
    const std::string path = context.panels.of<FileList>().typed;
    if (context.host.listFolder(path)) {
        enter(context, path);
        return false;
    }
    const Status status = openFile(context, path);
    context.panels.of<FileList>().problem = status.message();
    return status.ok();
}

}  // namespace

void drawOpenFile(StudioContext& context) {
    const std::string window = named("Open a file");
    FileList& list = context.panels.of<FileList>();
    if (context.dialogs.files && !ImGui::IsPopupOpen(window.c_str())) {
        ImGui::OpenPopup(window.c_str());
        enter(context, list.folder.path);
    }
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(screen.GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(
        {std::min(620.0f * context.scale, screen.Size.x * 0.96f), screen.Size.y * 0.76f});
    if (!ImGui::BeginPopupModal(window.c_str(), &context.dialogs.files, ImGuiWindowFlags_NoResize))
        return;
    bool done = false;
    char typed[1024] = {};
    list.typed.copy(typed, sizeof typed - 1);
    ImGui::SetNextItemWidth(-1);
    const bool entered =
        ImGui::InputText("##path", typed, sizeof typed, ImGuiInputTextFlags_EnterReturnsTrue);
    explain("folder");
    const bool typing = ImGui::IsItemActive();
    list.typed = typed;
    if (entered) done = takeTyped(context);
    if (!list.problem.empty()) {
        ImGui::PushTextWrapPos();
        ImGui::TextUnformatted(trMessage(list.problem).c_str());
        ImGui::PopTextWrapPos();
    }
    const int before = list.chosen;
    const int count = static_cast<int>(list.folder.entries.size());
    if (!typing && !entered) {
        if (ImGui::IsKeyPressed(ImGuiKey_DownArrow)) ++list.chosen;
        if (ImGui::IsKeyPressed(ImGuiKey_UpArrow)) --list.chosen;
        list.chosen = std::clamp(list.chosen, 0, std::max(0, count - 1));
    }
    std::optional<FolderEntry> taken;
    ImGui::BeginChild("files", {0, -ImGui::GetFrameHeightWithSpacing()});
    for (int k = 0; k < count; ++k) {
        const FolderEntry& entry = list.folder.entries[static_cast<std::size_t>(k)];
        const std::string label = entry.isFolder ? entry.name + "/" : entry.name;
        if (ImGui::Selectable(label.c_str(), k == list.chosen)) taken = entry;
        explain("file");
        if (k == list.chosen && before != list.chosen) ImGui::SetScrollHereY();
        if (k == list.chosen && !typing && !entered && ImGui::IsKeyPressed(ImGuiKey_Enter, false))
            taken = entry;
    }
    if (count == 0) ImGui::TextDisabled("%s", tr("No file here opens in the studio."));
    ImGui::EndChild();
    if (taken) done = take(context, *taken);
    const bool closed = ImGui::Button(tr("Close"));
    explain("close");
    if (done || closed || (!typing && ImGui::IsKeyPressed(ImGuiKey_Escape))) {
        context.dialogs.files = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace versorium
