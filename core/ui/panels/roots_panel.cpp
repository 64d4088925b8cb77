// SPDX-License-Identifier: MIT
// The inspector's part in the versor d: product or sum, the chosen root, roots drawn at random, and
// the sheet of candidates; then basins and circles (S Fig 3).
#include <algorithm>
#include <cmath>

#include "render/bind.h"
#include "ui/panels/number_field.h"
#include "ui/panels/panels.h"
#include "ui/panels/value_widgets.h"
#include "ui/session/context.h"
#include "ui/session/root_edit.h"
#include "ui/widgets/help.h"
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
    const Workspace& workspace = context.workspace;
    if (sumOrProductOf(workspace.views[0].map).empty()) return;
    bool sum = isRootSum(workspace.views[0].map);
    if (!either("product", "sum", sum, "product or sum")) return;
    context.edit([&](Workspace& w) { takeRootSum(w, sum); });
}

void drawChosen(StudioContext& context) {
    const Workspace& workspace = context.workspace;
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
        context.edit([&](Workspace& w) { setRoot(w, ref, root); });
    }
    if (ImGui::SmallButton(tr("take away"))) removeChosenRoot(context);
    explain("remove root");
}

void drawRandom(StudioContext& context) {
    drawValues(context, {"random.least", "random.most", "random.low", "random.high",
                         "random.whole_powers", "random.arrangement"});
    if (context.versor.draw.options.arrangement == RootArrangement::clustered)
        drawValues(context, {"random.clusters", "random.cluster_size"});
    drawValues(context, {"random.ball", "random.seed"});
    const int seed = context.versor.draw.seed;
    if (ImGui::Button(tr("Draw"))) drawRoots(context, seed);
    explain("draw roots");
    ImGui::SameLine();
    if (ImGui::Button(tr("Next"))) drawRoots(context, seed == kMostSeed ? 0 : seed + 1);
    explain("next seed");
    if (ImGui::Button(tr("Candidates…"), {-1, 0})) openContactSheet(context, seed);
    explain("contact sheet");
}

}  // namespace

void drawVersorPanel(StudioContext& context) {
    const Workspace& workspace = context.workspace;
    if (!hasRoots(workspace)) return;
    ImGui::PushID("versor");
    drawSwitch(context);
    drawValue(context, "show_roots");
    if (rowButton("add a root", "add root")) addRootAtPoint(context);
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
    const Workspace& workspace = context.workspace;
    if (!takesCircles(workspace)) return;
    ImGui::PushID("circles");
    drawValue(context, "basins");
    if (rowButton("drop a circle", "drop circle")) dropCircle(context);
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
            radius > 1e-12 && radius <= 1e6)
            context.edit([&](Workspace& w) { w.circles[k].radius = radius; });
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
