// SPDX-License-Identifier: MIT
#pragma once
// Quadratic and cubic families over the quaternions, and the quadratic family over the commutative
// bicomplex numbers (Q eq 1, R listings 1-6, K1).

#include "maps/map_info.h"
#include "math/bicomplex.h"
#include "math/quaternion.h"

namespace versorium {

struct QuaternionQuadratic {
    static constexpr ParameterInfo kParameters[] = {{.name = "c",
                                                     .kind = ParameterKind::quaternion,
                                                     .value = {0.285, 0.485, 0, 0},
                                                     .low = -2,
                                                     .high = 2,
                                                     .help = "added constant"}};
    static constexpr std::string_view kPolynomial[] = {"c", "", "1"};
    static constexpr MapInfo info{.name = "quaternion-quadratic",
                                  .title = "Quaternion quadratic family",
                                  .formula = "q^2 + c",
                                  .algebra = Algebra::quaternion,
                                  .parameters = kParameters,
                                  .polynomial = kPolynomial,
                                  .conjugation = true,
                                  .homeHeight = 3.2,
                                  .source = "Q eq 1, K"};
    template <class R>
    static Quaternion<R> step(Quaternion<R> q, Quaternion<R> c) {
        return square(q) + c;
    }
    template <class R>
    static Quaternion<R> critical(int, Quaternion<R>) {
        return {R(0.0), R(0.0), R(0.0), R(0.0)};
    }
    static constexpr int kCriticalPoints = 1;
    // As for the complex family: |q² + c| >= |q|² - |c|.
    template <class R>
    static auto outsideIsFinal(R squaredRadius, Quaternion<R>, Quaternion<R> c) {
        return (squaredRadius >= R(4.0)) & (squaredNorm(c) <= squaredRadius * R(1.0 - 0x1p-20));
    }
};

struct QuaternionCubic {
    static constexpr ParameterInfo kParameters[] = {
        {.name = "c",
         .kind = ParameterKind::quaternion,
         .value = {-2.0 / 22, 6.0 / 22, 15.0 / 22, -6.0 / 22},
         .low = -2,
         .high = 2,
         .help = "added constant"}};
    static constexpr std::string_view kPolynomial[] = {"c", "", "", "1"};
    static constexpr MapInfo info{.name = "quaternion-cubic",
                                  .title = "Quaternion cubic family",
                                  .formula = "q^3 + c",
                                  .algebra = Algebra::quaternion,
                                  .parameters = kParameters,
                                  .polynomial = kPolynomial,
                                  .degree = 3,
                                  .conjugation = true,
                                  .homeHeight = 3,
                                  .source = "R listings 1-6"};
    // q³ = w(w² - 3|v|²) + (3w² - |v|²) v.
    template <class R>
    static Quaternion<R> step(Quaternion<R> q, Quaternion<R> c) {
        const R ww = q.w * q.w;
        const R vv = q.x * q.x + q.y * q.y + q.z * q.z;
        const R scale = R(3.0) * ww - vv;
        return Quaternion<R>{q.w * (ww - R(3.0) * vv), scale * q.x, scale * q.y, scale * q.z} + c;
    }
    template <class R>
    static Quaternion<R> critical(int, Quaternion<R>) {
        return {R(0.0), R(0.0), R(0.0), R(0.0)};
    }
    static constexpr int kCriticalPoints = 1;
};

struct BicomplexQuadratic {
    static constexpr ParameterInfo kParameters[] = {{.name = "c",
                                                     .kind = ParameterKind::quaternion,
                                                     .value = {0.285, 0.485, 0, 0},
                                                     .low = -2,
                                                     .high = 2,
                                                     .help = "added constant"}};
    static constexpr MapInfo info{.name = "bicomplex-quadratic",
                                  .title = "Bicomplex quadratic family",
                                  .formula = "q^2 + c",
                                  .algebra = Algebra::bicomplex,
                                  .parameters = kParameters,
                                  .escapeRadius = 4,
                                  .homeHeight = 3.2,
                                  .source = "K1"};
    template <class R>
    static Bicomplex<R> step(Bicomplex<R> q, Bicomplex<R> c) {
        return square(q) + c;
    }
    template <class R>
    static Bicomplex<R> critical(int, Bicomplex<R>) {
        return {R(0.0), R(0.0), R(0.0), R(0.0)};
    }
    static constexpr int kCriticalPoints = 1;
};

}  // namespace versorium
