// SPDX-License-Identifier: MIT
#include "fields/dynamics.h"

#include <algorithm>
#include <cmath>

#include "fields/lanes_of_orbits.h"
#include "math/elementary.h"

namespace versorium {
namespace {

using Matrix = std::vector<std::vector<double>>;

// Largest modulus of an eigenvalue: the limit of the k-th root of the norm of the k-th power, by
// squaring. After 40 of them k is 10^12, and what the norm adds lies below the last digit.
double spectralRadius(Matrix power) {
    constexpr int kSquarings = 40;
    const std::size_t size = power.size();
    double logarithm = 0, weight = 1;
    for (int round = 0; round <= kSquarings; ++round) {
        double norm = 0;
        for (const auto& row : power)
            for (double value : row) norm = std::max(norm, std::abs(value));
        if (norm == 0) return 0;
        if (!std::isfinite(norm)) return norm;
        logarithm += weight * log(norm);
        weight /= 2;
        for (auto& row : power)
            for (double& value : row) value /= norm;
        Matrix square(size, std::vector<double>(size, 0.0));
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t k = 0; k < size; ++k)
                for (std::size_t j = 0; j < size; ++j) square[i][j] += power[i][k] * power[k][j];
        power = std::move(square);
    }
    return exp(logarithm);
}

}  // namespace

std::optional<Cycle> cycleOf(const OrbitProgram& program, const double* coordinates) {
    const double* one[3] = {coordinates, coordinates + 1, coordinates + 2};
    const FieldName fields[] = {FieldName::period};
    const double period = evaluateFields(program, 1, one, fields)[0][0];
    if (!(period >= 1)) return std::nullopt;
    Cycle cycle;
    cycle.period = static_cast<int>(period);
    // As many copies of the point as there are directions to derive along.
    const int dimension = program.map->dimension;
    const auto size = static_cast<std::size_t>(dimension);
    std::vector<std::vector<double>> copies;
    const double* pointers[3] = {};
    for (std::size_t k = 0; k < program.slice.axes.size(); ++k) {
        copies.emplace_back(size, coordinates[k]);
        pointers[k] = copies.back().data();
    }
    OrbitLanes lanes(program, dimension, pointers, {});
    lanes.advance(program.iterations);
    for (int k = 0; k < dimension; ++k) cycle.point.push_back(lanes.state(k)[0]);
    lanes.seedSlopes(-1);
    for (int k = 0; k < dimension; ++k) lanes.slope(k)[static_cast<std::size_t>(k)] = 1;
    for (int n = 0; n < cycle.period; ++n) lanes.advanceDual();
    Matrix jacobian(size, std::vector<double>(size));
    for (int i = 0; i < dimension; ++i)
        for (std::size_t j = 0; j < size; ++j)
            jacobian[static_cast<std::size_t>(i)][j] = lanes.slope(i)[j];
    cycle.modulus = spectralRadius(jacobian);
    if (dimension == 1) {
        cycle.multiplier = jacobian[0][0];
    } else if (program.map->info.algebra == Algebra::complex) {
        const double a = jacobian[0][0], b = jacobian[1][0];
        // Rounding of a product of `period` factors, with room.
        const double tolerance = 1e-9 * (1e-3 + std::sqrt(a * a + b * b));
        if (std::abs(jacobian[1][1] - a) <= tolerance && std::abs(jacobian[0][1] + b) <= tolerance)
            cycle.multiplier = std::complex<double>(a, b);
    }
    return cycle;
}

std::vector<std::vector<double>> imagesOf(const OrbitProgram& program, int count,
                                          const double* const* coordinates) {
    OrbitLanes lanes(program, count, coordinates, {});
    lanes.advance(1);
    std::vector<std::vector<double>> images;
    for (int k = 0; k < program.map->dimension; ++k)
        images.emplace_back(lanes.state(k).begin(), lanes.state(k).begin() + count);
    return images;
}

}  // namespace versorium
