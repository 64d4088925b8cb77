// SPDX-License-Identifier: MIT
#pragma once
// Calls a map's step from flat arrays: the types of its arguments say how they are taken apart.

#include <cstddef>
#include <utility>

#include "maps/bound.h"

namespace versorium {

template <class Function>
struct StepTraits;
template <class S, class Z, class... As>
struct StepTraits<S (*)(Z, As...)> {
    using State = S;
    using Arguments = std::tuple<std::remove_cvref_t<As>...>;
};

// Several arguments as one, for maps that are made of another map.
template <class R, class Tuple>
struct Bundle {
    Tuple all;
};

template <class Tuple>
struct ArgumentList;

template <class A, class R>
A loadArgument(const R*& parameters, const Environment<R>& environment) {
    if constexpr (requires { Layout<A>::bind(environment); }) {
        return Layout<A>::bind(environment);
    } else if constexpr (requires { Layout<A>::take(parameters, environment); }) {
        return Layout<A>::take(parameters, environment);
    } else {
        const R* from = parameters;
        parameters += Layout<A>::kWidth;
        return Layout<A>::load(from);
    }
}

// Braces fix the order in which the arguments are taken: left to right.
template <class... As>
struct ArgumentList<std::tuple<As...>> {
    static constexpr int kWidth = (0 + ... + Layout<As>::kWidth);
    template <class R>
    static std::tuple<As...> take(const R*& parameters, const Environment<R>& environment) {
        return std::tuple<As...>{loadArgument<As>(parameters, environment)...};
    }
};
template <class R, class Tuple>
struct Layout<Bundle<R, Tuple>> {
    static constexpr int kWidth = ArgumentList<Tuple>::kWidth;
    static Bundle<R, Tuple> take(const R*& parameters, const Environment<R>& environment) {
        return {ArgumentList<Tuple>::take(parameters, environment)};
    }
};

template <class M, class R>
using TraitsOf = StepTraits<decltype(&M::template step<R>)>;
template <class M, class R>
using StateOf = typename TraitsOf<M, R>::State;
template <class M, class R>
using ArgumentsOf = typename TraitsOf<M, R>::Arguments;

template <class M>
inline constexpr int kDimension = StateOf<M, double>::kDimension;
template <class M>
inline constexpr int kParameters = ArgumentList<ArgumentsOf<M, double>>::kWidth;

template <class M, class R>
StateOf<M, R> stepWith(const StateOf<M, R>& state, const ArgumentsOf<M, R>& arguments) {
    return std::apply([&](const auto&... as) { return M::template step<R>(state, as...); },
                      arguments);
}

template <class M, class R>
StateOf<M, R> applyStep(const StateOf<M, R>& state, const R* parameters,
                        const Environment<R>& environment) {
    return stepWith<M, R>(state, ArgumentList<ArgumentsOf<M, R>>::take(parameters, environment));
}

// In place, from and to flat arrays.
template <class M, class R>
void stepFlat(R* state, const R* parameters, const Environment<R>& environment) {
    using State = StateOf<M, R>;
    Layout<State>::store(applyStep<M, R>(Layout<State>::load(state), parameters, environment),
                         state);
}

}  // namespace versorium
