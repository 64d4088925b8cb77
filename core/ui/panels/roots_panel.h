// SPDX-License-Identifier: MIT
#pragma once
// The versor's part of the inspector and of the list of controls.

namespace versorium {

struct StudioContext;
class ControlList;

// Nothing where the map has no lists of roots.
void drawVersorPanel(StudioContext& context);
void collectVersor(StudioContext& context, ControlList& all);

}  // namespace versorium
