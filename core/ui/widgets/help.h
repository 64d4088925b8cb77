// SPDX-License-Identifier: MIT
#pragma once
// What every control is for, in one or two plain sentences: shown while the pointer rests on it, or
// while it has the keyboard's focus.

#include <string_view>

namespace versorium {

// Empty where there is none.
std::string_view helpOf(std::string_view control);
// Explains the control that was drawn last.
void explain(std::string_view control);
// The same with a text of its own, such as a parameter's.
void explainBy(std::string_view text);

}  // namespace versorium
