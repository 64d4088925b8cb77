// SPDX-License-Identifier: MIT
#pragma once
// z -> z^d + c with a whole or real exponent d, and the cubic family z -> z³ + a z + b, whose two
// critical points ±sqrt(-a/3) move with a.

#include "maps/map_info.h"
#include "math/power.h"

namespace versorium {

struct Power {
    static constexpr ParameterInfo kParameters[] = {
        {.name = "power", .value = {3}, .low = 2, .high = 8, .help = "exponent d, whole or real"},
        {.name = "c",
         .kind = ParameterKind::complex,
         .value = {0.45, 0.35},
         .low = -2,
         .high = 2,
         .help = "added constant"}};
    static constexpr std::string_view kPolynomial[] = {"c"};
    static constexpr MapInfo info{.name = "power",
                                  .title = "Power family",
                                  .formula = "z^d + c",
                                  .algebra = Algebra::complex,
                                  .parameters = kParameters,
                                  .polynomial = kPolynomial,
                                  .degreeParameter = "power",
                                  .degree = 3,
                                  .conjugation = true,
                                  .homeHeight = 3,
                                  .source = "A 3"};
    template <class R>
    static Complex<R> step(Complex<R> z, R d, Complex<R> c) {
        return power(z, d) + c;
    }
    template <class R>
    static Complex<R> critical(int, R, Complex<R>) {
        return {R(0.0), R(0.0)};
    }
    static constexpr int kCriticalPoints = 1;
};

struct Cubic {
    static constexpr ParameterInfo kParameters[] = {
        {.name = "a", .kind = ParameterKind::complex, .value = {-0.6, 0.1}, .help = "linear term"},
        {.name = "b",
         .kind = ParameterKind::complex,
         .value = {0.2, 0.6},
         .help = "added constant"}};
    static constexpr std::string_view kPolynomial[] = {"b", "a", "", "1"};
    static constexpr MapInfo info{.name = "cubic",
                                  .title = "Cubic family",
                                  .formula = "z^3 + a z + b",
                                  .algebra = Algebra::complex,
                                  .parameters = kParameters,
                                  .polynomial = kPolynomial,
                                  .escapeRadius = 4,
                                  .degree = 3,
                                  .conjugation = true,
                                  .homeHeight = 4,
                                  .source = "A 4.2"};
    template <class R>
    static Complex<R> step(Complex<R> z, Complex<R> a, Complex<R> b) {
        return z * (square(z) + a) + b;
    }
    template <class R>
    static Complex<R> critical(int k, Complex<R> a, Complex<R>) {
        const Complex<R> root = squareRoot(R(-1.0 / 3.0) * a);
        return k == 0 ? root : -root;
    }
    static constexpr int kCriticalPoints = 2;
};

}  // namespace versorium
