// SPDX-License-Identifier: MIT
// The inspector's part in what is found out: the start p* of a set of parameters and what the set
// may be read as; fixed points and cycles; the second start.
#include <algorithm>
#include <cmath>

#include "maps/critical.h"
#include "render/system_of.h"
#include "ui/marks/shapes.h"
#include "ui/panels/number_field.h"
#include "ui/panels/panels.h"
#include "ui/panels/value_widgets.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"

namespace versorium {
namespace {

// A word for each answer of A8, and a colour beside it.
const char* labelOf(CatalogueAnswer answer) {
    switch (answer) {
        case CatalogueAnswer::onlyCriticalOrbit:
            return tr("A catalogue of Julia sets");
        case CatalogueAnswer::oneOfSeveral:
            return tr("One condition of several");
        case CatalogueAnswer::notCritical:
            return tr("No catalogue: not a critical point");
        case CatalogueAnswer::noCriticalPoint:
            return tr("No catalogue: no critical point");
        default:
            return "";
    }
}

ImU32 colourOf(CatalogueAnswer answer) {
    switch (answer) {
        case CatalogueAnswer::onlyCriticalOrbit:
            return IM_COL32(0, 158, 115, 255);
        case CatalogueAnswer::oneOfSeveral:
            return IM_COL32(230, 159, 0, 255);
        default:
            return IM_COL32(213, 94, 0, 255);
    }
}

void drawBadge(StudioContext& context, int view) {
    const CatalogueBadge* badge = studyBadge(context, view);
    if (!badge || badge->answer == CatalogueAnswer::notAsked) return;
    const std::string label = labelOf(badge->answer);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float letter = ImGui::GetFontSize(), wide = ImGui::GetContentRegionAvail().x;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + wide, at.y + letter * 1.6f},
                       ImGui::GetColorU32(ImGuiCol_FrameBg), 4);
    list.AddRectFilled(at, {at.x + letter * 0.4f, at.y + letter * 1.6f}, colourOf(badge->answer),
                       4);
    list.AddText({at.x + letter * 0.8f, at.y + letter * 0.3f}, ImGui::GetColorU32(ImGuiCol_Text),
                 label.c_str());
    ImGui::Dummy({wide, letter * 1.7f});
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("%s", trMessage(badge->sentence).c_str());
    ImGui::PopTextWrapPos();
}

// Which of the critical points, where there are several.
void chooseCritical(StudioContext& context, int view) {
    const Scene& scene = context.workspace.views[static_cast<std::size_t>(view)];
    const std::optional<System> system = shownSystem(context);
    if (!system || system->dimension() > 2) return;
    const std::vector<PlanePoint> points = criticalPointsOf(*system);
    if (points.size() < 2) return;
    const auto textOf = [&](std::size_t k) {
        const PlanePoint& at = points[k];
        return "critical(" + std::to_string(k) + ") = " + shownNumber(at[0], 4) +
               (system->dimension() == 1 ? "" : numberSeparator() + shownNumber(at[1], 4));
    };
    const auto now = static_cast<std::size_t>(*scene.criticalStart);
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo(
        "##which critical", now < points.size() ? textOf(now).c_str() : tr("another one"));
    if (!open) return explain("which critical point");
    for (std::size_t k = 0; k < points.size(); ++k)
        if (ImGui::Selectable(textOf(k).c_str(), k == now) && k != now)
            context.edit([&](Workspace& w) {
                w.views[static_cast<std::size_t>(view)].criticalStart = static_cast<int>(k);
            });
    ImGui::EndCombo();
}

std::string complexNumber(std::complex<double> value) {
    if (value.imag() == 0) return shownNumber(value.real(), 4);
    return shownNumber(value.real(), 4) + (value.imag() < 0 ? " − " : " + ") +
           shownNumber(std::abs(value.imag()), 4) + "i";
}

void drawCycleRow(StudioContext& context, const PeriodicCycle& cycle, int index) {
    const Workspace& workspace = context.workspace;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float letter = ImGui::GetFontSize();
    const bool chosen = ImGui::Selectable(("##cycle" + std::to_string(index)).c_str(), false,
                                          ImGuiSelectableFlags_SpanAllColumns);
    explain("cycle row");
    drawCycleMark(*ImGui::GetWindowDrawList(), {at.x + 0.5f * letter, at.y + 0.55f * letter},
                  0.28f * letter, cycle.kind);
    ImGui::SameLine(1.25f * letter);
    ImGui::Text("%d", cycle.period);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(tr(wordOf(cycle.kind)));
    ImGui::TableNextColumn();
    std::string values;
    if (cycle.multiplier)
        values = complexNumber(*cycle.multiplier);
    else if (cycle.eigenvalues.size() == 2 && cycle.eigenvalues[0].imag() != 0)
        values = shownNumber(cycle.eigenvalues[0].real(), 4) + " ± " +
                 shownNumber(std::abs(cycle.eigenvalues[0].imag()), 4) + "i";
    else
        for (const auto& value : cycle.eigenvalues)
            values += (values.empty() ? "" : numberSeparator()) + complexNumber(value);
    ImGui::TextUnformatted(values.c_str());
    if (!chosen) return;
    context.edit([&](Workspace& w) {
        for (std::size_t k = 0; k < w.point.size(); ++k)
            w.point[k] = k < 2 ? cycle.points[0][k] : 0;
        w.orbitAt = 0;
    });
    std::string text = tr("The orbit starts at x = {1}", {shownNumber(cycle.points[0][0], 9)});
    if (workspace.point.size() > 1)
        text += numberSeparator() + ("y = " + shownNumber(cycle.points[0][1], 9));
    context.say(text);
}

void drawCycleList(StudioContext& context) {
    const CycleStudy& study = studyCycles(context);
    if (!study.problem.empty()) {
        ImGui::PushTextWrapPos();
        ImGui::TextDisabled("%s", trMessage(study.problem).c_str());
        ImGui::PopTextWrapPos();
        return;
    }
    const int count = static_cast<int>(study.cycles.size());
    if (count == 0) {
        ImGui::TextDisabled("%s",
                            study.finished ? tr("None found in the picture.") : tr("Searching …"));
        return;
    }
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float tall = line * static_cast<float>(std::min(count, 9) + 1) + 4;
    const bool complex = study.cycles[0].multiplier.has_value();
    if (ImGui::BeginTable("cycles", 3, ImGuiTableFlags_ScrollY, {0, tall})) {
        ImGui::TableSetupScrollFreeze(0, 1);
        ImGui::TableSetupColumn("n", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 2.6f);
        ImGui::TableSetupColumn(tr("kind"), ImGuiTableColumnFlags_WidthFixed,
                                ImGui::GetFontSize() * 5.2f);
        ImGui::TableSetupColumn(complex ? tr("multiplier") : tr("eigenvalues"));
        ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
        for (int k = 0; k < 3; ++k) {
            ImGui::TableSetColumnIndex(k);
            ImGui::TableHeader(ImGui::TableGetColumnName(k));
            explain("cycle row");
        }
        // A copy: choosing one may change the list.
        const std::vector<PeriodicCycle> cycles = study.cycles;
        ImGuiListClipper rows;
        rows.Begin(count);
        while (rows.Step())
            for (int k = rows.DisplayStart; k < rows.DisplayEnd; ++k)
                drawCycleRow(context, cycles[static_cast<std::size_t>(k)], k);
        ImGui::EndTable();
    }
    if (study.coarse) ImGui::TextDisabled("%s", tr("A coarse search: there may be more."));
}

}  // namespace

void drawStartControls(StudioContext& context) {
    const Workspace& workspace = context.workspace;
    const Scene& scene = workspace.view();
    if (!traitsOf(scene).ownStart) return;
    const MapKernels& map = mapOf(scene);
    if (hasCriticalPoints(map)) {
        bool critical = scene.criticalStart.has_value();
        if (ImGui::Checkbox(tr("start at the critical point"), &critical)) {
            const auto start = startOf(context, workspace.focused);
            context.edit([&](Workspace& w) {
                if (critical) {
                    w.view().criticalStart = 0;
                } else {
                    if (start) w.view().start = *start;
                    w.view().criticalStart.reset();
                }
            });
        }
        explain("start at the critical point");
    }
    const auto start = startOf(context, workspace.focused);
    if (scene.criticalStart) {
        chooseCritical(context, workspace.focused);
    } else if (start) {
        const MapInfo& info = map.info;
        for (int k = 0; k < map.dimension; ++k) {
            const std::string component = stateComponent(info, k);
            const std::size_t dot = component.rfind('.');
            const std::string label =
                "p*" + (dot == std::string::npos ? std::string() : component.substr(dot));
            double value = scene.start[static_cast<std::size_t>(k)];
            if (numberField(context, "start " + component, label, value,
                            {.help = helpOf("start"), .home = 0.0}))
                context.edit(
                    [&](Workspace& w) { w.view().start[static_cast<std::size_t>(k)] = value; });
        }
        if (map.dimension == 2) {
            if (ImGui::Button(tr("nearest critical point")))
                startAtNearest(context, workspace.focused, {scene.start[0], scene.start[1]});
            explain("nearest");
        }
    }
    drawBadge(context, workspace.focused);
}

void drawCycleControls(StudioContext& context) {
    const Workspace& workspace = context.workspace;
    const MapKernels& map = mapOf(workspace.views[0]);
    const Workspace::Study& study = workspace.study;
    if (map.dimension == 2) drawValue(context, "study.critical_curve");
    if (map.dimension > 2) {
        ImGui::TextDisabled("%s", tr("For maps of the line and of the plane."));
        return;
    }
    drawValue(context, "study.cycles");
    if (!study.cycles) return;
    drawValue(context, "study.most_period");
    if (map.dimension == 2) {
        drawValue(context, "study.manifolds");
        if (study.manifolds) ImGui::TextDisabled("%s", tr("stable blue, unstable orange"));
    }
    drawCycleList(context);
}

void drawComparedControls(StudioContext& context) {
    const Workspace& workspace = context.workspace;
    bool on = !workspace.compared.empty();
    if (ImGui::Checkbox(tr("a second start to compare"), &on)) {
        context.edit([on](Workspace& w) {
            w.compared = on ? w.point : std::vector<double>();
            if (on) w.compared[0] += 0.01;
        });
    }
    explain("compared");
    const MapInfo& info = mapOf(workspace.views[0]).info;
    for (std::size_t k = 0; k < workspace.compared.size(); ++k) {
        const std::string component = stateComponent(info, static_cast<int>(k));
        double value = workspace.compared[k];
        if (numberField(context, "second " + component, tr("second {1}", {component}), value,
                        {.help = helpOf("second start"), .home = workspace.point[k]}))
            context.edit([&](Workspace& w) { w.compared[k] = value; });
    }
}

}  // namespace versorium
