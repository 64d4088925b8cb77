// SPDX-License-Identifier: MIT
// Commands for what is found out about a map: cycles, manifolds, critical curve, basins, averages.
#include "ui/controls/command_families.h"
#include "ui/session/context.h"
#include "ui/session/ensemble_change.h"
#include "ui/session/planar_change.h"

namespace versorium {
namespace {

void average(StudioContext& context, Status (*over)(Scene&)) {
    const Status status = context.edit([&](Workspace& w) { return over(w.view()); });
    if (!status.ok()) return context.report(status);
    context.welcome = false;
}

void addAverages(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    all.push_back({"average.versors",
                   trLater("Average over random versors"),
                   trLater("The part of the sets that hold each point, when the versor is random."),
                   {},
                   [c] { average(*c, averageOverVersors); }});
    all.push_back({"average.number",
                   trLater("Average over a number of the map"),
                   trLater("The part of the sets that hold each point, when c is drawn from a disc "
                           "or another number from a range."),
                   {},
                   [c] { average(*c, averageOverNumber); }});
    all.push_back(
        {"plot.profile",
         trLater("Plot: mean of φ over circles"),
         trLater("Mean, least and largest φ over circles of radius r about 0, against r."),
         {},
         [c] { c->show(PlotPanel::profile); }});
}

}  // namespace

void addStudyCommands(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    const auto add = [&](Command command) { all.push_back(std::move(command)); };
    add({"cycles",
         trLater("Show or hide fixed points and cycles"),
         trLater("Searches the view for cycles; shape and colour tell attracting from repelling."),
         {},
         [c] { c->edit([](Workspace& w) { w.study.cycles = !w.study.cycles; }); }});
    add({"manifolds",
         trLater("Show or hide manifolds of saddles"),
         trLater("Stable manifolds are blue, unstable ones orange. Maps of the plane have them."),
         {},
         [c] {
             c->edit([](Workspace& w) {
                 w.study.manifolds = !w.study.manifolds;
                 w.study.cycles |= w.study.manifolds;
             });
         }});
    add({"critical.curve",
         trLater("Show or hide the critical curve"),
         trLater("Where det J = 0: the points at which the map folds the plane."),
         {"C"},
         [c] { c->edit([](Workspace& w) { w.study.criticalCurve = !w.study.criticalCurve; }); }});
    add({"basins",
         trLater("Show or hide proved basins"),
         trLater("Where capture or escape is certain, whatever the versor is (S Fig 3)."),
         {"B"},
         [c] { c->edit([](Workspace& w) { w.basins = !w.basins; }); }});
    add({"circles.drop",
         trLater("Add a circle around 0"),
         trLater("Through the pointer, or through the orbit's point: what becomes of its points?"),
         {"O"},
         [c] { dropCircle(*c); }});
    add({"circles.clear",
         trLater("Remove all circles"),
         trLater("Takes the circles away whose points are followed."),
         {},
         [c] {
             c->edit([](Workspace& w) { w.circles.clear(); });
             c->circles.chosen = -1;
         },
         [c] { return !c->workspace.circles.empty(); }});
    add({"as.complex",
         trLater("Show as a complex map"),
         trLater("The same pictures by a complex map, where the planar system is one."),
         {},
         [c] { showAsComplexMap(*c); }});
    add({"as.planar",
         trLater("Show as a planar system"),
         trLater("The same pictures by a planar system, with all its coefficients."),
         {},
         [c] { showAsPlanarSystem(*c); }});
    addAverages(context, all);
}

}  // namespace versorium
