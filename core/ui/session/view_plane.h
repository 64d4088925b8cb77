// SPDX-License-Identifier: MIT
#pragma once
// Where the points of a view's slice lie in the window.

#include <algorithm>
#include <cmath>

#include "ui/session/screen.h"
#include "view/slice.h"

namespace versorium {

struct ViewPlane {
    ScreenPoint low, high;  // the view's rectangle
    Viewport place;

    double unit() const { return (high.y - low.y) / place.height; }
    ScreenPoint at(double u, double v) const {
        const double x =
            0.5 * (low.x + high.x) + ((u - place.centre[0]) - place.centreLow[0]) * unit();
        const double y =
            0.5 * (low.y + high.y) - ((v - place.centre[1]) - place.centreLow[1]) * unit();
        const auto cut = [](double value) {
            return static_cast<float>(std::isfinite(value) ? std::clamp(value, -1e6, 1e6) : -1e6);
        };
        return {cut(x), cut(y)};
    }
    double u(float x) const {
        return place.centre[0] + (place.centreLow[0] + (x - 0.5 * (low.x + high.x)) / unit());
    }
    double v(float y) const {
        return place.centre[1] + (place.centreLow[1] - (y - 0.5 * (low.y + high.y)) / unit());
    }
};

}  // namespace versorium
