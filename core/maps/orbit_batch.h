// SPDX-License-Identifier: MIT
#pragma once
// Many orbits of one map at once, as the kernels take them: structures of arrays, all of `capacity`
// numbers (a multiple of kBatchPadding), of which `count` are orbits.

#include <cstdint>

#include "maps/bound.h"

namespace versorium {

inline constexpr int kBatchPadding = 128;
inline constexpr int kMostParameters = 64;
inline constexpr int kMostDimension = 4;
// A step count that says "not escaped": one more than the last iteration.

// A parameter: one value for all orbits, or one for each.
template <class T>
struct Stream {
    const T* values = nullptr;
    bool varies = false;
};

template <class T>
struct OrbitBatch {
    int count = 0;
    int capacity = 0;
    // In: the starts. Out: z at escape, or after the last iteration.
    T* state[kMostDimension] = {};
    Stream<T> parameters[kMostParameters];
    const BoundList* lists[kMostLists] = {};
    const DistanceField* field = nullptr;
    struct Override {
        int list = 0, item = 0, component = 0;
        Stream<T> stream;
    };
    Override overrides[kMostOverrides];
    int overrideCount = 0;
    // Of a typed formula: what a step does.
    const TapeCode* program = nullptr;

    // escape: the least n in 0 … iterations with !(|z_n|² <= squaredRadius), or iterations + 1.
    T squaredRadius = 4;
    int iterations = 100;
    std::int32_t* steps = nullptr;
    // Whether state is read after escape() for orbits that did not escape.
    bool needLast = true;
    // Whether it is read for orbits that did.
    bool needEscaped = true;
    // Of orbits that escaped the squared norm of the iterate before; null: not wanted. 0 where the
    // start is outside.
    T* previous = nullptr;
    // Whether orbits may be decided early where that changes no result.
    bool shortcuts = true;
    // Orbits whose squared norm is below this never escape; 0 where nothing is known.
    T squaredCapture = 0;
    // Room for escape(): scratchSize numbers and 6 * capacity integers.
    T* scratch = nullptr;
    std::int32_t* scratchIndex = nullptr;

    // advanceDual: derivatives along one direction, of the state and (the same for all orbits) of
    // the parameters and overrides.
    T* slope[kMostDimension] = {};
    T parameterSlopes[kMostParameters] = {};
    T overrideSlopes[kMostOverrides] = {};
};

// Rows of scratch: states of three groups of orbits with their streams, and the references.
constexpr std::size_t scratchSize(int capacity, int streams) {
    return static_cast<std::size_t>(capacity) *
           static_cast<std::size_t>(4 * kMostDimension + 3 * streams);
}

template <class T>
using BatchFunction = void (*)(OrbitBatch<T>&);

enum class Flavour { exact, fast };

struct KernelTarget {
    const char* name;  // "x86-64-v3", "simd128"
    Flavour flavour;
    bool (*available)();
    // Functions of all maps: in the catalogue's order, then typed formulas of dimension 1, 2 and 4.
    const BatchFunction<double>* escape;
    const BatchFunction<double>* advance;      // one step
    const BatchFunction<double>* advanceDual;  // one step with its derivative
    const BatchFunction<float>* escapeFloat;   // null for most maps (see kernels/escape.cpp)

    template <class T>
    BatchFunction<T> escapeOf(int map) const {
        if constexpr (sizeof(T) == sizeof(double))
            return escape[map];
        else
            return escapeFloat[map];
    }
};

}  // namespace versorium
