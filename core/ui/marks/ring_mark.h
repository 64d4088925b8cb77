// SPDX-License-Identifier: MIT
#pragma once
// The ring is the workspace's point, which every view shows; it lies on top of all other marks.

#include "ui/marks/mark.h"

namespace versorium {

inline constexpr float kPointReach =
    16;  // of the ring and of the places of an analysis, at scale 1

// The pointer is on the ring itself, which then is meant, whatever lies below.
bool onRing(const ViewFrame& frame);
// The point follows the pointer; `mark` is what stands for it.
Drag dragPoint(const Mark& mark, int item);
// The view is the first of an analysis: four places stand there for the one ring.
bool showsPlaces(const ViewFrame& frame);

}  // namespace versorium
