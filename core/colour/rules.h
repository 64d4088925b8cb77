// SPDX-License-Identifier: MIT
#pragma once
// The colour rules of deterministic fractals: pure functions from numbers to colours.
//
// Banisch & Sbert (A section 4.3) run a gradient from C_s, where orbits leave at once, to C_f,
// where they take long:
//   eq 14  C = (C_s - (n/N) (C_s - C_f))^e
//   eq 15  C = (C_s - ((n + β/‖p_n‖)/N) (C_s - C_f))^e     β and ‖·‖ are squared norms: β = R²
// The fraction is cut to [0, 1] (the errata: eq 15 may exceed N). These two work on *display*
// values, as the authors' shaders wrote them to the screen; the power acts on each of the three
// and not on alpha. Results here, as everywhere, are linear light with straight alpha.

#include "base/words.h"
#include "colour/palette.h"
#include "colour/srgb.h"

namespace versorium {

// What a picture's colours show.
enum class ColourRule {
    palette,   // a field, by a palette
    gradient,  // the escape step, by A eqs 14 and 15
    versor,    // the versor's imaginary parts
    phase,     // the argument, on a cyclic palette
    domain,    // the argument with edges of the polar grid
};
template <>
struct EnumWords<ColourRule> {
    static constexpr std::array<std::string_view, 5> table{"palette", "gradient", "versor", "phase",
                                                           "domain"};
};

// Of the gradient: eq 14, eq 15, or a logarithmic axis.
enum class Smoothing { none, ratio, logLog };
template <>
struct EnumWords<Smoothing> {
    static constexpr std::array<std::string_view, 3> table{"none", "ratio", "log-log"};
};

// sRGB-encoded values in [0, 1].
struct DisplayColour {
    double r = 0, g = 0, b = 0, a = 1;
    friend bool operator==(const DisplayColour&, const DisplayColour&) = default;
};
DisplayColour displayFromColour(const Colour& colour);
Colour colourFromDisplay(const DisplayColour& colour);

// C_s, C_f and e of one region; the escaped and the attracted region have one each.
struct Gradient {
    DisplayColour start{0, 0, 0, 1};
    DisplayColour finish{1, 1, 1, 1};
    double exponent = 1;  // above 0
    friend bool operator==(const Gradient&, const Gradient&) = default;
};

// n/N, cut to [0, 1]; 0 when N < 1.
double bandedFraction(double steps, double iterations);
// (n + β/‖p_n‖)/N, cut to [0, 1]. Overflowed and undefined norms give the banded fraction: there
// β/‖p_n‖ has become 0.
double smoothedFraction(double steps, double squaredNorm, double squaredRadius, double iterations);
// Eq 14 with the given fraction in place of n/N; a fraction that is NaN counts as 0.
Colour gradientColour(const Gradient& gradient, double fraction);

inline Colour bandedColour(const Gradient& gradient, double steps, double iterations) {
    return gradientColour(gradient, bandedFraction(steps, iterations));
}
inline Colour smoothedColour(const Gradient& gradient, double steps, double squaredNorm,
                             double squaredRadius, double iterations) {
    return gradientColour(gradient,
                          smoothedFraction(steps, squaredNorm, squaredRadius, iterations));
}

// Log-log smoothing: the position of a smooth escape time ν ≥ 0 on a logarithmic axis from 1 to N,
// ln(1 + ν) / ln(1 + N), cut to [0, 1]. `density` above 1 lets the palette begin later:
// position^density. NaN stays NaN.
double logEscapePosition(double smoothEscape, double iterations, double density = 1);

// The three imaginary parts of a unit quaternion as red, green, blue: (d + 1)/2 as display values
// (S Fig 2 and section 4). NaN gives mid grey.
Colour versorColour(double i, double j, double k);

// An angle in radians on a cyclic palette, 0 at its beginning. NaN gives palette.undefined.
Colour phaseColour(const Palette& palette, double angle);

// A complex value as a colour, with the grid of its polar coordinates: the argument on a cyclic
// palette, darker where |f| has just passed a power of two, and a little darker where the argument
// has just passed a multiple of π/6, so that both families of lines are seen as edges, in grey as
// well. 0 is black, infinity white, NaN palette.undefined.
Colour domainColour(const Palette& palette, double modulus, double angle);

}  // namespace versorium
