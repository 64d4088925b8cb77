// SPDX-License-Identifier: MIT
// The strip below the views: the orbit as a time series, and its numbers.
#include <algorithm>
#include <cmath>

#include "ui/context.h"

namespace versorium {

void drawOrbitStrip(StudioContext& context) {
    Workspace& workspace = context.workspace;
    const OrbitProgram* program = context.orbitProgram();
    const Scene scene = orbitScene(workspace);
    const MapInfo& info = mapOf(scene).info;
    if (ImGui::SmallButton("−"))
        workspace.orbitSteps = std::max(0, workspace.orbitSteps - 1), context.touch();
    ImGui::SameLine();
    if (ImGui::SmallButton("+"))
        workspace.orbitSteps = std::min(1000, workspace.orbitSteps + 1), context.touch();
    ImGui::SameLine();
    ImGui::Text("Orbit of %s, %d steps", std::string(stateName(info.algebra)).c_str(),
                workspace.orbitSteps);
    if (!program) {
        ImGui::TextDisabled("This shape is measured in the pictures only.");
        return;
    }
    const double start[2] = {workspace.point[0], scene.slice.centre[1]};
    const auto orbit = orbitOf(*program, start, workspace.orbitSteps);
    ImGui::SameLine();
    if (ImGui::SmallButton("Copy table")) {
        std::string table = "n";
        for (int k = 0; k < program->map->dimension; ++k) table += "\t" + stateComponent(info, k);
        for (std::size_t n = 0; n < orbit.size(); ++n) {
            table += "\n" + std::to_string(n);
            for (double value : orbit[n]) table += "\t" + formatNumber(value);
        }
        context.host.setClipboard(table + "\n");
        context.say("The orbit's table is on the clipboard");
    }
    ImGui::SameLine();
    const bool escaped = static_cast<int>(orbit.size()) <= workspace.orbitSteps;
    ImGui::TextDisabled(escaped ? "escapes at step %d" : "%d points, none escaped",
                        static_cast<int>(orbit.size()) - (escaped ? 1 : 0));

    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 space = ImGui::GetContentRegionAvail();
    if (space.x < 60 || space.y < 30) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high{low.x + space.x, low.y + space.y};
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 6);
    double top = 1e-300;
    for (const auto& row : orbit)
        for (double value : row)
            if (std::isfinite(value)) top = std::max(top, std::abs(value));
    top = std::min(top, 2.5);
    const float middle = 0.5f * (low.y + high.y);
    list.AddLine({low.x, middle}, {high.x, middle}, ImGui::GetColorU32(ImGuiCol_Border));
    const float step = (space.x - 24) / static_cast<float>(std::max(1, workspace.orbitSteps));
    list.PushClipRect(low, high, true);
    for (int k = 0; k < program->map->dimension; ++k) {
        const ImU32 colour = k == 0 ? ImGui::GetColorU32(ImGuiCol_CheckMark) : pinColour(k - 1);
        std::vector<ImVec2> points;
        for (std::size_t n = 0; n < orbit.size(); ++n) {
            const double value = orbit[n][static_cast<std::size_t>(k)];
            if (!std::isfinite(value)) break;
            const double y = middle - std::clamp(value / top, -2.0, 2.0) * (0.46 * space.y);
            points.push_back({low.x + 12 + step * static_cast<float>(n), static_cast<float>(y)});
        }
        list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, 1.5f);
        for (std::size_t n = 0; n < points.size(); ++n)
            list.AddCircleFilled(points[n], n == 0 ? 4.0f : 2.5f, colour);
        list.AddText({low.x + 8, low.y + 4 + ImGui::GetFontSize() * static_cast<float>(k)}, colour,
                     stateComponent(info, k).c_str());
    }
    list.PopClipRect();
}

}  // namespace versorium
