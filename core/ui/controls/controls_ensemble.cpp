// SPDX-License-Identifier: MIT
// The averages of the marked view as controls and as commands.
#include <algorithm>
#include <cmath>

#include "ui/controls/control_list.h"
#include "ui/session/context.h"
#include "ui/session/ensemble_change.h"

namespace versorium {
namespace {

using SceneChange = Status (*)(Scene&);

void run(StudioContext& context, SceneChange change) {
    if (Status status = change(context.workspace.view()); !status.ok())
        return context.report(status);
    context.welcome = false;
    context.touch();
}

void collectRoots(ControlList& all, EnsembleRoots& roots) {
    RandomRoots* draw = &roots.draw;
    // What makes no sense is refused by its check.
    const auto change = [draw](const auto& set) {
        RandomRoots next = *draw;
        set(next);
        if (checkRandomRoots(next).ok()) *draw = next;
    };
    all.number("ensemble least", "random roots, least", draw->least, 1, 1, kMostRandomRoots,
               [change](double value) {
                   change([&](RandomRoots& next) {
                       next.least = static_cast<int>(value);
                       next.most = std::max(next.most, next.least);
                   });
               });
    all.number("ensemble most", "random roots, most", draw->most, 1, 1, kMostRandomRoots,
               [change](double value) {
                   change([&](RandomRoots& next) {
                       next.most = static_cast<int>(value);
                       next.least = std::min(next.most, next.least);
                   });
               });
    all.number("ensemble low power", "their powers, least", draw->lowPower, 1, -1000, 1000,
               [change](double value) { change([&](RandomRoots& n) { n.lowPower = value; }); });
    all.number("ensemble high power", "their powers, most", draw->highPower, 1, -1000, 1000,
               [change](double value) { change([&](RandomRoots& n) { n.highPower = value; }); });
    all.toggle("ensemble whole", "whole powers", draw->wholePowers,
               [change](bool on) { change([&](RandomRoots& n) { n.wholePowers = on; }); });
    const std::vector<std::string> arrangements{trLater("even"), trLater("clustered"),
                                                trLater("spread")};
    all.choice("ensemble arrangement", "roots are arranged",
               arrangements[static_cast<std::size_t>(draw->arrangement)], arrangements,
               [change, arrangements](const std::string& word) {
                   change([&](RandomRoots& next) {
                       next.arrangement = static_cast<RootArrangement>(
                           std::find(arrangements.begin(), arrangements.end(), word) -
                           arrangements.begin());
                   });
               });
    if (draw->arrangement == RootArrangement::clustered)
        all.number("ensemble clusters", "clusters of roots", draw->clusters, 1, 1, 100,
                   [change](double value) {
                       change([&](RandomRoots& n) { n.clusters = static_cast<int>(value); });
                   });
    all.choice("ensemble region", "region of the roots", draw->ball ? "ball" : "box",
               {"box", "ball"}, [change](const std::string& word) {
                   change([&](RandomRoots& next) { next.ball = word == "ball"; });
               });
}

void collectNumbers(StudioContext& context, ControlList& all, Scene& scene) {
    EnsembleSpec& ensemble = scene.ensemble;
    StudioContext* c = &context;
    for (std::size_t k = 0; k < ensemble.ranges.size(); ++k) {
        EnsembleRange& range = ensemble.ranges[k];
        const double step = std::max(1e-3, std::abs(range.to - range.from) / 10);
        for (const bool from : {true, false})
            all.number(
                "ensemble " + range.name + (from ? " from" : " to"),
                tr(from ? trLater("{1} drawn from") : trLater("{1} drawn up to"), {range.name}),
                from ? range.from : range.to, step, -1e6, 1e6,
                [&range, from](double value) { (from ? range.from : range.to) = value; });
        all.command("ensemble keep " + range.name, tr("Draw {1} no longer", {range.name}), "",
                    [c, k] {
                        auto& ranges = c->workspace.view().ensemble.ranges;
                        ranges.erase(ranges.begin() + static_cast<std::ptrdiff_t>(k));
                        c->touch();
                    });
    }
    for (std::size_t k = 0; k < ensemble.discs.size(); ++k) {
        EnsembleDisc& disc = ensemble.discs[k];
        const auto number = [&](const char* id, const char* what, double& value, double low) {
            all.number("ensemble " + disc.name + id, tr(what, {disc.name}), value, 0.01, low, 1e6,
                       [&value](double wanted) { value = wanted; });
        };
        number(" disc re", trLater("{1}: centre of its disc, re"), disc.centreRe, -1e6);
        number(" disc im", trLater("{1}: centre of its disc, im"), disc.centreIm, -1e6);
        number(" disc radius", trLater("{1}: radius of its disc"), disc.radius, 0);
        all.command("ensemble keep " + disc.name, tr("Draw {1} no longer", {disc.name}), "",
                    [c, k] {
                        auto& discs = c->workspace.view().ensemble.discs;
                        discs.erase(discs.begin() + static_cast<std::ptrdiff_t>(k));
                        c->touch();
                    });
    }
    const auto more = [&](const char* id, const char* label, std::vector<std::string> names,
                          void (*add)(Scene&, const std::string&)) {
        if (!names.empty())
            all.choice(
                id, label, "", names,
                [c, add](const std::string& name) { add(c->workspace.view(), name); }, names);
    };
    more("ensemble range", "draw a number from a range", freeRanges(scene), addRange);
    more("ensemble disc", "draw a complex number from a disc", freeDiscs(scene), addDisc);
}

}  // namespace

void collectEnsemble(StudioContext& context, ControlList& all) {
    all.begin("Average over random maps, marked view");
    StudioContext* c = &context;
    Scene& scene = context.workspace.view();
    EnsembleSpec& ensemble = scene.ensemble;
    if (!mapOf(scene).info.lists.empty())
        all.toggle("ensemble roots", "random roots", ensemble.roots.has_value(), [c](bool on) {
            if (!on)
                c->workspace.view().ensemble.roots.reset();
            else
                c->report(averageOverVersors(c->workspace.view()));
        });
    if (ensemble.varies()) {
        const std::vector<std::string> shown{trLater("mean"), trLater("standard error"),
                                             trLater("neither")};
        const std::vector<std::string> fields{"mean_membership", "standard_error", ""};
        const auto at = std::find(fields.begin(), fields.end(), shownAverage(scene));
        all.choice("ensemble shown", "what is shown",
                   shown[static_cast<std::size_t>(at - fields.begin())], shown,
                   [c, shown, fields](const std::string& word) {
                       const auto k = std::find(shown.begin(), shown.end(), word) - shown.begin();
                       showAverage(c->workspace.view(), fields[static_cast<std::size_t>(k)]);
                   });
        all.number("ensemble members", "members", ensemble.count, 100, 1, kMostMembers,
                   [&ensemble](double value) { ensemble.count = static_cast<int>(value); });
        all.number("ensemble seed", "seed", ensemble.seed, 1, 0, 2147483647,
                   [&ensemble](double value) { ensemble.seed = static_cast<int>(value); });
        all.choice("ensemble set", "set that is averaged", ensemble.set, {"membership", "solid"},
                   [&ensemble](const std::string& word) { ensemble.set = word; });
        if (ensemble.roots) collectRoots(all, *ensemble.roots);
    }
    collectNumbers(context, all, scene);
    if (!ensemble.varies()) return;
    all.text("contours", "levels of contours", contourText(scene.colour.contours),
             [c](const std::string& text) {
                 Expected<std::vector<double>> levels = contoursFromText(text);
                 if (!levels) return c->report(levels.status()), false;
                 c->workspace.view().colour.contours = std::move(*levels);
                 c->touch();
                 return true;
             });
    all.command("no average", "No average any more", "", [c] {
        showAverage(c->workspace.view(), "");
        c->workspace.view().ensemble = {};
        c->touch();
    });
}

std::vector<Command> ensembleCommands(StudioContext& context) {
    StudioContext* c = &context;
    return {{"Average over random versors: the part of the sets that hold each point", "",
             [c] { run(*c, averageOverVersors); }},
            {"Average over c in a disc, or over another number of the map", "",
             [c] { run(*c, averageOverNumber); }},
            {"Mean of φ over circles of radius r, against r", "",
             [c] { c->show(StudioContext::Strip::profile); }}};
}

}  // namespace versorium
