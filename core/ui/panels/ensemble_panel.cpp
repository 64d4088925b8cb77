// SPDX-License-Identifier: MIT
// The inspector's section for ensembles: how many members, what is drawn at random for each, and
// how their average is shown.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "ui/panels/number_field.h"
#include "ui/panels/panels.h"
#include "ui/panels/value_widgets.h"
#include "ui/session/context.h"
#include "ui/session/ensemble_change.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

const std::vector<std::string> kArrangements{trLater("even"), trLater("clustered"),
                                             trLater("spread")};

void begin(StudioContext& context, Status (*average)(Scene&)) {
    const Status status = context.edit([&](Workspace& w) { return average(w.view()); });
    if (!status.ok()) return context.report(status);
    context.welcome = false;
}

void beginButtons(StudioContext& context) {
    const Scene& scene = context.workspace.view();
    if (!mapOf(scene).info.lists.empty()) {
        if (ImGui::Button(tr("over random versors"))) begin(context, averageOverVersors);
        explain("average versors");
    }
    const std::string number = averagedNumber(scene);
    if (number.empty()) return;
    if (!mapOf(scene).info.lists.empty()) ImGui::SameLine();
    if (ImGui::Button((tr("over {1}", {number}) + "###number").c_str()))
        begin(context, averageOverNumber);
    explain("average number");
}

bool rootControls(StudioContext& context, Scene& scene) {
    const MapInfo& info = mapOf(scene).info;
    if (info.lists.empty()) return false;
    EnsembleSpec& ensemble = scene.ensemble;
    bool on = ensemble.roots.has_value(), changed = false;
    if (ImGui::Checkbox(tr("random roots"), &on)) {
        if (!on)
            ensemble.roots.reset();
        else
            context.report(averageOverVersors(scene));
        changed = true;
    }
    explain("random roots");
    if (!ensemble.roots) return changed;
    if (info.field) {
        if (ImGui::Checkbox(tr("in the shape's box"), &ensemble.roots->shapeBox)) changed = true;
        explain("ensemble box");
    }
    drawGroup(context, "ensemble.roots");
    return changed;
}

// A choice that adds something; empty where nothing was chosen.
std::string chooseMore(const char* id, const char* text, const char* control,
                       const std::vector<std::string>& names) {
    std::string chosen;
    if (names.empty()) return chosen;
    ImGui::SetNextItemWidth(0.48f * ImGui::GetContentRegionAvail().x);
    const bool open = ImGui::BeginCombo(id, tr(text));
    if (!open) explain(control);
    if (!open) return chosen;
    for (const std::string& name : names)
        if (ImGui::Selectable(name.c_str())) chosen = name;
    ImGui::EndCombo();
    return chosen;
}

bool removeButton(const std::string& name) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name.c_str());
    ImGui::SameLine();
    const bool pressed = ImGui::SmallButton((tr("remove") + ("##" + name)).c_str());
    explain("ensemble remove");
    return pressed;
}

bool numberControls(StudioContext& context, Scene& scene) {
    EnsembleSpec& ensemble = scene.ensemble;
    bool changed = false;
    for (std::size_t k = 0; k < ensemble.ranges.size(); ++k) {
        const EnsembleRange& range = ensemble.ranges[k];
        if (removeButton(tr("{1} from a range", {range.name}))) {
            ensemble.ranges.erase(ensemble.ranges.begin() + static_cast<std::ptrdiff_t>(k));
            return true;
        }
        const std::string path = "ensemble.ranges[" + std::to_string(k) + "]";
        drawValue(context, path + ".from");
        drawValue(context, path + ".to");
    }
    for (std::size_t k = 0; k < ensemble.discs.size(); ++k) {
        const EnsembleDisc& disc = ensemble.discs[k];
        if (removeButton(tr("{1} from a disc", {disc.name}))) {
            ensemble.discs.erase(ensemble.discs.begin() + static_cast<std::ptrdiff_t>(k));
            return true;
        }
        drawGroup(context, "ensemble.discs[" + std::to_string(k) + "]");
    }
    const std::string range =
        chooseMore("##more ranges", "a number…", "ensemble range", freeRanges(scene));
    if (!range.empty()) addRange(scene, range);
    const std::vector<std::string> discs = freeDiscs(scene);
    if (!discs.empty()) ImGui::SameLine();
    const std::string disc = chooseMore("##more discs", "a disc…", "ensemble disc", discs);
    if (!disc.empty()) addDisc(scene, disc);
    return changed || !range.empty() || !disc.empty();
}

bool contourControls(StudioContext& context, Scene& scene) {
    Colouring& colour = scene.colour;
    std::string now = contourText(colour.contours);
    std::vector<std::string> names;
    for (const auto& [name, levels] : contourChoices()) {
        names.push_back(name);
        if (levels == colour.contours) now = name;
    }
    if (choose("contours", "contours", now, names)) {
        for (const auto& [name, levels] : contourChoices())
            if (name == now) colour.contours = levels;
        return true;
    }
    labelled("levels");
    static char typed[200];
    static bool typing = false;
    // What is being typed stays until it is taken.
    if (!typing) {
        const std::string text = contourText(colour.contours);
        const std::size_t size = std::min(text.size(), sizeof typed - 1);
        std::memcpy(typed, text.data(), size);
        typed[size] = 0;
    }
    const bool taken = ImGui::InputTextWithHint("##levels", "0.1, 0.5, 0.9", typed, sizeof typed,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
    const bool left = ImGui::IsItemDeactivatedAfterEdit();
    typing = ImGui::IsItemActive();
    explain("contour levels");
    if (!taken && !left) return false;
    Expected<std::vector<double>> levels = contoursFromText(typed);
    if (!levels) {
        context.report(levels.status());
        return false;
    }
    if (*levels == colour.contours) return false;
    colour.contours = std::move(*levels);
    return true;
}

bool showControls(Scene& scene) {
    const std::string now = shownAverage(scene);
    bool changed = false;
    const std::pair<const char*, const char*> choices[] = {
        {trLater("mean"), "mean_membership"},
        {trLater("standard error"), "standard_error"},
        {trLater("neither"), ""}};
    for (const auto& [label, field] : choices) {
        if (ImGui::RadioButton(tr(label), now == field) && now != field) {
            showAverage(scene, field);
            changed = true;
        }
        explain("show average");
        ImGui::SameLine();
    }
    ImGui::NewLine();
    return changed;
}

}  // namespace

void drawEnsemble(StudioContext& context) {
    // What is drawn changes a copy, which the workspace takes in the end.
    Scene scene = context.workspace.view();
    EnsembleSpec& ensemble = scene.ensemble;
    if (!ensemble.varies()) return beginButtons(context);
    ImGui::PushID("ensemble");
    bool changed = showControls(scene);
    if (!shownAverage(scene).empty()) {
        const LivePicture& picture =
            context.views[static_cast<std::size_t>(context.workspace.focused)].picture;
        ImGui::TextDisabled("%s", tr("{1} of {2} sets counted", {std::to_string(picture.members()),
                                                                 std::to_string(ensemble.count)})
                                      .c_str());
    }
    drawValues(context, {"ensemble.count", "ensemble.seed", "ensemble.set"});
    changed |= rootControls(context, scene);
    changed |= numberControls(context, scene);
    if (!shownAverage(scene).empty()) changed |= contourControls(context, scene);
    if (ImGui::Button(tr("no average"))) {
        showAverage(scene, "");
        ensemble = {};
        changed = true;
    }
    explain("no average");
    ImGui::PopID();
    if (changed)
        context.edit([&](Workspace& w) {
            w.view().ensemble = ensemble;
            w.view().colour = scene.colour;
        });
}

}  // namespace versorium
