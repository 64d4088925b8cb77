// SPDX-License-Identifier: MIT
// The planar system's coefficients as a table that reads like its formula, what they are as
// algebra, and the ways to the complex map of the same pictures and back.
#include <algorithm>

#include "ui/panels/number_field.h"
#include "ui/panels/panels.h"
#include "ui/session/context.h"
#include "ui/session/planar_change.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

constexpr std::size_t kTerms = 15;
constexpr const char* kTermText[kTerms] = {"x",  "x²",  "x³",  "x⁴",   "y", "y²",  "y³", "y⁴",
                                           "xy", "x²y", "xy²", "x²y²", "1", "x³y", "xy³"};
constexpr const char* kShort[kTerms] = {"a₁", "a₂", "a₃", "a₄", "b₁", "b₂", "b₃", "b₄",
                                        "c₁", "c₂", "c₃", "c₄", "d",  "e₁", "e₂"};

const std::vector<std::string>& planarPresets() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> found;
        for (const std::string& name : presetNames())
            if (const Expected<Scene> scene = presetNamed(name);
                scene && mapOf(*scene).info.planarCoefficients)
                found.push_back(name);
        return found;
    }();
    return names;
}

// A coefficient's name: a click makes it an axis.
void axisButton(StudioContext& context, const std::string& name, const char* label, float width) {
    const std::string sign = axisSign(context.workspace, name);
    if (!sign.empty())
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_HeaderActive));
    if (ImGui::Button((sign + label + "##" + name).c_str(), {width, 0})) nextAxis(context, name);
    if (!sign.empty()) ImGui::PopStyleColor();
    explain("coefficient axis");
}

void drawRow(StudioContext& context, std::size_t term) {
    const Workspace& workspace = context.workspace;
    const MapInfo& info = mapOf(workspace.views[0]).info;
    const float letter = ImGui::GetFontSize();
    ImGui::TableNextRow();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {2, 1});
    for (std::size_t part = 0; part < 2; ++part) {
        ImGui::TableNextColumn();
        const std::size_t k = part * kTerms + term;
        const ParameterInfo& parameter = info.parameters[k];
        const std::string name(parameter.name);
        double value = sharedNumber(workspace, name);
        const float wide = ImGui::GetContentRegionAvail().x;
        axisButton(context, name, kShort[term], letter * 1.9f);
        ImGui::SameLine(0, 2);
        const NumberLook look{.help = helpOf("coefficient"),
                              .low = parameter.low,
                              .high = parameter.high,
                              .home = parameter.value[0],
                              .slider = false,
                              .animated = true};
        if (numberCell(context, name, value, look, wide - letter * 4.4f - 4))
            context.edit([&](Workspace& w) { setSharedNumber(w, name, value); });
        ImGui::SameLine(0, 4);
        ImGui::AlignTextToFramePadding();
        if (value == 0)
            ImGui::TextDisabled("%s", kTermText[term]);
        else
            ImGui::TextUnformatted(kTermText[term]);
    }
    ImGui::PopStyleVar();
}

bool beginTerms(const char* id) {
    return ImGui::BeginTable(id, 2,
                             ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoPadOuterX);
}

void drawText(const StudioContext& context) {
    const Workspace& workspace = context.workspace;
    const PlanarNumbers numbers = planarNumbersOf(workspace.views[workspace.speaker()]);
    ImGui::PushTextWrapPos();
    for (int part = 0; part < 2; ++part)
        ImGui::TextUnformatted(((part == 0 ? "g = " : "h = ") + planarText(numbers, part)).c_str());
    if (const auto polynomial = complexPolynomialOf(numbers))
        ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s",
                           tr("complex: {1}", {complexText(*polynomial)}).c_str());
    else if (const auto conjugate = complexPolynomialOf(conjugateOf(numbers)))
        ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s",
                           tr("conjugate of {1}", {complexText(*conjugate)}).c_str());
    else
        ImGui::TextDisabled("%s", tr("not complex: Cauchy-Riemann fails"));
    ImGui::PopTextWrapPos();
}

void drawPresets(StudioContext& context) {
    ImGui::SetNextItemWidth(-1);
    const bool open =
        ImGui::BeginCombo("##planar presets", tr("a planar system…"), ImGuiComboFlags_HeightLarge);
    if (!open) explain("planar presets");
    if (!open) return;
    for (const std::string& name : planarPresets()) {
        if (ImGui::Selectable(tr(name.c_str()))) {
            Expected<Scene> scene = presetNamed(name);
            if (scene)
                context.open(workspaceOf(*scene));
            else
                context.report(scene.status());
        }
        explain("preset");
    }
    ImGui::EndCombo();
}

}  // namespace

void drawPlanarPanel(StudioContext& context) {
    const Workspace& workspace = context.workspace;
    if (!mapOf(workspace.views[0]).info.planarCoefficients) {
        const auto polynomial = polynomialOf(context);
        if (!polynomial) return;
        if (ImGui::Button(tr("as planar system"))) showAsPlanarSystem(context);
        explain("as planar system");
        return;
    }
    drawPresets(context);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {2, 1});
    if (beginTerms("coefficients")) {
        ImGui::TableNextRow();
        for (const char* head : {tr("g(x, y) = sum of"), tr("h(x, y) = sum of")}) {
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", head);
        }
        for (std::size_t term = 0; term < 13; ++term) drawRow(context, term);
        ImGui::EndTable();
    }
    const bool open =
        ImGui::TreeNodeEx(named("also x³y and xy³").c_str(),
                          ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
    explain("optional terms");
    if (open && beginTerms("optional")) {
        for (std::size_t term = 13; term < kTerms; ++term) drawRow(context, term);
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
    drawText(context);
    if (hasComplexForm(context)) {
        if (ImGui::Button(tr("as complex map"))) showAsComplexMap(context);
        explain("as complex map");
        ImGui::SameLine();
    }
    if (ImGui::Button(tr("reset")))
        context.edit([](Workspace& w) {
            for (const ParameterInfo& parameter : mapOf(w.views[0]).info.parameters)
                setSharedNumber(w, std::string(parameter.name), parameter.value[0]);
        });
    explain("reset");
}

}  // namespace versorium
