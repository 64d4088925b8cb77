// SPDX-License-Identifier: MIT
#pragma once
// How a formula is most likely meant where its letters allow two readings. A name that nobody
// declared and that can be taken apart into known names, as cz or 2iz, is refused with the product
// in real notation: to guess would be silently wrong.

#include <string>
#include <vector>

#include "trace/formula.h"

namespace versorium::formulas {

// What is wrong with an undeclared name; empty where it can only be a name. `others` are all names
// of the formula.
std::string doubtAbout(const std::string& name, FormulaSpace space,
                       const std::vector<std::string>& others);

}  // namespace versorium::formulas
