// SPDX-License-Identifier: MIT
// The averages of the focused view as controls and as commands.
#include <algorithm>
#include <cmath>

#include "ui/controls/control_list.h"
#include "ui/session/context.h"
#include "ui/session/ensemble_change.h"

namespace versorium {
namespace {

void collectNumbers(StudioContext& context, ControlList& all, const Scene& scene) {
    const EnsembleSpec& ensemble = scene.ensemble;
    StudioContext* c = &context;
    for (std::size_t k = 0; k < ensemble.ranges.size(); ++k) {
        const EnsembleRange& range = ensemble.ranges[k];
        const std::string path = "ensemble.ranges[" + std::to_string(k) + "]";
        all.values({(path + ".from").c_str(), (path + ".to").c_str()});
        all.command("ensemble keep " + range.name, tr("Draw {1} no longer", {range.name}), "",
                    [c, k] {
                        c->edit([&](Workspace& w) {
                            auto& ranges = w.view().ensemble.ranges;
                            ranges.erase(ranges.begin() + static_cast<std::ptrdiff_t>(k));
                        });
                    });
    }
    for (std::size_t k = 0; k < ensemble.discs.size(); ++k) {
        const EnsembleDisc& disc = ensemble.discs[k];
        const std::string path = "ensemble.discs[" + std::to_string(k) + "]";
        all.values({(path + ".center[0]").c_str(), (path + ".center[1]").c_str(),
                    (path + ".radius").c_str()});
        all.command("ensemble keep " + disc.name, tr("Draw {1} no longer", {disc.name}), "",
                    [c, k] {
                        c->edit([&](Workspace& w) {
                            auto& discs = w.view().ensemble.discs;
                            discs.erase(discs.begin() + static_cast<std::ptrdiff_t>(k));
                        });
                    });
    }
    const auto more = [&](const char* id, const char* label, std::vector<std::string> names,
                          void (*add)(Scene&, const std::string&)) {
        if (!names.empty())
            all.choice(
                id, label, "", names,
                [c, add](const std::string& name) {
                    c->edit([&](Workspace& w) { add(w.view(), name); });
                },
                names);
    };
    more("ensemble range", "draw a number from a range", freeRanges(scene), addRange);
    more("ensemble disc", "draw a complex number from a disc", freeDiscs(scene), addDisc);
}

}  // namespace

void collectEnsemble(StudioContext& context, ControlList& all) {
    all.begin("Average over random maps, focused view");
    StudioContext* c = &context;
    const Scene& scene = context.workspace.view();
    const EnsembleSpec& ensemble = scene.ensemble;
    if (!mapOf(scene).info.lists.empty())
        all.toggle("ensemble roots", "random roots", ensemble.roots.has_value(), [c](bool on) {
            c->report(c->edit([on](Workspace& w) {
                if (on) return averageOverVersors(w.view());
                w.view().ensemble.roots.reset();
                return Status();
            }));
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
                       c->edit([&](Workspace& w) {
                           showAverage(w.view(), fields[static_cast<std::size_t>(k)]);
                       });
                   });
        all.values({"ensemble.count", "ensemble.seed", "ensemble.set"});
        if (ensemble.roots) all.group("ensemble.roots");
    }
    collectNumbers(context, all, scene);
    if (!ensemble.varies()) return;
    all.command("no average", "No average any more", "", [c] {
        c->edit([](Workspace& w) {
            showAverage(w.view(), "");
            w.view().ensemble = {};
        });
    });
}

}  // namespace versorium
