// SPDX-License-Identifier: MIT
// The versor's part of the list of controls: its roots as numbers, roots at random, circles.
#include <algorithm>
#include <cmath>

#include "ui/controls/control_list.h"
#include "ui/session/context.h"
#include "ui/session/root_edit.h"

namespace versorium {
namespace {

// Longer lists are reached root by root in the views.
constexpr std::size_t kMostListed = 64;

void collectRoots(StudioContext& context, ControlList& all) {
    StudioContext* c = &context;
    const Workspace& workspace = context.workspace;
    const bool complex = mapOf(workspace.views[0]).info.algebra == Algebra::complex;
    const std::vector<std::string> parts = complex ? std::vector<std::string>{"re", "im"}
                                                   : std::vector<std::string>{"w", "x", "y", "z"};
    std::vector<std::string> names;
    for (const auto& [name, list] : workspace.views[0].lists) {
        names.push_back(name);
        for (std::size_t k = 0; k < std::min(kMostListed, list.roots.size()); ++k) {
            const RootRef ref{name, static_cast<int>(k)};
            const std::string id = name + "[" + std::to_string(k) + "].";
            for (const std::string& part : parts) all.values({(id + part).c_str()});
            all.values({(id + "power").c_str()});
            all.command(id + "remove", tr("{1}: take it away", {id.substr(0, id.size() - 1)}), "",
                        [c, ref] {
                            c->versor.chosen = ref;
                            removeChosenRoot(*c);
                        });
        }
    }
    all.choice("add root", "add a root or pole at the orbit's point", "", names,
               [c](const std::string& list) { addRootAtPoint(*c, list); });
    all.values({"show_roots"});
    if (!sumOrProductOf(workspace.views[0].map).empty())
        all.choice("versor from", "versor d from the product or the sum over its roots",
                   isRootSum(workspace.views[0].map) ? "sum" : "product", {"product", "sum"},
                   [c](const std::string& word) {
                       c->edit([&](Workspace& w) { takeRootSum(w, word == "sum"); });
                   });
}

void collectRandom(StudioContext& context, ControlList& all) {
    StudioContext* c = &context;
    all.values({"random.least", "random.most", "random.low", "random.high", "random.whole_powers",
                "random.arrangement", "random.clusters", "random.cluster_size", "random.ball",
                "random.seed"});
    all.command("draw roots", "Draw the roots of the seed", "",
                [c] { drawRoots(*c, c->versor.draw.seed); });
    all.values({"sheet.candidates"});
    // The sheet's candidates, one of which may be taken without seeing them.
    for (std::size_t k = 0; context.dialogs.candidates && k < context.sheet.candidates.size(); ++k)
        all.command("candidate " + std::to_string(k + 1),
                    tr("Take the candidate of seed {1}",
                       {std::to_string(context.sheet.candidates[k].seed)}),
                    "", [c, k] {
                        pickCandidate(*c, static_cast<int>(k));
                        c->dialogs.candidates = false;
                    });
}

void collectCircles(StudioContext& context, ControlList& all) {
    all.begin("Basins and circles");
    StudioContext* c = &context;
    const Workspace& workspace = context.workspace;
    all.values({"basins"});
    all.command("drop circle", "Drop a circle around 0", "O", [c] { dropCircle(*c); });
    const MapKernels& map = mapOf(workspace.views[0]);
    for (std::size_t k = 0; k < workspace.circles.size(); ++k) {
        const std::string id = "circles[" + std::to_string(k) + "].";
        const std::string number = std::to_string(k + 1);
        all.values({(id + "radius").c_str()});
        for (int i = 0; i < map.dimension; ++i)
            all.values({(id + "center[" + std::to_string(i) + "]").c_str()});
        all.command(id + "remove", tr("circle {1}: take it away", {number}), "",
                    [c, k] { removeCircle(*c, static_cast<int>(k)); });
    }
}

}  // namespace

void collectVersor(StudioContext& context, ControlList& all) {
    if (hasRoots(context.workspace)) {
        all.begin("Versor: roots and poles");
        collectRoots(context, all);
        collectRandom(context, all);
    }
    if (takesCircles(context.workspace)) collectCircles(context, all);
}

}  // namespace versorium
