// SPDX-License-Identifier: MIT
// What is known of periods, exponents and distances without computing an orbit.
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "fields/programs.h"

namespace versorium {
namespace {

OrbitProgram julia(double re, double im, int iterations, double radius) {
    return programOf("quadratic", {{"c.re", re}, {"c.im", im}}, {{"z.re"}, {"z.im"}}, iterations,
                     radius);
}

TEST(Period, OfTheCentresOfKnownComponents) {
    // Douady's rabbit, the basilica, and the centre of the cardioid.
    EXPECT_EQ(valueAt(julia(-0.122561, 0.744862, 1000, 2), FieldName::period), 3);
    EXPECT_EQ(valueAt(julia(-1, 0, 1000, 2), FieldName::period), 2);
    EXPECT_EQ(valueAt(julia(0, 0, 1000, 2), FieldName::period), 1);
    // The cascade of doublings on the real line: superstable parameters of period 4 and 8.
    const auto real = [](double c) {
        return programOf("real-quadratic", {{"c", c}}, {{"x"}}, 1000, 2);
    };
    EXPECT_EQ(valueAt(real(-1.3107026413368328), FieldName::period), 4);
    EXPECT_EQ(valueAt(real(-1.3815474844320617), FieldName::period), 8);
    // The window of period 3 of the logistic family opens at r = 1 + sqrt(8).
    const auto logistic = [](double r) {
        return programOf("logistic", {{"r", r}}, {{"x"}}, 4000, 16);
    };
    EXPECT_EQ(valueAt(logistic(3.2), FieldName::period, 0.3), 2);
    EXPECT_EQ(valueAt(logistic(1 + std::sqrt(8.0) + 0.003), FieldName::period, 0.3), 3);
}

TEST(Period, NoneWhereTheOrbitEscapesOrIsChaotic) {
    EXPECT_EQ(valueAt(julia(1, 0, 1000, 2), FieldName::period), 0);
    // At r = 4 an orbit comes back to within 1e-9 in 4096 steps with a chance of about 1e-5.
    EXPECT_EQ(valueAt(programOf("logistic", {{"r", 4}}, {{"x"}}, 1000, 16), FieldName::period, 0.3),
              0);
}

// With x = sin² θ the map doubles θ, so that ln|(fᴺ)'| = N ln 2 + ln|sin 2θ_N / sin 2θ_0|: the
// exponent is off by the last term over N, which is below 30 for all but one start in 10¹².
TEST(Lyapunov, OfTheLogisticMapAtFour) {
    const int iterations = 20000;
    const OrbitProgram program = programOf("logistic", {{"r", 4}}, {{"x"}}, iterations, 16);
    for (double x : {0.1, 0.3, 0.45, 0.77})
        EXPECT_NEAR(valueAt(program, FieldName::lyapunov, x), std::log(2.0), 30.0 / iterations);
}

TEST(Lyapunov, OfAttractingCycles) {
    // The fixed point 1 - 1/r has multiplier 2 - r; the way there costs a constant over N.
    const OrbitProgram fixed = programOf("logistic", {{"r", 2.5}}, {{"x"}}, 5000, 16);
    EXPECT_NEAR(valueAt(fixed, FieldName::lyapunov, 0.3), std::log(0.5), 10.0 / 5000);
    // c = -0.75 + ε: the cycle of c in the disc of period 2 has multiplier 4 (c + 1).
    const OrbitProgram two = julia(-1.1, 0.05, 5000, 2);
    EXPECT_NEAR(valueAt(two, FieldName::lyapunov, 0.01, 0.02),
                0.5 * std::log(4 * std::hypot(0.1, 0.05)), 10.0 / 5000);
    // A superattracting cycle has multiplier 0.
    EXPECT_LT(valueAt(julia(-1, 0, 500, 2), FieldName::lyapunov), -20);
    EXPECT_LT(valueAt(julia(-1, 0, 500, 2), FieldName::lyapunov, 0.1, 0.1), -20);
    EXPECT_TRUE(std::isnan(valueAt(julia(1, 0, 500, 2), FieldName::lyapunov)));
}

// Simple roots attract quadratically under Newton's map, a double root with multiplier 1 - 1/2, and
// the derivative is that also where the orbit has met the root to the bit.
TEST(Lyapunov, OfNewtonsMapAtRoots) {
    OrbitProgram newton = programOf("newton", {}, {{"z.re"}, {"z.im"}}, 4000, 1e6);
    newton.lists[0] = {{{1, 0, 0, 0}, 1}, {{-0.5, 0.5, 0, 0}, 1}, {{-0.5, -0.75, 0, 0}, 1}};
    EXPECT_LT(valueAt(newton, FieldName::lyapunov, 0.9, 0.1), -20);
    newton.lists[0][0].power = 2;
    EXPECT_NEAR(valueAt(newton, FieldName::lyapunov, 0.9, 0.1), std::log(0.5), 10.0 / 4000);
    EXPECT_NEAR(valueAt(newton, FieldName::lyapunov, 1, 0), std::log(0.5), 10.0 / 4000);
}

// The stretching of Hénon's map is shared by its two exponents, whose sum is ln|det J| = ln 0.3;
// the larger one is 0.42 (Benettin and others), to the fluctuations of 20000 steps.
TEST(Lyapunov, OfHenonsAttractor) {
    const OrbitProgram henon = programOf("planar",
                                         {{"g.a2", -1.4},
                                          {"g.b1", 1},
                                          {"g.b2", 0},
                                          {"g.d", 1},
                                          {"h.a1", 0.3},
                                          {"h.c1", 0},
                                          {"h.d", 0}},
                                         {{"p.x"}, {"p.y"}}, 20000, 100);
    EXPECT_NEAR(valueAt(henon, FieldName::lyapunov, 0.1, 0.1), 0.419, 0.01);
}

// For c = 0: |z_n| = r^(2ⁿ), |∇|z_n|| = 2ⁿ r^(2ⁿ - 1), hence ½ r ln r whatever n is. The derivative
// takes a dozen products; 1e-13 leaves room for them, times 2ⁿ for the power.
TEST(Distance, OfTheUnitDisc) {
    for (double radius : {2.0, 100.0, 1e10}) {
        const OrbitProgram disc = julia(0, 0, 200, radius);
        for (double r : {1.001, 1.1, 1.5, 1.9, 3.0})
            for (double angle : {0.0, 1.0, 2.5})
                EXPECT_NEAR(
                    valueAt(disc, FieldName::distance, r * std::cos(angle), r * std::sin(angle)) /
                        (0.5 * r * std::log(r)),
                    1, 1e-9)
                    << "r " << r << ", R " << radius;
        EXPECT_EQ(valueAt(disc, FieldName::distance, 0.5, 0.5), 0);
    }
}

// The tip of the Mandelbrot set is c = -2; by Koebe's theorem the estimate is right to a factor 2
// there, and at the tip of a straight whisker it tends to the distance itself.
TEST(Distance, OfTheTipOfTheMandelbrotSet) {
    const OrbitProgram mandelbrot = programOf("quadratic", {}, {{"c.re"}, {"c.im"}}, 5000, 1e6);
    for (double x : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        const double estimate = valueAt(mandelbrot, FieldName::distance, -2 - x, 0);
        EXPECT_GT(estimate, 0.5 * x);
        EXPECT_LT(estimate, 2 * x);
        if (x < 1e-3) {
            EXPECT_NEAR(estimate / x, 1, 0.05);
        }
    }
}

// R listing 7: w = c, dz = 1; then dz = 8 r⁷ dz + 1, w = w⁸ + c; ¼ ln m sqrt(m) / dz, m = |w|². On
// the z-axis the map is z⁸ + c, so that the recursion is its very derivative. Slicing the start
// together with c is the listing; slicing c alone from 0 is the same one step later.
TEST(Distance, OfTheMandelbulbHasThePlusOne) {
    const OrbitProgram both = programOf("mandelbulb", {}, {{"p.z", "c.z"}}, 12, 2);
    const OrbitProgram parameter = programOf("mandelbulb", {}, {{"c.z"}}, 13, 2);
    int escaped = 0;
    for (double c = 0.7; c < 1.6; c += 0.03) {
        double z = c, dz = 1;
        int n = 0;
        for (; n < 12 && z * z <= 4; ++n) {
            dz = 8 * std::pow(z, 7) * dz + 1;
            z = std::pow(z, 8) + c;
        }
        const double expected = z * z > 4 ? 0.25 * std::log(z * z) * std::abs(z) / dz : 0;
        escaped += expected > 0;
        // Rounding grows with the derivative, which is below 1e7 times the estimate's inverse.
        EXPECT_NEAR(valueAt(both, FieldName::distance, c), expected, 1e-9 * (1 + expected)) << c;
        EXPECT_NEAR(valueAt(parameter, FieldName::distance, c), expected, 1e-9 * (1 + expected))
            << c;
        // Without the one, in the dynamical plane of a fixed c, it is another number.
        if (expected > 0 && n > 0) {
            const OrbitProgram fixed = programOf("mandelbulb", {{"c.z", c}}, {{"p.z"}}, 12, 2);
            EXPECT_GT(valueAt(fixed, FieldName::distance, c), 1.001 * expected);
        }
    }
    EXPECT_GT(escaped, 10);
}

// An exponent may be an axis as well, also where it is whole (its powers then need no logarithm,
// but their derivatives do).
TEST(Distance, AlongAnExponent) {
    for (const char* name : {"power", "mandelbulb"})
        for (double exponent : {3.0, 3.25}) {
            const bool bulb = name[0] == 'm';
            OrbitProgram program =
                bulb ? programOf(name, {{"p.x", 0.9}, {"p.y", 0.5}, {"p.z", 0.7}}, {{"power"}}, 3,
                                 1e6)
                     : programOf(name, {{"z.re", 1.3}, {"z.im", 0.4}}, {{"power"}}, 3, 1e6);
            program.iterations = 2;
            program.escapeRadius = 1;
            // ½ |z| ln|z| / |d|z|/dp| at n = 0 … the start is outside already: n = 0 has no slope.
            EXPECT_EQ(valueAt(program, FieldName::distance, exponent), 0);
            program.escapeRadius = 1.6;
            const auto modulus = [&](double p) {
                const auto orbit = orbitOf(program, &p, 5);
                double square = 0;
                for (double part : orbit.back()) square += part * part;
                return std::sqrt(square);
            };
            const double h = 1e-6, size = modulus(exponent);
            const double slope = std::abs(modulus(exponent + h) - modulus(exponent - h)) / (2 * h);
            // Differences of step 1e-6: rounding 1e-10, curvature 1e-12 times a moderate factor.
            EXPECT_NEAR(valueAt(program, FieldName::distance, exponent) /
                            (0.5 * size * std::log(size) / slope),
                        1, 1e-6)
                << name << " " << exponent;
        }
}

// A eq 12 read literally tests only the last iterate: 0, -1, 0, … with R = ½ is out at n = 1 and
// back at n = 2.
TEST(EscapeTest, OnlyTheLastIterate) {
    OrbitProgram program = julia(-1, 0, 2, 0.5);
    EXPECT_EQ(valueAt(program, FieldName::membership), 0);
    EXPECT_EQ(valueAt(program, FieldName::escapeStep), 1);
    program.onlyLastTested = true;
    EXPECT_EQ(valueAt(program, FieldName::membership), 1);
    EXPECT_EQ(valueAt(program, FieldName::escapeStep), 2);
    program.iterations = 3;
    EXPECT_EQ(valueAt(program, FieldName::membership), 0);
    EXPECT_EQ(valueAt(program, FieldName::escapeStep), 3);
    EXPECT_EQ(valueAt(program, FieldName::squaredNorm), 1);
    // What has overflowed stays outside.
    OrbitProgram large = julia(1, 0, 500, 2);
    large.onlyLastTested = true;
    EXPECT_EQ(valueAt(large, FieldName::membership, 3), 0);
}

// |z|² = R² is inside: the test is !(|z|² <= R²).
TEST(EscapeTest, TheCircleItselfIsInside) {
    EXPECT_EQ(valueAt(julia(0, 0, 0, 2), FieldName::membership, 2, 0), 1);
    EXPECT_EQ(valueAt(julia(0, 0, 0, 2), FieldName::membership, std::nextafter(2, 3), 0), 0);
    EXPECT_EQ(valueAt(julia(0, 0, 5, 2), FieldName::escapeStep, 2, 0), 1);
    EXPECT_EQ(valueAt(julia(0, 0, 5, 2), FieldName::escapeStep, std::nan(""), 0), 0);
    EXPECT_EQ(valueAt(julia(0, 0, 5, 2), FieldName::escapeStep, HUGE_VAL, 0), 0);
}

// The smoothed step is continuous across the bands of the step, and equals Böttcher's logarithm:
// for c = 0, ln|z_n| = 2ⁿ ln r, so ν = n + 1 - log₂(2ⁿ ln r / ln R) = 1 - log₂(ln r / ln R).
TEST(SmoothEscape, IsBoettchersLogarithm) {
    const OrbitProgram disc = julia(0, 0, 100, 50);
    for (double r = 1.01; r < 40; r *= 1.07)
        EXPECT_NEAR(valueAt(disc, FieldName::smoothEscape, 0, r),
                    1 - std::log2(std::log(r) / std::log(50.0)), 1e-12)
            << r;
}

}  // namespace
}  // namespace versorium
