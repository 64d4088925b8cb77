// SPDX-License-Identifier: MIT
#pragma once
// Fixed points and cycles of maps of the line and of the plane (real or complex), found by Newton's
// method on fⁿ(x) - x from a grid of starts, whether they attract or not. The eigenvalues of the
// Jacobian of fⁿ round a cycle of period n say what it does to its neighbours.
//
// A grid misses cycles whose basins under Newton's method are small: what is found is a list of
// cycles, each of them true, and not a proof that there are no others.

#include <complex>
#include <optional>
#include <string>

#include "dynamics/system.h"
#include "jobs/job.h"

namespace versorium {

// By the moduli of the eigenvalues: all below 1, all above 1, one on each side; neutral where one
// of them is 1 to about seven digits (area-preserving maps have whole families of such cycles).
enum class CycleKind { attracting, repelling, saddle, neutral };
const char* wordOf(CycleKind kind);

struct PeriodicCycle {
    int period = 1;  // the least one
    // In the order in which the map takes them; the first is the least by x, then y.
    std::vector<PlanePoint> points;  // y is 0 on the line
    // Of the Jacobian of f^period, the largest modulus first; one on the line, two in the plane.
    std::vector<std::complex<double>> eigenvalues;
    // The derivative of f^period where that is one number: on the line, and where the Jacobian is a
    // multiplication by a complex number. Of a map with complex numbers as its state only.
    std::optional<std::complex<double>> multiplier;
    CycleKind kind = CycleKind::neutral;
};

struct CycleOptions {
    int maxPeriod = 4;  // 1 … kMostPeriod
    int across = 0;     // starts along each side of the window; 0: as many as the period asks for
    int mostCycles = 2000;
};
inline constexpr int kMostPeriod = 64;
inline constexpr int kMostStartsAcross = 1000;

struct CycleSearch {
    std::vector<PeriodicCycle> cycles;  // by period, then by the first point
    bool cut = false;                   // there were more than mostCycles
};

// Cycles with a point in the window. ErrorKind::usage for maps of more than two dimensions and for
// options out of range.
Expected<CycleSearch> findCycles(const System& system, const Window& window,
                                 const CycleOptions& options, Job& job);

// The cycle of a point that returns after `period` steps, to rounding; its least period.
PeriodicCycle cycleThrough(const System& system, const double* point, int period);

}  // namespace versorium
