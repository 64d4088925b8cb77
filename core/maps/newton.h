// SPDX-License-Identifier: MIT
#pragma once
// Newton's map of a polynomial given by its roots with multiplicities mᵢ:
//   N(z) = z - a p(z)/p'(z),  p'/p = Σ mᵢ / (z - rᵢ),  relaxation a.
// It maps infinity to itself as a repelling point (Q: the counter-example to "infinity attracts"),
// so no orbit escapes but through a pole of 1/p'.

#include "maps/bound.h"
#include "maps/map_info.h"

namespace versorium {

struct Newton {
    static constexpr ParameterInfo kParameters[] = {{.name = "relaxation",
                                                     .kind = ParameterKind::complex,
                                                     .value = {1, 0},
                                                     .low = 0,
                                                     .high = 2,
                                                     .help = "factor of the Newton step"}};
    static constexpr std::string_view kLists[] = {"roots"};
    static constexpr double kHalfRootOf3 = 0.8660254037844386;
    // p(z) = z³ - 1.
    static constexpr RootList::Root kUnityRoots[] = {
        {{1, 0, 0, 0}, 1}, {{-0.5, kHalfRootOf3, 0, 0}, 1}, {{-0.5, -kHalfRootOf3, 0, 0}, 1}};
    static constexpr MapInfo info{.name = "newton",
                                  .title = "Newton's map",
                                  .formula = "z - a p(z)/p'(z)",
                                  .algebra = Algebra::complex,
                                  .parameters = kParameters,
                                  .lists = kLists,
                                  .homeRoots = kUnityRoots,
                                  .rootForm = RootForm::newton,
                                  .escapeRadius = kNoEscape,
                                  .degree = 1,
                                  .homeHeight = 4,
                                  .source = "Q 3"};
    template <class R>
    static Complex<R> step(Complex<R> z, Complex<R> relaxation, Roots<R> roots) {
        // Beside the sum goes the nearest root: at a root, and so close that 1/|z - r|² overflows,
        // only its factor counts, z - a (z - r)/m.
        using Nearest = std::pair<Complex<R>, std::pair<R, R>>;  // z - r, |z - r|², m
        using Sum = std::pair<Complex<R>, Nearest>;
        const Complex<R> zero{R(0.0), R(0.0)};
        const Sum sum = roots.fold(Sum{zero, {zero, {R(1.0), R(1.0)}}}, [&](const Sum& before,
                                                                            const Root<R>& root) {
            const Complex<R> difference = z - root.complex();
            const R square = squaredNorm(difference);
            const R scale = root.power / square;
            const auto closer = square < before.second.second.first;
            return Sum{before.first + Complex<R>{scale * difference.re, -(scale * difference.im)},
                       {select(closer, difference, before.second.first),
                        {select(closer, square, before.second.second.first),
                         select(closer, root.power, before.second.second.second)}}};
        });
        const auto& [difference, squareAndPower] = sum.second;
        const Complex<R> next = z - relaxation * inverse(sum.first);
        const Complex<R> atRoot = z - relaxation * ((R(1.0) / squareAndPower.second) * difference);
        return select(squareAndPower.first < R(1e-30), atRoot, next);
    }
};

}  // namespace versorium
