// SPDX-License-Identifier: MIT
#pragma once
// What core/ui/session/studies.h finds, drawn on planes of starting points. Cycles are told apart
// by shape and by colour: attracting a disc, repelling a ring, a saddle a cross, neutral a diamond.

#include "dynamics/cycles.h"
#include "ui/session/context.h"
#include "ui/session/view_plane.h"

namespace versorium {

ImU32 cycleColour(CycleKind kind);
void drawCycleMark(ImDrawList& list, ImVec2 at, float size, CycleKind kind);
void drawStudyMarks(StudioContext& context, int view, const ViewPlane& plane, ImDrawList& list);

// A press of the left button: true where it took p* or the second start, which then follow the
// pointer. With Alt it moves p* onto the critical curve where that is drawn, else it sets the
// second start.
bool takeStudyMark(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse,
                   bool alt);
void dragStudyMark(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse);

}  // namespace versorium
