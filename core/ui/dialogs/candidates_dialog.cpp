// SPDX-License-Identifier: MIT
// The sheet of candidates for the versor d.
#include <algorithm>
#include <cmath>

#include "ui/backend/texture.h"
#include "ui/dialogs/dialogs.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

int moved(int chosen, int columns, int count) {
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(key, true); };
    if (pressed(ImGuiKey_RightArrow)) return std::min(chosen + 1, count - 1);
    if (pressed(ImGuiKey_LeftArrow)) return std::max(chosen - 1, 0);
    if (pressed(ImGuiKey_DownArrow)) return std::min(chosen + columns, count - 1);
    if (pressed(ImGuiKey_UpArrow)) return chosen >= columns ? chosen - columns : chosen;
    if (pressed(ImGuiKey_Home)) return 0;
    if (pressed(ImGuiKey_End)) return count - 1;
    return chosen;
}

// True when it was taken.
bool drawCell(ContactSheet::Candidate& one, bool chosen, ImVec2 size, float scale) {
    const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + size.x, low.y + size.y};
    ImGui::PushID(one.seed);
    const bool taken = ImGui::InvisibleButton("candidate", size);
    explain("candidate");
    ImGui::PopID();
    const float text = ImGui::GetTextLineHeight() + 6 * scale;
    const ImVec2 corner{high.x, high.y - text};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 6);
    list.AddRectFilled(low, corner, ImGui::GetColorU32(ImGuiCol_WindowBg), 6);
    if (!one.rgba.empty()) {
        if (one.texture == 0) one.texture = putTexture(0, one.size, one.rgba.data());
        list.AddImageRounded(textureId(one.texture), low, corner, {0, 0}, {1, 1}, IM_COL32_WHITE, 6,
                             ImDrawFlags_RoundCornersTop);
    }
    const std::string label =
        tr(one.roots.roots.size() == 1 ? trLater("seed {1} · {2} root")
                                       : trLater("seed {1} · {2} roots"),
           {std::to_string(one.seed), std::to_string(one.roots.roots.size())}) +
        (one.message.empty() ? one.rgba.empty() ? " …" : "" : ": " + trMessage(one.message));
    ImGui::PushClipRect({low.x + 4, low.y}, {high.x - 4, high.y}, true);
    list.AddText({low.x + 8, corner.y + 3 * scale}, ImGui::GetColorU32(ImGuiCol_Text),
                 label.c_str());
    ImGui::PopClipRect();
    if (chosen || ImGui::IsItemHovered())
        list.AddRect(low, high,
                     ImGui::GetColorU32(chosen ? ImGuiCol_CheckMark : ImGuiCol_TextDisabled), 6, 0,
                     chosen ? 2.5f : 1.0f);
    return taken;
}

}  // namespace

void drawCandidates(StudioContext& context) {
    ContactSheet& sheet = context.sheet;
    const std::string window = named("Candidates for the versor d");
    if (context.dialogs.candidates && !ImGui::IsPopupOpen(window.c_str()))
        ImGui::OpenPopup(window.c_str());
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(screen.GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(
        {std::min(980.0f * context.scale, screen.Size.x * 0.96f), screen.Size.y * 0.86f});
    if (!ImGui::BeginPopupModal(window.c_str(), &context.dialogs.candidates,
                                ImGuiWindowFlags_NoResize)) {
        if (!context.dialogs.candidates && !sheet.candidates.empty()) sheet.forget();
        return;
    }
    bool idle = true;
    for (const ViewState& view : context.views) idle = idle && !view.picture.waiting();
    if (idle) askForCandidate(context);
    int more = -1, taken = -1;
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 7);
    ImGui::SliderInt("##count", &sheet.count, ContactSheet::kLeast, ContactSheet::kMost,
                     tr("%d candidates"), ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemDeactivatedAfterEdit()) more = sheet.candidates.front().seed;
    explain("candidates");
    ImGui::SameLine();
    if (ImGui::Button(tr("More"))) more = sheet.candidates.back().seed + 1;
    explain("more candidates");
    ImGui::SameLine();
    if (ImGui::Button(tr("Take it"))) taken = sheet.at;
    explain("take candidate");
    ImGui::SameLine();
    if (ImGui::Button(tr("Close"))) context.dialogs.candidates = false;
    explain("close");
    ImGui::BeginChild("candidates");
    const int count = static_cast<int>(sheet.candidates.size());
    const float gap = 10 * context.scale, room = ImGui::GetContentRegionAvail().x;
    const int fitting = std::max(1, static_cast<int>((room + gap) / (220 * context.scale + gap)));
    const int columns = std::min(fitting, count <= 4 ? 2 : 3);
    const float wide = (room - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    const float tall = wide * 0.75f + ImGui::GetTextLineHeight() + 6 * context.scale;
    const int before = sheet.at;
    sheet.at = std::clamp(moved(sheet.at, columns, count), 0, std::max(0, count - 1));
    for (int k = 0; k < count; ++k) {
        if (k % columns > 0) ImGui::SameLine(0, gap);
        if (drawCell(sheet.candidates[static_cast<std::size_t>(k)], k == sheet.at, {wide, tall},
                     context.scale))
            taken = sheet.at = k;
        if (k == sheet.at && before != sheet.at) ImGui::SetScrollHereY(0.5f);
    }
    ImGui::EndChild();
    if (ImGui::IsKeyPressed(ImGuiKey_Enter, false) ||
        ImGui::IsKeyPressed(ImGuiKey_KeypadEnter, false))
        taken = sheet.at;
    if (taken >= 0) pickCandidate(context, taken);
    if (taken >= 0 || ImGui::IsKeyPressed(ImGuiKey_Escape)) context.dialogs.candidates = false;
    if (!context.dialogs.candidates) {
        sheet.forget();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
    if (more >= 0) openContactSheet(context, more);
}

}  // namespace versorium
