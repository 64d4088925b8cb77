// SPDX-License-Identifier: MIT
#pragma once
// Random numbers that are the same everywhere: SplitMix64 (Steele, Lea, Flood 2014). The standard's
// distributions differ between libraries, so none is used.

#include <cstdint>

namespace versorium {

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    // The index-th of many independent sequences under one seed: members of an ensemble can be
    // drawn in any order.
    static Random stream(std::uint64_t seed, std::uint64_t index) {
        const std::uint64_t base = Random(seed).next();
        return Random(Random(base + index * 0xd1342543de82ef95ULL).next());
    }

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15ULL;
        std::uint64_t mixed = state_;
        mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9ULL;
        mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebULL;
        return mixed ^ (mixed >> 31);
    }
    // Uniform in [0, 1): a multiple of 2^-53.
    double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    // Uniform in 0 … count-1 (count > 0; the bias is below count / 2^64).
    std::uint64_t below(std::uint64_t count) { return next() % count; }

  private:
    std::uint64_t state_;
};

}  // namespace versorium
