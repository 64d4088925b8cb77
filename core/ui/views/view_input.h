// SPDX-License-Identifier: MIT
#pragma once
// The hand on a view becomes edits of the workspace. A tool in the hand comes first, then the marks
// (marks/mark.h), then the view itself: drag pans, the wheel zooms at the pointer, a box drawn with
// the right button is zoomed to, a double click goes in. Two fingers come from the shell
// (StudioContext::pinch) and let go of whatever one of them had begun.

#include "ui/marks/view_frame.h"

namespace versorium {

// What ImGui says of the pointer; `over` and `held` are those of the view's own item.
Pointer readPointer(bool over, bool held);
void takeInput(const ViewFrame& frame);

}  // namespace versorium
