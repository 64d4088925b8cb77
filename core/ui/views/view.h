// SPDX-License-Identifier: MIT
#pragma once
// Folder views: a view of the studio in its rectangle. Three jobs stand in three places: what the
// pointer does becomes edits (view_input.h), the state becomes the picture that is wanted
// (view_wants.h), and what is there is drawn (view_drawing.h). Beside them the probe under the
// pointer. The folder knows the session and the marks, of which it asks for
// nothing but their table (marks/mark.h); of plots, panels and dialogs it knows nothing.

#include "imgui.h"
#include "ui/marks/view_frame.h"

namespace versorium {

// In this rectangle of the window, in ImGui's coordinates.
void drawView(StudioContext& context, int view, ImVec2 low, ImVec2 high);

// What becomes of the point under the pointer, into context.probe; and the table of that, for the
// inspector.
void probe(const ViewFrame& frame);
void drawProbe(StudioContext& context);

}  // namespace versorium
