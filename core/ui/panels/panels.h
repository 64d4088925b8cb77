// SPDX-License-Identifier: MIT
#pragma once
// Panels of the inspector. A panel draws values from their entries (value_widgets.h), or what needs
// more than that, and keeps what it remembers to itself (session/panel_states.h). Panels know
// widgets, the session, controls and what marks draw; no dialog and no plot.

namespace versorium {

struct StudioContext;

void drawInspector(StudioContext& context);
// Instead of the inspector: the controls that the lesson's step or a teacher's link leaves open,
// and those that are locked; false where there is no such choice.
bool drawOpenControls(StudioContext& context);

void drawFormulaChoices(StudioContext& context);  // entries of the list of maps
void drawFormulaPanel(StudioContext& context);    // the field with its faults, below the map
void drawPlanarPanel(StudioContext& context);
void drawShapePanel(StudioContext& context);
void drawVersorPanel(StudioContext& context);
void drawCircleControls(StudioContext& context);
void drawStartControls(StudioContext& context);
void drawCycleControls(StudioContext& context);
void drawComparedControls(StudioContext& context);
void drawPaletteEditor(StudioContext& context);
void drawEnsemble(StudioContext& context);
void drawSpaceView(
    StudioContext& context);  // the slice plane in space; nothing where there is none
void drawLayers(StudioContext& context);

// The chosen stop of an own palette; -1: none.
struct PaletteStopChoice {
    int at = -1;
};

}  // namespace versorium
