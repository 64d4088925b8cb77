// SPDX-License-Identifier: MIT
#include "shape/radial_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shape/modulation.h"

namespace versorium {
namespace {

// A trap is left some room for rounding.
constexpr double kMargin = 1e-9;

using Direction = std::array<double, 3>;

// Evenly spread directions, and the farthest that any direction lies from one of them, on the unit
// circle or sphere. On the sphere they are the midpoints of cells of equal area: even in z
// (Archimedes) and in the angle.
struct Directions {
    std::vector<Direction> all;
    double reach = 0;
};

Directions directionsOf(int dimensions, int points) {
    Directions directions;
    if (dimensions == 2) {
        for (int i = 0; i < points; ++i) {
            const double angle = 2 * std::numbers::pi * (i + 0.5) / points;
            directions.all.push_back({cos(angle), sin(angle), 0});
        }
        directions.reach = std::numbers::pi / points;
        return directions;
    }
    const int rows = std::max(2, static_cast<int>(std::sqrt(0.25 * points)));
    const int across = 4 * rows;
    for (int row = 0; row < rows; ++row) {
        const double z = -1 + (2 * row + 1.0) / rows;
        const double ring = std::sqrt(1 - z * z);
        for (int i = 0; i < across; ++i) {
            const double angle = 2 * std::numbers::pi * (i + 0.5) / across;
            directions.all.push_back({ring * cos(angle), ring * sin(angle), z});
        }
    }
    // A cell's corner differs from its midpoint by at most half a cell's angle around the axis and
    // by the angle between the heights, which is greatest at the poles.
    const double pole = std::sqrt(2.0 * (2.0 / rows));
    directions.reach = std::numbers::pi / across + pole;
    return directions;
}

// The largest difference between neighbouring nodes along each axis bounds the gradient of the
// interpolant. Beyond the box the distance to it may add 1.
double slopeOf(const DistanceField& field) {
    const Grid* grid = field.grid();
    if (!grid) return 1;
    const int n[3] = {grid->resolution.x, grid->resolution.y, grid->resolution.z};
    double steepest[3] = {};
    for (int z = 0; z < n[2]; ++z)
        for (int y = 0; y < n[1]; ++y)
            for (int x = 0; x < n[0]; ++x) {
                const int next[3][3] = {{x + 1, y, z}, {x, y + 1, z}, {x, y, z + 1}};
                for (int k = 0; k < 3; ++k) {
                    if (next[k][k] >= n[k]) continue;
                    const double cell = (grid->maximum[k] - grid->minimum[k]) / (n[k] - 1);
                    const double change =
                        grid->at(next[k][0], next[k][1], next[k][2]) - grid->at(x, y, z);
                    steepest[k] = std::max(steepest[k], std::abs(change) / cell);
                }
            }
    const double slope = std::sqrt(steepest[0] * steepest[0] + steepest[1] * steepest[1] +
                                   steepest[2] * steepest[2]);
    return slope + (field.outside() == Outside::distance ? 1 : 0);
}

Status checkOptions(const RadialOptions& options) {
    const auto finite = [](double value) { return std::abs(value) <= 1e9; };
    if (options.dimensions != 2 && options.dimensions != 3)
        return Status::usage("circles (2) or spheres (3) are expected");
    if (!(options.to > 0) || !finite(options.to))
        return Status::usage("the largest radius must be a positive number");
    if (options.radii < 2 || options.radii > kMostRadii)
        return Status::usage("2 to " + std::to_string(kMostRadii) + " radii are expected");
    if (options.outwardRadii < 2 || options.outwardRadii > kMostRadii ||
        options.outwardPoints < 1 || options.outwardPoints > kMostCirclePoints)
        return Status::usage("too few or too many radii or points on the way outward");
    if (options.points < 0 || options.points > kMostCirclePoints)
        return Status::usage("at most " + std::to_string(kMostCirclePoints) +
                             " points on a circle are expected");
    if (!finite(options.alpha) || !finite(options.beta) || !(options.escapeRadius > 0))
        return Status::usage("alpha, beta and the escape radius must be finite numbers");
    return {};
}

// All that α and the offset of φ may be, anywhere.
struct Controls {
    std::array<double, 2> alpha, offset;
};
Controls controlsOf(const DistanceField& field, const RadialOptions& options) {
    Controls controls{{options.alpha, options.alpha}, {options.beta, options.beta}};
    if (field.alpha()) controls.alpha = field.alpha()->rangeFrom(options.alpha);
    if (field.beta()) controls.offset = field.beta()->rangeFrom(options.beta);
    if (options.asPrinted) controls.offset = {-controls.offset[1], -controls.offset[0]};
    return controls;
}

double modulusOf(double alpha, double phi) { return exp(std::clamp(alpha * phi, -300.0, 300.0)); }

// The least and the greatest r̂ where φ lies between two values.
std::array<double, 2> moduliOf(const Controls& controls, double low, double high) {
    std::array<double, 2> range{1e300, -1e300};
    for (double alpha : controls.alpha)
        for (double phi : {low - controls.offset[1], high - controls.offset[0]}) {
            range[0] = std::min(range[0], modulusOf(alpha, phi));
            range[1] = std::max(range[1], modulusOf(alpha, phi));
        }
    return range;
}

// r̂ on the ball within radius i is at most what the values of φ there allow.
double findCapture(const RadialProfile& profile, const RadialOptions& options,
                   const Controls& controls) {
    double capture = 0, high = -1e300, low = 1e300;
    const double gap = profile.slope * options.to / (options.radii - 1);
    for (std::size_t i = 0; i < profile.radius.size(); ++i) {
        // Between this radius and the one before, φ is at most half a gap above both.
        high = std::max(high, profile.high[i] + (i > 0 ? 0.5 * gap : 0));
        low = std::min(low, profile.low[i] - (i > 0 ? 0.5 * gap : 0));
        const double most = moduliOf(controls, low, high)[1];
        const double radius = profile.radius[i];
        if (radius > 0 && radius <= options.escapeRadius && most <= radius * (1 - kMargin))
            capture = radius;
    }
    return capture;
}

// From outside inward: r̂ > r on every ring that has been passed.
double findEscape(const RadialProfile& profile, const RadialOptions& options,
                  const Controls& controls) {
    double escape = options.escapeRadius;
    const double gap = profile.slope * options.to / (options.radii - 1);
    for (std::size_t i = profile.radius.size() - 1; i > 0; --i) {
        const double low = std::min(profile.low[i - 1], profile.low[i]) - 0.5 * gap;
        const double high = std::max(profile.high[i - 1], profile.high[i]) + 0.5 * gap;
        const double least = moduliOf(controls, low, high)[0];
        if (!(least > profile.radius[i])) break;
        escape = std::min(escape, profile.radius[i - 1]);
    }
    return escape;
}

Expected<RadialProfile> sampled(const DistanceField& field, const RadialOptions& options,
                                Job& job) {
    const int points = options.points > 0 ? options.points : options.dimensions == 2 ? 4096 : 16384;
    const Directions directions = directionsOf(options.dimensions, points);
    const auto count = static_cast<std::size_t>(options.radii);
    RadialProfile profile;
    profile.slope = slopeOf(field);
    for (auto* list :
         {&profile.radius, &profile.mean, &profile.low, &profile.high, &profile.modulus})
        list->assign(count, 0);
    const bool done = job.parallelFor(count, [&](std::size_t i) {
        const double radius = options.to * static_cast<double>(i) / static_cast<double>(count - 1);
        double sum = 0, low = 1e300, high = -1e300;
        for (const Direction& d : directions.all) {
            const double phi =
                field.at(radius * d[0] - options.shift[0], radius * d[1] - options.shift[1],
                         radius * d[2] - options.shift[2]);
            sum += phi;
            low = std::min(low, phi);
            high = std::max(high, phi);
        }
        const double reach = profile.slope * radius * directions.reach;
        profile.radius[i] = radius;
        profile.mean[i] = sum / static_cast<double>(directions.all.size());
        profile.low[i] = low - reach;
        profile.high[i] = high + reach;
        const double beta = options.asPrinted ? -options.beta : options.beta;
        profile.modulus[i] = modulusOf(options.alpha, profile.mean[i] - beta);
    });
    if (!done) return Status::cancelled();
    return profile;
}

}  // namespace

Expected<RadialProfile> radialProfile(const DistanceField& field, const RadialOptions& options,
                                      Job& job) {
    if (Status status = checkOptions(options); !status.ok()) return status;
    Expected<RadialProfile> profile = sampled(field, options, job);
    if (!profile) return profile.status();
    const Controls controls = controlsOf(field, options);
    profile->capture = findCapture(*profile, options, controls);
    profile->escape = options.escapeRadius;
    if (options.dimensions != 2 || !options.outward) return profile;
    RadialOptions outward = options;
    outward.to = options.escapeRadius;
    outward.radii = options.outwardRadii;
    outward.points = options.outwardPoints;
    Expected<RadialProfile> whole = sampled(field, outward, job);
    if (!whole) return whole.status();
    profile->escape = findEscape(*whole, outward, controls);
    return profile;
}

}  // namespace versorium
