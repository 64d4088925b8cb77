// SPDX-License-Identifier: MIT
// The four answers of A8, for pictures about which they are known.
#include "dynamics/catalogue_badge.h"

#include <gtest/gtest.h>

#include "dynamics/planar_system.h"
#include "fields/programs.h"

namespace versorium {
namespace {

CatalogueBadge badgeOf(OrbitProgram program, double half = 1.5) {
    const double centre[3] = {-0.1, 0.2, 0};
    return catalogueBadge(program, centre, half, half);
}
OrbitProgram planarOf(const ComplexPolynomial& polynomial,
                      const std::vector<std::vector<std::string>>& axes) {
    const PlanarNumbers numbers = planarNumbersOf(polynomial);
    std::vector<std::pair<std::string, double>> values;
    const MapKernels& map = *findMap("planar");
    for (int k = 0; k < map.parameters; ++k)
        values.emplace_back(parameterComponent(map.info, k), numbers[static_cast<std::size_t>(k)]);
    return programOf("planar", values, axes, 100, 4);
}
const std::vector<std::vector<std::string>> kConstants = {{"g.d"}, {"h.d"}};
using C = std::complex<double>;

TEST(CatalogueBadge, OnlyCriticalOrbit) {
    const auto mandelbrot = badgeOf(programOf("quadratic", {}, {{"c.re"}, {"c.im"}}, 100, 2));
    EXPECT_EQ(mandelbrot.answer, CatalogueAnswer::onlyCriticalOrbit);
    EXPECT_EQ(mandelbrot.criticalPoints, 1);
    EXPECT_EQ(mandelbrot.determinant, 0);
    // The same family, and z³ + c and z⁴ + c, whose critical point is a multiple one.
    EXPECT_EQ(badgeOf(programOf("planar", {}, kConstants, 100, 2)).answer,
              CatalogueAnswer::onlyCriticalOrbit);
    for (std::size_t degree : {2u, 3u, 4u}) {
        ComplexPolynomial polynomial;
        polynomial.k[degree] = C(0.8, 0.6);
        const auto badge = badgeOf(planarOf(polynomial, kConstants));
        EXPECT_EQ(badge.answer, CatalogueAnswer::onlyCriticalOrbit) << degree << badge.sentence;
        EXPECT_TRUE(badge.analytic);
    }
    EXPECT_EQ(badgeOf(programOf("power", {{"power", 5}}, {{"c.re"}, {"c.im"}}, 100, 2)).answer,
              CatalogueAnswer::onlyCriticalOrbit);
    OrbitProgram logistic = programOf("logistic", {}, {{"r"}}, 100, 16);
    logistic.slice.origin[0] = 0.5;
    EXPECT_EQ(badgeOf(logistic).answer, CatalogueAnswer::onlyCriticalOrbit);
    // The tricorn: conj(z)² + c is no analytic map, but its second iterate is.
    const auto tricorn = badgeOf(programOf("planar", {{"h.c1", -2}}, kConstants, 100, 2));
    EXPECT_EQ(tricorn.answer, CatalogueAnswer::onlyCriticalOrbit);
    EXPECT_FALSE(tricorn.analytic);
    EXPECT_TRUE(tricorn.conjugate);
    EXPECT_FALSE(mandelbrot.conjugate);
    // z³ + a z² fixes its critical point 0, and -2a/3 is the only free one; it moves with a.
    ComplexPolynomial fixed;
    fixed.k[3] = 1;
    OrbitProgram family = planarOf(fixed, {{"g.a2"}, {"h.a2"}});
    // a (x + iy)²: both axes move three coefficients.
    const MapKernels& map = *family.map;
    family.slice.axes[0][numberAt(map, "g.b2")] = -1;
    family.slice.axes[0][numberAt(map, "h.c1")] = 2;
    family.slice.axes[1][numberAt(map, "h.b2")] = -1;
    family.slice.axes[1][numberAt(map, "g.c1")] = -2;
    family.critical = 0;
    const auto moving = badgeOf(family, 0.5);
    EXPECT_EQ(moving.answer, CatalogueAnswer::onlyCriticalOrbit) << moving.sentence;
    EXPECT_EQ(moving.criticalPoints, 2);
    // From the fixed one nothing is seen.
    family.critical.reset();
    EXPECT_EQ(badgeOf(family, 0.5).label, "a critical point that is fixed");
}

TEST(CatalogueBadge, OneOfSeveral) {
    OrbitProgram cubic = programOf("cubic", {}, {{"a.re"}, {"a.im"}}, 100, 4);
    cubic.critical = 0;
    const auto badge = badgeOf(cubic);
    EXPECT_EQ(badge.answer, CatalogueAnswer::oneOfSeveral);
    EXPECT_EQ(badge.criticalPoints, 2);
    EXPECT_TRUE(badge.startMoves);
    EXPECT_EQ(badge.label, "one of 2 critical orbits");
    // Quartics have three: z⁴ - z² + c from 0.
    ComplexPolynomial quartic;
    quartic.k[4] = 1, quartic.k[2] = -1;
    const auto three = badgeOf(planarOf(quartic, kConstants));
    EXPECT_EQ(three.answer, CatalogueAnswer::oneOfSeveral);
    EXPECT_EQ(three.criticalPoints, 3);
    // A planar map that is not complex: from a point of the curve det J = 0.
    const auto curve = badgeOf(programOf("planar", {{"g.b2", -0.9}}, kConstants, 100, 4));
    EXPECT_EQ(curve.answer, CatalogueAnswer::oneOfSeveral);
    EXPECT_FALSE(curve.analytic);
    EXPECT_EQ(curve.criticalPoints, -1);
    EXPECT_EQ(badgeOf(programOf("burning-ship", {}, {{"c.re"}, {"c.im"}}, 100, 2)).answer,
              CatalogueAnswer::oneOfSeveral);
}

TEST(CatalogueBadge, NotCritical) {
    OrbitProgram off = programOf("quadratic", {}, {{"c.re"}, {"c.im"}}, 100, 2);
    off.slice.origin[0] = 0.1;
    const auto badge = badgeOf(off);
    EXPECT_EQ(badge.answer, CatalogueAnswer::notCritical);
    EXPECT_NEAR(badge.determinant, 0.04, 1e-15);
    // (0, 0) is critical for z³ + a z + b only where a = 0.
    EXPECT_EQ(badgeOf(programOf("cubic", {}, {{"a.re"}, {"a.im"}}, 100, 4)).answer,
              CatalogueAnswer::notCritical);
    // The quadratic family seen along g.a1 and h.b1 with a start that does not follow.
    EXPECT_EQ(badgeOf(programOf("planar", {}, {{"g.a1"}, {"h.b1"}}, 100, 4)).answer,
              CatalogueAnswer::notCritical);
    OrbitProgram third = programOf("quadratic", {}, {{"c.re"}, {"c.im"}}, 100, 2);
    third.critical = 2;
    EXPECT_EQ(badgeOf(third).label, "no such critical point");
}

TEST(CatalogueBadge, NoCriticalPoint) {
    const std::vector<std::pair<std::string, double>> henon = {
        {"g.a2", -1}, {"g.b1", 0.3}, {"g.b2", 0}, {"h.a1", 1}, {"h.c1", 0}, {"h.d", 0}};
    const auto badge = badgeOf(programOf("planar", henon, {{"g.d"}, {"g.a2"}}, 100, 100));
    EXPECT_EQ(badge.answer, CatalogueAnswer::noCriticalPoint);
    EXPECT_NEAR(badge.determinant, -0.3, 1e-15);
    EXPECT_NE(badge.sentence.find("Hénon"), std::string::npos);
    ComplexPolynomial linear;
    linear.k[1] = C(0.5, 0.5);
    EXPECT_EQ(badgeOf(planarOf(linear, kConstants)).answer, CatalogueAnswer::noCriticalPoint);
}

TEST(CatalogueBadge, NotAsked) {
    EXPECT_EQ(badgeOf(programOf("quadratic", {}, {{"z.re"}, {"z.im"}}, 100, 2)).answer,
              CatalogueAnswer::notAsked);
    EXPECT_EQ(badgeOf(programOf("quadratic", {}, {{"z.re"}, {"c.re"}}, 100, 2)).answer,
              CatalogueAnswer::notAsked);
    const auto space = badgeOf(programOf("mandelbulb", {}, {{"p.x"}, {"p.y"}}, 10, 2));
    EXPECT_EQ(space.answer, CatalogueAnswer::notAsked);
    EXPECT_FALSE(space.sentence.empty());
}

}  // namespace
}  // namespace versorium
