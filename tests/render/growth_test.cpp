// SPDX-License-Identifier: MIT
// Smooth escape times, whatever a map's growth, and critical orbits through poles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/cpu/cpu_renderer.h"
#include "scene/properties.h"

namespace versorium {
namespace {

std::vector<double> measured(const Scene& scene, const std::vector<std::vector<double>>& points,
                             FieldName field) {
    Job job(1);
    CpuRenderer renderer;
    std::vector<std::vector<double>> rows;
    const std::vector<FieldName> fields{field};
    EXPECT_TRUE(renderer.measureAt(scene, points, fields, {}, job, rows).ok());
    std::vector<double> values;
    for (const auto& row : rows) values.push_back(row[0]);
    return values;
}

Scene sceneOfText(const std::string& text) {
    Expected<Scene> scene = sceneOfMap(text);
    EXPECT_TRUE(scene.ok()) << text;
    return std::move(*scene);
}

// Along a line outside, escape times have no flat pieces and no jumps: neighbours that are as near
// as here differ by little, and hardly any two are equal.
void expectSmooth(const Scene& scene, double from, double to, double height) {
    constexpr int kPoints = 4000;
    std::vector<std::vector<double>> points;
    for (int i = 0; i < kPoints; ++i) points.push_back({from + (to - from) * i / kPoints, height});
    const std::vector<double> values = measured(scene, points, FieldName::smoothEscape);
    int equal = 0, compared = 0, outside = 0;
    double largest = 0;
    for (int i = 1; i < kPoints; ++i) {
        const double a = values[std::size_t(i - 1)], b = values[std::size_t(i)];
        if (a > 8 || b > 8 || a < 1.001 || b < 1.001) continue;
        ++outside;
        equal += a == b;
        ++compared;
        largest = std::max(largest, std::abs(a - b));
    }
    EXPECT_GT(outside, kPoints / 10) << scene.formula->formula().text;
    EXPECT_LT(equal, compared / 50 + 1) << scene.formula->formula().text;
    // A step of 1/2000 of a picture's width: far from the set a jump would be about 1.
    EXPECT_LT(largest, 0.3) << scene.formula->formula().text;
}

TEST(SmoothEscape, HasNoFlatPiecesWhateverTheGrowth) {
    for (const char* text :
         {"z^2 + 0.1", "z^3 + 0.1", "z^n + 0.1; n = 5", "z^2.5 + 0.1", "z^4/z + 0.1",
          "z*norm(z) + 0.1", "conj(z)^3 + 0.1", "z^5/(z^2 + 0.1)"})
        expectSmooth(sceneOfText(text), 1.3, 3, 0.05);
    for (const char* text : {"exp(z)", "z^2*exp(z/2)", "0.9*sinh(z)"})
        expectSmooth(sceneOfText(text), 1.5, 4, 0.01);
}

TEST(SmoothEscape, MeasuredGrowthAgreesWithAKnownOne) {
    // z² + e^(z/10⁶) grows like z² as far as orbits are followed, but its form does not say so.
    const Scene known = sceneOfText("z^2 + 0.1");
    Scene hidden = sceneOfText("z^2 + 0.1*exp(z/100000000)");
    hidden.escapeRadius = 100;
    std::vector<std::vector<double>> points;
    for (int i = 0; i < 50; ++i) points.push_back({1.2 + 0.02 * i, 0.1});
    const auto a = measured(known, points, FieldName::smoothEscape);
    const auto b = measured(hidden, points, FieldName::smoothEscape);
    // ln(1 + |z|²) in the place of ln |z|² is off by 1e-4 at R = 100, and less after it.
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 2e-2) << points[i][0];
}

// |f| = e^(alpha (phi - beta)): no power of |z| at all. Its kernel is another one.
TEST(SmoothEscape, OfAShapeModulusIsSmoothToo) {
    Scene scene = sceneOf(*findMap("shape-modulus-quadratic"));
    ASSERT_TRUE(setProperty(scene, *propertyNamed(scene, "shape"), "disc(1.2)").ok());
    scene.escapeRadius = 20;
    scene.iterations = 12;
    std::vector<std::vector<double>> points;
    for (int i = 0; i < 600; ++i) points.push_back({1.4 + 0.002 * i, 0.1});
    for (const std::vector<FieldName>& fields :
         {std::vector<FieldName>{FieldName::smoothEscape},
          std::vector<FieldName>{FieldName::smoothEscape, FieldName::logModulus}}) {
        Job job(1);
        CpuRenderer renderer;
        std::vector<std::vector<double>> rows;
        ASSERT_TRUE(renderer.measureAlong(scene, points, fields, {}, job, rows).ok());
        int equal = 0;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            equal += rows[i][0] == rows[i - 1][0];
            EXPECT_LT(std::abs(rows[i][0] - rows[i - 1][0]), 0.2) << points[i][0];
        }
        EXPECT_LT(equal, 6);
    }
}

TEST(SmoothEscape, FollowsExponentsOnAnAxis) {
    Scene scene = sceneOfText("z^n + 0.1; n = 2");
    scene.slice.axes[0] = {{{"n", 1.0}}};
    scene.start = {1.7, 0.3};
    std::vector<std::vector<double>> points;
    for (int i = 0; i < 400; ++i) points.push_back({2 + 0.01 * i, 0.3});
    const auto values = measured(scene, points, FieldName::smoothEscape);
    for (std::size_t i = 1; i < values.size(); ++i)
        EXPECT_LT(std::abs(values[i] - values[i - 1]), 0.2) << points[i][0];
}

TEST(CriticalStart, OfAMapWithAPoleGoesOnFromTheValueAtInfinity) {
    Scene scene = sceneOfText("1/z^2 + c");
    scene.slice.axes = {{{{"c.re", 1.0}}}, {{{"c.im", 1.0}}}};
    ASSERT_TRUE(setProperty(scene, *propertyNamed(scene, "start"), Json{{"critical", 0}}).ok());
    scene.iterations = 200;
    // 0 -> infinity -> c -> 1/c^2 + c: as if c were the start.
    Scene plain = scene;
    plain.criticalStart.reset();
    plain.slice.axes = {{{{"c.re", 1.0}, {"z.re", 1.0}}}, {{{"c.im", 1.0}, {"z.im", 1.0}}}};
    std::vector<std::vector<double>> points;
    for (int i = 0; i < 60; ++i) points.push_back({-1.5 + 0.05 * i, 0.37 * std::cos(double(i))});
    const auto own = measured(scene, points, FieldName::trap);
    const auto same = measured(plain, points, FieldName::trap);
    EXPECT_EQ(own, same);
    EXPECT_GT(*std::max_element(own.begin(), own.end()),
              *std::min_element(own.begin(), own.end()) + 0.1);
}

TEST(CriticalStart, IsRefusedWhereThereIsNone) {
    Scene exponential = sceneOfText("c*exp(z)");
    const Status status =
        setProperty(exponential, *propertyNamed(exponential, "start"), Json{{"critical", 0}});
    EXPECT_FALSE(status.ok());
    EXPECT_NE(status.message().find("has no critical points"), std::string::npos);
    // A quadratic polynomial has one.
    Scene quadratic = sceneOfText("z^2 + c");
    quadratic.slice.axes = {{{{"c.re", 1.0}}}, {{{"c.im", 1.0}}}};
    ASSERT_TRUE(
        setProperty(quadratic, *propertyNamed(quadratic, "start"), Json{{"critical", 1}}).ok());
    Job job(1);
    CpuRenderer renderer;
    EXPECT_FALSE(renderer.binder().bind(quadratic, job).ok());
}

}  // namespace
}  // namespace versorium
