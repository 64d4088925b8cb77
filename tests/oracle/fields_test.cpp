// SPDX-License-Identifier: MIT
// Short orbits and their fields against the oracle, for every map, along slices through starting
// points and parameters. Chaos amplifies rounding, so every tolerance is the rounding of a step
// times what the oracle itself makes of such a change (oracle/orbits.h).
#include "fields/evaluate.h"

#include <gtest/gtest.h>

#include "oracle/cases.h"

namespace versorium {
namespace {

using oracle::Real;
using enum FieldName;

constexpr FieldName kFields[] = {
    membership, solid,    escapeStep,      smoothEscape,   squaredNorm, logModulus, imageModulus,
    versor,     argument, FieldName::trap, attractionStep, distance,    lyapunov};

// A program and the oracle's form of it. Axis 0 moves the first component of the start and, a
// little, the first parameter; axis 1 the second component or the last parameter.
struct Twins {
    OrbitProgram program;
    oracle::Case oracleCase;
    oracle::Trap oracleTrap;
};

Twins twinsOf(const MapKernels& map, const Sample& sample, const TestBindings& bindings,
              const oracle::Bound& bound, int iterations) {
    Twins twins;
    OrbitProgram& program = twins.program;
    program.map = &map;
    for (std::size_t k = 0; k < map.info.lists.size(); ++k)
        program.lists.push_back(k == 0 ? bindings.roots : bindings.poles);
    program.field = std::make_shared<const DistanceField>(bindings.field);
    program.slice.origin = sample.state;
    program.slice.origin.insert(program.slice.origin.end(), sample.parameters.begin(),
                                sample.parameters.end());
    program.slice.axes.assign(2, std::vector<double>(program.slice.origin.size(), 0.0));
    program.slice.axes[0][0] = 1;
    program.slice.axes[0][sample.state.size()] = 0.125;
    program.slice.axes[1][map.dimension > 1 ? 1 : program.slice.origin.size() - 1] = 1;
    program.iterations = iterations;
    program.escapeRadius = std::isinf(map.info.escapeRadius) ? 3 : map.info.escapeRadius;
    program.degree = map.info.degree;
    program.trap.kind = Trap::Kind::point;
    program.trap.point[0] = 0.25, program.trap.point[1] = -0.125;
    program.trap.components = std::min(2, map.dimension);

    oracle::Case& c = twins.oracleCase = caseOf(map, sample, bound);
    for (const auto& axis : program.slice.axes) c.axes.emplace_back(axis.begin(), axis.end());
    c.iterations = iterations;
    c.radius = program.escapeRadius;
    twins.oracleTrap.point.assign(program.trap.point, program.trap.point + program.trap.components);
    return twins;
}

// Counts comparisons, so that a test cannot pass by looking at nothing.
struct Tally {
    int compared = 0, undecided = 0;
};

void compare(const MapKernels& map, const Twins& twins, const oracle::Vector& u,
             const std::vector<std::vector<double>>& values, Tally& tally) {
    const oracle::Case& c = twins.oracleCase;
    const auto all = oracle::orbit(c, u);
    const auto amplified = oracle::amplification(c, u, all);
    // 32 roundings a step, as one step is checked to (maps_test.cpp).
    const auto slack = [&](std::size_t n) {
        return 32 * kRounding * (amplified[n] + oracle::length(all[n]));
    };
    for (std::size_t n = 0; n < all.size(); ++n)
        if (!(std::abs(oracle::length(all[n]) - c.radius) > 1e-9L * c.radius + 4 * slack(n))) {
            ++tally.undecided;
            return;
        }
    ++tally.compared;
    const oracle::Fields f = oracle::fieldsOf(c, u, all, twins.oracleTrap);
    const auto at = [&](std::size_t field, std::size_t channel = 0) {
        return static_cast<Real>(values[field][channel]);
    };
    const std::string where = std::string(map.info.name) + " at " +
                              std::to_string(static_cast<double>(u[0])) + ", " +
                              std::to_string(static_cast<double>(u[1]));
    const std::size_t last = all.size() - 1;
    const Real size = oracle::length(all[last]), error = slack(last);
    EXPECT_EQ(at(0), f.escaped ? 0 : 1) << where;
    EXPECT_EQ(at(2), f.step) << where;
    if (std::abs(f.logModulus) > error / size) {
        EXPECT_EQ(at(1), f.logModulus < 0) << where;
    }
    // The derivative of log_d(ln|z| / ln R) by |z|.
    const Real smoothError = f.escaped ? error / (size * std::log(size) * std::log(c.degree)) : 0;
    EXPECT_NEAR(at(3), f.smooth, smoothError + 64 * kRounding * (f.step + 1)) << where;
    EXPECT_NEAR(at(4), f.squaredNorm, 2 * size * error + error * error) << where;
    if (size > error) {  // not where the last iterate is 0
        EXPECT_NEAR(at(5), f.logModulus,
                    2 * error / size + 16 * kRounding * (1 + std::abs(f.logModulus)))
            << where;
    }
    Real least = 0;
    for (std::size_t n = 0; n <= last; ++n) least = std::fmax(least, slack(n));
    EXPECT_NEAR(at(9), f.trap, least) << where;
}

void compareImage(const MapKernels& map, const Twins& twins, const oracle::Vector& u,
                  const std::vector<std::vector<double>>& values) {
    oracle::Case c = twins.oracleCase;
    c.iterations = 1;
    c.radius = std::numeric_limits<Real>::infinity();
    const auto all = oracle::orbit(c, u);
    const Real size = oracle::length(all[1]);
    const Real error = 32 * kRounding * (oracle::amplification(c, u, all)[1] + size);
    const oracle::Fields f = oracle::fieldsOf(c, u, all, twins.oracleTrap);
    EXPECT_NEAR(static_cast<Real>(values[6][0]), f.imageModulus, error) << map.info.name;
    for (std::size_t k = 0; k < f.versor.size(); ++k)
        EXPECT_NEAR(static_cast<Real>(values[7][k]), f.versor[k], 2 * error / size)
            << map.info.name;
    const Real planeSize =
        all[1].size() > 1 ? oracle::length({all[1][0], all[1][1]}) : std::abs(all[1][0]);
    const Real turn = static_cast<Real>(values[8][0]) - f.argument;
    // Angles agree up to a whole turn: rounding may cross the seam.
    EXPECT_NEAR(turn - 2 * std::acos(Real(-1)) * std::round(turn / (2 * std::acos(Real(-1)))), 0,
                2 * error / planeSize + 8 * kRounding)
        << map.info.name;
}

TEST(OracleFields, EveryMapOnShortOrbits) {
    const TestBindings bindings;
    const oracle::Bound bound = oracleBound(bindings);
    for (const MapKernels& map : catalogue()) {
        Tally tally;
        for (const Sample& sample : samples(map, 8, 41)) {
            const Twins twins = twinsOf(map, sample, bindings, bound, 6);
            std::vector<double> x, y;
            for (int i = 0; i < 9; ++i) {
                x.push_back(0.0625 * (i % 3) - 0.0625);
                y.push_back(0.125 * (i / 3) - 0.125);
            }
            const double* coordinates[3] = {x.data(), y.data(), nullptr};
            const auto values = evaluateFields(twins.program, 9, coordinates, kFields);
            for (std::size_t i = 0; i < x.size(); ++i) {
                std::vector<std::vector<double>> own;
                for (const auto& field : values) {
                    own.emplace_back();
                    for (std::size_t k = i; k < field.size(); k += x.size())
                        own.back().push_back(field[k]);
                }
                compare(map, twins, {x[i], y[i]}, own, tally);
                compareImage(map, twins, {x[i], y[i]}, own);
            }
        }
        // Chaotic maps lose every digit in a few steps, but most orbits are comparable.
        EXPECT_GT(tally.compared, 2 * tally.undecided) << map.info.name;
    }
}

// The attraction step by its rule, where no difference of squared norms is close to the limit.
TEST(OracleFields, AttractionStep) {
    const TestBindings bindings;
    const oracle::Bound bound = oracleBound(bindings);
    int inside = 0, compared = 0;
    for (const MapKernels& map : catalogue())
        for (const Sample& sample : samples(map, 12, 42)) {
            const Twins twins = twinsOf(map, sample, bindings, bound, 6);
            const auto all = oracle::orbit(twins.oracleCase, {0, 0});
            const auto amplified = oracle::amplification(twins.oracleCase, {0, 0}, all);
            const double zero = 0;
            const double* coordinates[3] = {&zero, &zero, &zero};
            const FieldName field[] = {attractionStep};
            const double value = evaluateFields(twins.program, 1, coordinates, field)[0][0];
            bool decided = true;
            for (std::size_t n = 0; n < all.size(); ++n) {
                const Real size = oracle::length(all[n]);
                const Real slack = 1e-9L + 64 * kRounding * (amplified[n] + size) * (1 + size);
                decided = decided && std::abs(size - twins.oracleCase.radius) > slack;
                if (n == 0) continue;
                const Real before = oracle::length(all[n - 1]);
                const Real change = std::abs(size * size - before * before);
                decided = decided && std::abs(change - std::sqrt(0.0005L)) > slack;
            }
            if (!decided) continue;
            ++compared;
            const oracle::Fields f =
                oracle::fieldsOf(twins.oracleCase, {0, 0}, all, twins.oracleTrap);
            if (f.escaped) {
                EXPECT_TRUE(std::isnan(value)) << map.info.name;
            } else {
                ++inside;
                EXPECT_EQ(value, *f.attraction) << map.info.name;
            }
        }
    EXPECT_GT(compared, 200);
    EXPECT_GT(inside, 50);
}

// Central differences of step h = 1e-7 are off by h² f''' / 6f' and by rounding of 1e-19 / h; with
// derivatives that grow by up to 10³ in six steps both stay below 1e-5. A kink of |x| or of a shape
// within h, or a gradient that nearly vanishes, is met by few points.
TEST(OracleFields, DistanceAgreesWithFiniteDifferences) {
    const TestBindings bindings;
    const oracle::Bound bound = oracleBound(bindings);
    for (const MapKernels& map : catalogue()) {
        int compared = 0, wrong = 0;
        for (const Sample& sample : samples(map, 60, 43)) {
            Twins twins = twinsOf(map, sample, bindings, bound, 6);
            const auto all = oracle::orbit(twins.oracleCase, {0, 0});
            const double zero = 0;
            const double* coordinates[3] = {&zero, &zero, &zero};
            const FieldName field[] = {distance};
            const double value = evaluateFields(twins.program, 1, coordinates, field)[0][0];
            if (!oracle::outside(all.back(), twins.oracleCase.radius)) {
                EXPECT_EQ(value, 0) << map.info.name;
                continue;
            }
            const Real expected =
                oracle::distanceEstimate(twins.oracleCase, {0, 0}, all.size() - 1);
            if (!(std::isfinite(static_cast<double>(expected)) && expected > 0)) continue;
            ++compared;
            if (!(std::abs(value - expected) <= 1e-5L * expected)) ++wrong;
        }
        EXPECT_LE(wrong, compared / 20) << map.info.name << ", of " << compared;
        // Newton's map and shapes with a small shell hardly let anything escape.
        if (map.info.name == "quadratic" || map.info.name == "mandelbulb" ||
            map.info.name == "shape-modulus") {
            EXPECT_GT(compared, 10) << map.info.name;
        }
    }
}

// ln|∂z_N/∂x_0| / N is the mean of ln|Df v| along the orbit, as long as no derivative is lost.
TEST(OracleFields, LyapunovOfShortOrbits) {
    const TestBindings bindings;
    const oracle::Bound bound = oracleBound(bindings);
    int compared = 0, wrong = 0;
    for (const MapKernels& map : catalogue())
        for (const Sample& sample : samples(map, 20, 44)) {
            const Twins twins = twinsOf(map, sample, bindings, bound, 4);
            const auto all = oracle::orbit(twins.oracleCase, {0, 0});
            const double zero = 0;
            const double* coordinates[3] = {&zero, &zero, &zero};
            const FieldName field[] = {lyapunov};
            const double value = evaluateFields(twins.program, 1, coordinates, field)[0][0];
            if (oracle::outside(all.back(), twins.oracleCase.radius)) {
                EXPECT_TRUE(std::isnan(value)) << map.info.name;
                continue;
            }
            const Real expected = oracle::lyapunovOf(twins.oracleCase, {0, 0});
            if (!(std::abs(expected) < 3)) continue;
            ++compared;
            // As for the distance: differences, and points beside a kink.
            if (!(std::abs(value - expected) <= 1e-5L)) ++wrong;
        }
    EXPECT_GT(compared, 60);
    EXPECT_LE(wrong, compared / 50);
}

TEST(OracleFields, TrapsOfEveryKind) {
    const TestBindings bindings;
    const oracle::Bound bound = oracleBound(bindings);
    const MapKernels& map = *findMap("quadratic");
    for (const Sample& sample : samples(map, 30, 45)) {
        Twins twins = twinsOf(map, sample, bindings, bound, 5);
        for (int kind = 0; kind < 3; ++kind) {
            twins.program.trap.kind = static_cast<Trap::Kind>(kind);
            twins.program.trap.radius = 0.75;
            twins.program.trap.angle = 0.7;
            twins.oracleTrap.kind = static_cast<oracle::Trap::Kind>(kind);
            twins.oracleTrap.radius = 0.75L;
            twins.oracleTrap.angle = twins.program.trap.angle;
            const auto all = oracle::orbit(twins.oracleCase, {0, 0});
            const auto amplified = oracle::amplification(twins.oracleCase, {0, 0}, all);
            if (std::abs(oracle::length(all.back()) - 2) < 1e-9L) continue;
            const double zero = 0;
            const double* coordinates[3] = {&zero, &zero, &zero};
            const FieldName field[] = {FieldName::trap};
            EXPECT_NEAR(evaluateFields(twins.program, 1, coordinates, field)[0][0],
                        static_cast<double>(
                            oracle::fieldsOf(twins.oracleCase, {0, 0}, all, twins.oracleTrap).trap),
                        static_cast<double>(64 * kRounding * (1 + amplified.back())))
                << kind;
        }
    }
}

}  // namespace
}  // namespace versorium
