// SPDX-License-Identifier: MIT
// The curve det J = 0, by duals, against the polynomial that det J is.
#include "dynamics/critical_set.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "dynamics/planar_system.h"
#include "fields/programs.h"

namespace versorium {
namespace {

CriticalSet setOf(const System& system, const Window& window, int across = 128) {
    Job job(2);
    const auto set = criticalSet(system, window, {.across = across}, job);
    EXPECT_TRUE(set.ok()) << set.status().message();
    return set.ok() ? *set : CriticalSet{};
}

// (x² - y² + x/2, 2xy - y): det J = 4x² + 4y² - x - ... is a circle.
OrbitProgram circle() {
    return programOf("planar", {{"g.a1", 0.5}, {"g.d", 0}, {"h.b1", -0.5}, {"h.d", 0}}, {}, 10, 4);
}

// gₓ h_y - g_y hₓ = (2x + ½)(2x - ½) + 4y² = 4 (x² + y²) - ¼: the circle of radius ¼.
TEST(CriticalSet, OfAPerturbedSquareIsACircle) {
    const System system(circle());
    const CriticalSet set = setOf(system, {-1, 1, -1, 1});
    ASSERT_EQ(set.curves.size(), 1u);
    EXPECT_EQ(set.curves[0].front(), set.curves[0].back());
    double length = 0;
    for (std::size_t i = 0; i < set.curves[0].size(); ++i) {
        const PlanePoint& p = set.curves[0][i];
        EXPECT_NEAR(std::hypot(p[0], p[1]), 0.25, 1e-12);  // bisected on each edge
        if (i > 0)
            length += std::hypot(p[0] - set.curves[0][i - 1][0], p[1] - set.curves[0][i - 1][1]);
    }
    // A polygon of about 128 corners inside the circle: short by (π/n)²/6.
    EXPECT_NEAR(length, 2 * M_PI * 0.25, 1e-3);
    EXPECT_TRUE(set.points.empty());
    // Picking: the nearest point of a circle lies on the ray through its centre. The polygon's
    // nearest point is off along the circle by less than a cell's angle squared.
    Random random(3);
    for (int i = 0; i < 40; ++i) {
        const PlanePoint at{random.uniform(-1, 1), random.uniform(-1, 1)};
        const double size = std::hypot(at[0], at[1]);
        const auto found = nearestCriticalPoint(system, set, at);
        ASSERT_TRUE(found.has_value());
        EXPECT_NEAR(std::hypot((*found)[0], (*found)[1]), 0.25, 1e-12);
        if (size > 0.1) {
            EXPECT_LT(std::hypot((*found)[0] - at[0] / size / 4, (*found)[1] - at[1] / size / 4),
                      0.016);
        }
    }
}

// For random quartics: every vertex is a zero of the polynomial too, and wherever the polynomial
// changes its sign between neighbouring nodes there is a vertex.
TEST(CriticalSet, AgreesWithTheFormula) {
    Random random(29);
    for (int round = 0; round < 8; ++round) {
        OrbitProgram program = programOf("planar", {}, {}, 10, 4);
        PlanarNumbers numbers;
        for (double& number : numbers) number = random.uniform(-1, 1);
        std::copy(numbers.begin(), numbers.end(), program.slice.origin.begin() + 2);
        const PlanarDeterminant determinant = determinantOf(numbers);
        const Window window{-1.5, 1.5, -1.5, 1.5};
        const int across = 60;
        const CriticalSet set = setOf(System(program), window, across);
        std::size_t vertices = 0;
        for (const Polyline& line : set.curves) {
            vertices += line.size() - (line.front() == line.back() ? 1 : 0);
            // Bisection leaves 3/60 · 2⁻⁴⁰ along an edge, slopes of det J reach about 1e3.
            for (const PlanePoint& p : line)
                EXPECT_LT(std::abs(valueOf(determinant, p[0], p[1])), 1e-9);
        }
        std::size_t changes = 0;
        const auto negative = [&](int i, int j) {
            return valueOf(determinant, -1.5 + 3.0 * i / across, -1.5 + 3.0 * j / across) < 0;
        };
        for (int j = 0; j <= across; ++j)
            for (int i = 0; i <= across; ++i) {
                if (i < across) changes += negative(i, j) != negative(i + 1, j);
                if (j < across) changes += negative(i, j) != negative(i, j + 1);
            }
        EXPECT_EQ(vertices, changes);
        EXPECT_GT(changes, 20u);
    }
}

TEST(CriticalSet, OfAnAnalyticMapIsItsCriticalPoints) {
    const double a = 0.6;  // z³ - 3a²z: f' = 3 (z² - a²)
    const System system(programOf("cubic", {{"a.re", -3 * a * a}, {"a.im", 0}}, {}, 10, 4));
    const CriticalSet set = setOf(system, {});
    EXPECT_TRUE(set.curves.empty());
    ASSERT_EQ(set.points.size(), 2u);
    const auto near = nearestCriticalPoint(system, set, {-0.2, 0.4});
    EXPECT_NEAR((*near)[0], -a, 1e-12);
    EXPECT_NEAR((*near)[1], 0, 1e-12);
}

// A multiple critical point, which Newton's method on f' does not find: z³ + c and conj(z)³ + c.
TEST(CriticalSet, KnowsMultiplePoints) {
    for (const double sign : {1.0, -1.0}) {
        const System system(programOf("planar",
                                      {{"g.a2", 0},
                                       {"g.b2", 0},
                                       {"h.c1", 0},
                                       {"g.a3", 1},
                                       {"g.c3", -3},
                                       {"h.c2", 3 * sign},
                                       {"h.b3", -sign}},
                                      {}, 10, 4));
        const CriticalSet set = setOf(system, {});
        ASSERT_EQ(set.points.size(), 1u);
        EXPECT_NEAR(set.points[0][0], 0, 1e-9);
        EXPECT_NEAR(set.points[0][1], 0, 1e-9);
    }
}

TEST(CriticalSet, OfHenonIsEmpty) {
    const System system(
        programOf("planar", {{"g.a2", -1.4}, {"g.b1", 1}, {"g.b2", 0}, {"h.a1", 0.3}, {"h.c1", 0}},
                  {}, 10, 4));
    const CriticalSet set = setOf(system, {});
    EXPECT_TRUE(set.empty());
    EXPECT_FALSE(nearestCriticalPoint(system, set, {0, 0}).has_value());
}

TEST(CriticalSet, RefusesWhatMakesNoSense) {
    Job job(1);
    EXPECT_FALSE(criticalSet(System(programOf("logistic", {}, {}, 1, 1)), {}, {}, job).ok());
    const System system(circle());
    EXPECT_FALSE(criticalSet(system, {}, {.across = 1}, job).ok());
    EXPECT_FALSE(criticalSet(system, {0, 1e6, 0, 1}, {}, job).ok());
    job.cancel();
    EXPECT_EQ(criticalSet(system, {}, {}, job).status().kind(), ErrorKind::cancelled);
}

}  // namespace
}  // namespace versorium
