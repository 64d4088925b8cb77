// SPDX-License-Identifier: MIT
#pragma once
// What a view shows follows from the state alone: the scene, what it is told apart by, where its
// starting points are measured, and the place. The picture is asked for it, and comes when it can.

#include "ui/session/context.h"

namespace versorium {

// Of this place; the GPU may draw on for about so many seconds.
void wantPicture(StudioContext& context, int view, const Viewport& place, double seconds);

}  // namespace versorium
