// SPDX-License-Identifier: MIT
#pragma once
// Roots and poles on planes of starting points: a zero is a circle with its power, a pole a cross.
// They are dragged, raised by the wheel, added by a double click, and taken away by Delete or a
// menu. A root that does not lie in the plane is fainter and is moved along the plane's axes.

#include "ui/session/context.h"
#include "ui/session/view_plane.h"

namespace versorium {

void drawRootMarks(StudioContext& context, int view, const ViewPlane& plane, ImDrawList& list);
// The menu of the root that was clicked with the right button, while it is open.
void drawRootMenu(StudioContext& context);

// A press of the left button: true where it took a root, which then follows the pointer.
bool takeRootMark(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse);
void dragRootMark(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse);
// A press of the right button: true where it opened a root's menu.
bool openRootMenu(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse);
// The wheel over a root: a step of 1, or with Shift of 0.1. False where none is there.
bool raiseRoot(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse, float wheel,
               bool fine);
// A double click: true where it made a root, or met one.
bool addRootAt(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse);

// Adds to a list, or to the map's first one, at the orbit's point; takes the chosen root away.
void addRootAtPoint(StudioContext& context, const std::string& list = {});
void removeChosenRoot(StudioContext& context);

}  // namespace versorium
