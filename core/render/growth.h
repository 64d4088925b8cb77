// SPDX-License-Identifier: MIT
#pragma once
// How fast the map of a scene grows at infinity, |f(z)| ~ |z|^d: what escape times are smoothed
// with.

#include "fields/evaluate.h"
#include "scene/scene.h"

namespace versorium {

// d > 1, or 0 where it has to be measured along each orbit: no such d is known, it is no larger
// than 1, or it differs from pixel to pixel. The program's slice and lists are bound.
double growthAtInfinity(const Scene& scene, const OrbitProgram& program);

}  // namespace versorium
