// SPDX-License-Identifier: MIT
#pragma once
// Quaternions w + xi + yj + zk with Hamilton's product over any number type R. A quotient p/q is
// p q⁻¹ (Q section 3).

#include "math/elementary.h"

namespace versorium {

template <class R>
struct Quaternion {
    using Real = R;
    static constexpr int kDimension = 4;

    R w, x, y, z;

    friend Quaternion operator+(const Quaternion& a, const Quaternion& b) {
        return {a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend Quaternion operator-(const Quaternion& a, const Quaternion& b) {
        return {a.w - b.w, a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend Quaternion operator-(const Quaternion& a) { return {-a.w, -a.x, -a.y, -a.z}; }
    friend Quaternion operator*(const Quaternion& a, const Quaternion& b) {
        return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
                a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
    }
    friend Quaternion operator/(const Quaternion& a, const Quaternion& b) { return a * inverse(b); }
    friend Quaternion operator*(const R& s, const Quaternion& a) {
        return {s * a.w, s * a.x, s * a.y, s * a.z};
    }
};

template <class R>
Quaternion<R> conjugate(const Quaternion<R>& a) {
    return {a.w, -a.x, -a.y, -a.z};
}
template <class R>
R squaredNorm(const Quaternion<R>& a) {
    return a.w * a.w + a.x * a.x + a.y * a.y + a.z * a.z;
}
template <class R>
Quaternion<R> inverse(const Quaternion<R>& a) {
    return (R(1.0) / squaredNorm(a)) * conjugate(a);
}
// The square needs no full product: w² - |v|², 2w v.
template <class R>
Quaternion<R> square(const Quaternion<R>& a) {
    const R twice = a.w + a.w;
    return {a.w * a.w - a.x * a.x - a.y * a.y - a.z * a.z, twice * a.x, twice * a.y, twice * a.z};
}
template <class M, class R>
Quaternion<R> select(const M& mask, const Quaternion<R>& yes, const Quaternion<R>& no) {
    return {select(mask, yes.w, no.w), select(mask, yes.x, no.x), select(mask, yes.y, no.y),
            select(mask, yes.z, no.z)};
}

}  // namespace versorium
