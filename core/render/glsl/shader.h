// SPDX-License-Identifier: MIT
#pragma once
// The GLSL ES 3.00 frames around a map's generated step: source text only. Lists of roots come as a
// texture (RGBA32F, two rows a list: components, then powers), the distance grid as a 3D texture
// (R32F) that is interpolated by hand. An override sets one component of a root.

#include <string>

#include "trace/tape.h"

namespace versorium {

// What every fragment shader begins with: the version, and all precisions.
extern const char* const kShaderHead;

// Takes a pixel through the slice and iterates until escape, a few steps at a time, with the
// orbit's state kept in textures between draws:
//   outFields  (n, squared norm of the last iterate, 1 when escaped, attraction step or 0)
//   outState   z_n
//   outImage   f(z_0), written by the first draw only
// `shape` is the recorded distance of an analytic shape (3 numbers of state; its constants are its
// parameters) or null for a grid. `attraction` bounds squared differences of squared norms.
std::string iterationShader(const Tape& tape, const Tape* shape, double attraction);

// Members of an ensemble (fields/ensemble.h), a few in each draw: each runs its orbit from the
// start to the end, and those whose set holds the pixel are counted.
//   outFields  (members counted so far, 0, 0, 0)
// uRoots has three rows more for each member: components and powers of the roots of the list that
// is drawn (the second component of the first power says how many; the third one of a root in the
// plane is its power again), and numbers that are drawn (value, place among uNumbers), of which
// there are `drawn`.
std::string countingShader(const Tape& tape, const Tape* shape, int drawn);

}  // namespace versorium
