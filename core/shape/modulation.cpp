// SPDX-License-Identifier: MIT
#include "shape/modulation.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace versorium {
namespace {

// The box around all discs, with the nodes that the largest side and the smallest disc ask for.
Grid gridAround(const std::vector<PaintedDisc>& discs, bool planar) {
    Grid grid;
    grid.minimum = glm::dvec3(1e300);
    grid.maximum = glm::dvec3(-1e300);
    double least = 1e300;
    for (const PaintedDisc& disc : discs) {
        const glm::dvec3 centre(disc.x, disc.y, planar ? 0 : disc.z);
        grid.minimum = glm::min(grid.minimum, centre - disc.radius);
        grid.maximum = glm::max(grid.maximum, centre + disc.radius);
        least = std::min(least, disc.radius);
    }
    const int most = planar ? kModulationNodes : kModulationNodesInSpace;
    // Sixteen nodes across the smallest disc where there is room for them.
    constexpr double kAcross = 16;
    for (int k = 0; k < 3; ++k) {
        const double wanted = (grid.maximum[k] - grid.minimum[k]) / (2 * least) * kAcross;
        grid.resolution[k] = std::clamp(static_cast<int>(std::ceil(wanted)) + 1, 2, most);
    }
    if (planar) {
        grid.resolution.z = 1;
        grid.minimum.z = grid.maximum.z = 0;
    }
    return grid;
}

// The nodes along an axis that lie between two places, as a range [first, last].
std::array<int, 2> nodesBetween(const Grid& grid, int axis, double low, double high) {
    const int last = grid.resolution[axis] - 1;
    if (last < 1) return {0, 0};
    const double cell = (grid.maximum[axis] - grid.minimum[axis]) / last;
    const auto node = [&](double place) {
        return std::clamp((place - grid.minimum[axis]) / cell, 0.0, static_cast<double>(last));
    };
    return {static_cast<int>(std::floor(node(low))), static_cast<int>(std::ceil(node(high)))};
}

double nodeAt(const Grid& grid, int axis, int i) {
    if (grid.resolution[axis] < 2) return grid.minimum[axis];
    const double part = static_cast<double>(i) / (grid.resolution[axis] - 1);
    return grid.minimum[axis] + (grid.maximum[axis] - grid.minimum[axis]) * part;
}

}  // namespace

Modulation::Modulation(std::optional<ModulatingShape> shape, const std::vector<PaintedDisc>& discs,
                       bool planar)
    : shape_(std::move(shape)) {
    if (discs.empty()) return;
    Grid keep = gridAround(discs, planar);
    Grid add = keep;
    const auto size = static_cast<std::size_t>(keep.resolution.x) *
                      static_cast<std::size_t>(keep.resolution.y) *
                      static_cast<std::size_t>(keep.resolution.z);
    keep.values.assign(size, 1);
    add.values.assign(size, 0);
    for (const PaintedDisc& disc : discs) {
        values_.push_back(disc.value);
        const auto xs = nodesBetween(keep, 0, disc.x - disc.radius, disc.x + disc.radius);
        const auto ys = nodesBetween(keep, 1, disc.y - disc.radius, disc.y + disc.radius);
        const auto zs = nodesBetween(keep, 2, disc.z - disc.radius, disc.z + disc.radius);
        for (int z = zs[0]; z <= zs[1]; ++z)
            for (int y = ys[0]; y <= ys[1]; ++y)
                for (int x = xs[0]; x <= xs[1]; ++x) {
                    const double dx = nodeAt(keep, 0, x) - disc.x, dy = nodeAt(keep, 1, y) - disc.y;
                    const double dz = planar ? 0 : nodeAt(keep, 2, z) - disc.z;
                    const double away =
                        cubicStep(std::sqrt(dx * dx + dy * dy + dz * dz) / disc.radius);
                    if (away >= 1) continue;
                    const std::size_t at = keep.index(x, y, z);
                    keep.values[at] *= away;
                    add.values[at] = away * add.values[at] + (1 - away) * disc.value;
                }
    }
    keep_ = std::make_shared<const Grid>(std::move(keep));
    add_ = std::make_shared<const Grid>(std::move(add));
}

std::array<double, 2> Modulation::rangeFrom(double base) const {
    std::array<double, 2> range{base, base};
    const auto take = [&](double value) {
        range[0] = std::min(range[0], value);
        range[1] = std::max(range[1], value);
    };
    if (shape_) take(shape_->value);
    for (double value : values_) take(value);
    return range;
}

}  // namespace versorium
