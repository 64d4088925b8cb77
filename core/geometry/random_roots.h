// SPDX-License-Identifier: MIT
#pragma once
// Roots drawn at random: "laying down polynomial roots randomly inside a bounding box of the target
// shape produced an acceptable d" (S section 3.3.2). Tight clusters inside the shape and even
// spreads give different textures. The same options and seed give the same roots on every machine.

#include <array>
#include <cstdint>

#include "base/random.h"
#include "base/status.h"
#include "base/words.h"
#include "geometry/roots.h"

namespace versorium {

enum class RootArrangement {
    even,       // independent and uniform in the region
    clustered,  // uniform in small balls around a few centres
    spread,  // kept apart: each root is that of 16 candidates which is farthest from those before
};

template <>
struct EnumWords<RootArrangement> {
    static constexpr std::array<std::string_view, 3> table{"even", "clustered", "spread"};
};

struct RandomRoots {
    int least = 10, most = 10;  // how many; uniform between the two
    // The region: a box of these half extents, or the ellipsoid that touches its sides. A component
    // of half extent 0 is that of the centre.
    std::array<double, 4> centre{};
    std::array<double, 4> half{0.5, 0.5, 0.5, 0};
    bool ball = false;
    // Powers are uniform in [lowPower, highPower], or among the whole numbers in it.
    double lowPower = 1, highPower = 3;
    bool wholePowers = true;
    RootArrangement arrangement = RootArrangement::even;
    int clusters = 3;
    double clusterRadius = 0.15;  // in half extents of the region, below 1
    friend bool operator==(const RandomRoots&, const RandomRoots&) = default;
};

inline constexpr int kMostRandomRoots = 4096;
inline constexpr double kLargestRootExtent = 1e6;
inline constexpr double kLargestRootPower = 1000;

// ErrorKind::usage with the name of what is out of range.
Status checkRandomRoots(const RandomRoots& options);
// `options` pass the check. Roots lie in the region, in the order in which they were drawn.
RootList randomRoots(const RandomRoots& options, Random& random);
inline RootList randomRoots(const RandomRoots& options, std::uint64_t seed) {
    Random random = Random::stream(seed, 0);
    return randomRoots(options, random);
}

}  // namespace versorium
