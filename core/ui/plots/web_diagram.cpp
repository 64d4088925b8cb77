// SPDX-License-Identifier: MIT
#include "ui/plots/web_diagram.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/dynamics.h"

namespace versorium {
namespace {

std::vector<std::vector<double>> imagesOnLine(const OrbitProgram& program, double second,
                                              const std::vector<double>& x) {
    const std::vector<double> rest(x.size(), second);
    const double* coordinates[3] = {x.data(), rest.data(), rest.data()};
    return imagesOf(program, static_cast<int>(x.size()), coordinates);
}

}  // namespace

bool keepsRealLine(const OrbitProgram& program, double second) {
    if (program.critical) return false;
    if (program.map->dimension == 1) return true;
    if (second != 0) return false;
    // The other components stand still, and must be 0 as well.
    for (int k = 2; k < program.map->dimension; ++k)
        if (program.slice.origin[static_cast<std::size_t>(k)] != 0) return false;
    const auto images = imagesOnLine(program, 0, {-1.37, -0.5, 0, 0.31, 0.77, 1.9});
    for (std::size_t k = 1; k < images.size(); ++k)
        for (double value : images[k])
            if (value != 0) return false;
    return true;
}

std::vector<double> graphOf(const OrbitProgram& program, double second, double low, double high,
                            int count) {
    std::vector<double> x;
    for (int k = 0; k < count; ++k) x.push_back(low + (high - low) * k / std::max(1, count - 1));
    return imagesOnLine(program, second, x)[0];
}

std::vector<double> lineOrbit(const OrbitProgram& program, double second, double x, int steps) {
    OrbitProgram endless = program;
    endless.escapeRadius = std::numeric_limits<double>::infinity();
    const double start[3] = {x, second, 0};
    std::vector<double> orbit;
    for (const auto& row : orbitOf(endless, start, steps)) {
        if (!std::isfinite(row[0])) break;
        orbit.push_back(row[0]);
    }
    return orbit;
}

}  // namespace versorium
