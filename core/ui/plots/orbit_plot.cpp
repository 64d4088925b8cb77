// SPDX-License-Identifier: MIT
// The strip below the views: the orbit as a time series or as a web, and as a table.
#include <algorithm>
#include <cmath>

#include "ui/marks/shapes.h"
#include "ui/plots/plots.h"
#include "ui/plots/web_diagram.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

constexpr double kMostShown = 2.5;  // larger values leave the diagram
constexpr int kGraphPoints = 400;

ImU32 componentColour(int k) {
    return k == 0 ? ImGui::GetColorU32(ImGuiCol_CheckMark) : pinColour(k - 1);
}

std::string tableText(const MapInfo& info, const std::vector<std::vector<double>>& orbit) {
    std::string table = "n";
    for (int k = 0; k < dimensionOf(info.algebra); ++k) table += "\t" + stateComponent(info, k);
    for (std::size_t n = 0; n < orbit.size(); ++n) {
        table += "\n" + std::to_string(n);
        for (double value : orbit[n]) table += "\t" + formatNumber(value);
    }
    return table + "\n";
}

double normOf(const std::vector<double>& row) {
    double sum = 0;
    for (double value : row) sum += value * value;
    return std::sqrt(sum);
}

bool step(const char* label, const char* control) {
    const bool pressed = ImGui::SmallButton(label);
    explain(control);
    ImGui::SameLine(0, 4);
    return pressed;
}

void drawTabs(StudioContext& context, bool hasWeb) {
    const auto tab = [&](const char* name, PlotPanel plot) {
        const bool now = context.workspace.plot == plot;
        if (now) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_HeaderActive));
        if (ImGui::SmallButton(tr(name))) context.show(plot);
        if (now) ImGui::PopStyleColor();
        explain(name);
        ImGui::SameLine(0, 4);
    };
    tab("series", PlotPanel::series);
    if (hasWeb) tab("web", PlotPanel::web);
    tab("diagram", PlotPanel::diagram);
    if (mapOf(context.workspace.views[0]).info.field) tab("profile", PlotPanel::profile);
    tab("motion", PlotPanel::motion);
    ImGui::SameLine(0, 12);
}

// The step that the table has been scrolled to.
struct OrbitTable {
    int shown = 0;
};

void drawHead(StudioContext& context, const MapInfo& info) {
    const Workspace& workspace = context.workspace;
    ImGui::TextUnformatted(tr("Orbit of {1}", {std::string(stateName(info.algebra))}).c_str());
    ImGui::SameLine();
    if (step("|←", "orbit first")) context.stepOrbit(-workspace.orbitAt);
    ImGui::PushButtonRepeat(true);
    if (step("←", "orbit back")) context.stepOrbit(-1);
    if (step("→", "orbit forward")) context.stepOrbit(1);
    ImGui::PopButtonRepeat();
    if (step("→|", "orbit last")) context.stepOrbit(workspace.orbitSteps - workspace.orbitAt);
    ImGui::SameLine(0, 8);
    ImGui::TextUnformatted(tr("n = {1} of", {std::to_string(workspace.orbitAt)}).c_str());
    ImGui::SameLine(0, 6);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 3.6f);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(4, 0));
    int steps = workspace.orbitSteps;
    if (ImGui::DragInt("##steps", &steps, 0.5f, 0, kMostOrbitSteps, "%d",
                       ImGuiSliderFlags_AlwaysClamp))
        context.edit([&](Workspace& w) {
            w.orbitSteps = steps;
            w.orbitAt = std::min(w.orbitAt, steps);
        });
    ImGui::PopStyleVar();
    explain("orbit steps");
    const auto& orbit = context.bound.orbit();
    const bool escaped = static_cast<int>(orbit.size()) <= workspace.orbitSteps;
    const std::string fate = escaped ? tr("escapes at step {1}", {std::to_string(orbit.size() - 1)})
                                     : tr("none escaped");
    // On a narrow screen the rest has a line of its own.
    const ImGuiStyle& style = ImGui::GetStyle();
    sameLineIfRoom(ImGui::CalcTextSize(tr("Copy table")).x + 2 * style.FramePadding.x +
                   style.ItemSpacing.x + ImGui::CalcTextSize(fate.c_str()).x);
    if (ImGui::SmallButton(tr("Copy table"))) {
        context.host.setClipboard(tableText(info, orbit));
        context.say("The orbit's table is on the clipboard");
    }
    explain("copy table");
    ImGui::SameLine();
    ImGui::TextDisabled("%s", fate.c_str());
}

void drawTable(StudioContext& context, const MapInfo& info, float width) {
    const auto& orbit = context.bound.orbit();
    const int dimension = dimensionOf(info.algebra);
    if (!ImGui::BeginTable("orbit", dimension + 2, ImGuiTableFlags_ScrollY, {width, 0})) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("n", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 2.2f);
    for (int k = 0; k < dimension; ++k) ImGui::TableSetupColumn(stateComponent(info, k).c_str());
    ImGui::TableSetupColumn(dimension == 1 ? "|x|" : tr("norm"));
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (int k = 0; k < dimension + 2; ++k) {
        ImGui::TableSetColumnIndex(k);
        ImGui::TableHeader(ImGui::TableGetColumnName(k));
        explain("orbit row");
    }
    ImGuiListClipper rows;
    rows.Begin(static_cast<int>(orbit.size()));
    int& shown = context.panels.of<OrbitTable>().shown;
    if (shown != context.workspace.orbitAt)
        rows.IncludeItemByIndex(
            std::min(context.workspace.orbitAt, static_cast<int>(orbit.size()) - 1));
    while (rows.Step())
        for (int n = rows.DisplayStart; n < rows.DisplayEnd; ++n) {
            const auto& row = orbit[static_cast<std::size_t>(n)];
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            const bool chosen = n == context.workspace.orbitAt;
            if (ImGui::Selectable(std::to_string(n).c_str(), chosen,
                                  ImGuiSelectableFlags_SpanAllColumns))
                context.stepOrbit(n - context.workspace.orbitAt);
            explain("orbit row");
            if (chosen && shown != n) {
                ImGui::SetScrollHereY(0.5f);
                shown = n;
            }
            for (double value : row) {
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(shownNumber(value, 5).c_str());
            }
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(shownNumber(normOf(row), 5).c_str());
        }
    ImGui::EndTable();
}

void drawDashed(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 colour) {
    const float length = std::hypot(to.x - from.x, to.y - from.y), dash = 5;
    for (float at = 0; at < length; at += 2 * dash) {
        const float begin = at / length, end = std::min(1.0f, (at + dash) / length);
        list.AddLine({from.x + begin * (to.x - from.x), from.y + begin * (to.y - from.y)},
                     {from.x + end * (to.x - from.x), from.y + end * (to.y - from.y)}, colour,
                     1.2f);
    }
}

void drawSeries(StudioContext& context, const MapInfo& info, ImVec2 low, ImVec2 high) {
    const auto& orbit = context.bound.orbit();
    const Workspace& workspace = context.workspace;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    double top = 1e-300;
    for (const auto& row : orbit)
        for (double value : row)
            if (std::isfinite(value)) top = std::max(top, std::abs(value));
    const auto& second = comparedOrbit(context);
    for (const auto& row : second)
        for (double value : row)
            if (std::isfinite(value)) top = std::max(top, std::abs(value));
    top = std::min(top, kMostShown);
    const float tall = high.y - low.y, middle = 0.5f * (low.y + high.y);
    list.AddLine({low.x, middle}, {high.x, middle}, ImGui::GetColorU32(ImGuiCol_Border));
    const float gap = (high.x - low.x - 24) / static_cast<float>(std::max(1, workspace.orbitSteps));
    const auto across = [&](int n) { return low.x + 12 + gap * static_cast<float>(n); };
    if (ImGui::IsItemActive()) {
        const float part = (ImGui::GetIO().MousePos.x - low.x - 12) / gap;
        const int n = std::clamp(static_cast<int>(std::lround(part)), 0, workspace.orbitSteps);
        if (n != workspace.orbitAt) context.stepOrbit(n - workspace.orbitAt);
    }
    list.AddLine({across(workspace.orbitAt), low.y}, {across(workspace.orbitAt), high.y},
                 ImGui::GetColorU32(ImGuiCol_Text, 0.45f), 1);
    const int dimension = dimensionOf(info.algebra);
    for (int k = 0; k < dimension; ++k) {
        const ImU32 colour = componentColour(k);
        std::vector<ImVec2> points;
        for (std::size_t n = 0; n < orbit.size(); ++n) {
            const double value = orbit[n][static_cast<std::size_t>(k)];
            if (!std::isfinite(value)) break;
            const double y = middle - std::clamp(value / top, -2.0, 2.0) * (0.46 * tall);
            points.push_back({across(static_cast<int>(n)), static_cast<float>(y)});
        }
        list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, 1.5f);
        for (std::size_t n = 0; n < points.size(); ++n)
            list.AddCircleFilled(points[n], static_cast<int>(n) == workspace.orbitAt ? 4.5f : 2.5f,
                                 colour);
    }
    // The second orbit: dashed, in the same colours, and with open circles.
    for (int k = 0; k < dimension && !second.empty(); ++k) {
        ImVec2 before{};
        for (std::size_t n = 0; n < second.size(); ++n) {
            const double value = second[n][static_cast<std::size_t>(k)];
            if (!std::isfinite(value)) break;
            const double y = middle - std::clamp(value / top, -2.0, 2.0) * (0.46 * tall);
            const ImVec2 here{across(static_cast<int>(n)), static_cast<float>(y)};
            if (n > 0) drawDashed(list, before, here, componentColour(k));
            list.AddCircle(here, 3, componentColour(k), 0, 1.2f);
            before = here;
        }
    }
    ImVec2 at{low.x + 8, low.y + 4};
    for (int k = 0; k < dimension; ++k) {
        const std::string name = stateComponent(info, k);
        drawText(list, at, componentColour(k), name);
        at.x += ImGui::CalcTextSize(name.c_str()).x + ImGui::GetFontSize();
    }
    if (!second.empty())
        drawText(list, at, ImGui::GetColorU32(ImGuiCol_Text), tr("dashed: second"));
}

void drawWeb(StudioContext& context, const OrbitProgram& program, double second, ImVec2 low,
             ImVec2 high) {
    const Workspace& workspace = context.workspace;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::vector<double> orbit =
        lineOrbit(program, second, workspace.point[0], workspace.orbitSteps);
    // As much of the line as the orbit visits, but no more than where the map is at home.
    const MapInfo& info = program.map->info;
    const double home = info.homeCentre[0], half = 0.75 * info.homeHeight;
    const bool interval = info.interval[0] < info.interval[1];
    double left = interval ? info.interval[0] : home, right = interval ? info.interval[1] : home;
    for (double x : orbit) {
        left = std::min(left, std::clamp(x, home - half, home + half));
        right = std::max(right, std::clamp(x, home - half, home + half));
    }
    const double margin = std::max(0.12 * (right - left), 0.05);
    left -= margin, right += margin;
    const double unit = (high.y - low.y) / (right - left);
    const double wide = (high.x - low.x) / unit;
    const double centre = 0.5 * (left + right);
    const double first = centre - 0.5 * wide, last = centre + 0.5 * wide;
    const auto at = [&](double x, double y) {
        const auto cut = [](double value) {
            return static_cast<float>(std::clamp(value, -1e5, 1e5));
        };
        return ImVec2{cut(low.x + (x - first) * unit), cut(high.y - (y - left) * unit)};
    };
    if (ImGui::IsItemActive()) {
        const double x = first + (ImGui::GetIO().MousePos.x - low.x) / unit;
        if (x != workspace.point[0])
            context.edit([&](Workspace& w) { setSharedNumber(w, stateComponent(info, 0), x); });
    }
    const ImU32 line = ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.7f);
    list.AddLine(at(first, 0), at(last, 0), ImGui::GetColorU32(ImGuiCol_Border));
    list.AddLine(at(0, left), at(0, right), ImGui::GetColorU32(ImGuiCol_Border));
    list.AddLine(at(first, first), at(last, last), line);
    const std::vector<double> graph = graphOf(program, second, first, last, kGraphPoints);
    std::vector<ImVec2> curve;
    for (int k = 0; k <= kGraphPoints; ++k) {
        const bool end = k == kGraphPoints || !std::isfinite(graph[static_cast<std::size_t>(k)]);
        if (!end) {
            curve.push_back(at(first + (last - first) * k / (kGraphPoints - 1),
                               graph[static_cast<std::size_t>(k)]));
            continue;
        }
        list.AddPolyline(curve.data(), static_cast<int>(curve.size()), componentColour(0), 0, 2);
        curve.clear();
    }
    if (!orbit.empty()) list.AddCircleFilled(at(orbit[0], left), 4, IM_COL32(255, 222, 110, 255));
    ImVec2 corner = orbit.empty() ? ImVec2{} : at(orbit[0], left);
    for (std::size_t n = 0; n + 1 < orbit.size(); ++n) {
        const bool chosen = static_cast<int>(n) + 1 == workspace.orbitAt;
        const ImU32 colour = chosen ? ImGui::GetColorU32(ImGuiCol_Text)
                                    : stepColour(static_cast<int>(n), workspace.orbitSteps);
        const ImVec2 up = at(orbit[n], orbit[n + 1]), over = at(orbit[n + 1], orbit[n + 1]);
        const float width = chosen ? 2.5f : 1.2f;
        list.AddLine(corner, up, colour, width);
        list.AddLine(up, over, colour, width);
        if (chosen) list.AddCircleFilled(up, 4, colour);
        corner = over;
    }
    const std::string name = stateComponent(info, 0);
    drawText(list, {low.x + 8, low.y + 4}, componentColour(0),
             tr(program.map->dimension > 1 ? trLater("f({1}) on the real line, from x_0 = {2}")
                                           : trLater("f({1}), x_0 = {2}"),
                {name, shownNumber(workspace.point[0], 5)}));
}

}  // namespace

void drawPlot(StudioContext& context) {
    const OrbitProgram* program = context.bound.orbitProgram();
    const Scene scene = orbitScene(context.workspace);
    const MapInfo& info = mapOf(scene).info;
    if (!program || context.workspace.plot == PlotPanel::motion) drawTabs(context, false);
    if (context.workspace.plot == PlotPanel::motion) return drawTimeline(context);
    if (program && context.workspace.plot == PlotPanel::diagram) {
        const double other = scene.slice.centre.size() > 1 ? scene.slice.centre[1] : 0;
        drawTabs(context, keepsRealLine(*program, program->map->dimension == 1 ? other : 0));
        return drawDiagram(context);
    }
    if (context.workspace.plot == PlotPanel::profile && !info.field)
        context.show(PlotPanel::series);
    if (program && context.workspace.plot == PlotPanel::profile) {
        drawTabs(context, keepsRealLine(*program, 0));
        return drawProfile(context);
    }
    if (!program) {
        ImGui::TextDisabled("%s", tr("The shape is being made into a distance grid …"));
        return;
    }
    // On a line of numbers the slice's second axis is a parameter, else the imaginary part.
    const double second =
        program->map->dimension == 1 && scene.slice.centre.size() > 1 ? scene.slice.centre[1] : 0;
    const bool hasWeb = keepsRealLine(*program, second);
    if (!hasWeb && context.workspace.plot == PlotPanel::web) context.show(PlotPanel::series);
    drawTabs(context, hasWeb);
    drawHead(context, info);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 space = ImGui::GetContentRegionAvail();
    if (space.x < 60 || space.y < 30) return;
    const float columns = static_cast<float>(program->map->dimension + 1);
    const float table = std::min(0.45f * space.x, ImGui::GetFontSize() * (3.5f + 5.5f * columns));
    const bool web = context.workspace.plot == PlotPanel::web;
    const ImVec2 high{low.x + space.x - table - 10, low.y + space.y};
    ImGui::InvisibleButton("diagram", {high.x - low.x, space.y});
    explain(web ? "web diagram" : "series diagram");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 6);
    list.PushClipRect(low, high, true);
    if (web)
        drawWeb(context, *program, second, low, high);
    else
        drawSeries(context, info, low, high);
    list.PopClipRect();
    ImGui::SameLine(0, 10);
    drawTable(context, info, table);
}

}  // namespace versorium
