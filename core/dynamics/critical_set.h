// SPDX-License-Identifier: MIT
#pragma once
// Where a map of the plane is not locally invertible: det J = 0 (A 4.2 and the errata). In general
// that is a curve; for a complex-analytic map det J = |f'|² has isolated zeros only, the critical
// points. Any of these points may serve as the start p* of a bifurcation set.

#include <optional>

#include "dynamics/system.h"
#include "jobs/job.h"

namespace versorium {

// The critical points that a map of the line or plane names (maps/critical.h), each once; of a
// planar system that is complex-analytic, or the conjugate of one, the zeros of its derivative.
std::vector<PlanePoint> criticalPointsOf(const System& system);

struct CriticalSet {
    std::vector<Polyline> curves;    // closed ones end at their first point
    std::vector<PlanePoint> points;  // isolated ones: J = 0 there
    bool empty() const { return curves.empty() && points.empty(); }
};

struct CriticalSetOptions {
    int across = 256;  // cells of the grid along the wider side of the window, 8 … 2048
};

// Marching squares on det J at the nodes of a grid; each vertex is then put where det J = 0 along
// its edge, by bisection to 1e-12 of a cell; where det J jumps, as on the folds of the burning
// ship, that is the fold. ErrorKind::usage for maps that are not of the plane.
Expected<CriticalSet> criticalSet(const System& system, const Window& window,
                                  const CriticalSetOptions& options, Job& job);

// The point of the set next to `point`: on the nearest segment or at the nearest isolated point,
// then moved onto det J = 0. Nothing where the set is empty.
std::optional<PlanePoint> nearestCriticalPoint(const System& system, const CriticalSet& set,
                                               PlanePoint point);

}  // namespace versorium
