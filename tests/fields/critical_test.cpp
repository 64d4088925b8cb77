// SPDX-License-Identifier: MIT
// Critical points: closed forms, solved ones, and bifurcation sets that start at them.
#include "maps/critical.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "base/random.h"
#include "fields/programs.h"

namespace versorium {
namespace {

using Point = std::complex<double>;

// Newton's method ends where its step is below 1e-15; a zero of a derivative of order 1 is then
// found to about that.
constexpr double kSolved = 1e-12;

std::vector<double> parametersOf(const OrbitProgram& program) {
    return {program.slice.origin.begin() + program.map->dimension, program.slice.origin.end()};
}
std::vector<Point> criticalPoints(const OrbitProgram& program) {
    Environment<double> environment;
    for (std::size_t k = 0; k < program.lists.size(); ++k) environment.lists[k] = &program.lists[k];
    std::vector<Point> all;
    double at[2];
    for (int k = 0; k < 32; ++k) {
        if (!criticalPoint(*program.map, k, parametersOf(program).data(), environment, at)) break;
        all.emplace_back(at[0], at[1]);
    }
    return all;
}
double nearest(const std::vector<Point>& all, Point wanted) {
    double least = HUGE_VAL;
    for (const Point& one : all) least = std::min(least, std::abs(one - wanted));
    return least;
}

OrbitProgram cubicOf(Point a, Point b) {
    return programOf(
        "cubic", {{"a.re", a.real()}, {"a.im", a.imag()}, {"b.re", b.real()}, {"b.im", b.imag()}},
        {{"z.re"}}, 50, 4);
}
// The same map in the real plane: z³ = x³ - 3xy² + i (3x²y - y³).
OrbitProgram planarCubicOf(Point a, Point b) {
    return programOf("planar",
                     {{"g.a1", a.real()},
                      {"g.b1", -a.imag()},
                      {"g.a2", 0},
                      {"g.b2", 0},
                      {"g.a3", 1},
                      {"g.c3", -3},
                      {"g.d", b.real()},
                      {"h.a1", a.imag()},
                      {"h.b1", a.real()},
                      {"h.c1", 0},
                      {"h.c2", 3},
                      {"h.b3", -1},
                      {"h.d", b.imag()}},
                     {{"p.x"}}, 50, 4);
}

TEST(CriticalPoints, OfTheCubicAreThoseOfItsDerivative) {
    for (const Point a : {Point(-0.6, 0.1), Point(0.7, -0.4), Point(0, 1), Point(-3, 0)}) {
        const auto points = criticalPoints(cubicOf(a, {0.2, 0.6}));
        ASSERT_EQ(points.size(), 2u);
        for (const Point& z : points) EXPECT_LT(std::abs(3.0 * z * z + a), kSolved);
        EXPECT_LT(std::abs(points[0] + points[1]), kSolved);
    }
}

TEST(CriticalPoints, OfThePlanarFormAreSolved) {
    for (const Point a : {Point(-0.6, 0.1), Point(0.7, -0.4), Point(0, 1)}) {
        const auto closed = criticalPoints(cubicOf(a, {0.2, 0.6}));
        const auto solved = criticalPoints(planarCubicOf(a, {0.2, 0.6}));
        ASSERT_EQ(solved.size(), 2u);
        for (const Point& z : closed) EXPECT_LT(nearest(solved, z), kSolved);
        EXPECT_LE(solved[0].real(), solved[1].real());
    }
}

TEST(CriticalPoints, HenonHasNone) {
    const OrbitProgram henon = programOf("planar",
                                         {{"g.a2", -1.4},
                                          {"g.b1", 1},
                                          {"g.b2", 0},
                                          {"g.d", 1},
                                          {"h.a1", 0.3},
                                          {"h.c1", 0},
                                          {"h.d", 0}},
                                         {{"p.x"}}, 50, 100);
    EXPECT_TRUE(criticalPoints(henon).empty());
    // A start that does not exist is NaN and escapes at once.
    OrbitProgram program = henon;
    program.critical = 0;
    EXPECT_EQ(valueAt(program, FieldName::escapeStep), 0);
}

// N' = p p'' / p'²: the roots, which are fixed, and the zeros of p'', which are free.
TEST(CriticalPoints, OfNewtonsMapAreFreeOnesFirst) {
    OrbitProgram newton = programOf("newton", {}, {{"z.re"}}, 50, 1e6);
    const Point roots[3] = {{1, 0.1}, {-0.8, 0.3}, {0.2, -0.9}};
    for (const Point& root : roots)
        newton.lists[0].push_back({{root.real(), root.imag(), 0, 0}, 1});
    const auto points = criticalPoints(newton);
    ASSERT_EQ(points.size(), 4u);
    // p'' of a cubic vanishes at the mean of the roots.
    EXPECT_LT(std::abs(points[0] - (roots[0] + roots[1] + roots[2]) / 3.0), kSolved);
    for (const Point& root : roots)
        EXPECT_LT(nearest({points.begin() + 1, points.end()}, root), 1e-7);

    // Four roots, one of them moved: p'' has two zeros, from the elementary symmetric sums.
    const Point fourth(0.5, 0.7);
    newton.lists[0].push_back({{fourth.real(), fourth.imag(), 0, 0}, 1});
    Point one = 0, two = 0;
    const Point all[4] = {roots[0], roots[1], roots[2], fourth};
    for (int i = 0; i < 4; ++i) {
        one += all[i];
        for (int j = 0; j < i; ++j) two += all[i] * all[j];
    }
    // p'' = 12 z² - 6 e₁ z + 2 e₂.
    const Point root = std::sqrt(36.0 * one * one - 96.0 * two);
    const auto more = criticalPoints(newton);
    ASSERT_EQ(more.size(), 6u);
    const std::vector<Point> free(more.begin(), more.begin() + 2);
    EXPECT_LT(nearest(free, (6.0 * one + root) / 24.0), kSolved);
    EXPECT_LT(nearest(free, (6.0 * one - root) / 24.0), kSolved);
}

// N' = 1 + S'/S² vanishes at every point that is found, and none of the 2n - 2 is missing.
TEST(CriticalPoints, OfNewtonsMapAreComplete) {
    Random random(71);
    for (int n : {2, 3, 5, 8, 13}) {
        OrbitProgram newton = programOf("newton", {}, {{"z.re"}}, 50, 1e6);
        for (int i = 0; i < n; ++i)
            newton.lists[0].push_back({{random.uniform(-1, 1), random.uniform(-1, 1), 0, 0}, 1});
        const auto points = criticalPoints(newton);
        ASSERT_EQ(points.size(), static_cast<std::size_t>(2 * n - 2));
        for (int k = 0; k < n - 2; ++k) {
            Point sum = 0, first = 0;
            for (const auto& root : newton.lists[0]) {
                const Point term =
                    1.0 / (points[static_cast<std::size_t>(k)] - Point(root.q[0], root.q[1]));
                sum += term, first -= term * term;
            }
            EXPECT_LT(std::abs(1.0 + first / (sum * sum)), 1e-9) << n;
        }
    }
}

// R' = R Σ eᵢ/(z - cᵢ): one zero fewer than there are roots and poles.
TEST(CriticalPoints, OfRationalMapsAreComplete) {
    OrbitProgram rational = programOf("complex-rational", {}, {{"z.re"}}, 50, 1e6);
    rational.lists[0] = {{{0.3, 0.4, 0, 0}, 1}, {{-0.5, 0.1, 0, 0}, 1}, {{0.2, -0.6, 0, 0}, 1}};
    rational.lists[1] = {{{0.9, -0.8, 0, 0}, 1}};
    const auto points = criticalPoints(rational);
    ASSERT_EQ(points.size(), 3u);
    for (const Point& z : points) {
        Point sum = -1.0 / (z - Point(0.9, -0.8));
        for (const auto& root : rational.lists[0]) sum += 1.0 / (z - Point(root.q[0], root.q[1]));
        EXPECT_LT(std::abs(sum), 1e-9);
    }
}

// A bifurcation set starts at the critical point of each pixel's own parameters.
TEST(CriticalStart, MovesWithTheParameters) {
    OrbitProgram program = cubicOf({0, 0}, {0.3, 0.2});
    program.slice.axes.clear();
    for (const char* name : {"a.re", "a.im"}) {
        program.slice.axes.emplace_back(program.slice.origin.size(), 0.0);
        program.slice.axes.back()[numberAt(*program.map, name)] = 1;
    }
    for (int k = 0; k < 2; ++k) {
        program.critical = k;
        for (const Point a : {Point(-0.6, 0.1), Point(0.7, -0.4), Point(-1.4, 0)}) {
            const double u[2] = {a.real(), a.imag()};
            const auto orbit = orbitOf(program, u, 0);
            const Point z(orbit[0][0], orbit[0][1]);
            EXPECT_LT(std::abs(3.0 * z * z + a), kSolved);
            // The image under the map, by hand.
            EXPECT_NEAR(valueAt(program, FieldName::imageModulus, u[0], u[1]),
                        std::abs(z * z * z + a * z + Point(0.3, 0.2)), 1e-14);
        }
    }
}

// The derivative that distances need, against differences of the solved points themselves
// (step 1e-5: curvature 1e-10, rounding of the solver 1e-15 / 1e-5).
TEST(CriticalStart, CarriesItsDerivative) {
    const auto check = [](OrbitProgram program, double u) {
        program.iterations = 60;
        program.escapeRadius = 1e3;
        const auto modulus = [&](double at, int n) {
            double square = 0;
            OrbitProgram open = program;
            open.escapeRadius = 1e300;
            const auto orbit = orbitOf(open, &at, n);
            for (double part : orbit.back()) square += part * part;
            return std::sqrt(square);
        };
        const int n = static_cast<int>(valueAt(program, FieldName::escapeStep, u));
        ASSERT_GT(n, 0);
        ASSERT_LT(n, 60) << "the test wants an orbit that escapes";
        const double h = 1e-7, size = modulus(u, n);
        const double slope = std::abs(modulus(u + h, n) - modulus(u - h, n)) / (2 * h);
        EXPECT_NEAR(
            valueAt(program, FieldName::distance, u) / (0.5 * size * std::log(size) / slope), 1,
            1e-4);
    };
    OrbitProgram closed = cubicOf({0, 0}, {1.1, 0.4});
    closed.slice.axes[0].assign(closed.slice.origin.size(), 0.0);
    closed.slice.axes[0][numberAt(*closed.map, "a.re")] = 1;
    closed.critical = 0;
    check(closed, -1.3);
    OrbitProgram solved = planarCubicOf({0, 0.2}, {1.1, 0.4});
    solved.slice.axes[0].assign(solved.slice.origin.size(), 0.0);
    for (const char* name : {"g.a1", "h.b1"}) solved.slice.axes[0][numberAt(*solved.map, name)] = 1;
    solved.slice.origin[numberAt(*solved.map, "g.a1")] = 0;
    solved.slice.origin[numberAt(*solved.map, "h.b1")] = 0;
    solved.critical = 0;
    check(solved, -1.3);
    // A component of a root as the axis: z² (z - r)(z + 1) scaled up, whose critical points move.
    OrbitProgram rational =
        programOf("complex-rational", {{"log_scale", 1.2}}, {{"z.re"}}, 60, 1e3);
    rational.lists[0] = {{{0, 0, 0, 0}, 2}, {{0.6, 0.5, 0, 0}, 1}, {{-1, 0, 0, 0}, 1}};
    rational.overrides.push_back({0, 1, 0});
    rational.slice.origin.push_back(0);
    rational.slice.axes[0].assign(rational.slice.origin.size(), 0.0);
    rational.slice.axes[0].back() = 1;
    for (int k = 0; k < 3; ++k) {
        rational.critical = k;
        if (valueAt(rational, FieldName::membership, 1.9) == 0) check(rational, 1.9);
    }
}

}  // namespace
}  // namespace versorium
