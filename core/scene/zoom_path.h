// SPDX-License-Identifier: MIT
#pragma once
// The way from one view to another. A view is a point with a scale: heights go by equal ratios, and
// the centre so that the point which both views show at the same spot stays there all the way,
//   c = c₁ + (c₀ - c₁) (h - h₁) / (h₀ - h₁),
// which is to say that it always moves by the same share of the height. So a zoom keeps its target
// in sight. Views of the same height are joined by a straight line at constant speed.

namespace versorium {

// The height when a part in [0, 1] of the way is done; heights are positive.
double heightOnTheWay(double from, double to, double part);
// The part of the centre's way that is done at that height, in [0, 1]. `part` stands for views of
// the same height.
double centreOnTheWay(double from, double to, double part);

}  // namespace versorium
