// SPDX-License-Identifier: MIT
#pragma once
// The widgets of values that need more than their kind gives: one line for each in
// special_widgets.cpp.

#include <string_view>

#include "ui/controls/controls.h"

namespace versorium {

// Draws the control and sets the value; true where it was set.
using SpecialWidget = bool (*)(StudioContext& context, const Control& control);

// Null where the value is drawn by its kind.
SpecialWidget specialWidget(std::string_view path);

}  // namespace versorium
