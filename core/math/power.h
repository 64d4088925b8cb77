// SPDX-License-Identifier: MIT
#pragma once
// Powers of complex numbers and quaternions with a real exponent (Q section 3):
//   z^e = |z|^e (cos eθ + v̂ sin eθ),  θ = atan2(|v|, w),  v̂ = v / |v| (0 where v = 0)
// on the principal branch. A whole exponent up to ±256 is done by repeated squaring instead, which
// needs no transcendental function and has no seam. Each lane decides for itself, so that lanes and
// scalars agree.

#include "math/complex.h"
#include "math/dual.h"
#include "math/quaternion.h"

namespace versorium {

inline constexpr double kLargestWholePower = 256;

namespace powers {

// base^exponent for whole exponents >= 1 lane by lane; lanes with exponent 0 give `one`.
template <class Z, class P>
Z wholePower(Z base, P left, const Z& one) {
    Z result = one;
    auto untouched = left == left;
    while (true) {
        const P half = floor(left * P(0.5));
        const auto odd = (left - (half + half)) != P(0.0);
        result = select(odd, select(untouched, base, result * base), result);
        untouched = untouched & !odd;
        left = half;
        if (!any(left > P(0.0))) return result;
        base = square(base);
    }
}

template <class R>
Complex<R> unit(const Complex<R>&) {
    return {R(1.0), R(0.0)};
}
template <class R>
Quaternion<R> unit(const Quaternion<R>&) {
    return {R(1.0), R(0.0), R(0.0), R(0.0)};
}
template <class R>
Complex<R> polarPower(const Complex<R>& z, const R& e) {
    const R modulus = pow(sqrt(squaredNorm(z)), e);
    const R angle = e * argument(z);
    return {modulus * cos(angle), modulus * sin(angle)};
}
template <class R>
Quaternion<R> polarPower(const Quaternion<R>& q, const R& e) {
    const R modulus = pow(sqrt(squaredNorm(q)), e);
    const R length = sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
    const R angle = e * atan2(length, q.w);
    const R scale = modulus * select(length == R(0.0), R(0.0), sin(angle) / length);
    return {modulus * cos(angle), scale * q.x, scale * q.y, scale * q.z};
}

// z^e ln z, the derivative by the exponent, added to the slope of a whole power where the exponent
// moves. Plain numbers have none.
template <class Z, class R>
Z alongExponent(const Z& raised, const Z&, const R&) {
    return raised;
}
template <class R>
Complex<Dual<R>> alongExponent(Complex<Dual<R>> raised, const Complex<Dual<R>>& z,
                               const Dual<R>& exponent) {
    if (!any(plainValue(exponent.slope) != plainValue(R(0.0)))) return raised;
    const Complex<R> base{z.re.value, z.im.value}, value{raised.re.value, raised.im.value};
    const R square = squaredNorm(base);
    const Complex<R> logarithm{R(0.5) * log(square), argument(base)};
    const Complex<R> slope = exponent.slope * (value * logarithm);
    const auto moves = (exponent.slope != R(0.0)) & (square > R(0.0));
    raised.re.slope = raised.re.slope + select(moves, slope.re, R(0.0));
    raised.im.slope = raised.im.slope + select(moves, slope.im, R(0.0));
    return raised;
}
template <class R>
Quaternion<Dual<R>> alongExponent(Quaternion<Dual<R>> raised, const Quaternion<Dual<R>>& q,
                                  const Dual<R>& exponent) {
    if (!any(plainValue(exponent.slope) != plainValue(R(0.0)))) return raised;
    const Quaternion<R> value{raised.w.value, raised.x.value, raised.y.value, raised.z.value};
    const R x = q.x.value, y = q.y.value, z = q.z.value;
    const R length = sqrt(x * x + y * y + z * z), square = length * length + q.w.value * q.w.value;
    const R scale = select(length == R(0.0), R(0.0), atan2(length, q.w.value) / length);
    const Quaternion<R> logarithm{R(0.5) * log(square), scale * x, scale * y, scale * z};
    const Quaternion<R> slope = exponent.slope * (value * logarithm);
    const auto moves = (exponent.slope != R(0.0)) & (square > R(0.0));
    raised.w.slope = raised.w.slope + select(moves, slope.w, R(0.0));
    raised.x.slope = raised.x.slope + select(moves, slope.x, R(0.0));
    raised.y.slope = raised.y.slope + select(moves, slope.y, R(0.0));
    raised.z.slope = raised.z.slope + select(moves, slope.z, R(0.0));
    return raised;
}

// Whether an exponent is known to be 1 in all lanes. One that has a slope, or is recorded, is not.
template <class R>
bool isOne(const R& exponent) {
    if constexpr (PlainReal<R>)
        return !any(exponent != R(1.0));
    else
        return false;
}

template <class Z, class R>
Z anyPower(const Z& z, const R& exponent) {
    if (isOne(exponent)) return z;
    const auto e = plainValue(exponent);
    using P = std::remove_cvref_t<decltype(e)>;
    const P size = abs(e);
    const auto whole = (floor(size) == size) & (size <= P(kLargestWholePower));
    const auto polar = !whole;
    if (!any(whole)) return polarPower(z, exponent);
    const Z raised = wholePower(z, select(whole, size, P(1.0)), unit(z));
    const auto negative = whole & (e < P(0.0));
    const Z result = alongExponent(
        any(negative) ? select(negative, inverse(raised), raised) : raised, z, exponent);
    return any(polar) ? select(polar, polarPower(z, exponent), result) : result;
}

}  // namespace powers

template <class R>
Complex<R> power(const Complex<R>& z, const R& exponent) {
    return powers::anyPower(z, exponent);
}
template <class R>
Quaternion<R> power(const Quaternion<R>& q, const R& exponent) {
    return powers::anyPower(q, exponent);
}

}  // namespace versorium
