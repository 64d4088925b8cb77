// SPDX-License-Identifier: MIT
// The gallery: pictures of presets and of recent scenes, for the pointer and for the keyboard.
#include <algorithm>

#include "ui/backend/texture.h"
#include "ui/dialogs/dialogs.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

void openEntry(StudioContext& context, const Gallery::Entry& entry) {
    if (!entry.preset.empty()) {
        Expected<Scene> scene = presetNamed(entry.preset);
        if (!scene) return context.report(scene.status());
        return context.open(workspaceOf(*scene));
    }
    Expected<Workspace> workspace = workspaceFromLink(entry.link);
    if (!workspace) return context.report(workspace.status());
    context.open(std::move(*workspace));
}

// True when it was taken.
bool drawCell(StudioContext& context, const Gallery::Entry& entry, bool chosen, ImVec2 size) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high{low.x + size.x, low.y + size.y};
    const bool taken = ImGui::InvisibleButton(entry.key().c_str(), size);
    const bool hovered = ImGui::IsItemHovered();
    explain("preset");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float text = ImGui::GetTextLineHeight() + 6 * context.scale;
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 6);
    const ImVec2 corner{high.x, high.y - text};
    if (const unsigned texture = context.gallery.picture(entry))
        list.AddImageRounded(textureId(texture), low, corner, {0, 0}, {1, 1}, IM_COL32_WHITE, 6,
                             ImDrawFlags_RoundCornersTop);
    else
        list.AddRectFilled(low, corner, ImGui::GetColorU32(ImGuiCol_WindowBg), 6);
    ImGui::PushClipRect({low.x + 4, low.y}, {high.x - 4, high.y}, true);
    list.AddText({low.x + 8, corner.y + 3 * context.scale}, ImGui::GetColorU32(ImGuiCol_Text),
                 shownTitle(entry).c_str());
    ImGui::PopClipRect();
    if (hovered || chosen)
        list.AddRect(low, high,
                     ImGui::GetColorU32(chosen ? ImGuiCol_CheckMark : ImGuiCol_TextDisabled), 6, 0,
                     chosen ? 2.5f : 1.0f);
    return taken;
}

// Where the keys lead from an entry. Rows end where a heading begins.
int moved(int chosen, int columns, int presets, int recent) {
    const int count = presets + recent;
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(key, true); };
    if (pressed(ImGuiKey_RightArrow)) return std::min(chosen + 1, count - 1);
    if (pressed(ImGuiKey_LeftArrow)) return std::max(chosen - 1, 0);
    if (pressed(ImGuiKey_Home)) return 0;
    if (pressed(ImGuiKey_End)) return count - 1;
    const bool second = chosen >= presets;
    const int first = second ? presets : 0, size = second ? recent : presets;
    const int place = chosen - first;
    if (pressed(ImGuiKey_DownArrow)) {
        if (place + columns < size) return chosen + columns;
        if (place / columns < (size - 1) / columns) return first + size - 1;
        return second || recent == 0 ? chosen : presets + std::min(place % columns, recent - 1);
    }
    if (pressed(ImGuiKey_UpArrow)) {
        if (place >= columns) return chosen - columns;
        const int last = (presets - 1) / columns * columns + place;
        return !second ? chosen : std::min(last, presets - 1);
    }
    return chosen;
}

}  // namespace

void drawGallery(StudioContext& context) {
    const std::string window = named("Presets and recent scenes");
    int& at = context.panels.of<GalleryPlace>().at;
    if (context.dialogs.gallery && !ImGui::IsPopupOpen(window.c_str())) {
        ImGui::OpenPopup(window.c_str());
        at = 0;
    }
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(screen.GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(
        {std::min(920.0f * context.scale, screen.Size.x * 0.96f), screen.Size.y * 0.86f});
    if (!ImGui::BeginPopupModal(window.c_str(), &context.dialogs.gallery,
                                ImGuiWindowFlags_NoResize))
        return;
    bool idle = true;
    for (const ViewState& view : context.views) idle = idle && !view.picture.waiting();
    if (idle) context.gallery.ask(context.host);
    // Opening an entry changes the list.
    const std::vector<Gallery::Entry> presets = context.gallery.presets();
    const std::vector<Gallery::Entry> recent = context.gallery.recent();
    const int count = static_cast<int>(presets.size() + recent.size());
    std::optional<Gallery::Entry> taken;
    ImGui::BeginChild("pictures");
    const float gap = 10 * context.scale;
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns = std::max(1, static_cast<int>((room + gap) / (170 * context.scale + gap)));
    const float wide = (room - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    const float tall =
        wide * Gallery::kHeight / Gallery::kWidth + ImGui::GetTextLineHeight() + 6 * context.scale;
    const int before = at;
    at = std::clamp(
        moved(at, columns, static_cast<int>(presets.size()), static_cast<int>(recent.size())), 0,
        std::max(0, count - 1));
    int index = 0;
    for (const auto* entries : {&presets, &recent}) {
        ImGui::TextDisabled("%s", entries == &presets ? tr("Presets") : tr("Recent"));
        if (entries->empty()) ImGui::TextDisabled("%s", tr("What you work on will stand here."));
        int column = 0;
        for (const Gallery::Entry& entry : *entries) {
            if (column > 0) ImGui::SameLine(0, gap);
            const bool chosen = index == at;
            if (drawCell(context, entry, chosen, {wide, tall})) taken = entry;
            if (chosen && before != at) ImGui::SetScrollHereY(0.5f);
            if (chosen && (ImGui::IsKeyPressed(ImGuiKey_Enter, false) ||
                           ImGui::IsKeyPressed(ImGuiKey_KeypadEnter, false)))
                taken = entry;
            column = (column + 1) % columns;
            ++index;
        }
        ImGui::Spacing();
    }
    ImGui::EndChild();
    if (taken || ImGui::IsKeyPressed(ImGuiKey_Escape)) {
        context.dialogs.gallery = false;
        ImGui::CloseCurrentPopup();
    }
    if (taken) openEntry(context, *taken);
    ImGui::EndPopup();
}

}  // namespace versorium
