// SPDX-License-Identifier: MIT
// The shape, and α and β over space, among the controls that the keyboard and a screen reader
// reach.
#include "ui/controls/control_list.h"
#include "ui/session/shape_change.h"

namespace versorium {
namespace {

void collectModulation(StudioContext& context, ControlList& all, bool alpha) {
    StudioContext* c = &context;
    const std::string id = alpha ? "modulation.alpha." : "modulation.beta.";
    const std::string name = alpha ? "α" : "β";
    const auto specOf = [alpha](auto& scene) -> auto& {
        return alpha ? scene.alphaOverSpace : scene.betaOverSpace;
    };
    const ModulationSpec spec = specOf(context.workspace.view());
    all.values({(id + "shape").c_str()});
    if (!spec.shape.empty())
        all.values(
            {(id + "value").c_str(), (id + "between[0]").c_str(), (id + "between[1]").c_str()});
    all.values({alpha ? "brush.alpha" : "brush.beta"});
    all.command(id + "dab", tr("Paint {1} at the orbit's starting point", {name}), "", [c, alpha] {
        paintAtPoint(*c, alpha ? Drawing::Tool::alpha : Drawing::Tool::beta);
    });
    if (!spec.discs.empty())
        all.command(id + "clear", tr("Take all paint of {1} away", {name}), "", [c, specOf] {
            c->edit([&](Workspace& w) {
                for (Scene& scene : w.views) specOf(scene).discs.clear();
            });
        });
}

}  // namespace

void collectShape(StudioContext& context, ControlList& all) {
    all.begin("Shape");
    StudioContext* c = &context;
    const Scene& scene = context.workspace.view();
    std::vector<std::string> names;
    for (const ShapeChoice& choice : shapeChoices()) names.emplace_back(choice.name);
    all.choice("shape choice", "a shape to begin with", "", names, [c](const std::string& name) {
        for (const ShapeChoice& choice : shapeChoices())
            if (choice.name == name) return c->report(setShape(*c, choice.source));
    });
    const bool field = mapOf(scene).info.field;
    all.text("shape.source", "shape, as a text or corners: polygon(x1, y1, x2, y2, …)",
             field ? scene.shape.source : std::string(), [c, field](const std::string& text) {
                 if (text.empty() && !field) return true;
                 const Status status = setShape(*c, text);
                 c->report(status);
                 return status.ok();
             });
    if (!field) return;
    if (scene.shape.source.starts_with("asset:"))
        all.values({"shape.threshold", "shape.by_alpha", "shape.invert"});
    for (const bool alpha : {true, false}) collectModulation(context, all, alpha);
    if (const std::optional<PlaneInSpace> plane = markedPlane(context)) {
        all.number("slice offset", "how far the slice lies from the origin", planeOffset(*plane),
                   0.01, -1e6, 1e6, [c, plane = *plane](double value) {
                       PlaneInSpace next = plane;
                       next.origin += (value - planeOffset(plane)) * plane.normal();
                       putPlane(*c, next);
                   });
        const auto tilt = [c, plane = *plane](bool about, double angle) {
            const std::vector<double>& centre = c->workspace.view().slice.centre;
            putPlane(*c,
                     turned(plane, centre[0], centre[1], about ? plane.up : plane.right, angle));
        };
        constexpr double kTilt = 0.0872664626;  // 5 degrees
        all.command("tilt right", "Tilt the slice about its upward axis", "",
                    [tilt] { tilt(true, kTilt); });
        all.command("tilt left", "Tilt it back", "", [tilt] { tilt(true, -kTilt); });
        all.command("tilt up", "Tilt the slice about its axis to the right", "",
                    [tilt] { tilt(false, kTilt); });
        all.command("tilt down", "Tilt it down", "", [tilt] { tilt(false, -kTilt); });
    }
    all.values({"brush.radius", "brush.erases", "brush.overlay"});
}

}  // namespace versorium
