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
    static constexpr MapInfo info{.name = "newton",
                                  .title = "Newton's map",
                                  .formula = "z - a p(z)/p'(z)",
                                  .algebra = Algebra::complex,
                                  .parameters = kParameters,
                                  .lists = kLists,
                                  .escapeRadius = kNoEscape,
                                  .degree = 1,
                                  .homeHeight = 4,
                                  .source = "Q 3"};
    template <class R>
    static Complex<R> step(Complex<R> z, Complex<R> relaxation, Roots<R> roots) {
        // Beside the sum goes the least squared distance to a root: at a root the step is 0.
        using Sum = std::pair<Complex<R>, R>;
        const Sum sum = roots.fold(Sum{{R(0.0), R(0.0)}, R(1.0)}, [&](const Sum& before,
                                                                      const Root<R>& root) {
            const Complex<R> difference = z - root.complex();
            const R square = squaredNorm(difference);
            const R scale = root.power / square;
            return Sum{before.first + Complex<R>{scale * difference.re, -(scale * difference.im)},
                       min(before.second, square)};
        });
        const Complex<R> next = z - relaxation * inverse(sum.first);
        return select(sum.second == R(0.0), z, next);
    }
};

}  // namespace versorium
