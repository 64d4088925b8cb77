// SPDX-License-Identifier: MIT
#pragma once
// What the studio draws over a plane of starting points, on the panels of a step's plate: the orbit
// and its start, circles that were dropped, roots and poles, and what is studied.

#include "plate/plate.h"
#include "workspace/workspace.h"

namespace versorium {

// The first panels are those of the workspace's views, in their order.
void markPanels(const Workspace& workspace, Plate& plate);

}  // namespace versorium
