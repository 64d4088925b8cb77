// SPDX-License-Identifier: MIT
#pragma once
// Elementary functions over any plain real number: float, double, and lanes of them. There is one
// definition of each, made of additions, multiplications, divisions and operations on bits, so that
// every instruction set and WebAssembly give the same bits. (The C library's functions differ from
// one system to the next.)
//
// Errors in units in the last place of the result, as tests/math/elementary_test.cpp checks them
// against the system's long double functions, for float and double alike:
//   exp    2        all x; underflow is gradual, overflow is +inf
//   log    2        x > 0; log(0) = -inf, log(x < 0) = NaN
//   sin, cos  3     |x| <= 2^20 (double), 2^10 (float), at results above 2^-20 (double), 2^-10
//                   (float); close to their zeros and further out the error is that of the
//                   reduction by multiples of pi/2, which grows with |x|
//   atan2  3        all points; atan2(±0, +x) = ±0, atan2(0, 0) = 0
//   pow    3 + 2 |y ln x|   x > 0; pow(0, y) is 0, 1 or +inf; pow(x < 0, y) = NaN
// They are calls: inlined into every map they would make the kernels many times as large, at no
// gain. min and max return their first argument when one of the two is NaN.

#include <array>
#include <cstddef>
#include <limits>

#include "math/lanes.h"

namespace versorium {

template <class R>
struct IsPlainReal : std::false_type {};
template <>
struct IsPlainReal<float> : std::true_type {};
template <>
struct IsPlainReal<double> : std::true_type {};
template <>
struct IsPlainReal<Lanes<float>> : std::true_type {};
template <>
struct IsPlainReal<Lanes<double>> : std::true_type {};
template <class X>
struct IsPlainReal<Pair<X>> : IsPlainReal<X> {};
template <class R>
concept PlainReal = IsPlainReal<R>::value;

// Scalars take part in the same algorithms as lanes.
inline double select(bool mask, double yes, double no) { return mask ? yes : no; }
inline float select(bool mask, float yes, float no) { return mask ? yes : no; }
inline double sqrt(double a) { return __builtin_sqrt(a); }
inline float sqrt(float a) { return __builtin_sqrtf(a); }
inline std::int64_t toBits(double a) { return __builtin_bit_cast(std::int64_t, a); }
inline std::int32_t toBits(float a) { return __builtin_bit_cast(std::int32_t, a); }
template <class T>
T fromBits(typename BitsOf<T>::type bits) {
    return __builtin_bit_cast(T, bits);
}
inline bool any(bool mask) { return mask; }
inline double lane(double a, int) { return a; }
inline float lane(float a, int) { return a; }
inline bool lane(bool a, int) { return a; }
inline void setLane(double& a, int, double value) { a = value; }
inline void setLane(float& a, int, float value) { a = value; }
inline void loadLanes(double& a, const double* from) { a = *from; }
inline void loadLanes(float& a, const float* from) { a = *from; }
inline void storeLanes(double a, double* to) { *to = a; }
inline void storeLanes(float a, float* to) { *to = a; }

namespace elementary {

// The numbers in which float and double differ.
template <class T>
struct Format;
template <>
struct Format<double> {
    using Bits = std::int64_t;
    static constexpr int kMantissa = 52;
    static constexpr Bits kBias = 1023;
    static constexpr Bits kExponentBits = 0x7ff;
    static constexpr Bits kMagnitude = 0x7fffffffffffffffLL;
    static constexpr double kRound = 0x1.8p52;  // adding it rounds to a whole number
    static constexpr double kWhole = 0x1p52;    // from here on every number is whole
    static constexpr double kLeastNormal = 0x1p-1022;
    static constexpr double kTiny = 0x1p-54, kHuge = 0x1p54;
    static constexpr Bits kTinyShift = 54;
    static constexpr double kExpLow = -746, kExpHigh = 710;
    static constexpr double kLn2High = 0x1.62e42fefa0000p-1, kLn2Low = 0x1.cf79abc9e3b3ap-40;
    // π/2 in three parts; the first two have so few bits that n times them is exact.
    static constexpr double kHalfPi1 = 0x1.921fb54400000p+0, kHalfPi2 = 0x1.0b4611a600000p-34,
                            kHalfPi3 = 0x1.3198a2e037073p-69;
    static constexpr int kExpTerms = 14, kLogTerms = 11, kSineTerms = 9, kAtanTerms = 14;
    static constexpr double kScaleDown = 0x1p-600, kScaleUp = 0x1p600, kLarge = 0x1p500,
                            kSmall = 0x1p-500;
};
template <>
struct Format<float> {
    using Bits = std::int32_t;
    static constexpr int kMantissa = 23;
    static constexpr Bits kBias = 127;
    static constexpr Bits kExponentBits = 0xff;
    static constexpr Bits kMagnitude = 0x7fffffff;
    static constexpr float kRound = 0x1.8p23F;
    static constexpr float kWhole = 0x1p23F;
    static constexpr float kLeastNormal = 0x1p-126F;
    static constexpr float kTiny = 0x1p-25F, kHuge = 0x1p25F;
    static constexpr Bits kTinyShift = 25;
    static constexpr float kExpLow = -105, kExpHigh = 89;
    static constexpr float kLn2High = 0x1.62e4p-1F, kLn2Low = 0x1.7f7d1cp-20F;
    static constexpr float kHalfPi1 = 0x1.92p+0F, kHalfPi2 = 0x1.fb4p-12F,
                           kHalfPi3 = 0x1.4442d2p-24F;
    static constexpr int kExpTerms = 8, kLogTerms = 5, kSineTerms = 5, kAtanTerms = 6;
    static constexpr float kScaleDown = 0x1p-70F, kScaleUp = 0x1p70F, kLarge = 0x1p60F,
                           kSmall = 0x1p-60F;
};

template <class R>
using FormatOf = Format<ScalarOf<R>>;
template <class R>
using BitsLike = decltype(toBits(std::declval<R>()));

template <class R>
R constant(ScalarOf<R> value) {
    return R(value);
}
template <class R>
BitsLike<R> bitsConstant(typename FormatOf<R>::Bits value) {
    return BitsLike<R>(value);
}

// 2^n for a whole number n, given as the bits of n + kRound; n + bias must be a normal exponent.
template <class R>
R powerOfTwo(const R& rounded) {
    using F = FormatOf<R>;
    const BitsLike<R> whole = toBits(rounded) - toBits(constant<R>(F::kRound));
    return fromBits<ScalarOf<R>>((whole + bitsConstant<R>(F::kBias)) << F::kMantissa);
}

// Σ coefficient(k) x^k for k = 0 … Terms-1, by Horner's rule. The coefficients are made when the
// program is compiled.
template <int Terms, class R, class Coefficient>
R horner(const R& x, Coefficient) {
    static constexpr auto kTable = [] {
        std::array<ScalarOf<R>, Terms> table{};
        for (int k = 0; k < Terms; ++k) table[static_cast<std::size_t>(k)] = Coefficient{}(k);
        return table;
    }();
    R sum = constant<R>(kTable[Terms - 1]);
    for (int k = Terms - 2; k >= 0; --k)
        sum = sum * x + constant<R>(kTable[static_cast<std::size_t>(k)]);
    return sum;
}

template <class T>
constexpr T inverseFactorial(int n) {
    double product = 1;
    for (int k = 2; k <= n; ++k) product *= k;
    return static_cast<T>(1 / product);
}

}  // namespace elementary

template <PlainReal R>
R abs(const R& a) {
    using F = elementary::FormatOf<R>;
    return fromBits<ScalarOf<R>>(toBits(a) & elementary::bitsConstant<R>(F::kMagnitude));
}
template <PlainReal R>
R min(const R& a, const R& b) {
    return select(b < a, b, a);
}
template <PlainReal R>
R max(const R& a, const R& b) {
    return select(a < b, b, a);
}
template <PlainReal R>
auto isNan(const R& a) {
    return a != a;
}

// The nearest whole number, ties to even.
template <PlainReal R>
R round(const R& a) {
    using F = elementary::FormatOf<R>;
    const R rounded = (a + R(F::kRound)) - R(F::kRound);
    return select(abs(a) < R(F::kWhole), rounded, a);
}
// The greatest whole number that is not above a.
template <PlainReal R>
R floor(const R& a) {
    const R nearest = round(a);
    return select(a < nearest, nearest - R(ScalarOf<R>(1)), nearest);
}

template <PlainReal R>
[[gnu::noinline]] R exp(const R& a) {
    using F = elementary::FormatOf<R>;
    using T = ScalarOf<R>;
    const R x = min(max(a, R(F::kExpLow)), R(F::kExpHigh));
    // a = n ln 2 + r with |r| <= ln 2 / 2; 2^n in two factors, so that underflow is gradual.
    const R rounded = x * R(T(1.4426950408889634074)) + R(F::kRound);
    const R n = rounded - R(F::kRound);
    const R r = (x - n * R(F::kLn2High)) - n * R(F::kLn2Low);
    const R half = n * R(T(0.5)) + R(F::kRound);
    const R rest = (n - (half - R(F::kRound))) + R(F::kRound);
    // e^r = 1 + r + r²(1/2 + r/6 + …): the small terms first.
    const R tail = elementary::horner<F::kExpTerms - 2>(
        r, [](int k) { return elementary::inverseFactorial<T>(k + 2); });
    const R value = R(T(1)) + (r + r * r * tail);
    const R result = value * elementary::powerOfTwo(half) * elementary::powerOfTwo(rest);
    return select(isNan(a), a, result);
}

template <PlainReal R>
[[gnu::noinline]] R log(const R& a) {
    using F = elementary::FormatOf<R>;
    using T = ScalarOf<R>;
    const auto subnormal = a < R(F::kLeastNormal);
    const auto positive = a > R(T(0));
    const R x = select(positive, select(subnormal, a * R(F::kHuge), a), R(T(1)));
    // x = 2^e m with m in [sqrt(1/2), sqrt(2)): shift the bits so that m's border is a carry.
    const auto offset = toBits(R(T(1))) - toBits(R(T(0.70710678118654752440)));
    const auto shifted = toBits(x) + offset;
    const auto exponent = (shifted >> F::kMantissa) & elementary::bitsConstant<R>(F::kExponentBits);
    const auto unbiased = exponent - elementary::bitsConstant<R>(F::kBias);
    const R m = fromBits<T>(toBits(x) - (unbiased << F::kMantissa));
    const R whole = fromBits<T>(unbiased + toBits(R(F::kRound))) - R(F::kRound);
    const R e = select(subnormal, whole - R(T(F::kTinyShift)), whole);
    // log(1 + f) = f - f²/2 + s (f²/2 + 2 s² (1/3 + s²/5 + …)), s = f / (2 + f).
    const R f = m - R(T(1));
    const R s = f / (R(T(2)) + f);
    const R z = s * s;
    const R series = z * elementary::horner<F::kLogTerms>(
                             z, [](int k) { return static_cast<T>(2.0 / (2 * k + 3)); });
    const R halfSquare = R(T(0.5)) * f * f;
    const R value =
        e * R(F::kLn2High) - ((halfSquare - (s * (halfSquare + series) + e * R(F::kLn2Low))) - f);
    constexpr T infinity = std::numeric_limits<T>::infinity();
    const R special = select(a == R(T(0)), R(-infinity), R(std::numeric_limits<T>::quiet_NaN()));
    const R finite = select(positive, value, special);
    return select(a == R(infinity), a, finite);
}

namespace elementary {

// sin and cos of r, |r| <= π/4, by their series about 0.
template <class R>
R sineSeries(const R& r) {
    using T = ScalarOf<R>;
    const R square = r * r;
    const R tail = horner<FormatOf<R>::kSineTerms - 1>(
        square, [](int k) { return (k % 2 == 0 ? T(-1) : T(1)) * inverseFactorial<T>(2 * k + 3); });
    return r + r * (square * tail);
}
template <class R>
R cosineSeries(const R& r) {
    using T = ScalarOf<R>;
    const R square = r * r;
    const R tail = horner<FormatOf<R>::kSineTerms - 1>(
        square, [](int k) { return (k % 2 == 0 ? T(1) : T(-1)) * inverseFactorial<T>(2 * k + 4); });
    const R half = T(0.5) * square;
    // 1 - half is rounded; what it lost comes back with the tail.
    const R main = R(T(1)) - half;
    return main + (((R(T(1)) - main) - half) + square * square * tail);
}

// sin(x + quarter·π/2).
template <class R>
[[gnu::noinline]] R sineOfQuarter(const R& x, typename Format<ScalarOf<R>>::Bits quarter) {
    using F = FormatOf<R>;
    using T = ScalarOf<R>;
    const R rounded = x * R(T(0.63661977236758134308)) + R(F::kRound);
    const R n = rounded - R(F::kRound);
    const R r = ((x - n * R(F::kHalfPi1)) - n * R(F::kHalfPi2)) - n * R(F::kHalfPi3);
    const auto turns = (toBits(rounded) + bitsConstant<R>(quarter)) & bitsConstant<R>(3);
    const R sine = sineSeries(r), cosine = cosineSeries(r);
    // The quarters 0 … 3 as numbers, since comparisons of integers are not needed elsewhere.
    const R q = fromBits<T>(turns + toBits(R(F::kRound))) - R(F::kRound);
    const R odd = select((q == R(T(1))) | (q == R(T(3))), cosine, sine);
    const R value = select(q < R(T(2)), odd, -odd);
    return select(abs(x) < R(F::kWhole), value, x - x + R(std::numeric_limits<T>::quiet_NaN()));
}

}  // namespace elementary

template <PlainReal R>
R sin(const R& x) {
    return elementary::sineOfQuarter(x, 0);
}
template <PlainReal R>
R cos(const R& x) {
    return elementary::sineOfQuarter(x, 1);
}

// The angle of the point (x, y) in (-π, π]; NaN where a coordinate is NaN.
template <PlainReal R>
[[gnu::noinline]] R atan2(const R& y, const R& x) {
    using F = elementary::FormatOf<R>;
    using T = ScalarOf<R>;
    constexpr T infinity = std::numeric_limits<T>::infinity();
    const R across = abs(x), up = abs(y);
    R least = min(across, up), most = max(across, up);
    // Two infinities make 45°, one makes 0° or 90°; 0/0 is 0.
    const auto endless = most == R(infinity);
    least = select(endless, select(least == R(infinity), R(T(1)), R(T(0))), least);
    most = select(endless | (most == R(T(0))), R(T(1)), most);
    const R scale = select(most > R(F::kLarge), R(F::kScaleDown),
                           select(most < R(F::kSmall), R(F::kScaleUp), R(T(1))));
    least = least * scale;
    most = most * scale;
    // atan(t) = atan(c) + atan((t - c) / (1 + t c)) with c = 0, 1/2 or 1, whichever is nearest.
    const auto one = least > R(T(0.75)) * most;
    const auto half = least > R(T(0.25)) * most;
    const R c = select(one, R(T(1)), select(half, R(T(0.5)), R(T(0))));
    const R base = select(one, R(T(0.78539816339744830962)),
                          select(half, R(T(0.46364760900080611621)), R(T(0))));
    const R u = (least - c * most) / (most + c * least);
    const R square = u * u;
    const R tail = elementary::horner<F::kAtanTerms - 1>(
        square, [](int k) { return static_cast<T>((k % 2 == 0 ? -1.0 : 1.0) / (2 * k + 3)); });
    R angle = base + (u + u * (square * tail));
    angle = select(up > across, R(T(1.57079632679489661923)) - angle, angle);
    angle = select(x < R(T(0)), R(T(3.14159265358979323846)) - angle, angle);
    // The sign of y's bits, so that -0 counts as below the axis except at the origin.
    const R sign = fromBits<T>((toBits(y) & toBits(R(T(-0.0)))) | toBits(R(T(1))));
    angle = select((across == R(T(0))) & (up == R(T(0))), R(T(0)), angle * sign);
    return select(isNan(x) | isNan(y), x + y, angle);
}

template <PlainReal R>
R pow(const R& x, const R& y) {
    using T = ScalarOf<R>;
    const R value = exp(y * log(x));
    const R atZero = select(y > R(T(0)), R(T(0)), R(std::numeric_limits<T>::infinity()));
    return select(y == R(T(0)), R(T(1)), select(x == R(T(0)), atZero, value));
}

}  // namespace versorium
