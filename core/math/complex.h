// SPDX-License-Identifier: MIT
#pragma once
// Complex numbers over any number type R (plain, lanes, dual, recording). The operations are the
// textbook ones, in a fixed order, with no special treatment of infinities.

#include "math/elementary.h"

namespace versorium {

template <class R>
struct Complex {
    using Real = R;
    static constexpr int kDimension = 2;

    R re, im;

    friend Complex operator+(const Complex& a, const Complex& b) {
        return {a.re + b.re, a.im + b.im};
    }
    friend Complex operator-(const Complex& a, const Complex& b) {
        return {a.re - b.re, a.im - b.im};
    }
    friend Complex operator-(const Complex& a) { return {-a.re, -a.im}; }
    friend Complex operator*(const Complex& a, const Complex& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend Complex operator/(const Complex& a, const Complex& b) { return a * inverse(b); }
    friend Complex operator*(const R& s, const Complex& a) { return {s * a.re, s * a.im}; }
};

template <class R>
Complex<R> conjugate(const Complex<R>& a) {
    return {a.re, -a.im};
}
template <class R>
R squaredNorm(const Complex<R>& a) {
    return a.re * a.re + a.im * a.im;
}
template <class R>
Complex<R> inverse(const Complex<R>& a) {
    const R scale = R(1.0) / squaredNorm(a);
    return {a.re * scale, -(a.im * scale)};
}
// Three multiplications and two additions: the form that kernels spend their time in.
template <class R>
Complex<R> square(const Complex<R>& a) {
    const R product = a.re * a.im;
    return {a.re * a.re - a.im * a.im, product + product};
}
// The angle in (-π, π].
template <class R>
R argument(const Complex<R>& a) {
    return atan2(a.im, a.re);
}
template <class M, class R>
Complex<R> select(const M& mask, const Complex<R>& yes, const Complex<R>& no) {
    return {select(mask, yes.re, no.re), select(mask, yes.im, no.im)};
}
// The principal square root: the one with a real part >= 0.
template <class R>
Complex<R> squareRoot(const Complex<R>& a) {
    const R modulus = sqrt(squaredNorm(a));
    const R re = sqrt(max(R(0.5) * (modulus + a.re), R(0.0)));
    const R im = sqrt(max(R(0.5) * (modulus - a.re), R(0.0)));
    return {re, select(a.im < R(0.0), -im, im)};
}

}  // namespace versorium
