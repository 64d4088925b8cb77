// SPDX-License-Identifier: MIT
#pragma once
// Stable and unstable manifolds of a saddle of a map of the plane: the points that come to it under
// forward, and under backward iteration. The unstable one is grown from a short segment along the
// eigenvector, whose images cover the whole curve, with points added where images lie too far
// apart. The stable one is the same under the inverse of the map, which is solved for by Newton's
// method from the neighbouring point; it exists where the map is invertible (Hénon: det J = -b ≠
// 0).

#include <string>

#include "dynamics/cycles.h"

namespace versorium {

struct ManifoldOptions {
    double spacing = 1.0 / 500;  // of neighbouring points at most, in heights of the window
    double length = 60;          // of each branch within the window, in heights of the window
    int mostPoints = 60000;      // of one manifold
};

struct Manifold {
    std::vector<Polyline> curves;  // clipped to the window
    bool cut = false;              // ended by mostPoints before `length`
};

struct SaddleManifolds {
    Manifold unstable;
    std::optional<Manifold> stable;
    std::string whyNoStable;  // a sentence, where there is none
};

// ErrorKind::usage where the cycle is no saddle of a map of the plane.
Expected<SaddleManifolds> manifoldsOf(const System& system, const PeriodicCycle& saddle,
                                      const Window& window, const ManifoldOptions& options,
                                      Job& job);

}  // namespace versorium
