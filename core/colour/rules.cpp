// SPDX-License-Identifier: MIT
#include "colour/rules.h"

#include <cmath>

#include "math/elementary.h"

namespace versorium {
namespace {

constexpr double kTurn = 6.283185307179586, kLog2 = 0.6931471805599453;
// Of domain colours: rays in a turn, and the light just past a ring or a ray.
constexpr double kRays = 12, kDarkRing = 0.55, kDarkRay = 0.82;

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

Colour domainColour(const Palette& palette, double modulus, double angle) {
    if (std::isnan(modulus) || std::isnan(angle)) return palette.undefined;
    if (modulus == 0) return {0, 0, 0, 1};
    if (std::isinf(modulus)) return {1, 1, 1, 1};
    const auto fraction = [](double x) { return x - std::floor(x); };
    const double ring = fraction(log(modulus) / kLog2), ray = fraction(angle / kTurn * kRays);
    DisplayColour colour = displayFromColour(phaseColour(palette, angle));
    const double light = (kDarkRing + (1 - kDarkRing) * ring) * (kDarkRay + (1 - kDarkRay) * ray);
    for (double* part : {&colour.r, &colour.g, &colour.b}) *part *= light;
    return colourFromDisplay(colour);
}

}  // namespace versorium
