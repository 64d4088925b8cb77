// SPDX-License-Identifier: MIT
#include "geometry/random_roots.h"

#include <gtest/gtest.h>

#include <cmath>

namespace versorium {
namespace {

double nearestPair(const RootList& list) {
    double least = 1e300;
    for (std::size_t i = 0; i < list.roots.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            double square = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const double part = list.roots[i].q[k] - list.roots[j].q[k];
                square += part * part;
            }
            least = std::min(least, std::sqrt(square));
        }
    return least;
}

TEST(RandomRoots, FollowFromTheSeedAndLieInTheRegion) {
    const RandomRoots options{.least = 5,
                              .most = 9,
                              .centre = {1, -2, 0.5, 7},
                              .half = {0.5, 0.25, 2, 0},
                              .lowPower = -2,
                              .highPower = 4};
    bool counts[16] = {};
    double powerSum = 0;
    int powers = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const RootList list = randomRoots(options, seed);
        EXPECT_EQ(list, randomRoots(options, seed));
        EXPECT_NE(list, randomRoots(options, seed + 1000));
        ASSERT_GE(list.roots.size(), 5u);
        ASSERT_LE(list.roots.size(), 9u);
        counts[list.roots.size()] = true;
        for (const RootList::Root& root : list.roots) {
            for (std::size_t k = 0; k < 4; ++k)
                EXPECT_LE(std::abs(root.q[k] - options.centre[k]), options.half[k]);
            EXPECT_EQ(root.power, std::floor(root.power));
            EXPECT_LE(std::abs(root.power - 1), 3);
            powerSum += root.power;
            ++powers;
        }
    }
    for (int count = 5; count <= 9; ++count) EXPECT_TRUE(counts[count]) << count;
    // The mean of about 1400 powers of variance 4 is known to 0.053; five of these.
    EXPECT_NEAR(powerSum / powers, 1, 0.27);
}

TEST(RandomRoots, BallsClustersAndSpreads) {
    RandomRoots options{.least = 40, .most = 40, .half = {2, 1, 1, 0}, .ball = true};
    const auto inBall = [&](const RootList::Root& root) {
        double square = 0;
        for (std::size_t k = 0; k < 3; ++k)
            square += root.q[k] * root.q[k] / (options.half[k] * options.half[k]);
        return square <= 1 + 1e-12;
    };
    double spread = 0, even = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        options.arrangement = RootArrangement::even;
        for (const RootList::Root& root : randomRoots(options, seed).roots)
            EXPECT_TRUE(inBall(root));
        even += nearestPair(randomRoots(options, seed));
        options.arrangement = RootArrangement::spread;
        spread += nearestPair(randomRoots(options, seed));
        // One cluster: no two roots are farther apart than its two radii.
        options.arrangement = RootArrangement::clustered;
        options.clusters = 1;
        options.clusterRadius = 0.1;
        const RootList tight = randomRoots(options, seed);
        for (const RootList::Root& root : tight.roots) {
            EXPECT_TRUE(inBall(root));
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_LE(std::abs(root.q[k] - tight.roots[0].q[k]), 0.2 * options.half[k] + 1e-12);
        }
    }
    EXPECT_GT(spread, 3 * even);
}

TEST(RandomRoots, RefuseWhatMakesNoSense) {
    const auto message = [](RandomRoots options) { return checkRandomRoots(options).message(); };
    EXPECT_TRUE(checkRandomRoots({}).ok());
    EXPECT_NE(message({.least = 0}).find("count"), std::string::npos);
    EXPECT_NE(message({.least = 6, .most = 5}).find("count"), std::string::npos);
    EXPECT_NE(message({.half = {0, 0, 0, 0}}).find("half"), std::string::npos);
    EXPECT_NE(message({.half = {NAN, 1, 1, 0}}).find("half"), std::string::npos);
    EXPECT_NE(message({.lowPower = 1.2, .highPower = 1.8}).find("whole"), std::string::npos);
    EXPECT_NE(message({.clusterRadius = 1}).find("cluster_radius"), std::string::npos);
}

}  // namespace
}  // namespace versorium
