// SPDX-License-Identifier: MIT
#pragma once
// Shape modulus (S eqs 1-3, with the errata): the direction of an inner map p with a modulus that
// follows a distance field φ, negative inside the shape:
//   f(q) = e^{α(φ(x) - β)} p(x)/|p(x)|,   x = q - shift.
// φ is looked up at three of the four components of a quaternion; `drop` says which one is left out
// (default 3: k). `as_printed` = 1 takes φ + β, as S eq 2 prints it. Where p is NaN, or |p| is 0 or
// infinite, the direction is that of q itself; where that fails too, it is 1.

#include "maps/apply.h"
#include "maps/map_info.h"

namespace versorium {

namespace shape_modulus {

// e^300 is beyond every escape radius and e^600, its squared norm, is still finite.
inline constexpr double kLargestExponent = 300;
inline constexpr double kEscapeRadius = 20, kHomeHeight = 1.2;

// Their names are those of scene/shape_controls.h.
inline constexpr ParameterInfo kOwn[] = {{.name = "alpha",
                                          .value = {8},
                                          .low = 0,
                                          .high = 100,
                                          .help = "thinness of the shell",
                                          .label = "α"},
                                         {.name = "beta",
                                          .value = {0},
                                          .low = -0.5,
                                          .high = 0.5,
                                          .help = "offset of the surface",
                                          .label = "β"},
                                         // Two views show S eq 2 as it is meant and as printed.
                                         {.name = "as_printed",
                                          .kind = ParameterKind::whole,
                                          .value = {0},
                                          .low = 0,
                                          .high = 1,
                                          .help = "1: the sign of beta as S eq 2 prints it",
                                          .label = "φ + β (print)",
                                          .ofView = true}};

// The map's own parameters; only quaternions have a component to leave out.
template <class R, class State>
struct Controls {
    static constexpr bool kDrops = State::kDimension == 4;
    R alpha, beta, asPrinted;
    State shift;
    R drop;
};

// Where the shape is looked up.
template <class R>
struct Place {
    R x, y, z;
};
template <class R>
Place<R> placeOf(const Complex<R>& x, const R&) {
    return {x.re, x.im, R(0.0)};
}
template <class R>
Place<R> placeOf(const Quaternion<R>& x, const R& drop) {
    return {select(drop == R(0.0), x.x, x.w), select(drop <= R(1.0), x.y, x.x),
            select(drop <= R(2.0), x.z, x.y)};
}

// α(φ - β), held within ±kLargestExponent: the logarithm of the modulus.
template <class R, class State>
R exponentAt(const State& x, const Controls<R, State>& controls, const Field<R>& field) {
    const Place<R> at = placeOf(x, controls.drop);
    const R phi = field.at(at.x, at.y, at.z);
    const R alpha = field.alphaAt(at.x, at.y, at.z, controls.alpha);
    const R beta = field.betaAt(at.x, at.y, at.z, controls.beta);
    const R offset = select(controls.asPrinted == R(0.0), beta, -beta);
    const R largest(kLargestExponent);
    return min(max(alpha * (phi - offset), -largest), largest);
}

// e^logModulus p/|p|, where p is the inner map's value and q the point itself.
template <class R, class State>
State withDirection(const State& q, const State& p, const R& logModulus) {
    // A squared norm of p that is 0, infinite or NaN leaves no direction.
    const R square = squaredNorm(p);
    const auto good = (square > R(0.0)) & (square < R(kNoEscape));
    const State chosen = select(good, p, q);
    const R chosenSquare = select(good, square, squaredNorm(q));
    const auto usable = (chosenSquare > R(0.0)) & (chosenSquare < R(kNoEscape));
    const R scale = exp(logModulus) / sqrt(select(usable, chosenSquare, R(1.0)));
    return scale * select(usable, chosen, powers::unit(q));
}

// f(q) around any function p of x.
template <class R, class State, class Inner>
State stepAround(const State& q, const Controls<R, State>& controls, const Field<R>& field,
                 Inner p) {
    const State x = q - controls.shift;
    const R logModulus = exponentAt(x, controls, field);
    return withDirection(q, p(x), logModulus);
}

// The parameters that come before those of p, in the order of Controls.
template <bool kQuaternion>
constexpr auto ownParameters() {
    std::array<ParameterInfo, kQuaternion ? 5 : 4> all{};
    std::size_t next = 0;
    for (const ParameterInfo& own : kOwn) all[next++] = own;
    all[next++] = {.name = "shift",
                   .kind = kQuaternion ? ParameterKind::quaternion : ParameterKind::complex,
                   .low = -1,
                   .high = 1,
                   .help = "moves the shape and the inner map against the origin"};
    if constexpr (kQuaternion)
        all[next++] = {.name = "drop",
                       .kind = ParameterKind::whole,
                       .value = {3},
                       .low = 0,
                       .high = 3,
                       .help = "component that the shape does not see: 0 w … 3 z"};
    return all;
}
template <class M>
constexpr auto joinedParameters() {
    constexpr auto own = ownParameters<M::info.algebra == Algebra::quaternion>();
    std::array<ParameterInfo, own.size() + std::size(M::kParameters)> all{};
    std::size_t next = 0;
    for (const ParameterInfo& parameter : own) all[next++] = parameter;
    for (const ParameterInfo& inner : M::kParameters) all[next++] = inner;
    return all;
}

// "shape-modulus" around the quaternion rational map, "shape-modulus-NAME" around others.
template <class M>
struct Name {
    static constexpr auto kText = [] {
        std::array<char, 64> text{};
        std::size_t at = 0;
        for (char c : std::string_view("shape-modulus")) text[at++] = c;
        if (M::info.name != "quaternion-rational") {
            text[at++] = '-';
            for (char c : M::info.name) text[at++] = c;
        }
        return text;
    }();
    static constexpr std::string_view kView{kText.data()};
};

}  // namespace shape_modulus

template <class R, class State>
struct Layout<shape_modulus::Controls<R, State>> {
    using Controls = shape_modulus::Controls<R, State>;
    static constexpr int kWidth = 3 + State::kDimension + (Controls::kDrops ? 1 : 0);
    static Controls load(const R* from) {
        return {from[0], from[1], from[2], Layout<State>::load(from + 3),
                Controls::kDrops ? from[kWidth - 1] : R(3.0)};
    }
};

// `Inner` is any complex or quaternion map of the catalogue.
template <class Inner>
struct ShapeModulus {
    static constexpr auto kParameters = shape_modulus::joinedParameters<Inner>();
    static constexpr MapInfo info{.name = shape_modulus::Name<Inner>::kView,
                                  .title = Inner::info.algebra == Algebra::complex
                                               ? "Shape modulus over the complex numbers"
                                               : "Shape modulus over the quaternions",
                                  .formula = Inner::info.algebra == Algebra::complex
                                                 ? "e^(alpha (phi(z) - beta)) p(z)/|p(z)|"
                                                 : "e^(alpha (phi(q) - beta)) p(q)/|p(q)|",
                                  .algebra = Inner::info.algebra,
                                  .parameters = kParameters,
                                  .lists = Inner::info.lists,
                                  .rootForm = Inner::info.rootForm,
                                  .field = true,
                                  .degreeParameter = Inner::info.degreeParameter,
                                  .escapeRadius = shape_modulus::kEscapeRadius,
                                  .homeHeight = shape_modulus::kHomeHeight,
                                  .source = "S eqs 2-3"};
    static constexpr int kRegisters = 2;
    static constexpr bool kStepwise = true;

    template <class R>
    using InnerArguments = Bundle<R, ArgumentsOf<Inner, R>>;

    template <class R>
    static StateOf<Inner, R> step(StateOf<Inner, R> q,
                                  shape_modulus::Controls<R, StateOf<Inner, R>> controls,
                                  Field<R> field, InnerArguments<R> inner) {
        return shape_modulus::stepAround(
            q, controls, field, [&](const StateOf<Inner, R>& x) { return direction<R>(x, inner); });
    }

    // log |f(q)|, but for rounding, at a fraction of the price of f(q).
    template <class R>
    static R logModulus(StateOf<Inner, R> q, shape_modulus::Controls<R, StateOf<Inner, R>> controls,
                        Field<R> field, const InnerArguments<R>&) {
        return shape_modulus::exponentAt(q - controls.shift, controls, field);
    }
    // f(q), where that is known already.
    template <class R>
    static StateOf<Inner, R> withLogModulus(StateOf<Inner, R> q, R logModulus,
                                            shape_modulus::Controls<R, StateOf<Inner, R>> controls,
                                            Field<R>, const InnerArguments<R>& inner) {
        return shape_modulus::withDirection(q, direction<R>(q - controls.shift, inner), logModulus);
    }

  private:
    template <class R>
    static StateOf<Inner, R> direction(const StateOf<Inner, R>& x, const InnerArguments<R>& inner) {
        return std::apply(
            [&](const auto&... as) {
                if constexpr (requires { Inner::template direction<R>(x, as...); })
                    return Inner::template direction<R>(x, as...);
                else
                    return Inner::template step<R>(x, as...);
            },
            inner.all);
    }
};

}  // namespace versorium
