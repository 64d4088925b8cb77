// SPDX-License-Identifier: MIT
#pragma once
// The sum of powers of the distances to roots tᵢ and poles bᵢ, in place of their product:
//   S(q) = e^C (Σ (q - tᵢ)^(τ Tᵢ) + Σ (q - bᵢ)^(-β Bᵢ)).
// The authors' interactive program in two dimensions takes the direction d of a shape modulus from
// this sum, without poles; their program in space, and the paper's text, from the product
// (maps/rational.h). Parameters and lists are those of the product, so that one may take the
// other's place. Roots with equal whole powers T give a polynomial of degree T whose zeros lie
// elsewhere.

#include "maps/rational.h"

namespace versorium {

namespace root_sum {

template <class R>
Complex<R> zero(const Complex<R>&) {
    return {R(0.0), R(0.0)};
}
template <class R>
Quaternion<R> zero(const Quaternion<R>&) {
    return {R(0.0), R(0.0), R(0.0), R(0.0)};
}

template <class Z, class R, class List>
Z sum(const Z& before, const Z& q, const List& list, const R& scale) {
    return list.fold(before, [&](const Z& all, const Root<R>& root) {
        return all + power(q - rational::rootAs(root, &q), root.power * scale);
    });
}

}  // namespace root_sum

// Z is Complex or Quaternion.
template <template <class> class Z>
struct RootSum {
    static constexpr bool kComplex = Z<double>::kDimension == 2;
    static constexpr auto& kParameters = Rational<Z>::kParameters;
    static constexpr MapInfo info{
        .name = kComplex ? "complex-root-sum" : "quaternion-root-sum",
        .title = kComplex ? "Complex sum over roots" : "Quaternion sum over roots",
        .formula = kComplex ? "e^C (sum (z - t_i)^(tau T_i) + sum (z - b_i)^(-beta B_i))"
                            : "e^C (sum (q - t_i)^(tau T_i) + sum (q - b_i)^(-beta B_i))",
        .algebra = kComplex ? Algebra::complex : Algebra::quaternion,
        .parameters = kParameters,
        .lists = Rational<Z>::kLists,
        .rootForm = RootForm::sum,
        .escapeRadius = 20,
        .degree = 3,
        .homeHeight = 3,
        .source = "S, the authors' program in 2D"};
    static constexpr int kRegisters = 1;
    static constexpr bool kStepwise = true;

    template <class R>
    static Z<R> step(Z<R> q, R logScale, R tau, R beta, Roots<R, 0> roots, Roots<R, 1> poles) {
        return exp(logScale) * direction<R>(q, logScale, tau, beta, roots, poles);
    }
    template <class R>
    static Z<R> direction(Z<R> q, R, R tau, R beta, Roots<R, 0> roots, Roots<R, 1> poles) {
        const Z<R> top = root_sum::sum(root_sum::zero(q), q, roots, tau);
        return root_sum::sum(top, q, poles, -beta);
    }
};

}  // namespace versorium
