// SPDX-License-Identifier: MIT
#include "scene/zoom_path.h"

#include <cmath>

#include "math/elementary.h"

namespace versorium {

double heightOnTheWay(double from, double to, double part) {
    if (from == to || part <= 0) return from;
    return part >= 1 ? to : exp(log(from) + (log(to) - log(from)) * part);
}

double centreOnTheWay(double from, double to, double part) {
    const double whole = from - to;
    // Heights that hardly differ leave no digits in their quotient.
    if (std::abs(whole) < 1e-6 * from) return part;
    return (from - heightOnTheWay(from, to, part)) / whole;
}

}  // namespace versorium
