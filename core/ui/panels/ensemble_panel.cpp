// SPDX-License-Identifier: MIT
// The inspector's section for ensembles: how many members, what is drawn at random for each, and
// how their average is shown.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "ui/session/context.h"
#include "ui/session/ensemble_change.h"
#include "ui/widgets/help.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

const std::vector<std::string> kArrangements{trLater("even"), trLater("clustered"),
                                             trLater("spread")};

void take(StudioContext& context, const Status& status) {
    if (!status.ok()) return context.report(status);
    context.welcome = false;
    context.touch();
}

void beginButtons(StudioContext& context) {
    Scene& scene = context.workspace.view();
    if (!mapOf(scene).info.lists.empty()) {
        if (ImGui::Button(tr("over random versors"))) take(context, averageOverVersors(scene));
        explain("average versors");
    }
    const std::string number = averagedNumber(scene);
    if (number.empty()) return;
    if (!mapOf(scene).info.lists.empty()) ImGui::SameLine();
    if (ImGui::Button((tr("over {1}", {number}) + "###number").c_str()))
        take(context, averageOverNumber(scene));
    explain("average number");
}

bool whole(StudioContext& context, const char* name, const char* label, const char* control,
           int& value, int low, int high, bool logarithmic = false) {
    double number = value;
    if (!numberField(context, std::string("ensemble ") + name, label, number,
                     {.help = helpOf(control),
                      .low = static_cast<double>(low),
                      .high = static_cast<double>(high),
                      .whole = true,
                      .logarithmic = logarithmic}))
        return false;
    value = static_cast<int>(std::round(number));
    return true;
}

bool real(StudioContext& context, const std::string& name, const char* label, const char* control,
          double& value, double low, double high) {
    return numberField(context, "ensemble " + name, label, value,
                       {.help = helpOf(control), .low = low, .high = high, .slider = false});
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
    ImGui::PushID("roots");
    EnsembleRoots& roots = *ensemble.roots;
    RandomRoots next = roots.draw;
    if (info.lists.size() > 1)
        changed |=
            choose("list", "ensemble list", roots.list, {info.lists.begin(), info.lists.end()});
    bool moved = whole(context, "least", "roots, least", "ensemble roots", next.least, 1, 100);
    if (moved) next.most = std::max(next.least, next.most);
    if (whole(context, "most", "roots, most", "ensemble roots", next.most, 1, 100)) {
        next.least = std::min(next.least, next.most);
        moved = true;
    }
    moved |= real(context, "low power", "power, least", "ensemble power", next.lowPower, 0.5, 10);
    moved |= real(context, "high power", "power, most", "ensemble power", next.highPower, 0.5, 10);
    moved |= ImGui::Checkbox(tr("whole powers"), &next.wholePowers);
    explain("ensemble whole");
    std::string arrangement = kArrangements[static_cast<std::size_t>(next.arrangement)];
    if (choose("arranged", "ensemble arrangement", arrangement, kArrangements)) {
        next.arrangement = static_cast<RootArrangement>(
            std::find(kArrangements.begin(), kArrangements.end(), arrangement) -
            kArrangements.begin());
        moved = true;
    }
    if (next.arrangement == RootArrangement::clustered) {
        moved |= whole(context, "clusters", "clusters", "ensemble clusters", next.clusters, 1, 20);
        moved |= real(context, "cluster radius", "their radius", "ensemble clusters",
                      next.clusterRadius, 0.01, 0.99);
    }
    std::string region = next.ball ? "ball" : "box";
    if (choose("region", "ensemble region", region, {"box", "ball"})) {
        next.ball = region == "ball";
        moved = true;
    }
    if (info.field) {
        if (ImGui::Checkbox(tr("in the shape's box"), &roots.shapeBox)) changed = true;
        explain("ensemble box");
    }
    if (!roots.shapeBox) {
        const auto dimension = static_cast<std::size_t>(dimensionOf(info.algebra));
        for (std::size_t k = 0; k < dimension; ++k) {
            const std::string label =
                tr("half extent {1}", {stateComponent(info, static_cast<int>(k)).substr(2)});
            moved |= real(context, label, label.c_str(), "ensemble half", next.half[k], 0, 2);
        }
    }
    ImGui::PopID();
    // What makes no sense is not taken, such as a least power above the greatest.
    if (moved && checkRandomRoots(next).ok()) {
        roots.draw = next;
        changed = true;
    }
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
        EnsembleRange& range = ensemble.ranges[k];
        if (removeButton(tr("{1} from a range", {range.name}))) {
            ensemble.ranges.erase(ensemble.ranges.begin() + static_cast<std::ptrdiff_t>(k));
            return true;
        }
        const double reach = 1 + std::abs(range.to - range.from);
        changed |= real(context, range.name + " from", "from", "ensemble range", range.from,
                        range.from - reach, range.from + reach);
        changed |= real(context, range.name + " to", "to", "ensemble range", range.to,
                        range.to - reach, range.to + reach);
    }
    for (std::size_t k = 0; k < ensemble.discs.size(); ++k) {
        EnsembleDisc& disc = ensemble.discs[k];
        if (removeButton(tr("{1} from a disc", {disc.name}))) {
            ensemble.discs.erase(ensemble.discs.begin() + static_cast<std::ptrdiff_t>(k));
            return true;
        }
        const std::string name = disc.name + " disc ";
        changed |= real(context, name + "re", "centre re", "ensemble disc", disc.centreRe, -2, 2);
        changed |= real(context, name + "im", "centre im", "ensemble disc", disc.centreIm, -2, 2);
        double radius = disc.radius;
        if (real(context, name + "radius", "radius", "ensemble disc", radius, 0, 1) &&
            radius >= 0) {
            disc.radius = radius;
            changed = true;
        }
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
    Scene& scene = context.workspace.view();
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
    changed |=
        whole(context, "members", "members", "ensemble members", ensemble.count, 1, 100000, true);
    ensemble.count = std::clamp(ensemble.count, 1, kMostMembers);
    changed |= whole(context, "seed", "seed", "ensemble seed", ensemble.seed, 0, 1000);
    ensemble.seed = std::max(0, ensemble.seed);
    changed |= choose("set", "ensemble set", ensemble.set, {"membership", "solid"});
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
    if (changed) context.touch();
}

}  // namespace versorium
