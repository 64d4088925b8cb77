// SPDX-License-Identifier: MIT
#pragma once
// How values are drawn in the inspector: each from its entry in the tables, by its kind. What needs
// more than that (a palette, a range) has a widget of its own, registered for its path.

#include <initializer_list>
#include <string>

#include "ui/controls/controls.h"

namespace versorium {

// Draws a control and sets what the hand does with it; true where it was set.
bool drawControl(StudioContext& context, const Control& control);
// The same of a value by its path, if it applies and matters now.
bool drawValue(StudioContext& context, const std::string& path);
// A component of a number, such as the real part, beside a pad: with a short label, and no slider.
bool drawComponent(StudioContext& context, const std::string& path);
void drawValues(StudioContext& context, std::initializer_list<const char*> paths);
// All values of a group of the scene that matter now ("colour").
void drawGroup(StudioContext& context, const std::string& group);

}  // namespace versorium
