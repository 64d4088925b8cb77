// SPDX-License-Identifier: MIT
#pragma once
// What is drawn on a view of starting points: the orbit, and arrows from points to their images.

#include "ui/session/context.h"
#include "ui/session/view_plane.h"

namespace versorium {

// The colour of the n-th of `steps` points of an orbit.
ImU32 stepColour(int n, int steps, int alpha = 255);
void drawArrow(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 colour, ImU32 halo, float scale);
void drawOrbit(StudioContext& context, int view, const ViewPlane& plane, ImDrawList& list);
void drawArrows(StudioContext& context, int view, const ViewPlane& plane, ImDrawList& list);
// What becomes of the point under the pointer; into context.probe.
void probe(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse);

}  // namespace versorium
