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

void collectNumbers(StudioContext& context, ControlList& all, Scene& scene) {
    EnsembleSpec& ensemble = scene.ensemble;
    StudioContext* c = &context;
    for (std::size_t k = 0; k < ensemble.ranges.size(); ++k) {
        const EnsembleRange& range = ensemble.ranges[k];
        const std::string path = "ensemble.ranges[" + std::to_string(k) + "]";
        all.values({(path + ".from").c_str(), (path + ".to").c_str()});
        all.command("ensemble keep " + range.name, tr("Draw {1} no longer", {range.name}), "",
                    [c, k] {
                        auto& ranges = c->workspace.view().ensemble.ranges;
                        ranges.erase(ranges.begin() + static_cast<std::ptrdiff_t>(k));
                        c->touch();
                    });
    }
    for (std::size_t k = 0; k < ensemble.discs.size(); ++k) {
        const EnsembleDisc& disc = ensemble.discs[k];
        const std::string path = "ensemble.discs[" + std::to_string(k) + "]";
        all.values({(path + ".center[0]").c_str(), (path + ".center[1]").c_str(),
                    (path + ".radius").c_str()});
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
        all.values({"ensemble.count", "ensemble.seed", "ensemble.set"});
        if (ensemble.roots) all.group("ensemble.roots");
    }
    collectNumbers(context, all, scene);
    if (!ensemble.varies()) return;
    all.command("no average", "No average any more", "", [c] {
        showAverage(c->workspace.view(), "");
        c->workspace.view().ensemble = {};
        c->touch();
    });
}

std::vector<Command> ensembleCommands(StudioContext& context) {
    StudioContext* c = &context;
    return {{"average.versors",
             trLater("Average over random versors: the part of the sets that hold each point"),
             {},
             [c] { run(*c, averageOverVersors); }},
            {"average.number",
             trLater("Average over c in a disc, or over another number of the map"),
             {},
             [c] { run(*c, averageOverNumber); }},
            {"plot.profile", trLater("Mean of φ over circles of radius r, against r"), {}, [c] {
                 c->show(Strip::profile);
             }}};
}

}  // namespace versorium
