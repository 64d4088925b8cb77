// SPDX-License-Identifier: MIT
#include "fields/dynamics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/programs.h"

namespace versorium {
namespace {

OrbitProgram julia(double re, double im) {
    return programOf("quadratic", {{"c.re", re}, {"c.im", im}}, {{"z.re"}, {"z.im"}}, 5000, 2);
}

// The fixed point of z^2 + c in the cardioid is λ/2 with multiplier λ; the cycle of period 2 has
// the multiplier 4 (c + 1).
TEST(Multiplier, OfTheQuadraticFamilyInClosedForm) {
    const std::complex<double> lambda(0.3, -0.5);
    const std::complex<double> c = lambda / 2.0 - lambda * lambda / 4.0;
    const double at[3] = {0.01, 0.02, 0};
    const std::optional<Cycle> one = cycleOf(julia(c.real(), c.imag()), at);
    ASSERT_TRUE(one && one->multiplier);
    EXPECT_EQ(one->period, 1);
    // The orbit has come to the fixed point up to rounding.
    EXPECT_LT(std::abs(*one->multiplier - lambda), 1e-12);
    EXPECT_NEAR(one->modulus, std::abs(lambda), 1e-12);
    EXPECT_LT(std::abs(std::complex<double>(one->point[0], one->point[1]) - lambda / 2.0), 1e-12);
    const std::optional<Cycle> two = cycleOf(julia(-1.1, 0.05), at);
    ASSERT_TRUE(two && two->multiplier);
    EXPECT_EQ(two->period, 2);
    EXPECT_LT(std::abs(*two->multiplier - std::complex<double>(-0.4, 0.2)), 1e-12);
}

TEST(Multiplier, OfTheLogisticFamily) {
    // The fixed point 1 - 1/r has multiplier 2 - r; the cycle of period 2 has 4 + 2r - r^2.
    const double at[3] = {0.3, 0, 0};
    const auto logistic = [&](double r) {
        return cycleOf(programOf("logistic", {{"r", r}}, {{"x"}}, 5000, 16), at);
    };
    ASSERT_TRUE(logistic(2.7));
    EXPECT_NEAR(logistic(2.7)->multiplier->real(), -0.7, 1e-12);
    ASSERT_TRUE(logistic(3.2));
    EXPECT_NEAR(logistic(3.2)->multiplier->real(), 4 + 6.4 - 10.24, 1e-12);
    EXPECT_NEAR(logistic(3.2)->modulus, 0.16, 1e-12);
}

// The product of both eigenvalues of Hénon's map (0.1 - 0.2 x^2 + y, b x) is the determinant -b of
// its Jacobian; where they are complex both have the modulus sqrt|b|. No complex number stands for
// them.
TEST(Multiplier, OfAMapOfThePlaneIsASpectralRadius) {
    const double at[3] = {0.1, 0.1, 0};
    const std::optional<Cycle> cycle = cycleOf(programOf("planar",
                                                         {{"g.a2", -0.2},
                                                          {"g.b1", 1},
                                                          {"g.b2", 0},
                                                          {"g.d", 0.1},
                                                          {"h.a1", -0.3},
                                                          {"h.c1", 0},
                                                          {"h.d", 0}},
                                                         {{"p.x"}, {"p.y"}}, 5000, 100),
                                               at);
    ASSERT_TRUE(cycle);
    EXPECT_EQ(cycle->period, 1);
    EXPECT_FALSE(cycle->multiplier);
    // 40 squarings of the powers of the Jacobian leave the last digits to rounding.
    EXPECT_NEAR(cycle->modulus, std::sqrt(0.3), 1e-9);
}

TEST(Multiplier, NoneWhereTheOrbitEscapes) {
    const double at[3] = {0, 0, 0};
    EXPECT_FALSE(cycleOf(julia(1, 0), at));
}

TEST(Images, AreOneStep) {
    const double u[3] = {0.5, -1, 3}, v[3] = {0, 2, 1};
    const double* at[2] = {u, v};
    const auto images = imagesOf(julia(-0.25, 0.5), 3, at);
    ASSERT_EQ(images.size(), 2u);
    for (std::size_t k = 0; k < 3; ++k) {
        // Small dyadic numbers: nothing is rounded.
        EXPECT_EQ(images[0][k], u[k] * u[k] - v[k] * v[k] - 0.25);
        EXPECT_EQ(images[1][k], 2 * u[k] * v[k] + 0.5);
    }
}

}  // namespace
}  // namespace versorium
