// SPDX-License-Identifier: MIT
#include "maps/critical.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "maps/critical_starts.h"
#include "maps/formula_map.h"
#include "trace/formula_growth.h"

namespace versorium {
namespace {

constexpr int kStartsAcross = 5;
constexpr double kReach = 2;
constexpr int kNewtonSteps = 60;

struct Plane2 {
    double x, y;
};

// `slopes` of the overrides may be null.
Environment<SecondNumber> lifted(const Environment<double>& environment,
                                 const double* slopes = nullptr) {
    Environment<SecondNumber> result;
    for (int k = 0; k < kMostLists; ++k) result.lists[k] = environment.lists[k];
    result.field = environment.field;
    result.overrideCount = environment.overrideCount;
    for (int k = 0; k < environment.overrideCount; ++k)
        result.overrides[k] = {
            environment.overrides[k].list, environment.overrides[k].item,
            environment.overrides[k].component,
            SecondNumber({environment.overrides[k].value, slopes ? slopes[k] : 0.0}, {0.0, 0.0})};
    return result;
}

// ∂F/∂x at a point, and its derivative along (dx, dy) and `parameterSlopes` (may be null).
struct Slope {
    Plane2 value, derivative;
};
Slope slopeOf(const MapKernels& map, Plane2 at, double dx, double dy, const double* parameters,
              const double* parameterSlopes, const Environment<SecondNumber>& environment) {
    SecondNumber state[2] = {{{at.x, dx}, {1.0, 0.0}}, {{at.y, dy}, {0.0, 0.0}}};
    std::array<SecondNumber, kMostParameters> lifted;
    for (int k = 0; k < map.parameters; ++k)
        lifted[static_cast<std::size_t>(k)] = {
            {parameters[k], parameterSlopes ? parameterSlopes[k] : 0.0}, {0.0, 0.0}};
    map.stepSecond(state, lifted.data(), environment);
    return {{state[0].slope.value, state[1].slope.value},
            {state[0].slope.slope, state[1].slope.slope}};
}

bool solve2(Plane2 a, Plane2 b, Plane2 right, Plane2& solution) {
    const double determinant = a.x * b.y - a.y * b.x;
    if (!(std::abs(determinant) > 1e-14)) return false;
    solution = {(right.x * b.y - right.y * b.x) / determinant,
                (a.x * right.y - a.y * right.x) / determinant};
    return true;
}

// The middle of the chord through a point, along a direction, on which the derivative is 0 to the
// last bit: around a zero of high order it underflows on a disc. The point itself where it is not.
template <class Vanishes>
Plane2 middleOfChord(Plane2 at, double dx, double dy, Vanishes vanishes) {
    const auto reach = [&](double sign) {
        double in = 0, out = 1e-6;
        const auto place = [&](double r) {
            return Plane2{at.x + sign * r * dx, at.y + sign * r * dy};
        };
        while (out < 64 && vanishes(place(out))) in = out, out *= 2;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (in + out);
            (vanishes(place(middle)) ? in : out) = middle;
        }
        return in;
    };
    const double half = 0.5 * (reach(1) - reach(-1));
    return {at.x + half * dx, at.y + half * dy};
}

bool newton(const MapKernels& map, Plane2 start, const double* parameters,
            const Environment<SecondNumber>& environment, Plane2& found) {
    const auto vanishes = [&](Plane2 at) {
        const Slope slope = slopeOf(map, at, 0, 0, parameters, nullptr, environment);
        return slope.value.x == 0 && slope.value.y == 0;
    };
    Plane2 at = start, before{}, secondLast{};
    for (int i = 0; i < kNewtonSteps; ++i) {
        const Slope byX = slopeOf(map, at, 1, 0, parameters, nullptr, environment);
        const Slope byY = slopeOf(map, at, 0, 1, parameters, nullptr, environment);
        const double size = std::abs(byX.value.x) + std::abs(byX.value.y);
        Plane2 step{};
        if (size > 0 && !solve2(byX.derivative, byY.derivative, byX.value, step)) return false;
        at = {at.x - step.x, at.y - step.y};
        if (!(std::abs(at.x) + std::abs(at.y) < 1e6)) return false;
        const double moved = std::abs(step.x) + std::abs(step.y);
        if (moved <= 1e-15 * (1 + std::abs(at.x) + std::abs(at.y))) {
            const Slope last = slopeOf(map, at, 0, 0, parameters, nullptr, environment);
            if (!(std::abs(last.value.x) + std::abs(last.value.y) < 1e-9)) return false;
            if (size == 0)
                for (int round = 0; round < 2; ++round) {
                    at = middleOfChord(at, 1, 0, vanishes);
                    at = middleOfChord(at, 0, 1, vanishes);
                }
            found = at;
            return true;
        }
        // Steps that shrink by the same factor again and again lead to a zero of higher order: the
        // sum of all that would follow is taken at once.
        const double last2 = before.x * before.x + before.y * before.y;
        const double ratio = (step.x * before.x + step.y * before.y) / last2;
        const double ratioBefore = (before.x * secondLast.x + before.y * secondLast.y) /
                                   (secondLast.x * secondLast.x + secondLast.y * secondLast.y);
        secondLast = before, before = step;
        if (ratio > 0.6 && ratio < 1 && std::abs(ratio - ratioBefore) < 1e-3) {
            const double rest = ratio / (1 - ratio);
            at = {at.x - rest * step.x, at.y - rest * step.y};
            before = secondLast = {};
        }
    }
    return false;
}

struct Candidate {
    Plane2 point;
    bool fixed;
    bool infinity = false;  // the point stands for it
};

// f(infinity), where infinity is a critical point: f(z) - f(infinity) falls like |z|^-2 or faster.
std::optional<Plane2> imageOfInfinity(const MapKernels& map, const double* parameters,
                                      const Environment<double>& environment) {
    if (!map.formula) return std::nullopt;
    const auto value = valueAtInfinity(map.formula->formula(), parameters);
    if (!value || !std::isfinite(value->re) || !std::isfinite(value->im)) return std::nullopt;
    const auto difference = [&](double radius) {
        double state[2] = {0.8 * radius, 0.6 * radius};
        map.step(state, parameters, environment);
        const double x = state[0] - value->re, y = state[1] - value->im;
        return std::sqrt(x * x + y * y);
    };
    const double near = difference(1e3), far = difference(1e4);
    if (!(near > 0) || !(far < 0.05 * near)) return std::nullopt;
    return Plane2{value->re, value->im};
}

std::vector<Candidate> solvedPoints(const MapKernels& map, const double* parameters,
                                    const Environment<double>& environment) {
    const auto second = lifted(environment);
    std::vector<Candidate> all;
    const auto attempt = [&](Plane2 start) {
        Plane2 found{};
        if (!newton(map, start, parameters, second, found)) return;
        const bool known = std::any_of(all.begin(), all.end(), [&](const Candidate& other) {
            return std::abs(other.point.x - found.x) + std::abs(other.point.y - found.y) < 1e-7;
        });
        if (known) return;
        double image[2] = {found.x, found.y};
        map.step(image, parameters, environment);
        const bool fixed = std::abs(image[0] - found.x) + std::abs(image[1] - found.y) < 1e-7;
        all.push_back({found, fixed, false});
    };
    const auto starts = criticalStarts(map, parameters, environment);
    for (const Complex<double>& start : starts) attempt({start.re, start.im});
    if (starts.empty())
        for (int row = 0; row < kStartsAcross; ++row)
            for (int column = 0; column < kStartsAcross; ++column) {
                // A little off the axes, where symmetric maps have no slope.
                const auto place = [](int i) {
                    return kReach * (2.0 * i / (kStartsAcross - 1) - 1) + 0.013;
                };
                attempt({place(column), place(row)});
            }
    std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
        if (a.fixed != b.fixed) return b.fixed;
        return std::abs(a.point.x - b.point.x) > 1e-9 ? a.point.x < b.point.x
                                                      : a.point.y < b.point.y;
    });
    if (const auto image = imageOfInfinity(map, parameters, environment))
        all.push_back({*image, false, true});
    return all;
}

}  // namespace

bool hasCriticalPoints(const MapKernels& map) { return map.criticalPoints > 0 || map.stepSecond; }

bool movesCritical(const MapKernels& map, int number) {
    if (!map.formula) return true;
    const std::vector<bool>& moves = map.formula->formula().movesCritical;
    const auto at = static_cast<std::size_t>(number);
    return at >= moves.size() || moves[at];
}

bool criticalPoint(const MapKernels& map, int k, const double* parameters,
                   const Environment<double>& environment, double* point,
                   const double* parameterSlopes, const double* overrideSlopes, double* slope) {
    if (map.criticalPoints > 0) {
        if (k >= map.criticalPoints) return false;
        map.critical(k, point, parameters);
        if (slope) {
            std::array<DualNumber, kMostParameters> lifted;
            for (int i = 0; i < map.parameters; ++i)
                lifted[static_cast<std::size_t>(i)] = {parameters[i], parameterSlopes[i]};
            DualNumber state[kMostDimension];
            map.criticalDual(k, state, lifted.data());
            for (int i = 0; i < map.dimension; ++i) slope[i] = state[i].slope;
        }
        return true;
    }
    if (!map.stepSecond) return false;
    // What does not move them takes a value of its own, so that they are the same to the last bit
    // for all values, and found also where it is 0.
    std::array<double, kMostParameters> settled;
    std::copy_n(parameters, map.parameters, settled.begin());
    for (int i = 0; i < map.parameters; ++i)
        if (!movesCritical(map, i)) settled[static_cast<std::size_t>(i)] = 1;
    parameters = settled.data();
    const auto all = solvedPoints(map, parameters, environment);
    if (static_cast<std::size_t>(k) >= all.size()) return false;
    const Plane2 at = all[static_cast<std::size_t>(k)].point;
    point[0] = at.x, point[1] = at.y;
    if (slope && all[static_cast<std::size_t>(k)].infinity) {
        std::array<DualNumber, kMostParameters> moving;
        for (int i = 0; i < map.parameters; ++i)
            moving[static_cast<std::size_t>(i)] = {parameters[i], parameterSlopes[i]};
        const auto value = valueAtInfinity(map.formula->formula(), moving.data());
        slope[0] = value->re.slope, slope[1] = value->im.slope;
    } else if (slope) {
        // ∂F/∂x(p*(s), s) = 0 for all s: differentiate it.
        const auto second = lifted(environment);
        const Slope byX = slopeOf(map, at, 1, 0, parameters, nullptr, second);
        const Slope byY = slopeOf(map, at, 0, 1, parameters, nullptr, second);
        const Slope byS = slopeOf(map, at, 0, 0, parameters, parameterSlopes,
                                  lifted(environment, overrideSlopes));
        Plane2 moved{};
        solve2(byX.derivative, byY.derivative, byS.derivative, moved);
        slope[0] = -moved.x, slope[1] = -moved.y;
    }
    return true;
}

}  // namespace versorium
