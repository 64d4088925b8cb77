// SPDX-License-Identifier: MIT
#pragma once
// Shapes and colours that marks share with plots and panels. Cycles are told apart by shape and by
// colour: attracting a disc, repelling a ring, a saddle a cross, neutral a diamond.

#include "dynamics/cycles.h"
#include "imgui.h"

namespace versorium {

// The colour of the n-th of `steps` points of an orbit.
ImU32 stepColour(int n, int steps, int alpha = 255);
void drawArrow(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 colour, ImU32 halo, float scale);
ImU32 cycleColour(CycleKind kind);
void drawCycleMark(ImDrawList& list, ImVec2 at, float size, CycleKind kind);

}  // namespace versorium
