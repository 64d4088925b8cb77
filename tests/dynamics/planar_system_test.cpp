// SPDX-License-Identifier: MIT
// The algebra of planar polynomials against the maps themselves.
#include "dynamics/planar_system.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "dynamics/system.h"
#include "fields/programs.h"
#include "maps/planar.h"

namespace versorium {
namespace {

using C = std::complex<double>;

PlanarNumbers numbersOf(std::vector<std::pair<std::string, double>> values) {
    const OrbitProgram program = programOf("planar", values, {}, 1, 1);
    PlanarNumbers numbers{};
    std::copy(program.slice.origin.begin() + 2, program.slice.origin.end(), numbers.begin());
    return numbers;
}
System systemOf(const PlanarNumbers& numbers) {
    OrbitProgram program = programOf("planar", {}, {}, 1, 1);
    std::copy(numbers.begin(), numbers.end(), program.slice.origin.begin() + 2);
    return System(program);
}

TEST(PlanarSystem, IsTheComplexPolynomial) {
    Random random(5);
    for (int round = 0; round < 50; ++round) {
        ComplexPolynomial polynomial;
        for (C& k : polynomial.k) k = {random.uniform(-2, 2), random.uniform(-2, 2)};
        const PlanarNumbers numbers = planarNumbersOf(polynomial);
        const auto back = complexPolynomialOf(numbers);
        ASSERT_TRUE(back.has_value());
        EXPECT_EQ(*back, polynomial);
        const System system = systemOf(numbers);
        const C z(random.uniform(-2, 2), random.uniform(-2, 2));
        PlanePoint image{z.real(), z.imag()};
        system.step(image.data());
        C value = 0;
        for (std::size_t n = 5; n-- > 0;) value = value * z + polynomial.k[n];
        // Terms of size up to 2 · 2.83⁴, ten of them, rounded once or twice.
        EXPECT_LT(std::abs(value - C(image[0], image[1])), 1e-12);
    }
}

TEST(PlanarSystem, IsNotComplexWhenOneCoefficientIsOff) {
    ComplexPolynomial polynomial;
    polynomial.k = {C(0.3, 0.1), C(-0.5, 0.2), C(0, 1), C(1, 0), C(0, 0)};
    const PlanarNumbers good = planarNumbersOf(polynomial);
    int same = 0;
    for (std::size_t k = 0; k < kPlanarNumbers; ++k) {
        PlanarNumbers numbers = good;
        numbers[k] += 1e-6;
        // Only the constants are free: any other single change breaks the equations.
        same += complexPolynomialOf(numbers).has_value();
    }
    EXPECT_EQ(same, 2);
    EXPECT_FALSE(complexPolynomialOf(numbersOf({{"g.b1", 0.3}, {"h.a1", 0.3}})).has_value());
    EXPECT_TRUE(complexPolynomialOf(numbersOf({})).has_value());
}

TEST(PlanarSystem, ReadsLikeItsFormula) {
    const PlanarNumbers numbers = numbersOf({{"g.d", -0.75}, {"h.d", 0}});
    EXPECT_EQ(planarText(numbers, 0), "x² − y² − 0.75");
    EXPECT_EQ(planarText(numbers, 1), "2xy");
    EXPECT_EQ(planarText(PlanarNumbers{}, 0), "0");
    PlanarNumbers other{};
    other[planar::c4] = -1, other[planar::x3y] = 0.5, other[planar::b1] = 1;
    EXPECT_EQ(planarText(other, 0), "0.5x³y − x²y² + y");
    std::vector<std::string> names(kPlanarNumbers);
    names[planar::d] = "d";
    names[planar::a1] = "a₁";
    EXPECT_EQ(planarText(numbers, 0, names), "x² − y² + a₁ x + d");
    EXPECT_EQ(complexText({{C(-0.5, 0), C(0.3, -0.1), C(0, 0), C(1, 0), C(0, 0)}}),
              "z³ + (0.3 − 0.1i)z − 0.5");
    EXPECT_EQ(complexText({{C(0, -1), C(0, 0), C(-1, 2), C(0, 0), C(0, 2)}}),
              "2iz⁴ − (1 − 2i)z² − i");
    EXPECT_EQ(complexText({}), "0");
}

// det J by the product rule of polynomials, and by dual numbers.
TEST(PlanarSystem, DeterminantAgreesWithDuals) {
    Random random(11);
    for (int round = 0; round < 30; ++round) {
        PlanarNumbers numbers;
        for (double& number : numbers) number = random.uniform(-2, 2);
        const PlanarDeterminant determinant = determinantOf(numbers);
        const System system = systemOf(numbers);
        for (int i = 0; i < 20; ++i) {
            const PlanePoint at{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)};
            const double duals = system.determinant(at.data());
            // Products of sums of about twenty terms of size up to 100.
            EXPECT_NEAR(valueOf(determinant, at[0], at[1]), duals, 1e-10 * (1 + std::abs(duals)));
        }
    }
    // Hénon: det J = -b everywhere.
    const PlanarDeterminant henon = determinantOf(
        numbersOf({{"g.a2", -1.4}, {"g.b1", 1}, {"g.b2", 0}, {"h.a1", 0.3}, {"h.c1", 0}}));
    for (std::size_t i = 0; i < 7; ++i)
        for (std::size_t j = 0; j < 7; ++j) EXPECT_EQ(henon[i][j], i + j == 0 ? -0.3 : 0.0);
}

}  // namespace
}  // namespace versorium
