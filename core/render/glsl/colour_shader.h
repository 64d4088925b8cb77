// SPDX-License-Identifier: MIT
#pragma once
// The second pass as a fragment shader: kept orbits become fields (fields/field_names.h, as
// fields/evaluate.cpp computes them) and fields become colours (colour/scale.h, colour/rules.h).
// One program serves all scenes; what differs comes as uniforms. Row 0 of what it draws is the top
// of the picture, while kept orbits have their row 0 at the bottom.

#include <string>

namespace versorium {

// Values of uRule; `raw` writes the field's own numbers.
// Beside the colour rules: the field as it is.
inline constexpr int kRawRule = 5;

std::string colourShader();
// Lines along which the shown field has a value; more of them are the CPU's.
inline constexpr int kMostGpuContours = 16;

}  // namespace versorium
