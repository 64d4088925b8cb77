// SPDX-License-Identifier: MIT
#pragma once
// Approximate critical points of the complex maps that are given by roots, all at once, by the
// method of Aberth and Ehrlich: for a polynomial h of degree D, D approximations z_i repel each
// other like charges,
//   z_i <- z_i - 1 / (h'(z_i)/h(z_i) - Σ_{j≠i} 1/(z_i - z_j)),
// and h'/h follows from sums over the roots, so that h is never multiplied out.
//   Newton's map   N' = 1 + a S'/S², S = Σ mᵢ/(z - rᵢ):  h = (S² + a S') Π (z - rᵢ)², where simple
//                  roots (m² = a m) are zeros that are known. The others of p are those of p''.
//   rational maps  R'/R = L = Σ eᵢ/(z - cᵢ) over roots and poles:  h = L Π (z - cᵢ).

#include <vector>

#include "maps/catalogue.h"
#include "math/complex.h"

namespace versorium {

// Empty for other maps, and for lists too long to be solved at each pixel.
std::vector<Complex<double>> criticalStarts(const MapKernels& map, const double* parameters,
                                            const Environment<double>& environment);

}  // namespace versorium
