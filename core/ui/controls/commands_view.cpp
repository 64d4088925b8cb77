// SPDX-License-Identifier: MIT
// Commands for the views: where they are, how many there are, how they are coloured, and the orbit.
#include <algorithm>

#include "ui/controls/command_families.h"
#include "ui/session/context.h"

namespace versorium {
namespace {

void zoomAtCentre(StudioContext& context, double factor) {
    const auto& centre = context.workspace.view().slice.centre;
    context.zoom(context.workspace.focused, factor, centre[0], centre.size() > 1 ? centre[1] : 0,
                 true);
}

void setViews(StudioContext& context, int count) {
    context.edit([count](Workspace& w) { setViewCount(w, count); });
}

void showAnalysis(StudioContext& context) {
    if (!context.edit([](Workspace& w) { return setAnalysis(w); }))
        context.say("This map has no two parameters that could be the axes of a set");
}

void showBands(StudioContext& context) {
    Scene scene = context.workspace.view();
    context.edit([&](Workspace& w) {
        setViewCount(w, 2);
        scene.colour.rule = ColourRule::gradient;
        scene.colour.smoothing = Smoothing::none;
        w.views[0] = scene;
        scene.colour.smoothing = Smoothing::ratio;
        w.views[1] = std::move(scene);
    });
}

void nextPalette(StudioContext& context) {
    const std::vector<std::string> names = paletteNames();
    context.edit([&](Workspace& w) {
        Colouring& colour = w.view().colour;
        colour.ownPalette = nullptr;
        const auto found = std::find(names.begin(), names.end(), colour.palette);
        const bool last = found == names.end() || found + 1 == names.end();
        colour.palette = last ? names.front() : *(found + 1);
    });
}

void addPlaces(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    const auto add = [&](Command command) { all.push_back(harmless(std::move(command))); };
    add({"view.home",
         trLater("Home"),
         trLater("The focused view goes back to the place it began with."),
         {"Home"},
         [c] { c->home(c->workspace.focused); }});
    add({"view.back",
         trLater("Back in the view's history"),
         trLater("The place that the focused view showed before."),
         {"Backspace"},
         [c] { c->goInHistory(c->workspace.focused, -1); }});
    add({"view.forward",
         trLater("Forward in the view's history"),
         trLater("The place that the focused view showed before you went back."),
         {"Backspace", false, true},
         [c] { c->goInHistory(c->workspace.focused, 1); }});
    add({"view.zoom.in",
         trLater("Zoom in"),
         trLater("Goes into the middle of the focused view."),
         {"+"},
         [c] { zoomAtCentre(*c, 0.8); }});
    add({"view.zoom.out",
         trLater("Zoom out"),
         trLater("Shows more around the middle of the focused view."),
         {"-"},
         [c] { zoomAtCentre(*c, 1.25); }});
    add({"view.maximise",
         trLater("Maximise the focused view, or show all"),
         trLater("One view fills the window; the same key brings the others back."),
         {"F"},
         [c] { c->edit([](Workspace& w) { w.maximised = !w.maximised; }); }});
}

void addLayouts(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    const auto add = [&](Command command) { all.push_back(std::move(command)); };
    add({"views.one", trLater("One view"), trLater("Keeps the focused view alone."), {}, [c] {
             setViews(*c, 1);
         }});
    add({"views.two",
         trLater("Two views"),
         trLater("Parameters beside starting points: each point of one is a picture of the other."),
         {},
         [c] { setViews(*c, 2); }});
    add({"views.four",
         trLater("Four views"),
         trLater("Four views of one map, each with its own place and colours."),
         {},
         [c] { setViews(*c, 4); }});
    add({"views.analysis",
         trLater("Analysis: a set of parameters with four places in it"),
         trLater("One set of parameters, and beside it the starting points of four of its places."),
         {"N"},
         [c] { showAnalysis(*c); }});
    add({"views.bands",
         trLater("Bands beside smooth colours"),
         trLater("The same view twice: whole escape steps, and A eqs 14 and 15 between them."),
         {},
         [c] { showBands(*c); }});
    for (int k = 0; k < kMostViews; ++k) {
        const std::string number = std::to_string(k + 1);
        add({"view.focus." + number,
             tr("Focus view {1}", {number}),
             trLater("Commands and the inspector are about the focused view."),
             {number},
             [c, k] { c->focus(k); },
             [c, k] { return k < static_cast<int>(c->workspace.views.size()); }});
    }
}

}  // namespace

void addViewCommands(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    addPlaces(context, all);
    addLayouts(context, all);
    const auto add = [&](Command command) { all.push_back(std::move(command)); };
    add({"palette.next",
         trLater("Next palette"),
         trLater("The focused view takes the next of the built-in palettes."),
         {"P"},
         [c] { nextPalette(*c); }});
    add({"pins.clear",
         trLater("Remove all pins"),
         trLater("Pins mark parameters that you kept by Shift and a click."),
         {},
         [c] { c->edit([](Workspace& w) { w.pins.clear(); }); },
         [c] { return !c->workspace.pins.empty(); }});
    add(harmless({"orbit.forward",
                  trLater("One step on along the orbit"),
                  trLater("The next point of the orbit is marked; at its end the orbit grows."),
                  {"."},
                  [c] { c->stepOrbit(1); }}));
    add(harmless({"orbit.back",
                  trLater("One step back along the orbit"),
                  trLater("The point before is marked."),
                  {","},
                  [c] { c->stepOrbit(-1); }}));
    add({"arrows",
         trLater("Show or hide arrows from x to f(x)"),
         trLater("A grid of arrows in views of starting points: where one step takes each point."),
         {"A"},
         [c] { c->edit([](Workspace& w) { w.arrows = !w.arrows; }); }});
    add(harmless({"plot.series",
                  trLater("Plot: orbit as a time series"),
                  trLater("The orbit's numbers against the step n."),
                  {},
                  [c] { c->show(PlotPanel::series); }}));
    add(harmless(
        {"plot.web",
         trLater("Plot: orbit as a cobweb diagram"),
         trLater("The graph of f with the orbit between it and the diagonal, where the map "
                 "keeps a real line."),
         {},
         [c] { c->show(PlotPanel::web); }}));
    add(harmless({"plot.diagram",
                  trLater("Plot: bifurcation diagram"),
                  trLater("The attractor against one parameter. Drag in it to set the parameter."),
                  {},
                  [c] { c->show(PlotPanel::diagram); }}));
}

}  // namespace versorium
