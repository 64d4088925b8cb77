// SPDX-License-Identifier: MIT
#pragma once
// Burning ship: z -> (|x| + i|y|)² + c. Continuous but not analytic: its derivative jumps across
// both axes, so distance estimates are only valid away from them.

#include "maps/map_info.h"
#include "math/complex.h"

namespace versorium {

struct BurningShip {
    static constexpr ParameterInfo kParameters[] = {{.name = "c",
                                                     .kind = ParameterKind::complex,
                                                     .value = {-1.6, -0.02},
                                                     .low = -2.5,
                                                     .high = 2.5,
                                                     .help = "added constant"}};
    static constexpr MapInfo info{.name = "burning-ship",
                                  .title = "Burning ship",
                                  .formula = "(|x| + i|y|)^2 + c",
                                  .algebra = Algebra::complex,
                                  .parameters = kParameters,
                                  .homeHeight = 3.2,
                                  .source = "A 3"};
    template <class R>
    static Complex<R> step(Complex<R> z, Complex<R> c) {
        return square(Complex<R>{abs(z.re), abs(z.im)}) + c;
    }
    template <class R>
    static Complex<R> critical(int, Complex<R>) {
        return {R(0.0), R(0.0)};
    }
    static constexpr int kCriticalPoints = 1;
};

}  // namespace versorium
