// SPDX-License-Identifier: MIT
#pragma once
// Polynomial systems of the real plane with 13 coefficients in each component, and the two optional
// terms of footnote 1 (A eqs 5-6):
//   Σ aₖ xᵏ + Σ bₖ yᵏ + c₁ xy + c₂ x²y + c₃ xy² + c₄ x²y² + d (+ x3y x³y + xy3 xy³).
// All complex polynomials up to degree 3 are among them (A eq 7), and with the optional terms those
// of degree 4; so is Hénon's map. Horner's rule in y, with coefficients that are polynomials in x.
//
// Where coefficients are 0, shorter forms of the same sum do less work; they leave out additions of
// x·0 only, so that they give the same numbers wherever x and y are finite.

#include <initializer_list>
#include "maps/layout.h"

#include "maps/map_info.h"

namespace versorium {

template <class R>
struct PlanarComponent {
    R a1, a2, a3, a4, b1, b2, b3, b4, c1, c2, c3, c4, d, x3y, xy3;
};
template <class R>
struct PlanarCoefficients {
    PlanarComponent<R> g, h;
};
template <class R>
struct Layout<PlanarComponent<R>> {
    static constexpr int kWidth = 15;
    static PlanarComponent<R> load(const R* p) {
        return {p[0], p[1], p[2],  p[3],  p[4],  p[5],  p[6], p[7],
                p[8], p[9], p[10], p[11], p[12], p[13], p[14]};
    }
};
template <class R>
struct Layout<PlanarCoefficients<R>> {
    static constexpr int kWidth = 30;
    static PlanarCoefficients<R> load(const R* p) {
        return {Layout<PlanarComponent<R>>::load(p), Layout<PlanarComponent<R>>::load(p + 15)};
    }
};

namespace planar {

enum Coefficient { a1, a2, a3, a4, b1, b2, b3, b4, c1, c2, c3, c4, d, x3y, xy3 };

template <class R>
R full(const PlanarComponent<R>& k, const R& x, const R& y) {
    return (k.d + x * (k.a1 + x * (k.a2 + x * (k.a3 + x * k.a4)))) +
           y * ((k.b1 + x * (k.c1 + x * (k.c2 + x * k.x3y))) +
                y * ((k.b2 + x * (k.c3 + x * k.c4)) + y * ((k.b3 + x * k.xy3) + y * k.b4)));
}
template <class R>
R quartic(const PlanarComponent<R>& k, const R& x, const R& y) {
    return (k.d + x * (k.a1 + x * (k.a2 + x * (k.a3 + x * k.a4)))) +
           y * ((k.b1 + x * (k.c1 + x * k.c2)) +
                y * ((k.b2 + x * (k.c3 + x * k.c4)) + y * (k.b3 + y * k.b4)));
}
template <class R>
R quadratic(const PlanarComponent<R>& k, const R& x, const R& y) {
    return (k.d + x * (k.a1 + x * k.a2)) + y * ((k.b1 + x * k.c1) + y * k.b2);
}
template <class R>
R henonQuadratic(const PlanarComponent<R>& k, const R& x, const R& y) {
    return (k.d + x * (k.a1 + x * k.a2)) + y * k.b1;
}
template <class R>
R linear(const PlanarComponent<R>& k, const R& x, const R& y) {
    return (k.d + x * k.a1) + y * k.b1;
}

// Which of the 30 coefficients a form has a place for: those of g, then those of h.
struct Places {
    bool has[30] = {};
};
constexpr Places places(std::initializer_list<Coefficient> g,
                        std::initializer_list<Coefficient> h) {
    Places result;
    for (Coefficient coefficient : g) result.has[coefficient] = true;
    for (Coefficient coefficient : h) result.has[15 + coefficient] = true;
    return result;
}

}  // namespace planar

struct PlanarQuarticForm {
    template <class R>
    static Plane<R> step(const Plane<R>& p, const PlanarCoefficients<R>& k) {
        return {planar::quartic(k.g, p.x, p.y), planar::quartic(k.h, p.x, p.y)};
    }
    static constexpr planar::Places kPlaces = [] {
        using namespace planar;
        return places({a1, a2, a3, a4, b1, b2, b3, b4, c1, c2, c3, c4, d},
                      {a1, a2, a3, a4, b1, b2, b3, b4, c1, c2, c3, c4, d});
    }();
};
struct PlanarQuadraticForm {
    template <class R>
    static Plane<R> step(const Plane<R>& p, const PlanarCoefficients<R>& k) {
        return {planar::quadratic(k.g, p.x, p.y), planar::quadratic(k.h, p.x, p.y)};
    }
    static constexpr planar::Places kPlaces = [] {
        using namespace planar;
        return places({a1, a2, b1, b2, c1, d}, {a1, a2, b1, b2, c1, d});
    }();
};
struct PlanarHenonForm {
    template <class R>
    static Plane<R> step(const Plane<R>& p, const PlanarCoefficients<R>& k) {
        return {planar::henonQuadratic(k.g, p.x, p.y), planar::linear(k.h, p.x, p.y)};
    }
    static constexpr planar::Places kPlaces = [] {
        using namespace planar;
        return places({a1, a2, b1, d}, {a1, b1, d});
    }();
};

struct Planar {
#define VERSORIUM_COEFFICIENT(text, number) \
    { .name = text, .value = {number}, .low = -2, .high = 2, .help = "coefficient" }
    // The defaults are A eq 7 with c = -0.122561 + 0.744862i: the quadratic family in the plane.
    static constexpr ParameterInfo kParameters[] = {
        VERSORIUM_COEFFICIENT("g.a1", 0),        VERSORIUM_COEFFICIENT("g.a2", 1),
        VERSORIUM_COEFFICIENT("g.a3", 0),        VERSORIUM_COEFFICIENT("g.a4", 0),
        VERSORIUM_COEFFICIENT("g.b1", 0),        VERSORIUM_COEFFICIENT("g.b2", -1),
        VERSORIUM_COEFFICIENT("g.b3", 0),        VERSORIUM_COEFFICIENT("g.b4", 0),
        VERSORIUM_COEFFICIENT("g.c1", 0),        VERSORIUM_COEFFICIENT("g.c2", 0),
        VERSORIUM_COEFFICIENT("g.c3", 0),        VERSORIUM_COEFFICIENT("g.c4", 0),
        VERSORIUM_COEFFICIENT("g.d", -0.122561), VERSORIUM_COEFFICIENT("g.x3y", 0),
        VERSORIUM_COEFFICIENT("g.xy3", 0),       VERSORIUM_COEFFICIENT("h.a1", 0),
        VERSORIUM_COEFFICIENT("h.a2", 0),        VERSORIUM_COEFFICIENT("h.a3", 0),
        VERSORIUM_COEFFICIENT("h.a4", 0),        VERSORIUM_COEFFICIENT("h.b1", 0),
        VERSORIUM_COEFFICIENT("h.b2", 0),        VERSORIUM_COEFFICIENT("h.b3", 0),
        VERSORIUM_COEFFICIENT("h.b4", 0),        VERSORIUM_COEFFICIENT("h.c1", 2),
        VERSORIUM_COEFFICIENT("h.c2", 0),        VERSORIUM_COEFFICIENT("h.c3", 0),
        VERSORIUM_COEFFICIENT("h.c4", 0),        VERSORIUM_COEFFICIENT("h.d", 0.744862),
        VERSORIUM_COEFFICIENT("h.x3y", 0),       VERSORIUM_COEFFICIENT("h.xy3", 0)};
#undef VERSORIUM_COEFFICIENT
    // Whatever the family, the constant terms are varied.
    static constexpr std::string_view kConstants[] = {kParameters[planar::d].name,
                                                      kParameters[15 + planar::d].name};
    static constexpr MapInfo info{.name = "planar",
                                  .title = "Planar polynomial system",
                                  .formula = "(g(x, y), h(x, y)) of degree 4",
                                  .algebra = Algebra::plane,
                                  .parameters = kParameters,
                                  .planarCoefficients = true,
                                  .escapeRadius = 4,
                                  .homeHeight = 3.2,
                                  .parameterAxes = kConstants,
                                  .source = "A eqs 5-6"};
    using Forms = std::tuple<PlanarHenonForm, PlanarQuadraticForm, PlanarQuarticForm>;

    template <class R>
    static Plane<R> step(const Plane<R>& p, const PlanarCoefficients<R>& k) {
        return {planar::full(k.g, p.x, p.y), planar::full(k.h, p.x, p.y)};
    }
};

}  // namespace versorium
