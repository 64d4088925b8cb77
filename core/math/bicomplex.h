// SPDX-License-Identifier: MIT
#pragma once
// The commutative hypercomplex numbers of K1: w + xi + yj + zk with i² = j² = -1, ij = ji = k and
// hence k² = +1. They are two complex numbers w + xi and y + zi with a second unit j, and have
// divisors of zero.

#include "math/elementary.h"

namespace versorium {

template <class R>
struct Bicomplex {
    using Real = R;
    static constexpr int kDimension = 4;

    R w, x, y, z;

    friend Bicomplex operator+(const Bicomplex& a, const Bicomplex& b) {
        return {a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend Bicomplex operator-(const Bicomplex& a, const Bicomplex& b) {
        return {a.w - b.w, a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend Bicomplex operator*(const Bicomplex& a, const Bicomplex& b) {
        return {a.w * b.w - a.x * b.x - a.y * b.y + a.z * b.z,
                a.w * b.x + a.x * b.w - a.y * b.z - a.z * b.y,
                a.w * b.y + a.y * b.w - a.x * b.z - a.z * b.x,
                a.w * b.z + a.z * b.w + a.x * b.y + a.y * b.x};
    }
};

// The Euclidean norm of the four components; the algebra itself has no multiplicative norm.
template <class R>
R squaredNorm(const Bicomplex<R>& a) {
    return a.w * a.w + a.x * a.x + a.y * a.y + a.z * a.z;
}
template <class R>
Bicomplex<R> square(const Bicomplex<R>& a) {
    return {a.w * a.w - a.x * a.x - a.y * a.y + a.z * a.z, R(2.0) * (a.w * a.x - a.y * a.z),
            R(2.0) * (a.w * a.y - a.x * a.z), R(2.0) * (a.w * a.z + a.x * a.y)};
}
template <class M, class R>
Bicomplex<R> select(const M& mask, const Bicomplex<R>& yes, const Bicomplex<R>& no) {
    return {select(mask, yes.w, no.w), select(mask, yes.x, no.x), select(mask, yes.y, no.y),
            select(mask, yes.z, no.z)};
}

}  // namespace versorium
