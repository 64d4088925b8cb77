// SPDX-License-Identifier: MIT
#pragma once
// What one step does to points, and how a cycle draws its neighbours to it.

#include <complex>
#include <optional>
#include <vector>

#include "fields/evaluate.h"

namespace versorium {

// The attracting cycle that an orbit comes to: its multiplier is the product of the derivatives
// round it.
struct Cycle {
    int period = 0;
    std::vector<double> point;  // z_N, which lies on it as far as N steps go
    // The largest modulus of an eigenvalue of the Jacobian of f^period there: below 1 attracts.
    double modulus = 0;
    // The multiplier itself, where that Jacobian is a multiplication by a complex number, or where
    // there is but one dimension.
    std::optional<std::complex<double>> multiplier;
};

// The cycle behind the point with these coordinates (one for each axis of the slice); nothing where
// the orbit escapes or none is found (fields/field_names.h, `period`).
std::optional<Cycle> cycleOf(const OrbitProgram& program, const double* coordinates);

// f(z_0) of `count` points with coordinates[axis][i]: one vector for each component of the state.
std::vector<std::vector<double>> imagesOf(const OrbitProgram& program, int count,
                                          const double* const* coordinates);

}  // namespace versorium
