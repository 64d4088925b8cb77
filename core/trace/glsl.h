// SPDX-License-Identifier: MIT
#pragma once
// Prints a tape as a GLSL ES 3.00 function
//   void mapStep(inout float state[D], const float parameters[P])
// Nothing but the tape's own operations and numbers gets into the text. It relies on the functions
// of the library in render/glsl/shader.h: v_pow, v_atan2, complexPower, quaternionPower, fieldAt,
// listSize, listItem. A fold over a list is a loop over uniform data.

#include <string>

#include "trace/tape.h"

namespace versorium {

std::string glslStep(const Tape& tape);

// A number as a GLSL float literal; infinities and NaN by their bits.
std::string glslFloat(double value);

}  // namespace versorium
