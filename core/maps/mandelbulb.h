// SPDX-License-Identifier: MIT
#pragma once
// The Mandelbulb p -> pⁿ + c of White and Nylander (R eq 1, with the errata's angles): a power
// multiplies both angles of spherical coordinates with the z-axis as pole. With ρ = sqrt(x² + y²),
//   (z + iρ)ⁿ = rⁿ (cos nθ + i sin nθ)  and  ((x + iy)/ρ)ⁿ = cos nφ + i sin nφ,
// so that a whole power needs no trigonometry at all, and a real power only that of `power`.
// Where ρ = 0 the longitude φ is 0.

#include "maps/map_info.h"
#include "math/point.h"
#include "math/power.h"

namespace versorium {

struct Mandelbulb {
    static constexpr ParameterInfo kParameters[] = {
        {.name = "power", .value = {8}, .low = 2, .high = 12, .help = "exponent n, whole or real"},
        {.name = "c",
         .kind = ParameterKind::space,
         .value = {0, 0, 0},
         .low = -1.5,
         .high = 1.5,
         .help = "added point"}};
    static constexpr MapInfo info{.name = "mandelbulb",
                                  .title = "Mandelbulb",
                                  .formula = "p^n + c",
                                  .algebra = Algebra::space,
                                  .parameters = kParameters,
                                  .degree = 8,
                                  .homeHeight = 2.6,
                                  .source = "R eq 1"};
    template <class R>
    static Space<R> step(Space<R> p, R exponent, Space<R> c) {
        const R rho = sqrt(p.x * p.x + p.y * p.y);
        const auto onAxis = rho == R(0.0);
        const R scale = R(1.0) / select(onAxis, R(1.0), rho);
        const Complex<R> longitude{select(onAxis, R(1.0), p.x * scale), p.y * scale};
        const Complex<R> latitude = power(Complex<R>{p.z, rho}, exponent);
        const Complex<R> turned = power(longitude, exponent);
        return Space<R>{latitude.im * turned.re, latitude.im * turned.im, latitude.re} + c;
    }
    template <class R>
    static Space<R> critical(int, R, Space<R>) {
        return {R(0.0), R(0.0), R(0.0)};
    }
    static constexpr int kCriticalPoints = 1;
};

}  // namespace versorium
