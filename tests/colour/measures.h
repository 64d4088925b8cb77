// SPDX-License-Identifier: MIT
#pragma once
// What tests of colours measure.

#include <algorithm>
#include <array>
#include <cmath>

#include "colour/srgb.h"

namespace versorium {

inline Oklch oklchFromOklab(const Oklab& lab) {
    return {lab.lightness, std::hypot(lab.a, lab.b), std::atan2(lab.b, lab.a)};
}

// CIE 1976 L* of the relative luminance, 0 to 100.
inline double cieLightness(const Colour& colour) {
    const double y = 0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b;
    return y > 216.0 / 24389.0 ? 116 * std::cbrt(y) - 16 : y * 24389.0 / 27.0;
}

// Whether a screen can show it.
inline bool inGamut(const Colour& colour) {
    const std::array parts{colour.r, colour.g, colour.b};
    return std::all_of(parts.begin(), parts.end(),
                       [](double value) { return value >= 0 && value <= 1; });
}

}  // namespace versorium
