// SPDX-License-Identifier: MIT
#pragma once
// The two classical families of the real line: x -> r x (1 - x) and x -> x² + c. They are the same
// up to an affine change of variable, with c = r/2 - r²/4.

#include "maps/map_info.h"
#include "math/point.h"

namespace versorium {

struct Logistic {
    static constexpr ParameterInfo kParameters[] = {
        {.name = "r", .value = {3.5}, .low = 0, .high = 4, .help = "growth rate"}};
    static constexpr MapInfo info{.name = "logistic",
                                  .title = "Logistic family",
                                  .formula = "r x (1 - x)",
                                  .algebra = Algebra::real,
                                  .parameters = kParameters,
                                  .escapeRadius = 16,
                                  .homeCentre = {0.5, 0},
                                  .homeHeight = 1.2,
                                  .interval = {0, 1},
                                  .source = "teaching"};
    template <class R>
    static Line<R> step(Line<R> x, R r) {
        return {r * x.x * (R(1.0) - x.x)};
    }
    template <class R>
    static Line<R> critical(int, R) {
        return {R(0.5)};
    }
    static constexpr int kCriticalPoints = 1;
};

struct RealQuadratic {
    static constexpr ParameterInfo kParameters[] = {
        {.name = "c", .value = {-1.3}, .low = -2, .high = 0.5, .help = "added constant"}};
    static constexpr MapInfo info{.name = "real-quadratic",
                                  .title = "Real quadratic family",
                                  .formula = "x^2 + c",
                                  .algebra = Algebra::real,
                                  .parameters = kParameters,
                                  .source = "teaching"};
    template <class R>
    static Line<R> step(Line<R> x, R c) {
        return {x.x * x.x + c};
    }
    template <class R>
    static Line<R> critical(int, R) {
        return {R(0.0)};
    }
    static constexpr int kCriticalPoints = 1;
};

}  // namespace versorium
