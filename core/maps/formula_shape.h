// SPDX-License-Identifier: MIT
#pragma once
// shape(p) of a typed formula p: the shape modulus of maps/shape_modulus.h run on recording numbers
// around p, so that what is typed and what is built in follow from one definition.

#include "maps/map_info.h"
#include "trace/formula.h"

namespace versorium {

// The parameters that shape(…) brings along, as the parser asks for them, and as maps state them.
const FormulaShape& formulaShape();
std::span<const ParameterInfo> shapeParameters(FormulaSpace space);

// The whole step. `formula` is a shape(p) of z or q; its tape is that of p.
Tape shapeTape(const Formula& formula);

}  // namespace versorium
