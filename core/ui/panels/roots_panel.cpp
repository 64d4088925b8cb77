// SPDX-License-Identifier: MIT
// The inspector's part in the versor d: product or sum, the chosen root, roots drawn at random, and
// the sheet of candidates; then basins and circles (S Fig 3).
#include <algorithm>
#include <cmath>

#include "render/bind.h"
#include "ui/panels/roots_panel.h"
#include "ui/session/context.h"
#include "ui/session/root_edit.h"
#include "ui/widgets/help.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/panel_parts.h"
#include "ui/widgets/shown_number.h"

namespace versorium {
namespace {

// Two words of which one holds; true when the other one was taken.
bool either(const char* first, const char* second, bool& isSecond, const char* control) {
    bool changed = false;
    if (ImGui::RadioButton(tr(first), !isSecond)) changed = isSecond, isSecond = false;
    explain(control);
    ImGui::SameLine();
    if (ImGui::RadioButton(tr(second), isSecond)) changed = !isSecond, isSecond = true;
    explain(control);
    return changed;
}

void drawSwitch(StudioContext& context) {
    Workspace& workspace = context.workspace;
    if (sumOrProductOf(workspace.views[0].map).empty()) return;
    bool sum = isRootSum(workspace.views[0].map);
    if (!either("product", "sum", sum, "product or sum")) return;
    takeRootSum(workspace, sum);
    context.touch();
}

void drawChosen(StudioContext& context) {
    Workspace& workspace = context.workspace;
    const RootRef ref = context.versor.chosen;
    if (!isRoot(workspace, ref)) {
        ImGui::TextDisabled("%s", tr("Click a root in a view to see its numbers."));
        return;
    }
    RootList::Root root = rootAt(workspace, ref);
    const bool complex = mapOf(workspace.views[0]).info.algebra == Algebra::complex;
    constexpr const char* kComplex[] = {"re", "im"};
    constexpr const char* kQuaternion[] = {"w", "x", "y", "z"};
    ImGui::TextDisabled("%s[%d]", ref.list.c_str(), ref.item);
    bool changed = false;
    ImGui::PushID("chosen root");
    for (int k = 0; k < (complex ? 2 : 4); ++k) {
        const char* part = (complex ? kComplex : kQuaternion)[k];
        changed |= numberField(context, std::string("root ") + part, part,
                               root.q[static_cast<std::size_t>(k)],
                               {.help = helpOf("root part"), .low = -1, .high = 1});
    }
    changed |= numberField(context, "root power", "power", root.power,
                           {.help = helpOf("root power"), .low = -4, .high = 8});
    ImGui::PopID();
    if (changed) {
        root.power = std::clamp(root.power, -kLargestRootPower, kLargestRootPower);
        setRoot(workspace, ref, root);
        context.touch();
    }
    if (ImGui::SmallButton(tr("take away"))) removeChosenRoot(context);
    explain("remove root");
}

// A whole number of the panel's own.
bool wholeField(const char* id, const char* control, int& value, int low, int high,
                const char* format, float width) {
    ImGui::SetNextItemWidth(width);
    int typed = value;
    const bool changed =
        ImGui::DragInt(id, &typed, 0.1f, low, high, tr(format), ImGuiSliderFlags_AlwaysClamp);
    explain(control);
    if (!changed || typed == value) return false;
    value = std::clamp(typed, low, high);
    return true;
}
bool realField(const char* id, const char* control, double& value, double low, double high,
               const char* format, float width) {
    ImGui::SetNextItemWidth(width);
    const bool changed = dragNumber(id, value, 0.02, tr(format), low, high);
    explain(control);
    return changed;
}

void drawRandom(StudioContext& context) {
    RandomRoots& options = context.versor.draw.options;
    const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    wholeField("##least", "roots least", options.least, 1, kMostRandomRoots, "from %d", half);
    ImGui::SameLine();
    wholeField("##most", "roots most", options.most, 1, kMostRandomRoots, "to %d roots", half);
    options.most = std::max(options.most, options.least);
    realField("##low", "power least", options.lowPower, -20, 20, "powers from %.3g", half);
    ImGui::SameLine();
    realField("##high", "power most", options.highPower, -20, 20, "to %.3g", half);
    options.highPower = std::max(options.highPower, options.lowPower);
    bool real = !options.wholePowers;
    if (either("whole", "real powers", real, "whole powers")) options.wholePowers = !real;
    const char* words[] = {tr("even"), tr("clustered"), tr("spread")};
    int arrangement = static_cast<int>(options.arrangement);
    ImGui::SetNextItemWidth(half);
    const bool open = ImGui::BeginCombo("##arrangement", words[arrangement]);
    if (!open) explain("arrangement");
    if (open) {
        for (int k = 0; k < 3; ++k)
            if (ImGui::Selectable(words[k], k == arrangement))
                options.arrangement = static_cast<RootArrangement>(k);
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    bool ball = options.ball;
    if (either("box", "ball", ball, "region")) options.ball = ball;
    if (options.arrangement == RootArrangement::clustered) {
        wholeField("##clusters", "clusters", options.clusters, 1, 100, "%d clusters", half);
        ImGui::SameLine();
        realField("##size", "cluster size", options.clusterRadius, 0.001, 0.999, "size %.3g", half);
    }
    int& seed = context.versor.draw.seed;
    wholeField("##seed", "seed", seed, 0, 2147483647, "seed %d", half);
    ImGui::SameLine();
    if (ImGui::Button(tr("Draw"))) drawRoots(context, seed);
    explain("draw roots");
    ImGui::SameLine();
    if (ImGui::Button(tr("Next"))) drawRoots(context, seed == 2147483647 ? 0 : seed + 1);
    explain("next seed");
    if (ImGui::Button(tr("Candidates…"), {-1, 0})) openContactSheet(context, seed);
    explain("contact sheet");
}

}  // namespace

void drawVersorPanel(StudioContext& context) {
    Workspace& workspace = context.workspace;
    if (!hasRoots(workspace)) return;
    ImGui::PushID("versor");
    drawSwitch(context);
    if (ImGui::Checkbox(tr("show roots"), &workspace.showRoots)) context.touch();
    explain("show roots");
    ImGui::SameLine();
    if (ImGui::SmallButton(tr("add a root"))) addRootAtPoint(context);
    explain("add root");
    drawChosen(context);
    const bool open =
        ImGui::TreeNodeEx(named("roots at random").c_str(), ImGuiTreeNodeFlags_SpanAvailWidth);
    explain("random roots");
    if (open) {
        drawRandom(context);
        ImGui::TreePop();
    }
    ImGui::PopID();
}

void drawCircleControls(StudioContext& context) {
    Workspace& workspace = context.workspace;
    if (!takesCircles(workspace)) return;
    ImGui::PushID("circles");
    if (ImGui::Checkbox(tr("show basins"), &workspace.basins)) context.touch();
    explain("show basins");
    ImGui::SameLine();
    if (ImGui::SmallButton(tr("drop a circle"))) dropCircle(context);
    explain("drop circle");
    const int view = circleViewOf(workspace);
    const std::vector<CircleStudy> all = view >= 0 && !workspace.circles.empty()
                                             ? studyCircles(context, view)
                                             : std::vector<CircleStudy>();
    int removed = -1;
    for (std::size_t k = 0; k < workspace.circles.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        double radius = workspace.circles[k].radius;
        if (numberField(context, "circle radius", "radius", radius,
                        {.help = helpOf("circle radius"), .low = 0.01, .high = 3}) &&
            radius > 1e-12 && radius <= 1e6) {
            workspace.circles[k].radius = radius;
            context.touch();
        }
        if (ImGui::SmallButton(tr("take away"))) removed = static_cast<int>(k);
        explain("remove circle");
        if (k < all.size()) {
            ImGui::PushTextWrapPos();
            ImGui::TextUnformatted(sentenceOf(all[k]).c_str());
            ImGui::PopTextWrapPos();
        }
        ImGui::PopID();
    }
    if (removed >= 0) removeCircle(context, removed);
    if (workspace.basins) {
        const Basins basins = studyBasins(context);
        const std::string text = basins.capture > 0
                                     ? tr("Within |x| ≤ {1} every orbit stays, whatever d is.",
                                          {shownNumber(basins.capture, 3)})
                                     : tr("No ball around 0 is proved to keep its orbits.");
        ImGui::PushTextWrapPos();
        ImGui::TextDisabled("%s", text.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::PopID();
}

}  // namespace versorium
