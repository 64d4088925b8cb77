// SPDX-License-Identifier: MIT
#pragma once
// Dual numbers a + b ε, ε² = 0: a value and its derivative along one direction, over any number
// type. Running a map on them gives the derivative of the map along the seeded direction. Duals of
// duals give second derivatives. The derivative of |x| at 0 is taken as that of +x.

#include "math/elementary.h"

namespace versorium {

template <class R>
struct Dual {
    R value, slope;

    Dual() = default;
    Dual(R a, R b) : value(a), slope(b) {}
    explicit Dual(R a) requires(!std::is_arithmetic_v<R>) : value(a), slope(R(0.0)) {}
    Dual(double a) : value(R(a)), slope(R(0.0)) {}

    friend Dual operator+(const Dual& a, const Dual& b) {
        return {a.value + b.value, a.slope + b.slope};
    }
    friend Dual operator-(const Dual& a, const Dual& b) {
        return {a.value - b.value, a.slope - b.slope};
    }
    friend Dual operator-(const Dual& a) { return {-a.value, -a.slope}; }
    friend Dual operator*(const Dual& a, const Dual& b) {
        return {a.value * b.value, a.value * b.slope + a.slope * b.value};
    }
    friend Dual operator/(const Dual& a, const Dual& b) {
        const R quotient = a.value / b.value;
        return {quotient, (a.slope - quotient * b.slope) / b.value};
    }
    // Only values are compared: the branch that the value takes is the one that is differentiated.
    friend auto operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
    friend auto operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
    friend auto operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
    friend auto operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
    friend auto operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
    friend auto operator!=(const Dual& a, const Dual& b) { return a.value != b.value; }
};

template <class R>
struct LaneTraits<Dual<R>> {
    using Scalar = ScalarOf<R>;
    static constexpr int kCount = kLaneCount<R>;
};

template <class M, class R>
Dual<R> select(const M& mask, const Dual<R>& yes, const Dual<R>& no) {
    return {select(mask, yes.value, no.value), select(mask, yes.slope, no.slope)};
}
template <class R>
auto isNan(const Dual<R>& a) {
    return isNan(a.value);
}
template <class R>
Dual<R> abs(const Dual<R>& a) {
    return {abs(a.value), select(a.value < R(0.0), -a.slope, a.slope)};
}
template <class R>
Dual<R> min(const Dual<R>& a, const Dual<R>& b) {
    return select(b.value < a.value, b, a);
}
template <class R>
Dual<R> max(const Dual<R>& a, const Dual<R>& b) {
    return select(a.value < b.value, b, a);
}
template <class R>
Dual<R> floor(const Dual<R>& a) {
    return {floor(a.value), R(0.0)};
}
template <class R>
Dual<R> sqrt(const Dual<R>& a) {
    const R root = sqrt(a.value);
    return {root, select(root == R(0.0), R(0.0), a.slope / (root + root))};
}
template <class R>
Dual<R> exp(const Dual<R>& a) {
    const R value = exp(a.value);
    return {value, value * a.slope};
}
template <class R>
Dual<R> log(const Dual<R>& a) {
    return {log(a.value), a.slope / a.value};
}
template <class R>
Dual<R> sin(const Dual<R>& a) {
    return {sin(a.value), cos(a.value) * a.slope};
}
template <class R>
Dual<R> cos(const Dual<R>& a) {
    return {cos(a.value), -(sin(a.value) * a.slope)};
}
template <class R>
Dual<R> atan2(const Dual<R>& y, const Dual<R>& x) {
    const R square = x.value * x.value + y.value * y.value;
    const R slope = (x.value * y.slope - y.value * x.slope) / square;
    return {atan2(y.value, x.value), select(square == R(0.0), R(0.0), slope)};
}
template <class R>
Dual<R> pow(const Dual<R>& x, const Dual<R>& y) {
    const R value = pow(x.value, y.value);
    const R bySlope = y.value * pow(x.value, y.value - R(1.0)) * x.slope;
    // The exponent's part only where it moves: log of a base that is 0 would spoil the rest.
    const R byExponent = select(y.slope == R(0.0), R(0.0), value * log(x.value) * y.slope);
    return {value, bySlope + byExponent};
}

// The plain value inside, however deep.
template <PlainReal R>
const R& plainValue(const R& a) {
    return a;
}
template <class R>
auto plainValue(const Dual<R>& a) {
    return plainValue(a.value);
}

}  // namespace versorium
