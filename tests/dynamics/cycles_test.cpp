// SPDX-License-Identifier: MIT
// Cycles whose points, number and multipliers are known in closed form.
#include "dynamics/cycles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/programs.h"

namespace versorium {
namespace {

// Newton's method ends at a relative step of 1e-13; multipliers are products of a few factors.
constexpr double kSolved = 1e-11;

OrbitProgram henon(double a, double b) {
    return programOf(
        "planar",
        {{"g.a2", -a}, {"g.b1", 1}, {"g.b2", 0}, {"g.d", 1}, {"h.a1", b}, {"h.c1", 0}, {"h.d", 0}},
        {}, 100, 100);
}
OrbitProgram quadratic(double re, double im) {
    return programOf("quadratic", {{"c.re", re}, {"c.im", im}}, {}, 100, 2);
}

CycleSearch cyclesOf(const OrbitProgram& program, int period, const Window& window = {}) {
    Job job(2);
    const Expected<CycleSearch> found =
        findCycles(System(program), window, {.maxPeriod = period}, job);
    EXPECT_TRUE(found.ok()) << found.status().message();
    return found.ok() ? *found : CycleSearch{};
}
int countOf(const CycleSearch& search, int period) {
    int count = 0;
    for (const PeriodicCycle& cycle : search.cycles) count += cycle.period == period;
    return count;
}

// x = 1 - a x² + b x at the fixed points, and the eigenvalues there are the roots of
// λ² + 2 a x λ - b = 0.
TEST(Cycles, OfHenonsMap) {
    const double a = 1.4, b = 0.3;
    const CycleSearch search = cyclesOf(henon(a, b), 2);
    ASSERT_EQ(countOf(search, 1), 2);
    const PeriodicCycle& fixed = search.cycles[1];
    EXPECT_NEAR(fixed.points[0][0], 0.631354, 5e-7);
    const double x = (b - 1 + std::sqrt((1 - b) * (1 - b) + 4 * a)) / (2 * a);
    EXPECT_NEAR(fixed.points[0][0], x, kSolved);
    EXPECT_NEAR(fixed.points[0][1], b * x, kSolved);
    EXPECT_EQ(fixed.kind, CycleKind::saddle);
    const double root = std::sqrt(a * a * x * x + b);
    ASSERT_EQ(fixed.eigenvalues.size(), 2u);
    EXPECT_NEAR(fixed.eigenvalues[0].real(), -a * x - root, kSolved);
    EXPECT_NEAR(fixed.eigenvalues[1].real(), -a * x + root, kSolved);
    EXPECT_FALSE(fixed.multiplier.has_value());
    // The cycle of period 2: x₁ + x₂ = (1 - b)/a, and det of the second iterate is b².
    ASSERT_EQ(countOf(search, 2), 1);
    const PeriodicCycle& two = search.cycles[2];
    EXPECT_NEAR(two.points[0][0] + two.points[1][0], (1 - b) / a, kSolved);
    EXPECT_NEAR((two.eigenvalues[0] * two.eigenvalues[1]).real(), b * b, kSolved);
}

// The logistic map at 3.5: fixed points 0 and 1 - 1/r, and the cycles of its cascade, of which the
// one of period 4 attracts.
TEST(Cycles, OfTheLogisticFamily) {
    const double r = 3.5;
    const CycleSearch search =
        cyclesOf(programOf("logistic", {{"r", r}}, {}, 100, 16), 4, {-0.5, 1.5, 0, 1});
    ASSERT_EQ(search.cycles.size(), 4u);
    EXPECT_NEAR(search.cycles[0].points[0][0], 0, kSolved);
    EXPECT_NEAR(search.cycles[0].multiplier->real(), r, kSolved);
    EXPECT_NEAR(search.cycles[1].points[0][0], 1 - 1 / r, kSolved);
    EXPECT_NEAR(search.cycles[1].multiplier->real(), 2 - r, kSolved);
    // Multiplier of the cycle of period 2: 4 + 2r - r².
    EXPECT_NEAR(search.cycles[2].multiplier->real(), 4 + 2 * r - r * r, kSolved);
    EXPECT_EQ(search.cycles[2].kind, CycleKind::repelling);
    EXPECT_EQ(search.cycles[3].period, 4);
    EXPECT_EQ(search.cycles[3].kind, CycleKind::attracting);
    // Its points, as printed in every table of the logistic map.
    const double known[4] = {0.38281968, 0.82694071, 0.50088421, 0.87499726};
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(search.cycles[3].points[k][0], known[k], 5e-9);
}

// z² + c has (2ᵖ - Σ over proper divisors) / p cycles of period p: 2, 1, 2, 3, 6 where none meet.
TEST(Cycles, OfTheQuadraticFamilyAreComplete) {
    const CycleSearch search = cyclesOf(quadratic(-0.122561, 0.744862), 5);
    const int known[] = {2, 1, 2, 3, 6};
    for (int period = 1; period <= 5; ++period)
        EXPECT_EQ(countOf(search, period), known[period - 1]) << period;
    int attracting = 0;
    for (const PeriodicCycle& cycle : search.cycles) {
        ASSERT_TRUE(cycle.multiplier.has_value());
        // (fᵖ)' is the product of 2z along the cycle.
        std::complex<double> product = 1;
        for (const PlanePoint& z : cycle.points) product *= 2.0 * std::complex(z[0], z[1]);
        EXPECT_LT(std::abs(product - *cycle.multiplier), 1e-10 * (1 + std::abs(product)));
        attracting += cycle.kind == CycleKind::attracting;
    }
    // One critical orbit, hence at most one attracting cycle: the rabbit's, nearly superattracting.
    ASSERT_EQ(attracting, 1);
    for (const PeriodicCycle& cycle : search.cycles)
        if (cycle.kind == CycleKind::attracting) {
            EXPECT_EQ(cycle.period, 3);
            EXPECT_LT(std::abs(*cycle.multiplier), 1e-4);  // c is given to six digits
        }
}

// At r = 4 the map is a doubling of angles: all points of period p are known to exist, and all
// multipliers are ±2ᵖ but that of 0, which is 4.
TEST(Cycles, OfTheLogisticMapAtFourAreComplete) {
    const CycleSearch search =
        cyclesOf(programOf("logistic", {{"r", 4}}, {}, 100, 16), 8, {-0.1, 1.1, 0, 1});
    const int known[] = {2, 1, 2, 3, 6, 9, 18, 30};
    for (int period = 1; period <= 8; ++period)
        EXPECT_EQ(countOf(search, period), known[period - 1]) << period;
    for (const PeriodicCycle& cycle : search.cycles) {
        const double size = std::pow(2.0, cycle.period);
        EXPECT_NEAR(std::abs(cycle.multiplier->real()), cycle.points[0][0] < 1e-9 ? 4 : size,
                    1e-9 * size);
    }
}

// Hénon's cycles at the usual parameters, as counted by Biham and Wenzel and others: on the
// attractor 1, 1, 0, 1, 0, 2, 4, 7, 6, 10 of period 1 … 10, and the fixed point beside it.
TEST(Cycles, OfHenonsAttractorAreComplete) {
    const CycleSearch search = cyclesOf(henon(1.4, 0.3), 10);
    const int known[] = {2, 1, 0, 1, 0, 2, 4, 7, 6, 10};
    for (int period = 1; period <= 10; ++period)
        EXPECT_EQ(countOf(search, period), known[period - 1]) << period;
    for (const PeriodicCycle& cycle : search.cycles) {
        EXPECT_EQ(cycle.kind, CycleKind::saddle);
        // det J = -b at each point.
        const double product = (cycle.eigenvalues[0] * cycle.eigenvalues[1]).real();
        EXPECT_NEAR(product / std::pow(-0.3, cycle.period), 1, 1e-6);
    }
}

TEST(Cycles, HaveThePeriodsOfKnownCentres) {
    struct Centre {
        double re, im;
        int period;
    };
    for (const Centre& c :
         {Centre{0, 0, 1}, Centre{-1, 0, 2}, Centre{-0.12256116687665361, 0.74486176661974424, 3},
          Centre{-1.7548776662466927, 0, 3}, Centre{0.28227139076691387, 0.53006061757852529, 4},
          Centre{-1.3107026413368328, 0, 4}}) {
        const PeriodicCycle cycle =
            cycleThrough(System(quadratic(c.re, c.im)), PlanePoint{0, 0}.data(), c.period);
        EXPECT_EQ(cycle.period, c.period);
        EXPECT_LT(std::abs(*cycle.multiplier), 1e-12);
        const CycleSearch search = cyclesOf(quadratic(c.re, c.im), c.period);
        int superattracting = 0;
        for (const PeriodicCycle& one : search.cycles)
            superattracting += one.period == c.period && std::abs(*one.multiplier) < 1e-9;
        EXPECT_EQ(superattracting, 1) << c.re << " " << c.im;
    }
}

// Where cycles meet there is one, and not a crowd of points that rounding leaves.
TEST(Cycles, AtBifurcationsAreOne) {
    // c = 1/4: both fixed points meet at 1/2 with multiplier 1.
    const CycleSearch cusp = cyclesOf(quadratic(0.25, 0), 1);
    ASSERT_EQ(cusp.cycles.size(), 1u);
    EXPECT_NEAR(cusp.cycles[0].points[0][0], 0.5, 1e-6);
    EXPECT_NEAR(cusp.cycles[0].multiplier->real(), 1, 1e-5);
    // c = -3/4: the cycle of period 2 is born at -1/2, a triple root.
    const CycleSearch doubling = cyclesOf(quadratic(-0.75, 0), 2);
    EXPECT_EQ(countOf(doubling, 1), 2);
    EXPECT_EQ(countOf(doubling, 2), 0);
}

TEST(Cycles, DoNotDependOnThreads) {
    Job one(1), four(4);
    const System system(henon(1.4, 0.3));
    const auto a = findCycles(system, {}, {.maxPeriod = 6}, one);
    const auto b = findCycles(system, {}, {.maxPeriod = 6}, four);
    ASSERT_TRUE(a.ok() && b.ok());
    ASSERT_EQ(a->cycles.size(), b->cycles.size());
    EXPECT_GT(a->cycles.size(), 4u);
    for (std::size_t i = 0; i < a->cycles.size(); ++i) {
        EXPECT_EQ(a->cycles[i].points, b->cycles[i].points);
        EXPECT_EQ(a->cycles[i].eigenvalues, b->cycles[i].eigenvalues);
    }
}

TEST(Cycles, RefuseWhatMakesNoSense) {
    Job job(1);
    const System system(henon(1.4, 0.3));
    EXPECT_EQ(findCycles(system, {}, {.maxPeriod = 0}, job).status().kind(), ErrorKind::usage);
    EXPECT_EQ(findCycles(system, {2, -2, 0, 1}, {}, job).status().kind(), ErrorKind::usage);
    EXPECT_EQ(findCycles(system, {NAN, 2, 0, 1}, {}, job).status().kind(), ErrorKind::usage);
    const System space(programOf("mandelbulb", {}, {}, 10, 2));
    const auto refused = findCycles(space, {}, {}, job);
    EXPECT_EQ(refused.status().kind(), ErrorKind::usage);
    EXPECT_NE(refused.status().message().find("mandelbulb"), std::string::npos);
    job.cancel();
    EXPECT_EQ(findCycles(system, {}, {}, job).status().kind(), ErrorKind::cancelled);
}

}  // namespace
}  // namespace versorium
