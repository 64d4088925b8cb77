// SPDX-License-Identifier: MIT
#pragma once
// Several numbers that are computed with at once. `Lanes<T>` is one machine register, `Pair<X>` two
// X side by side, so that Pair<Pair<Lanes<double>>> keeps four registers in flight and hides the
// latency of the operations. All operations are lane by lane and, without contraction, give each
// lane the bits that the scalar operation gives.
//
// This header is compiled once per instruction set: the width of a register and the inner
// namespace follow the target, so that code for different sets never shares a symbol.

#include <cstdint>
#include <cstring>
#include <type_traits>

#if defined(VERSORIUM_KERNEL_TARGET)
#define VERSORIUM_TARGET VERSORIUM_KERNEL_TARGET
#else
#define VERSORIUM_TARGET baseline
#endif
#if defined(__AVX512F__)
#define VERSORIUM_LANE_BYTES 64
#elif defined(__AVX2__)
#define VERSORIUM_LANE_BYTES 32
#else
#define VERSORIUM_LANE_BYTES 16
#endif

namespace versorium {
inline namespace VERSORIUM_TARGET {

template <class T>
struct RegisterOf;
template <>
struct RegisterOf<double> {
    typedef double type __attribute__((vector_size(VERSORIUM_LANE_BYTES)));
};
template <>
struct RegisterOf<float> {
    typedef float type __attribute__((vector_size(VERSORIUM_LANE_BYTES)));
};
template <>
struct RegisterOf<std::int64_t> {
    typedef std::int64_t type __attribute__((vector_size(VERSORIUM_LANE_BYTES)));
};
template <>
struct RegisterOf<std::int32_t> {
    typedef std::int32_t type __attribute__((vector_size(VERSORIUM_LANE_BYTES)));
};

// What sums are formed in. Integers wrap around: the bits of NaN are numbers like any other.
template <class T>
struct WrappingOf {
    using type = typename RegisterOf<T>::type;
};
template <>
struct WrappingOf<std::int64_t> {
    typedef std::uint64_t type __attribute__((vector_size(VERSORIUM_LANE_BYTES)));
};
template <>
struct WrappingOf<std::int32_t> {
    typedef std::uint32_t type __attribute__((vector_size(VERSORIUM_LANE_BYTES)));
};

// The integer of the same width as a number, lane by lane.
template <class T>
struct BitsOf;
template <>
struct BitsOf<double> {
    using type = std::int64_t;
};
template <>
struct BitsOf<float> {
    using type = std::int32_t;
};

template <class T>
struct Lanes {
    using Scalar = T;
    using Register = typename RegisterOf<T>::type;
    using Wrapping = typename WrappingOf<T>::type;
    static constexpr int kCount = VERSORIUM_LANE_BYTES / sizeof(T);

    Register v;

    Lanes() = default;
    Lanes(Register value) : v(value) {}
    Lanes(T value) : v(value - Register{}) {}

    friend Lanes operator+(Lanes a, Lanes b) { return Register(Wrapping(a.v) + Wrapping(b.v)); }
    friend Lanes operator-(Lanes a, Lanes b) { return Register(Wrapping(a.v) - Wrapping(b.v)); }
    friend Lanes operator*(Lanes a, Lanes b) { return Register(a.v * b.v); }
    friend Lanes operator/(Lanes a, Lanes b) { return Register(a.v / b.v); }
    friend Lanes operator-(Lanes a) { return Register(-a.v); }
};

// A truth value for each lane: all bits set, or none.
template <class T>
struct LanesMask {
    using Integer = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
    using Register = typename RegisterOf<Integer>::type;

    Register v;

    friend LanesMask operator&(LanesMask a, LanesMask b) { return {Register(a.v & b.v)}; }
    friend LanesMask operator|(LanesMask a, LanesMask b) { return {Register(a.v | b.v)}; }
    friend LanesMask operator!(LanesMask a) { return {Register(~a.v)}; }
};

#define VERSORIUM_COMPARE(op)                                         \
    template <class T>                                                \
    LanesMask<T> operator op(Lanes<T> a, Lanes<T> b) {                \
        return {(typename LanesMask<T>::Register)(a.v op b.v)};       \
    }                                                                 \
    template <class T>                                                \
    LanesMask<T> operator op(Lanes<T> a, std::type_identity_t<T> b) { \
        return a op Lanes<T>(b);                                      \
    }
VERSORIUM_COMPARE(<)
VERSORIUM_COMPARE(<=)
VERSORIUM_COMPARE(>)
VERSORIUM_COMPARE(>=)
VERSORIUM_COMPARE(==)
VERSORIUM_COMPARE(!=)
#undef VERSORIUM_COMPARE

template <class T>
Lanes<T> select(LanesMask<T> mask, Lanes<T> yes, Lanes<T> no) {
    return typename Lanes<T>::Register(mask.v ? yes.v : no.v);
}

template <class T>
Lanes<T> sqrt(Lanes<T> a) {
    Lanes<T> root;
    for (int i = 0; i < Lanes<T>::kCount; ++i) root.v[i] = T(__builtin_sqrt(double(a.v[i])));
    return root;
}
template <>
inline Lanes<float> sqrt(Lanes<float> a) {
    Lanes<float> root;
    for (int i = 0; i < Lanes<float>::kCount; ++i) root.v[i] = __builtin_sqrtf(a.v[i]);
    return root;
}

template <class T>
Lanes<typename BitsOf<T>::type> toBits(Lanes<T> a) {
    return (typename RegisterOf<typename BitsOf<T>::type>::type)(a.v);
}
template <class T>
Lanes<T> fromBits(Lanes<typename BitsOf<T>::type> bits) {
    return (typename RegisterOf<T>::type)(bits.v);
}
// Integers only: bit operations and shifts by a constant.
template <class I>
Lanes<I> operator&(Lanes<I> a, Lanes<I> b) {
    return typename Lanes<I>::Register(a.v & b.v);
}
template <class I>
Lanes<I> operator|(Lanes<I> a, Lanes<I> b) {
    return typename Lanes<I>::Register(a.v | b.v);
}
template <class I>
Lanes<I> operator<<(Lanes<I> a, int count) {
    return typename Lanes<I>::Register(a.v << count);
}
// Only for values whose sign bit is clear.
template <class I>
Lanes<I> operator>>(Lanes<I> a, int count) {
    return typename Lanes<I>::Register(a.v >> count);
}

// One bit for each lane, the first lane lowest.
template <class T>
std::uint64_t maskBits(LanesMask<T> mask) {
#if defined(__AVX512DQ__)
    if constexpr (sizeof(T) == 8)
        return static_cast<std::uint8_t>(
            __builtin_ia32_cvtq2mask512((long long __attribute__((vector_size(64))))mask.v));
    else
        return static_cast<std::uint16_t>(
            __builtin_ia32_cvtd2mask512((int __attribute__((vector_size(64))))mask.v));
#elif defined(__AVX2__)
    if constexpr (sizeof(T) == 8)
        return static_cast<std::uint64_t>(
            __builtin_ia32_movmskpd256((typename RegisterOf<double>::type)mask.v));
    else
        return static_cast<std::uint64_t>(
            __builtin_ia32_movmskps256((typename RegisterOf<float>::type)mask.v));
#else
    std::uint64_t bits = 0;
    for (int i = 0; i < Lanes<T>::kCount; ++i)
        bits |= static_cast<std::uint64_t>(mask.v[i] & 1) << i;
    return bits;
#endif
}
template <class T>
bool any(LanesMask<T> mask) {
    return maskBits(mask) != 0;
}

template <class T>
T lane(Lanes<T> a, int index) {
    return a.v[index];
}
template <class T>
bool lane(LanesMask<T> a, int index) {
    return a.v[index] != 0;
}
template <class T>
void setLane(Lanes<T>& a, int index, T value) {
    a.v[index] = value;
}
template <class T>
void loadLanes(Lanes<T>& a, const T* from) {
    std::memcpy(&a.v, from, sizeof a.v);
}
template <class T>
void storeLanes(Lanes<T> a, T* to) {
    std::memcpy(to, &a.v, sizeof a.v);
}

}  // namespace VERSORIUM_TARGET

// Two of a kind. Comparisons of Pairs give a Pair of truth values.
template <class X>
struct Pair {
    X low, high;

    Pair() = default;
    Pair(X first, X second) : low(first), high(second) {}
    template <class T>
    requires std::is_arithmetic_v<T> Pair(T value) : low(value), high(value) {}

    friend Pair operator+(const Pair& a, const Pair& b) { return {a.low + b.low, a.high + b.high}; }
    friend Pair operator-(const Pair& a, const Pair& b) { return {a.low - b.low, a.high - b.high}; }
    friend Pair operator*(const Pair& a, const Pair& b) { return {a.low * b.low, a.high * b.high}; }
    friend Pair operator/(const Pair& a, const Pair& b) { return {a.low / b.low, a.high / b.high}; }
    friend Pair operator-(const Pair& a) { return {-a.low, -a.high}; }
    friend auto operator<(const Pair& a, const Pair& b) {
        return both(a.low < b.low, a.high < b.high);
    }
    friend auto operator<=(const Pair& a, const Pair& b) {
        return both(a.low <= b.low, a.high <= b.high);
    }
    friend auto operator>(const Pair& a, const Pair& b) {
        return both(a.low > b.low, a.high > b.high);
    }
    friend auto operator>=(const Pair& a, const Pair& b) {
        return both(a.low >= b.low, a.high >= b.high);
    }
    friend auto operator==(const Pair& a, const Pair& b) {
        return both(a.low == b.low, a.high == b.high);
    }
    friend auto operator!=(const Pair& a, const Pair& b) {
        return both(a.low != b.low, a.high != b.high);
    }
    // For truth values and integers.
    friend Pair operator&(const Pair& a, const Pair& b) { return {a.low & b.low, a.high & b.high}; }
    friend Pair operator|(const Pair& a, const Pair& b) { return {a.low | b.low, a.high | b.high}; }
    friend Pair operator!(const Pair& a) { return {!a.low, !a.high}; }
    friend Pair operator<<(const Pair& a, int count) { return {a.low << count, a.high << count}; }
    friend Pair operator>>(const Pair& a, int count) { return {a.low >> count, a.high >> count}; }

  private:
    template <class M>
    static Pair<M> both(M low, M high) {
        return {low, high};
    }
};

template <class M, class X>
Pair<X> select(const Pair<M>& mask, const Pair<X>& yes, const Pair<X>& no) {
    return {select(mask.low, yes.low, no.low), select(mask.high, yes.high, no.high)};
}
template <class X>
Pair<X> sqrt(const Pair<X>& a) {
    return {sqrt(a.low), sqrt(a.high)};
}
template <class X>
auto toBits(const Pair<X>& a) {
    return Pair<decltype(toBits(a.low))>{toBits(a.low), toBits(a.high)};
}
template <class T, class X>
auto fromBits(const Pair<X>& a) {
    return Pair<decltype(fromBits<T>(a.low))>{fromBits<T>(a.low), fromBits<T>(a.high)};
}
template <class X>
bool any(const Pair<X>& mask) {
    return any(mask.low | mask.high);
}

// What a number type is made of: its scalar, and how many of them.
template <class R>
struct LaneTraits {
    using Scalar = R;
    static constexpr int kCount = 1;
};
template <class T>
struct LaneTraits<Lanes<T>> {
    using Scalar = T;
    static constexpr int kCount = Lanes<T>::kCount;
};
template <class T>
struct LaneTraits<LanesMask<T>> {
    using Scalar = bool;
    static constexpr int kCount = Lanes<T>::kCount;
};
template <class X>
struct LaneTraits<Pair<X>> {
    using Scalar = typename LaneTraits<X>::Scalar;
    static constexpr int kCount = 2 * LaneTraits<X>::kCount;
};
template <class R>
using ScalarOf = typename LaneTraits<R>::Scalar;
template <class R>
inline constexpr int kLaneCount = LaneTraits<R>::kCount;

// At most 64 lanes.
template <class X>
std::uint64_t maskBits(const Pair<X>& mask) {
    static_assert(2 * kLaneCount<X> <= 64);
    return maskBits(mask.low) | (maskBits(mask.high) << kLaneCount<X>);
}

template <class X>
auto lane(const Pair<X>& a, int index) {
    return index < kLaneCount<X> ? lane(a.low, index) : lane(a.high, index - kLaneCount<X>);
}
template <class X>
void setLane(Pair<X>& a, int index, ScalarOf<X> value) {
    index < kLaneCount<X> ? setLane(a.low, index, value)
                          : setLane(a.high, index - kLaneCount<X>, value);
}
template <class X>
void loadLanes(Pair<X>& a, const ScalarOf<X>* from) {
    loadLanes(a.low, from);
    loadLanes(a.high, from + kLaneCount<X>);
}
template <class X>
void storeLanes(const Pair<X>& a, ScalarOf<X>* to) {
    storeLanes(a.low, to);
    storeLanes(a.high, to + kLaneCount<X>);
}

}  // namespace versorium
