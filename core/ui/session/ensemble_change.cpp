// SPDX-License-Identifier: MIT
#include "ui/session/ensemble_change.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "render/cpu/averaged_map.h"
#include "ui/session/context.h"

namespace versorium {
namespace {

constexpr const char* kMean = "mean_membership";
constexpr const char* kError = "standard_error";
constexpr const char* kPerceptual = "viridis";
// Half extents of the box of roots where there is no shape, if they have no box of their own.
constexpr double kRootBox = 1;
// A number is drawn from this part of its slider's range around where it is.
constexpr double kAround = 0.05;
constexpr double kDisc = 0.1;

bool isDrawn(const EnsembleSpec& ensemble, const std::string& name) {
    for (const EnsembleRange& range : ensemble.ranges)
        if (range.name == name) return true;
    for (const EnsembleDisc& disc : ensemble.discs)
        if (disc.name + ".re" == name || disc.name + ".im" == name) return true;
    return false;
}

bool isFree(const Scene& scene, const std::string& name) {
    return !isOnAxis(scene.slice, name) && !isDrawn(scene.ensemble, name);
}

double numberOf(const Scene& scene, const std::string& name) {
    const auto number = numberNamed(scene, name);
    return number ? numberValue(scene, *number) : 0;
}

// The slider's range of a component of a parameter; ±2 for components of a state.
std::array<double, 2> usualRange(const Scene& scene, const std::string& name) {
    const MapInfo& info = mapOf(scene).info;
    int component = 0;
    for (const ParameterInfo& parameter : info.parameters)
        for (int k = 0; k < widthOf(parameter.kind); ++k)
            if (parameterComponent(info, component++) == name)
                return {parameter.low, parameter.high};
    return {-2, 2};
}

// The parameter that an average is taken over where none is named: a complex one before a real one.
struct Candidate {
    std::string name;
    bool disc = false;
};
Candidate candidateOf(const Scene& scene) {
    const MapInfo& info = mapOf(scene).info;
    const std::vector<std::string> discs = freeDiscs(scene), ranges = freeRanges(scene);
    const auto has = [](const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const ParameterInfo& parameter : info.parameters)
        if (has(discs, std::string(parameter.name))) return {std::string(parameter.name), true};
    for (int k = 0; k < parameterSize(info); ++k)
        if (has(ranges, parameterComponent(info, k))) return {parameterComponent(info, k), false};
    return {};
}

}  // namespace

std::string shownAverage(const Scene& scene) {
    return showsEnsemble(scene) ? std::string(wordOf(scene.colour.field)) : std::string();
}

void showAverage(Scene& scene, const std::string& field) {
    Colouring& colour = scene.colour;
    const std::string before = shownAverage(scene);
    if (field.empty()) {
        if (!before.empty()) colour = sceneOf(mapOf(scene)).colour;
        return;
    }
    if (before.empty()) {
        colour.palette = kPerceptual;
        colour.ownPalette = nullptr;
        colour.reverse = false;
    }
    colour.rule = ColourRule::palette;
    colour.field = *fromWord<FieldName>(field);
    colour.scale.reset();
    colour.interior = colour.outline = SetName::none;
    // No standard error of a mean of yes and no is larger than this.
    const double members = std::max(2, scene.ensemble.count);
    colour.range = {0, field == kError ? 0.5 / std::sqrt(members - 1) : 1};
    if (field == kError)
        colour.contours.clear();
    else if (before != kMean)
        colour.contours = contourChoices()[1].second;
}

Status averageOverVersors(Scene& scene) {
    const MapInfo& info = mapOf(scene).info;
    if (info.lists.empty())
        return Status::usage("This map has no list of roots; average over a number instead");
    Scene next = scene;
    EnsembleRoots& roots = next.ensemble.roots.emplace();
    roots.list = info.lists[0];
    const RootList& now = next.lists[roots.list];
    if (!now.roots.empty()) roots.draw.least = roots.draw.most = static_cast<int>(now.roots.size());
    roots.shapeBox = info.field;
    if (!info.field) {
        roots.draw.half.fill(0);
        const auto dimension = static_cast<std::size_t>(dimensionOf(info.algebra));
        std::fill(roots.draw.half.begin(),
                  roots.draw.half.begin() + static_cast<std::ptrdiff_t>(dimension), kRootBox);
    }
    if (Status status = checkEnsemble(next); !status.ok()) return status;
    showAverage(next, kMean);
    scene = std::move(next);
    return {};
}

std::string averagedNumber(const Scene& scene) {
    const Candidate candidate = candidateOf(scene);
    if (candidate.name.empty()) return {};
    return tr(candidate.disc ? trLater("{1} in a disc") : trLater("{1} in a range"),
              {candidate.name});
}

Status averageOverNumber(Scene& scene) {
    const Candidate candidate = candidateOf(scene);
    if (candidate.name.empty())
        return Status::usage(
            "All numbers of this map are on the axes of the view or drawn already: mark a view of "
            "starting points");
    if (candidate.disc)
        addDisc(scene, candidate.name);
    else
        addRange(scene, candidate.name);
    showAverage(scene, kMean);
    return {};
}

std::vector<std::string> freeRanges(const Scene& scene) {
    std::vector<std::string> names;
    if (scene.ensemble.ranges.size() >= kMostEnsembleNumbers) return names;
    for (const std::string& name : axisNames(scene))
        if (isFree(scene, name)) names.push_back(name);
    return names;
}

std::vector<std::string> freeDiscs(const Scene& scene) {
    std::vector<std::string> names;
    if (scene.ensemble.discs.size() >= kMostEnsembleNumbers) return names;
    for (const std::string& name : axisNames(scene)) {
        if (!name.ends_with(".re")) continue;
        const std::string whole = name.substr(0, name.size() - 3);
        if (numberNamed(scene, whole + ".im") && isFree(scene, name) &&
            isFree(scene, whole + ".im"))
            names.push_back(whole);
    }
    return names;
}

void addRange(Scene& scene, const std::string& name) {
    const std::array<double, 2> usual = usualRange(scene, name);
    const double now = numberOf(scene, name), reach = kAround * (usual[1] - usual[0]);
    scene.ensemble.ranges.push_back({name, now - reach, now + reach});
}

void addDisc(Scene& scene, const std::string& name) {
    scene.ensemble.discs.push_back(
        {name, numberOf(scene, name + ".re"), numberOf(scene, name + ".im"), kDisc});
}

const std::vector<std::pair<std::string, std::vector<double>>>& contourChoices() {
    static const std::vector<std::pair<std::string, std::vector<double>>> choices = {
        {trLater("none"), {}},
        {"0.05, 0.5, 0.95", {0.05, 0.5, 0.95}},
        {"0.5", {0.5}},
        {"0.25, 0.5, 0.75", {0.25, 0.5, 0.75}},
        {trLater("0.1 to 0.9"), {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}}};
    return choices;
}

std::string contourText(const std::vector<double>& levels) {
    std::string text;
    for (double level : levels) text += (text.empty() ? "" : ", ") + formatNumber(level);
    return text;
}

Expected<std::vector<double>> contoursFromText(const std::string& text) {
    std::vector<double> levels;
    for (const char* at = text.c_str(); *at;) {
        if (*at == ' ' || *at == ',' || *at == ';') {
            ++at;
            continue;
        }
        char* end = nullptr;
        const double level = std::strtod(at, &end);
        if (end == at || !std::isfinite(level))
            return Status::usage("Levels are numbers with commas between them, as 0.1, 0.5, 0.9");
        levels.push_back(level);
        at = end;
    }
    if (levels.size() > kMostContours)
        return Status::usage("At most " + std::to_string(kMostContours) + " levels are drawn");
    std::sort(levels.begin(), levels.end());
    return levels;
}

std::string describeEnsemble(const StudioContext& context, int view) {
    const auto index = static_cast<std::size_t>(view);
    const Scene& scene = context.workspace.views[index];
    const std::string shown = shownAverage(scene);
    if (shown.empty()) return {};
    const EnsembleSpec& ensemble = scene.ensemble;
    const LivePicture& picture = context.views[index].picture;
    const int goal = picture.memberGoal() > 0 ? picture.memberGoal() : ensemble.count;
    std::string drawn;
    const auto also = [&](const std::string& what) { drawn += (drawn.empty() ? "" : ", ") + what; };
    if (ensemble.roots) also(tr("random {1}", {tr(std::string_view(ensemble.roots->list))}));
    for (const EnsembleRange& range : ensemble.ranges)
        also(tr("{1} from {2} to {3}",
                {range.name, shownNumber(range.from, 4), shownNumber(range.to, 4)}));
    for (const EnsembleDisc& disc : ensemble.discs)
        also(tr("{1} from a disc of radius {2}", {disc.name, shownNumber(disc.radius, 4)}));
    return tr(shown == kMean ? trLater("Mean of {1} of {2} sets with {3}.")
                             : trLater("Standard error of the mean of {1} of {2} sets with {3}."),
              {std::to_string(picture.members()), std::to_string(goal), drawn});
}

}  // namespace versorium
