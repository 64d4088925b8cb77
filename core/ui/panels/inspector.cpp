// SPDX-License-Identifier: MIT
// The inspector: the map with its formula, its parameters, what is seen and how it is coloured.
#include <algorithm>
#include <cmath>

#include "ui/panels/number_field.h"
#include "ui/panels/panels.h"
#include "ui/panels/value_widgets.h"
#include "ui/session/context.h"
#include "ui/session/ensemble_change.h"
#include "ui/views/view.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

// The plane of a complex number, with the other components below it.
bool pad(const char* id, double& x, double& y, double low, double high) {
    const float side = std::min(ImGui::GetContentRegionAvail().x * 0.42f, 130.0f);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(id, {side, side});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{corner.x + side, corner.y + side};
    list.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_FrameBg), 6);
    const ImU32 line = ImGui::GetColorU32(ImGuiCol_Border);
    const auto across = [&](double value) {
        return static_cast<float>((value - low) / (high - low)) * side;
    };
    list.AddLine({corner.x + across(0), corner.y}, {corner.x + across(0), end.y}, line);
    list.AddLine({corner.x, end.y - across(0)}, {end.x, end.y - across(0)}, line);
    list.PushClipRect(corner, end, true);
    drawMark(list, {corner.x + across(x), end.y - across(y)}, 6, MarkShape::ring,
             ImGui::GetColorU32(ImGuiCol_CheckMark));
    list.PopClipRect();
    explain("pad");
    if (!ImGui::IsItemActive()) return false;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto value = [&](float part) {
        return low + (high - low) * std::clamp(part / side, 0.0f, 1.0f);
    };
    const double u = value(mouse.x - corner.x), v = value(end.y - mouse.y);
    const bool changed = u != x || v != y;
    x = u;
    y = v;
    return changed;
}

void parameters(StudioContext& context) {
    const Workspace& workspace = context.workspace;
    const MapInfo& info = mapOf(workspace.views[0]).info;
    int component = 0;
    for (const ParameterInfo& parameter : info.parameters) {
        const int width = widthOf(parameter.kind);
        const std::string name(parameter.name);
        const Scene& spoken =
            parameter.ofView ? workspace.view() : workspace.views[workspace.speaker()];
        std::vector<double> value = spoken.parameters.at(name);
        bool changed = false;
        ImGui::PushID(name.c_str());
        if (width >= 2) {
            changed |= pad("pad", value[0], value[1], std::max(parameter.low, -2.0),
                           std::min(parameter.high, 2.0));
            ImGui::SameLine();
            ImGui::BeginGroup();
            if (info.parameters.size() > 1) ImGui::TextDisabled("%s", name.c_str());
        }
        for (int k = 0; k < width; ++k) {
            const std::string part = parameterComponent(info, component + k);
            if (width == 1)
                drawValue(context, part);
            else
                drawComponent(context, part);
        }
        if (width >= 2) {
            if (ImGui::SmallButton(tr("reset"))) {
                value.assign(parameter.value.begin(), parameter.value.begin() + width);
                changed = true;
            }
            explain("reset");
            ImGui::EndGroup();
        }
        ImGui::PopID();
        if (changed) context.edit([&](Workspace& w) { setSharedParameter(w, name, value); });
        component += width;
    }
}

void axisControl(StudioContext& context, std::size_t k) {
    const Scene& scene = context.workspace.view();
    const auto& terms = scene.slice.axes[k].terms;
    std::string name = terms.size() == 1 ? terms[0].first : "";
    if (chooseName(k == 0 ? "axis →" : "axis ↑", "axis", name, axisNames(scene), "several"))
        context.edit([&](Workspace& w) { setAxis(w, k, name); });
}

void borderControls(StudioContext& context) {
    const Scene& scene = context.workspace.view();
    const double aspect = context.aspect(context.workspace.focused);
    const char* labels[] = {trLater("left"), trLater("right"), trLater("bottom"), trLater("top")};
    const std::array<double, 4> borders = bordersOf(scene, aspect);
    for (int k = 0; k < 4 && k / 2 < static_cast<int>(scene.slice.centre.size()); ++k) {
        double value = borders[static_cast<std::size_t>(k)];
        const NumberLook look{.help = helpOf("border"),
                              .low = value - scene.slice.height,
                              .high = value + scene.slice.height,
                              .slider = false};
        Scene next = scene;
        if (numberField(context, labels[k], labels[k], value, look) &&
            setBorder(next, k, value, aspect))
            context.moveTo(context.workspace.focused, next.slice);
    }
}

void sliceControls(StudioContext& context) {
    const Scene& scene = context.workspace.view();
    for (std::size_t k = 0; k < 2 && k < scene.slice.axes.size(); ++k) axisControl(context, k);
    drawValues(context, {"slice.center[0]", "slice.center[1]", "slice.height"});
    const bool open =
        ImGui::TreeNodeEx(named("borders").c_str(), ImGuiTreeNodeFlags_SpanAvailWidth);
    explain("borders");
    if (open) {
        borderControls(context);
        ImGui::TreePop();
    }
}

}  // namespace

void drawInspector(StudioContext& context) {
    const Workspace& workspace = context.workspace;
    const MapInfo& info = mapOf(workspace.views[0]).info;
    heading("Map");
    ImGui::SetNextItemWidth(-1);
    const bool open =
        ImGui::BeginCombo("##map", tr(info.title).c_str(), ImGuiComboFlags_HeightLarge);
    if (!open) explain("map");
    if (open) {
        drawFormulaChoices(context);
        for (const MapKernels& map : catalogue())
            if (ImGui::Selectable(tr(map.info.title).c_str(), map.info.name == info.name) &&
                map.info.name != info.name) {
                context.newMap(std::string(map.info.name));
                break;
            }
        ImGui::EndCombo();
    }
    const MapInfo& shown = mapOf(workspace.views[0]).info;
    if (!workspace.views[0].formula) {
        ImGui::PushTextWrapPos();
        ImGui::TextUnformatted(tr(shown.formula).c_str());
        ImGui::PopTextWrapPos();
        explainBy(shown.source);
    }
    drawFormulaPanel(context);
    if (ImGui::Button(tr("Gallery"))) context.dialogs.gallery = true;
    explain("gallery");
    if (rowButton("Find", "find")) context.dialogs.find = true;
    if (rowButton("Open", "open")) context.chooseFile();
    if (rowButton("Export", "export dialog")) context.dialogs.exporting = true;
    if (rowButton("Lessons", "lessons")) context.lessons.open = !context.lessons.open;

    heading("Parameters");
    if (!mapOf(workspace.views[0]).info.planarCoefficients) parameters(context);
    drawPlanarPanel(context);
    drawShapePanel(context);
    drawSpaceView(context);

    if (hasRoots(workspace)) {
        heading("Versor d: roots and poles");
        drawVersorPanel(context);
    }
    const bool circled = workspace.basins || !workspace.circles.empty();
    if (takesCircles(workspace) && section("Basins and circles", circled))
        drawCircleControls(context);

    if (traitsOf(workspace.view()).ownStart) {
        heading("Start of the orbits in the focused view");
        drawStartControls(context);
    }

    heading("Fixed points and cycles");
    drawCycleControls(context);

    heading("Under the pointer");
    drawProbe(context);

    heading("Orbits");
    drawValues(context, {"iterations", "escape_radius", "escape_test"});
    drawComparedControls(context);

    heading(workspace.views.size() > 1 ? "Slice of the focused view" : "Slice");
    sliceControls(context);
    heading("Colours");
    drawGroup(context, "colour");
    if (section("Average over random maps", workspace.view().ensemble.varies()))
        drawEnsemble(context);
    if (section("Images behind and in front", !workspace.view().layers.empty()))
        drawLayers(context);
    heading("Interface");
    drawValues(context, {"language", "theme"});
}

}  // namespace versorium
