// SPDX-License-Identifier: MIT
#pragma once
// How a formula behaves at infinity, from its expression: |f(z)| ~ a |z|^g. Products add their g,
// quotients subtract them, powers multiply them, sums take the largest, conj, abs and re keep it,
// norm doubles it. Transcendental functions of what grows have no such g.

#include <optional>
#include <vector>

#include "math/complex.h"
#include "math/dual.h"
#include "trace/formula.h"

namespace versorium {

// g for these parameters, component by component; nothing where it cannot be found. Parameters that
// vary in a picture are taken for numbers that are not known, and are not 0. In the plane the
// larger of both formulas.
std::optional<double> growthOf(const Formula& formula, const double* parameters,
                               const std::vector<bool>& varies = {});

// f(∞) of a complex formula where it is finite, as far as its form says so.
std::optional<Complex<double>> valueAtInfinity(const Formula& formula, const double* parameters);
std::optional<Complex<Dual<double>>> valueAtInfinity(const Formula& formula,
                                                     const Dual<double>* parameters);

}  // namespace versorium
