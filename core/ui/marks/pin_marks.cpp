// SPDX-License-Identifier: MIT
// Pins: parameters that are kept at hand, drawn on planes of parameters. Shift and a click pins
// those that are shown.
#include "ui/marks/mark.h"

namespace versorium {
namespace {

void drawPins(const ViewFrame& frame) {
    const Scene& scene = frame.scene();
    if (!traitsOf(scene).pins) return;
    const Workspace& workspace = frame.workspace();
    for (std::size_t k = 0; k < workspace.pins.size(); ++k) {
        Scene pinned = scene;
        pinned.parameters = workspace.pins[k];
        const auto at = markerOf(pinned, scene.slice);
        drawMark(frame.list(), frame.plane.at(at[0], at[1]), 7 * frame.scale(),
                 static_cast<MarkShape>(k), pinColour(static_cast<int>(k)));
    }
}

std::optional<Drag> pressPin(const ViewFrame& frame) {
    if (!frame.pointer.shift) return std::nullopt;
    frame.context.edit([](Workspace& workspace) {
        if (workspace.pins.size() == kMostPins) workspace.pins.erase(workspace.pins.begin());
        workspace.pins.push_back(workspace.views[workspace.speaker()].parameters);
    });
    return Drag{};
}

}  // namespace

const Mark pinMark{.draw = drawPins, .press = pressPin};

}  // namespace versorium
