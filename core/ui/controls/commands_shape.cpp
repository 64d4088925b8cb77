// SPDX-License-Identifier: MIT
// Commands for shapes and versors: drawing, painting, roots and poles.
#include "ui/controls/command_families.h"
#include "ui/session/context.h"
#include "ui/session/root_edit.h"
#include "ui/session/shape_change.h"

namespace versorium {
namespace {

void removeChosen(StudioContext& context) {
    if (context.circles.chosen >= 0)
        removeCircle(context, context.circles.chosen);
    else
        removeChosenRoot(context);
}

void addRoots(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    const auto add = [&](Command command) { all.push_back(std::move(command)); };
    add({"roots.show",
         trLater("Show or hide roots and poles"),
         trLater("A zero is a circle with its power, a pole a cross. Drag them in the views."),
         {"V"},
         [c] { c->edit([](Workspace& w) { w.showRoots = !w.showRoots; }); }});
    add({"roots.add",
         trLater("Add a root at the orbit's point"),
         trLater("A zero of the versor; its power may be negative, which makes it a pole."),
         {},
         [c] { addRootAtPoint(*c); }});
    add({"roots.remove",
         trLater("Remove the chosen root or circle"),
         trLater("The one that was clicked last."),
         {"Delete"},
         [c] { removeChosen(*c); },
         [c] {
             // Stops of a palette are taken away by the same key, with the pointer over them.
             return c->probe.view >= 0 &&
                    (c->circles.chosen >= 0 || isRoot(c->workspace, c->versor.chosen));
         }});
    add({"roots.random",
         trLater("Roots at random: the next seed"),
         trLater("Draws the roots anew, by the next number in place of the last."),
         {"S", false, true},
         [c] {
             const int seed = c->versor.draw.seed;
             drawRoots(*c, seed == kMostSeed ? 0 : seed + 1);
         }});
    add({"versor.product",
         trLater("Versor d from the product over its roots"),
         trLater("d is the product of the factors of its roots, divided by its modulus."),
         {},
         [c] { c->edit([](Workspace& w) { takeRootSum(w, false); }); }});
    add({"versor.sum",
         trLater("Versor d from the sum over its roots"),
         trLater("d is the sum of the terms of its roots, divided by its modulus."),
         {},
         [c] { c->edit([](Workspace& w) { takeRootSum(w, true); }); }});
    add({"versor.candidates",
         trLater("Candidates for the versor d"),
         trLater("A sheet of pictures, each by other random roots. Pick one."),
         {"S"},
         [c] { openContactSheet(*c, c->versor.draw.seed); }});
}

}  // namespace

void addShapeCommands(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    const auto add = [&](Command command) { all.push_back(std::move(command)); };
    add({"draw.outline",
         trLater("Draw the outline of a shape"),
         trLater("In one stroke, or corner by corner, in a view: its Julia set appears."),
         {"D"},
         [c] { chooseTool(*c, Drawing::Tool::outline); }});
    add({"paint.alpha",
         trLater("Paint α"),
         trLater("A brush that changes α where it goes. Escape lays it down."),
         {},
         [c] { chooseTool(*c, Drawing::Tool::alpha); }});
    add({"paint.beta",
         trLater("Paint β"),
         trLater("A brush that changes β where it goes. Escape lays it down."),
         {},
         [c] { chooseTool(*c, Drawing::Tool::beta); }});
    add({"views.modulus",
         trLater("Modulus, versor, log-modulus and members side by side"),
         trLater("Four views of one map, as in S Fig 2."),
         {"M"},
         [c] { showModulusAndVersor(*c); }});
    add({"views.printed",
         trLater("φ − β beside φ + β as printed"),
         trLater(
             "S eq 2 prints φ + β, by which β > 0 shrinks the shape; the authors compute φ − β."),
         {},
         [c] { showAsPrinted(*c); }});
    addRoots(context, all);
}

}  // namespace versorium
