// SPDX-License-Identifier: MIT
#include "shape/bounds.h"

#include <algorithm>
#include <cmath>

namespace versorium {
namespace {

constexpr double kFarthest = 16;
constexpr int kCells = 24;  // along each axis, each time
constexpr int kTimes = 7;

struct Hull {
    std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    void add(int axis, double from, double to) {
        const auto k = static_cast<std::size_t>(axis);
        low[k] = std::min(low[k], from);
        high[k] = std::max(high[k], to);
    }
    bool empty() const { return low[0] > high[0]; }
};

Hull gridHull(const Grid& grid) {
    Hull hull;
    const int n[3] = {grid.resolution.x, grid.resolution.y, grid.resolution.z};
    double cell[3];
    for (int k = 0; k < 3; ++k)
        cell[k] = n[k] > 1 ? (grid.maximum[k] - grid.minimum[k]) / (n[k] - 1) : 0;
    for (int z = 0; z < n[2]; ++z)
        for (int y = 0; y < n[1]; ++y)
            for (int x = 0; x < n[0]; ++x) {
                if (!(grid.at(x, y, z) <= 0)) continue;
                const int at[3] = {x, y, z};
                for (int k = 0; k < 3; ++k) {
                    const double place = grid.minimum[k] + at[k] * cell[k];
                    hull.add(k, std::max(grid.minimum[k], place - 0.5 * cell[k]),
                             std::min(grid.maximum[k], place + 0.5 * cell[k]));
                }
            }
    return hull;
}

// A cell may hold a point inside only where φ at its centre is at most half its diagonal, since no
// analytic shape's φ changes faster than the point moves.
Hull cellsThatMay(const ShapeTree& shape, const Hull& box, int dimensions) {
    Hull hull;
    double size[3] = {}, square = 0;
    for (int k = 0; k < dimensions; ++k) {
        const auto i = static_cast<std::size_t>(k);
        size[k] = (box.high[i] - box.low[i]) / kCells;
        square += size[k] * size[k];
    }
    const double reach = 0.5 * std::sqrt(square);
    const int layers = dimensions == 3 ? kCells : 1;
    for (int z = 0; z < layers; ++z)
        for (int y = 0; y < kCells; ++y)
            for (int x = 0; x < kCells; ++x) {
                const int at[3] = {x, y, z};
                double from[3] = {}, middle[3] = {};
                for (int k = 0; k < dimensions; ++k) {
                    from[k] = box.low[static_cast<std::size_t>(k)] + at[k] * size[k];
                    middle[k] = from[k] + 0.5 * size[k];
                }
                if (!(distance(shape, middle[0], middle[1], middle[2]) <= reach)) continue;
                for (int k = 0; k < 3; ++k) hull.add(k, from[k], from[k] + size[k]);
            }
    return hull;
}

}  // namespace

ShapeBounds boundsOf(const DistanceField& field, int dimensions) {
    Hull hull;
    if (field.grid()) {
        hull = gridHull(*field.grid());
    } else {
        for (int k = 0; k < 3; ++k) hull.add(k, -kFarthest, kFarthest);
        for (int i = 0; i < kTimes && !hull.empty(); ++i)
            hull = cellsThatMay(*field.shape(), hull, dimensions);
    }
    ShapeBounds bounds;
    bounds.empty = hull.empty();
    if (bounds.empty) return bounds;
    for (std::size_t k = 0; k < 3; ++k) {
        if (hull.low[k] <= -kFarthest || hull.high[k] >= kFarthest) continue;
        if (!(hull.low[k] < hull.high[k])) continue;
        bounds.low[k] = hull.low[k];
        bounds.high[k] = hull.high[k];
    }
    return bounds;
}

}  // namespace versorium
