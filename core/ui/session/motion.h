// SPDX-License-Identifier: MIT
#pragma once
// How a view moves: eased from one place to another, or with two fingers. Knows nothing of the
// window.

#include "scene/scene.h"

namespace versorium {

inline constexpr double kGlideSeconds = 0.12;

// A view on its way.
struct Glide {
    SliceSpec from, to;
    double begin = 0;  // seconds
};

// The place at a part t in [0, 1] of the way, slow at both ends. Heights go by equal ratios, and
// centres so that the point which both places show at the same spot stays there all the way. Places
// with different axes have nothing between them: the target itself.
SliceSpec between(const SliceSpec& from, const SliceSpec& to, double t);

// A slice with another height, (u, v) staying where it is in the view. `factor` below 1 goes in.
SliceSpec zoomed(const SliceSpec& slice, double factor, double u, double v);
// A slice whose centre lies elsewhere by (u, v).
SliceSpec shifted(const SliceSpec& slice, double u, double v);

}  // namespace versorium
