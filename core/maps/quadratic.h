// SPDX-License-Identifier: MIT
#pragma once
// The complex quadratic family z -> z² + c: filled Julia sets in the z-plane, the Mandelbrot set in
// the c-plane through the critical point 0 (S section 2.2, A eq 7).

#include "maps/map_info.h"
#include "math/complex.h"

namespace versorium {

struct Quadratic {
    static constexpr ParameterInfo kParameters[] = {{.name = "c",
                                                     .kind = ParameterKind::complex,
                                                     .value = {-0.122561, 0.744862},
                                                     .low = -2,
                                                     .high = 2,
                                                     .help = "added constant"}};
    static constexpr std::string_view kPolynomial[] = {"c", "", "1"};
    static constexpr MapInfo info{.name = "quadratic",
                                  .title = "Quadratic family",
                                  .formula = "z^2 + c",
                                  .algebra = Algebra::complex,
                                  .parameters = kParameters,
                                  .polynomial = kPolynomial,
                                  .conjugation = true,
                                  .homeHeight = 3.2,
                                  .parameterCentre = {-0.65, 0},
                                  .source = "S 2.2, A eq 7"};
    template <class R>
    static Complex<R> step(Complex<R> z, Complex<R> c) {
        return square(z) + c;
    }
    template <class R>
    static Complex<R> critical(int, Complex<R>) {
        return {R(0.0), R(0.0)};
    }
    static constexpr int kCriticalPoints = 1;

    // For |z| > R >= 2 and |c| < R: |z² + c| > |z|² - |z| >= |z|, so an orbit that is out stays
    // out. The margin leaves room for rounding.
    template <class R>
    static auto outsideIsFinal(R squaredRadius, Complex<R>, Complex<R> c) {
        return (squaredRadius >= R(4.0)) & (squaredNorm(c) <= squaredRadius * R(1.0 - 0x1p-20));
    }
    // Started at 0, c in the main cardioid or in the disc of period 2 is attracted by a fixed point
    // or a cycle inside the disc of radius 2. The margin leaves room for rounding.
    template <class R>
    static auto knownInterior(R squaredRadius, Complex<R> z, Complex<R> c) {
        const R x = c.re - R(0.25), y2 = c.im * c.im;
        const R q = x * x + y2;
        const R margin(1e-6);
        const auto cardioid = q * (q + x) < R(0.25) * y2 - margin;
        const R left = c.re + R(1.0);
        const auto disc = left * left + y2 < R(0.0625) - margin;
        return (squaredRadius >= R(4.0)) & (z.re == R(0.0)) & (z.im == R(0.0)) & (cardioid | disc);
    }
};

}  // namespace versorium
