// SPDX-License-Identifier: MIT
#pragma once
// How the arguments of a map's step lie in flat arrays of numbers: the state first, then the
// parameters one after the other, each with its components in the order of its declaration.

#include <tuple>
#include <utility>

#include "math/bicomplex.h"
#include "math/complex.h"
#include "math/point.h"
#include "math/quaternion.h"

namespace versorium {

// The general case is a single number. Bound arguments have a `bind` instead of `load`, bundles of
// arguments a `take` (maps/bound.h, maps/apply.h).
template <class A>
struct Layout {
    static constexpr int kWidth = 1;
    static A load(const A* from) { return *from; }
    static void store(const A& value, A* to) { *to = value; }
};
template <class R>
struct Layout<Line<R>> {
    static constexpr int kWidth = 1;
    static Line<R> load(const R* from) { return {from[0]}; }
    static void store(const Line<R>& value, R* to) { to[0] = value.x; }
};
template <class R>
struct Layout<Plane<R>> {
    static constexpr int kWidth = 2;
    static Plane<R> load(const R* from) { return {from[0], from[1]}; }
    static void store(const Plane<R>& value, R* to) { to[0] = value.x, to[1] = value.y; }
};
template <class R>
struct Layout<Space<R>> {
    static constexpr int kWidth = 3;
    static Space<R> load(const R* from) { return {from[0], from[1], from[2]}; }
    static void store(const Space<R>& value, R* to) {
        to[0] = value.x, to[1] = value.y, to[2] = value.z;
    }
};
template <class R>
struct Layout<Complex<R>> {
    static constexpr int kWidth = 2;
    static Complex<R> load(const R* from) { return {from[0], from[1]}; }
    static void store(const Complex<R>& value, R* to) { to[0] = value.re, to[1] = value.im; }
};
template <class R>
struct Layout<Quaternion<R>> {
    static constexpr int kWidth = 4;
    static Quaternion<R> load(const R* from) { return {from[0], from[1], from[2], from[3]}; }
    static void store(const Quaternion<R>& value, R* to) {
        to[0] = value.w, to[1] = value.x, to[2] = value.y, to[3] = value.z;
    }
};
template <class R>
struct Layout<Bicomplex<R>> {
    static constexpr int kWidth = 4;
    static Bicomplex<R> load(const R* from) { return {from[0], from[1], from[2], from[3]}; }
    static void store(const Bicomplex<R>& value, R* to) {
        to[0] = value.w, to[1] = value.x, to[2] = value.y, to[3] = value.z;
    }
};
template <class A, class B>
struct Layout<std::pair<A, B>> {
    static constexpr int kWidth = Layout<A>::kWidth + Layout<B>::kWidth;
    template <class R>
    static std::pair<A, B> load(const R* from) {
        return {Layout<A>::load(from), Layout<B>::load(from + Layout<A>::kWidth)};
    }
    template <class R>
    static void store(const std::pair<A, B>& value, R* to) {
        Layout<A>::store(value.first, to);
        Layout<B>::store(value.second, to + Layout<A>::kWidth);
    }
};

}  // namespace versorium
