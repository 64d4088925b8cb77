// SPDX-License-Identifier: MIT
#include "colour/rules.h"

#include <cmath>

#include "math/elementary.h"

namespace versorium {
namespace {

constexpr double kTurn = 6.283185307179586;

double cut(double x) { return x > 0 ? (x < 1 ? x : 1.0) : 0.0; }

}  // namespace

DisplayColour displayFromColour(const Colour& colour) {
    return {srgbFromLinear(colour.r), srgbFromLinear(colour.g), srgbFromLinear(colour.b), colour.a};
}

Colour colourFromDisplay(const DisplayColour& colour) {
    return colourFromSrgb(colour.r, colour.g, colour.b, colour.a);
}

double bandedFraction(double steps, double iterations) {
    return iterations >= 1 ? cut(steps / iterations) : 0;
}

double smoothedFraction(double steps, double squaredNorm, double squaredRadius, double iterations) {
    if (!(iterations >= 1)) return 0;
    const double excess = squaredNorm > 0 ? squaredRadius / squaredNorm : 0;
    return cut((steps + (excess > 0 ? excess : 0)) / iterations);
}

Colour gradientColour(const Gradient& gradient, double fraction) {
    const double t = cut(fraction);
    const DisplayColour &s = gradient.start, &f = gradient.finish;
    const auto raise = [&](double start, double finish) {
        const double base = cut(start - t * (start - finish));
        return gradient.exponent == 1 ? base : cut(pow(base, gradient.exponent));
    };
    return colourFromSrgb(raise(s.r, f.r), raise(s.g, f.g), raise(s.b, f.b),
                          cut(s.a - t * (s.a - f.a)));
}

double logEscapePosition(double smoothEscape, double iterations, double density) {
    if (std::isnan(smoothEscape)) return smoothEscape;
    if (!(iterations >= 1)) return 0;
    const double t = cut(log(1 + max(smoothEscape, 0.0)) / log(1 + iterations));
    return density == 1 ? t : pow(t, density);
}

Colour versorColour(double i, double j, double k) {
    const auto part = [](double d) { return std::isnan(d) ? 0.5 : cut(0.5 * (d + 1)); };
    return colourFromSrgb(part(i), part(j), part(k));
}

Colour phaseColour(const Palette& palette, double angle) { return palette.at(angle / kTurn); }

}  // namespace versorium
