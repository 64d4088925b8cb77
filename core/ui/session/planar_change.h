// SPDX-License-Identifier: MIT
#pragma once
// A complex polynomial is a planar system that satisfies the Cauchy-Riemann equations (A eq 7): the
// same pictures, told by the other of the two maps.

#include <optional>

#include "dynamics/planar_system.h"
#include "ui/session/context.h"

namespace versorium {

// The 30 coefficients of a scene of a planar polynomial system.
PlanarNumbers planarNumbersOf(const Scene& scene);
// The polynomial of degree 1 … 4 that a complex map is with the numbers that are shown; nothing
// where it is none. Read off its values at eight points, and checked at others to 1e-9.
std::optional<ComplexPolynomial> polynomialOf(StudioContext& context);

// Whether there is such a map to go to, and the way there; views, places, colours and the orbit
// stay. The complex map is z² + c, z^d + c, z³ + az + b, else a formula.
bool hasComplexForm(const StudioContext& context);
void showAsComplexMap(StudioContext& context);
void showAsPlanarSystem(StudioContext& context);

}  // namespace versorium
