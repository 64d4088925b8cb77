// SPDX-License-Identifier: MIT
#pragma once
// Rational maps given by roots tᵢ, poles bᵢ and real exponents (Q eqs 4, 8):
//   R(q) = e^C Π (q - tᵢ)^(τ Tᵢ) · (Π (q - bᵢ)^(β Bᵢ))⁻¹,
// products from left to right, and Q eq 19, where each root is followed by its pole. β is called
// exponent_beta here. A list of any length, also an empty one, may be bound to either place.
//
// Modulus and direction are kept apart: the logarithm of the modulus is a sum, and the direction a
// product of unit numbers, so that neither overflows. `direction` alone costs no logarithm, and
// whole exponents cost no transcendental function; shape modulus needs nothing else.

#include "maps/bound.h"
#include "maps/map_info.h"

namespace versorium {

namespace rational {

template <class R>
const Complex<R> rootAs(const Root<R>& root, const Complex<R>*) {
    return root.complex();
}
template <class R>
const Quaternion<R> rootAs(const Root<R>& root, const Quaternion<R>*) {
    return root.quaternion();
}

// Direction first, logarithm of the modulus second.
template <class Z, class R>
using Factored = std::pair<Z, R>;

template <class Z, class R>
Factored<Z, R> timesPower(const Factored<Z, R>& before, const Z& factor, const R& exponent) {
    const R square = squaredNorm(factor);
    const auto zero = square == R(0.0);
    const Z unitFactor = select(zero, powers::unit(factor), (R(1.0) / sqrt(square)) * factor);
    const R logarithm = R(0.5) * log(square) * exponent;
    return {before.first * power(unitFactor, exponent),
            before.second + select(exponent == R(0.0), R(0.0), logarithm)};
}

// In line: a state that is returned through memory stalls the next product.
template <class Z, class R>
[[gnu::always_inline]] inline Z directionTimes(const Z& before, const Z& factor,
                                               const R& exponent) {
    const Z unitFactor = (R(1.0) / sqrt(squaredNorm(factor))) * factor;
    // Asked here, since a call for nothing costs more than the product.
    if (powers::isOne(exponent)) return before * unitFactor;
    return before * power(unitFactor, exponent);
}

template <class Z, class R, class List>
Factored<Z, R> product(const Z& q, const List& list, const R& scale) {
    return list.fold(Factored<Z, R>{powers::unit(q), R(0.0)},
                     [&](const Factored<Z, R>& before, const Root<R>& root) {
                         return timesPower(before, q - rootAs(root, &q), root.power * scale);
                     });
}
template <class Z, class R, class List>
Z productDirection(const Z& q, const List& list, const R& scale) {
    return list.fold(powers::unit(q), [&](const Z& before, const Root<R>& root) {
        return directionTimes(before, q - rootAs(root, &q), root.power * scale);
    });
}

inline constexpr ParameterInfo kLogScale{.name = "log_scale",
                                         .value = {0},
                                         .low = -5,
                                         .high = 5,
                                         .help = "C, log of the factor",
                                         .label = "log scale"};

}  // namespace rational

// Z is Complex or Quaternion.
template <template <class> class Z>
struct Rational {
    static constexpr bool kComplex = Z<double>::kDimension == 2;
    static constexpr ParameterInfo kParameters[] = {rational::kLogScale,
                                                    {.name = "tau",
                                                     .value = {1},
                                                     .low = 0,
                                                     .high = 4,
                                                     .help = "factor of the roots' powers",
                                                     .label = "τ"},
                                                    {.name = "exponent_beta",
                                                     .value = {1},
                                                     .low = 0,
                                                     .high = 4,
                                                     .help = "factor of the poles' powers",
                                                     .label = "exponent β"}};
    static constexpr std::string_view kLists[] = {"roots", "poles"};
    static constexpr MapInfo info{
        .name = kComplex ? "complex-rational" : "quaternion-rational",
        .title = kComplex ? "Complex rational map" : "Quaternion rational map",
        .formula = kComplex ? "e^C prod (z - t_i)^(tau T_i) / prod (z - b_i)^(beta B_i)"
                            : "e^C prod (q - t_i)^(tau T_i) (prod (q - b_i)^(beta B_i))^-1",
        .algebra = kComplex ? Algebra::complex : Algebra::quaternion,
        .parameters = kParameters,
        .lists = kLists,
        .rootForm = RootForm::product,
        .escapeRadius = 20,
        .degree = 3,
        .homeHeight = 3,
        .source = "Q eqs 4, 8"};
    static constexpr int kRegisters = 1;
    static constexpr bool kStepwise = true;

    template <class R>
    static Z<R> step(Z<R> q, R logScale, R tau, R beta, Roots<R, 0> roots, Roots<R, 1> poles) {
        const auto top = rational::product(q, roots, tau);
        const auto bottom = rational::product(q, poles, beta);
        // The bottom is a product of unit numbers: its inverse is its conjugate.
        return exp(logScale + (top.second - bottom.second)) * (top.first * conjugate(bottom.first));
    }
    template <class R>
    static Z<R> direction(Z<R> q, R, R tau, R beta, Roots<R, 0> roots, Roots<R, 1> poles) {
        return rational::productDirection(q, roots, tau) *
               conjugate(rational::productDirection(q, poles, beta));
    }
};

// Q eq 19: the i-th root with τ Tᵢ, then the i-th pole with β Bᵢ. The list "factors" holds them in
// turn, poles with negative powers.
struct QuaternionInterleaved {
    static constexpr ParameterInfo kParameters[] = {rational::kLogScale,
                                                    {.name = "tau",
                                                     .value = {1},
                                                     .low = 0,
                                                     .high = 4,
                                                     .help = "factor of all powers",
                                                     .label = "τ"}};
    static constexpr std::string_view kLists[] = {"factors"};
    static constexpr MapInfo info{.name = "quaternion-interleaved",
                                  .title = "Quaternion rational map, roots and poles in turn",
                                  .formula = "e^C prod (q - t_i)^T_i (q - b_i)^-B_i",
                                  .algebra = Algebra::quaternion,
                                  .parameters = kParameters,
                                  .lists = kLists,
                                  .escapeRadius = 20,
                                  .degree = 3,
                                  .homeHeight = 3,
                                  .source = "Q eq 19"};
    static constexpr int kRegisters = 1;
    static constexpr bool kStepwise = true;

    template <class R>
    static Quaternion<R> step(Quaternion<R> q, R logScale, R tau, Roots<R, 0> factors) {
        const auto all = rational::product(q, factors, tau);
        return exp(logScale + all.second) * all.first;
    }
    template <class R>
    static Quaternion<R> direction(Quaternion<R> q, R, R tau, Roots<R, 0> factors) {
        return rational::productDirection(q, factors, tau);
    }
};

}  // namespace versorium
