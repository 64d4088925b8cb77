// SPDX-License-Identifier: MIT
#pragma once
// Fields that look at every step of an orbit (fields/field_names.h says what each one is).

#include "fields/lanes_of_orbits.h"

namespace versorium {

struct Observed {
    std::vector<double> attractionStep, trap, lyapunov;
};

inline constexpr double kAttractionDifference = 0.0005;  // A 4.3.2, on squared norms
inline constexpr int kLongestPeriod = 4096;
inline constexpr double kPeriodTolerance = 1e-9;  // relative to 1 + |z|

Observed observe(const OrbitProgram& program, OrbitLanes lanes, bool lyapunov);
std::vector<double> distanceEstimates(const OrbitProgram& program, const OrbitLanes& start);
// `last` holds z_N of the orbits that did not escape.
std::vector<double> periodsOf(const OrbitProgram& program, OrbitLanes last,
                              const EscapeResult& escape);

}  // namespace versorium
