// SPDX-License-Identifier: MIT
#pragma once
// The elementary functions that formulas are typed with, over any number type R: of real numbers,
// of complex numbers on their principal branches, and of quaternions w + v as functions of the
// complex plane through 1 and v, f(w + v) = Re f(w + i|v|) + v/|v| Im f(w + i|v|) (v/|v| is 0 where
// v = 0). All stand on math/elementary.h, so that they give the same bits everywhere and leave a
// tape.
//
// On a branch cut the value is that from above (for acosh and what follows from asin: from where
// Kahan's formulas put it). Errors are a few units in the last place of the larger part of the
// result, but near zeros that are not 0 itself.

#include "math/complex.h"
#include "math/quaternion.h"

namespace versorium::functions {

using versorium::cos;
using versorium::exp;
using versorium::log;
using versorium::sin;
using versorium::sqrt;

// ---- real numbers ------------------------------------------------------------------------------

// Beyond this cosh overflows, and tanh is 1 long before.
inline constexpr double kMostHyperbolic = 350;

// Near 0 the series, since e^x - e^-x loses digits there.
template <class R>
R sinh(const R& x) {
    const R up = exp(x);
    const R square = x * x;
    R series = R(1.0 / 1307674368000.0);
    for (double factorial : {6227020800.0, 39916800.0, 362880.0, 5040.0, 120.0, 6.0})
        series = series * square + R(1.0 / factorial);
    return select(abs(x) < R(0.5), x + x * (square * series), R(0.5) * (up - R(1.0) / up));
}
template <class R>
R cosh(const R& x) {
    const R up = exp(abs(x));
    return R(0.5) * (up + R(1.0) / up);
}
template <class R>
R within(const R& x, double most) {
    // NaN stays: min and max return their first argument then.
    return max(min(x, R(most)), R(-most));
}
template <class R>
R tanh(const R& x) {
    const R y = within(x, kMostHyperbolic);
    return sinh(y) / cosh(y);
}
template <class R>
R tan(const R& x) {
    return sin(x) / cos(x);
}
template <class R>
R asin(const R& x) {
    return atan2(x, sqrt((R(1.0) - x) * (R(1.0) + x)));
}
template <class R>
R acos(const R& x) {
    return atan2(sqrt((R(1.0) - x) * (R(1.0) + x)), x);
}
template <class R>
R atan(const R& x) {
    return atan2(x, R(1.0));
}
// log(1 + x) without the loss near 0: with u = 1 + x, log(u) x / (u - 1).
template <class R>
R logOfOnePlus(const R& x) {
    const R u = R(1.0) + x;
    const R d = u - R(1.0);
    const auto none = d == R(0.0);
    const auto huge = abs(x) > R(1e15);
    return select(none, x, select(huge, log(u), log(u) * (x / select(none, R(1.0), d))));
}
template <class R>
R asinh(const R& x) {
    const R size = abs(x);
    const R square = x * x;
    // Squares of very large numbers overflow; log(2|x|) is as good there.
    const auto large = size > R(1e18);
    const R small = logOfOnePlus(size + square / (R(1.0) + sqrt(R(1.0) + square)));
    const R value = select(large, log(size) + R(0.69314718055994530942), small);
    return select(x < R(0.0), -value, value);
}
template <class R>
R acosh(const R& x) {
    const R t = x - R(1.0);
    const auto large = x > R(1e18);
    const R small = logOfOnePlus(t + sqrt(t * (x + R(1.0))));
    return select(large, log(x) + R(0.69314718055994530942), small);
}
template <class R>
R atanh(const R& x) {
    return R(0.5) * logOfOnePlus((x + x) / (R(1.0) - x));
}

// ---- complex numbers ---------------------------------------------------------------------------

// -0 becomes 0, so that cuts are seen from above.
template <class R>
R fromAbove(const R& x) {
    return x + R(0.0);
}
// z i and z / i.
template <class R>
Complex<R> timesI(const Complex<R>& z) {
    return {-z.im, z.re};
}
template <class R>
Complex<R> overI(const Complex<R>& z) {
    return {z.im, -z.re};
}

template <class R>
Complex<R> exp(const Complex<R>& z) {
    const R modulus = exp(z.re);
    return {modulus * cos(z.im), modulus * sin(z.im)};
}
template <class R>
Complex<R> log(const Complex<R>& z) {
    return {R(0.5) * log(squaredNorm(z)), atan2(fromAbove(z.im), z.re)};
}
template <class R>
Complex<R> sqrt(const Complex<R>& z) {
    const R modulus = sqrt(squaredNorm(z));
    const R t = sqrt(R(0.5) * (modulus + abs(z.re)));
    const auto zero = t == R(0.0);
    const R other = select(zero, R(0.0), z.im / select(zero, R(1.0), t + t));
    const auto left = z.re < R(0.0);
    return {select(left, abs(other), t), select(left, select(z.im < R(0.0), -t, t), other)};
}
template <class R>
Complex<R> sin(const Complex<R>& z) {
    return {sin(z.re) * cosh(z.im), cos(z.re) * sinh(z.im)};
}
template <class R>
Complex<R> cos(const Complex<R>& z) {
    return {cos(z.re) * cosh(z.im), -(sin(z.re) * sinh(z.im))};
}
// (sin 2x + i sinh 2y) / (cos 2x + cosh 2y).
template <class R>
Complex<R> tan(const Complex<R>& z) {
    // Both terms below are positive, so that nothing cancels near a pole.
    const R y = within(z.im, 0.5 * kMostHyperbolic);
    const R cosine = cos(z.re), up = sinh(y);
    const R below = cosine * cosine + up * up;
    return {sin(z.re) * cosine / below, up * cosh(y) / below};
}
template <class R>
Complex<R> sinh(const Complex<R>& z) {
    return {sinh(z.re) * cos(z.im), cosh(z.re) * sin(z.im)};
}
template <class R>
Complex<R> cosh(const Complex<R>& z) {
    return {cosh(z.re) * cos(z.im), sinh(z.re) * sin(z.im)};
}
template <class R>
Complex<R> tanh(const Complex<R>& z) {
    return overI(tan(timesI(z)));
}
// The inverse functions by W. Kahan, "Branch cuts for complex elementary functions", 1987.
template <class R>
Complex<R> asin(const Complex<R>& z) {
    const Complex<R> low = sqrt(Complex<R>{R(1.0) - z.re, -z.im});
    const Complex<R> high = sqrt(Complex<R>{R(1.0) + z.re, z.im});
    return {atan2(z.re, low.re * high.re - low.im * high.im),
            asinh(low.re * high.im - low.im * high.re)};
}
template <class R>
Complex<R> acos(const Complex<R>& z) {
    const Complex<R> low = sqrt(Complex<R>{R(1.0) - z.re, -z.im});
    const Complex<R> high = sqrt(Complex<R>{R(1.0) + z.re, z.im});
    const R angle = atan2(low.re, high.re);
    return {angle + angle, asinh(high.re * low.im - high.im * low.re)};
}
template <class R>
Complex<R> atan(const Complex<R>& z) {
    const R square = z.re * z.re;
    const R up = R(1.0) + z.im, down = R(1.0) - z.im;
    const R twice = z.re + z.re;
    return {R(0.5) * atan2(twice, up * down - square),
            R(0.25) * logOfOnePlus(R(4.0) * z.im / (square + down * down))};
}
template <class R>
Complex<R> asinh(const Complex<R>& z) {
    return overI(asin(timesI(z)));
}
template <class R>
Complex<R> acosh(const Complex<R>& z) {
    const Complex<R> low = sqrt(Complex<R>{z.re - R(1.0), z.im});
    const Complex<R> high = sqrt(Complex<R>{z.re + R(1.0), z.im});
    const R angle = atan2(low.im, high.re);
    return {asinh(low.re * high.re + low.im * high.im), angle + angle};
}
template <class R>
Complex<R> atanh(const Complex<R>& z) {
    return overI(atan(timesI(z)));
}
// z^w = e^(w log z); 0 where z is 0 and the real part of w is positive.
template <class R>
Complex<R> complexExponent(const Complex<R>& z, const Complex<R>& w) {
    const auto zero = (squaredNorm(z) == R(0.0)) & (w.re > R(0.0));
    const Complex<R> raised = exp(w * log(z));
    return {select(zero, R(0.0), raised.re), select(zero, R(0.0), raised.im)};
}

// ---- quaternions -------------------------------------------------------------------------------

template <class R, class Function>
Quaternion<R> alongAxis(const Quaternion<R>& q, Function function) {
    const R length = sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
    const Complex<R> value = function(Complex<R>{q.w, length});
    const auto real = length == R(0.0);
    const R scale = select(real, R(0.0), value.im / select(real, R(1.0), length));
    return {value.re, scale * q.x, scale * q.y, scale * q.z};
}

}  // namespace versorium::functions
