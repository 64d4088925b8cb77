// SPDX-License-Identifier: MIT
#pragma once
// The "web" of a map on a real line: the graph of f, the diagonal, and the path of an orbit between
// them, (x_n, x_n) up to (x_n, x_{n+1}) across to (x_{n+1}, x_{n+1}).

#include <vector>

#include "fields/evaluate.h"

namespace versorium {

// Whether f keeps the line of the first component: every f(x), all others being 0, is real again.
// `program` starts at its slice's (u, v) = (first component, second component or a parameter);
// `second` is what v stands at.
bool keepsRealLine(const OrbitProgram& program, double second);
// f at `count` evenly spaced points of [low, high], the second coordinate being `second`.
std::vector<double> graphOf(const OrbitProgram& program, double second, double low, double high,
                            int count);
// x_0 … x_steps on the line, not cut at the escape radius; ends with what is not finite.
std::vector<double> lineOrbit(const OrbitProgram& program, double second, double x, int steps);

}  // namespace versorium
