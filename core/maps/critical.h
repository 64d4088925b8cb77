// SPDX-License-Identifier: MIT
#pragma once
// Critical points p* of a map, from which bifurcation sets start (A 4.2, A8). Closed forms where a
// map has them. Other maps of the plane are solved: a point where ∂F/∂x = 0, found by Newton's
// method, with second derivatives by duals of duals, from the approximations of
// maps/critical_starts.h or from a grid of starts. For a complex-analytic map
// that is f' = 0; for any planar map it makes det J = 0. Points that are fixed by the map (the
// roots under Newton's map) come last; within each group they are ordered by x, then y. Where a
// formula has a finite value at infinity and is no local bijection there, infinity is a critical
// point, behind all others: its orbit goes on with f(infinity), which stands for it, as it does for
// a multiple pole (1/z^2 + c: 0 -> infinity -> c). Multiple
// roots of rational maps, where the derivative has no direction, are not among them; on a planar
// system only points that one of 25 starts leads to are.

#include <vector>

#include "maps/catalogue.h"

namespace versorium {

// Whether the map may have critical points that can be named at all.
bool hasCriticalPoints(const MapKernels& map);

// Whether critical points may move with a number: of the parameters, component by component, and
// behind them one for each override. What a typed formula adds, or is multiplied by, moves none.
bool movesCritical(const MapKernels& map, int number);

// The k-th critical point for these parameters; false where there is none. `slope`, when not null,
// receives its derivative along the direction of `parameterSlopes` and `overrideSlopes`, one for
// each override of the environment.
bool criticalPoint(const MapKernels& map, int k, const double* parameters,
                   const Environment<double>& environment, double* point,
                   const double* parameterSlopes = nullptr, const double* overrideSlopes = nullptr,
                   double* slope = nullptr);

}  // namespace versorium
