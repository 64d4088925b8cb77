// SPDX-License-Identifier: MIT
#include "fields/observers.h"

#include <cmath>
#include <limits>

namespace versorium {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double trapDistance(const Trap& trap, const OrbitLanes& lanes, int dimension, std::size_t i) {
    const double x = lanes.state(0)[i] - trap.point[0];
    const double y = dimension > 1 ? lanes.state(1)[i] - trap.point[1] : 0;
    switch (trap.kind) {
        case Trap::Kind::line:
            return std::abs(y * cos(trap.angle) - x * sin(trap.angle));
        case Trap::Kind::circle:
            return std::abs(std::sqrt(x * x + y * y) - trap.radius);
        default: {
            double square = 0;
            for (int k = 0; k < dimension && k < trap.components; ++k) {
                const double part = lanes.state(k)[i] - trap.point[k];
                square = square + part * part;
            }
            return std::sqrt(square);
        }
    }
}

// Adds ln|slope| and makes the slope a unit vector again.
double stretch(OrbitLanes& lanes, int dimension, std::size_t i) {
    double square = 0;
    for (int k = 0; k < dimension; ++k) square = square + lanes.slope(k)[i] * lanes.slope(k)[i];
    // A direction that is lost (a critical point was met) starts anew from the first axis.
    const bool lost = !(square > 1e-280);
    const double size = lost ? 1e-140 : std::sqrt(square);
    for (int k = 0; k < dimension; ++k)
        lanes.slope(k)[i] = lost ? (k == 0 ? 1.0 : 0.0) : lanes.slope(k)[i] / size;
    return log(size);
}

}  // namespace

Observed observe(const OrbitProgram& program, OrbitLanes lanes, bool lyapunov) {
    const auto count = static_cast<std::size_t>(lanes.count());
    const int dimension = program.map->dimension;
    const double radius2 = program.escapeRadius * program.escapeRadius;
    Observed result;
    result.attractionStep.assign(count, kNan);
    result.trap.assign(count, std::numeric_limits<double>::infinity());
    result.lyapunov.assign(count, 0.0);
    std::vector<double> before(count);
    std::vector<char> alive(count, 1), attracted(count, 0);
    if (lyapunov) {
        lanes.seedSlopes(-1);
        for (double& value : lanes.slope(0)) value = 1;
    }
    std::size_t left = count;
    for (int n = 0; n <= program.iterations && left > 0; ++n) {
        if (n > 0) lyapunov ? lanes.advanceDual() : lanes.advance(1);
        for (std::size_t i = 0; i < count; ++i) {
            if (!alive[i]) continue;
            const double norm = lanes.squaredNorm(i);
            const double trap = trapDistance(program.trap, lanes, dimension, i);
            if (trap < result.trap[i]) result.trap[i] = trap;
            if (!(norm <= radius2)) {
                alive[i] = 0;
                --left;
                result.attractionStep[i] = result.lyapunov[i] = kNan;
                continue;
            }
            const double difference = norm - before[i];
            if (n > 0 && !attracted[i] && difference * difference < kAttractionDifference) {
                attracted[i] = 1;
                result.attractionStep[i] = n;
            }
            before[i] = norm;
            if (lyapunov && n > 0) result.lyapunov[i] += stretch(lanes, dimension, i);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (!alive[i]) continue;
        if (!attracted[i]) result.attractionStep[i] = program.iterations;
        if (program.iterations > 0) result.lyapunov[i] /= program.iterations;
    }
    return result;
}

std::vector<double> distanceEstimates(const OrbitProgram& program, const OrbitLanes& start) {
    const auto count = static_cast<std::size_t>(start.count());
    const int dimension = program.map->dimension;
    const double radius2 = program.escapeRadius * program.escapeRadius;
    std::vector<double> slopeSquares(count, 0.0), norm(count, 0.0);
    for (std::size_t axis = 0; axis < program.slice.axes.size(); ++axis) {
        OrbitLanes lanes = start;
        lanes.seedSlopes(static_cast<int>(axis));
        std::vector<char> alive(count, 1);
        std::size_t left = count;
        for (int n = 0; n <= program.iterations && left > 0; ++n) {
            if (n > 0) lanes.advanceDual();
            for (std::size_t i = 0; i < count; ++i) {
                if (!alive[i]) continue;
                const double square = lanes.squaredNorm(i);
                if (square <= radius2) continue;
                alive[i] = 0;
                --left;
                norm[i] = std::sqrt(square);
                double product = 0;
                for (int k = 0; k < dimension; ++k)
                    product = product + lanes.state(k)[i] * lanes.slope(k)[i];
                const double slope = product / norm[i];
                slopeSquares[i] = slopeSquares[i] + slope * slope;
            }
        }
    }
    std::vector<double> estimates(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        if (norm[i] == 0) continue;
        const double estimate = 0.5 * norm[i] * log(norm[i]) / std::sqrt(slopeSquares[i]);
        // Overflow of an orbit or of its derivative leaves no estimate.
        estimates[i] = std::isfinite(estimate) && estimate > 0 ? estimate : 0;
    }
    return estimates;
}

std::vector<double> periodsOf(const OrbitProgram& program, OrbitLanes last,
                              const EscapeResult& escape) {
    const auto count = static_cast<std::size_t>(last.count());
    const int dimension = program.map->dimension;
    std::vector<double> periods(count, 0.0);
    std::vector<char> open(count, 0);
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (!escape.escaped[i]) open[i] = 1, ++left;
    const OrbitLanes reference = last;
    for (int p = 1; p <= kLongestPeriod && left > 0; ++p) {
        last.advance(1);
        for (std::size_t i = 0; i < count; ++i) {
            if (!open[i]) continue;
            double away = 0, size = 0;
            for (int k = 0; k < dimension; ++k) {
                const double difference = last.state(k)[i] - reference.state(k)[i];
                away = away + difference * difference;
                size = size + reference.state(k)[i] * reference.state(k)[i];
            }
            const double tolerance = kPeriodTolerance * (1 + std::sqrt(size));
            if (!(away <= tolerance * tolerance)) continue;
            periods[i] = p;
            open[i] = 0;
            --left;
        }
    }
    return periods;
}

}  // namespace versorium
