// SPDX-License-Identifier: MIT
#pragma once
// Points of the real line, plane and space as states of a map, over any number type R.

#include "math/elementary.h"

namespace versorium {

template <class R>
struct Line {
    using Real = R;
    static constexpr int kDimension = 1;
    R x;
};
template <class R>
struct Plane {
    using Real = R;
    static constexpr int kDimension = 2;
    R x, y;
};
template <class R>
struct Space {
    using Real = R;
    static constexpr int kDimension = 3;
    R x, y, z;

    friend Space operator+(const Space& a, const Space& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
};

template <class R>
R squaredNorm(const Line<R>& a) {
    return a.x * a.x;
}
template <class R>
R squaredNorm(const Plane<R>& a) {
    return a.x * a.x + a.y * a.y;
}
template <class R>
R squaredNorm(const Space<R>& a) {
    return a.x * a.x + a.y * a.y + a.z * a.z;
}
template <class M, class R>
Line<R> select(const M& mask, const Line<R>& yes, const Line<R>& no) {
    return {select(mask, yes.x, no.x)};
}
template <class M, class R>
Plane<R> select(const M& mask, const Plane<R>& yes, const Plane<R>& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y)};
}
template <class M, class R>
Space<R> select(const M& mask, const Space<R>& yes, const Space<R>& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

}  // namespace versorium
