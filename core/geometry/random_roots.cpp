// SPDX-License-Identifier: MIT
#include "geometry/random_roots.h"

#include <cmath>
#include <string>

namespace versorium {
namespace {

using Point = std::array<double, 4>;

constexpr int kCandidates = 16;

// In [-1, 1] along each axis of the region that has an extent; in the unit ball of these where
// `ball` is set.
Point unitPoint(const RandomRoots& options, bool ball, Random& random) {
    Point point{};
    double square = 0;
    do {
        square = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            point[k] = options.half[k] > 0 ? random.uniform(-1, 1) : 0;
            square += point[k] * point[k];
        }
    } while (ball && square > 1);
    return point;
}

double squaredDistance(const Point& a, const Point& b) {
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

// Farthest from the points so far, of several candidates (Mitchell 1991).
Point farPoint(const RandomRoots& options, const std::vector<Point>& points, Random& random) {
    Point best{};
    double greatest = -1;
    for (int i = 0; i < kCandidates; ++i) {
        const Point candidate = unitPoint(options, options.ball, random);
        double nearest = 1e300;
        for (const Point& other : points)
            nearest = std::min(nearest, squaredDistance(candidate, other));
        if (nearest > greatest) {
            greatest = nearest;
            best = candidate;
        }
    }
    return best;
}

}  // namespace

Status checkRandomRoots(const RandomRoots& options) {
    const auto bad = [](const std::string& what) { return Status::usage(what); };
    if (options.least < 1 || options.most < options.least || options.most > kMostRandomRoots)
        return bad("count: 1 to " + std::to_string(kMostRandomRoots) +
                   " roots are expected, the least number first");
    double extent = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        if (!(options.half[k] >= 0) || !(options.half[k] <= kLargestRootExtent))
            return bad("half: every half extent of the region is 0 to 1e6");
        if (!(std::abs(options.centre[k]) <= kLargestRootExtent))
            return bad("center: every component is a number of moderate size");
        extent = std::max(extent, options.half[k]);
    }
    if (extent == 0) return bad("half: a region without any extent has room for one root only");
    if (!(std::abs(options.lowPower) <= kLargestRootPower) ||
        !(std::abs(options.highPower) <= kLargestRootPower) ||
        !(options.lowPower <= options.highPower))
        return bad("power: two numbers from -1000 to 1000 are expected, the lower first");
    if (options.wholePowers && std::ceil(options.lowPower) > std::floor(options.highPower))
        return bad("power: there is no whole number between the two; take real powers");
    if (options.clusters < 1 || options.clusters > kMostRandomRoots)
        return bad("clusters: 1 to " + std::to_string(kMostRandomRoots) + " are expected");
    if (!(options.clusterRadius > 0) || !(options.clusterRadius < 1))
        return bad("cluster_radius: a part of the region, between 0 and 1, is expected");
    return {};
}

RootList randomRoots(const RandomRoots& options, Random& random) {
    const auto count = static_cast<std::size_t>(options.least) +
                       static_cast<std::size_t>(random.below(
                           static_cast<std::uint64_t>(options.most - options.least + 1)));
    std::vector<Point> points, centres;
    if (options.arrangement == RootArrangement::clustered)
        for (int i = 0; i < options.clusters; ++i) {
            // Their balls stay in the region.
            Point centre = unitPoint(options, options.ball, random);
            for (double& part : centre) part *= 1 - options.clusterRadius;
            centres.push_back(centre);
        }
    for (std::size_t i = 0; i < count; ++i) {
        if (options.arrangement == RootArrangement::spread) {
            points.push_back(farPoint(options, points, random));
        } else if (options.arrangement == RootArrangement::even) {
            points.push_back(unitPoint(options, options.ball, random));
        } else {
            Point point = centres[static_cast<std::size_t>(random.below(centres.size()))];
            const Point offset = unitPoint(options, true, random);
            for (std::size_t k = 0; k < 4; ++k) point[k] += options.clusterRadius * offset[k];
            points.push_back(point);
        }
    }
    RootList list;
    for (const Point& point : points) {
        RootList::Root root;
        for (std::size_t k = 0; k < 4; ++k)
            root.q[k] = options.centre[k] + options.half[k] * point[k];
        if (options.wholePowers) {
            const double low = std::ceil(options.lowPower), high = std::floor(options.highPower);
            root.power =
                low + static_cast<double>(random.below(static_cast<std::uint64_t>(high - low) + 1));
        } else {
            root.power = random.uniform(options.lowPower, options.highPower);
        }
        list.roots.push_back(root);
    }
    return list;
}

}  // namespace versorium
