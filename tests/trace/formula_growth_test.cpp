// SPDX-License-Identifier: MIT
#include "trace/formula_growth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace versorium {
namespace {

constexpr double kUnknown = -1;

double growth(const std::string& text, const std::vector<bool>& varies = {}) {
    const Expected<Formula> formula = parseFormula(text);
    EXPECT_TRUE(formula.ok()) << text;
    if (!formula) return kUnknown;
    std::vector<double> values;
    for (const FormulaParameter& parameter : formula->parameters)
        for (int k = 0; k < widthOf(parameter.kind); ++k)
            values.push_back(parameter.value[static_cast<std::size_t>(k)]);
    values.push_back(0);
    return growthOf(*formula, values.data(), varies).value_or(kUnknown);
}

TEST(FormulaGrowth, AddsInProductsAndTakesTheLargestOfSums) {
    EXPECT_EQ(growth("z^2 + c"), 2);
    EXPECT_EQ(growth("z^3 - a*z + c"), 3);
    EXPECT_EQ(growth("z^4/z"), 3);
    EXPECT_EQ(growth("(z^5 + 1)/(z^2 - c)"), 3);
    EXPECT_EQ(growth("z*norm(z)"), 3);
    EXPECT_EQ(growth("z*abs(z) + c"), 2);
    EXPECT_EQ(growth("conj(z)^2 + c"), 2);
    EXPECT_EQ(growth("conj(z)^3*z - c"), 4);
    EXPECT_EQ(growth("(abs(z.re) + i*abs(z.im))^2 + c"), 2);
    EXPECT_EQ(growth("z^2.5 + c"), 2.5);
    EXPECT_EQ(growth("sqrt(z)*z^2"), 2.5);
    EXPECT_EQ(growth("1/z^2 + c"), 0);
    EXPECT_EQ(growth("q^3 + c"), 3);
    EXPECT_EQ(growth("x' = y*x^2, y' = x"), 3);
    EXPECT_EQ(growth("r*x*(1 - x)"), 2);
    EXPECT_EQ(growth("z^2 + sin(1/z)"), 2);
    EXPECT_EQ(growth("z^2*exp(1/z)"), 2);
}

TEST(FormulaGrowth, FollowsParametersByTheirValues) {
    EXPECT_EQ(growth("z^n + c; n = 5"), 5);
    EXPECT_EQ(growth("z^n + c; n = 2.5"), 2.5);
    EXPECT_EQ(growth("z^(n + 1) + c; n: real = 3"), 4);
    EXPECT_EQ(growth("z^n*z^m; n = 2; m = 3"), 5);
    // A leading coefficient of 0 leads nothing.
    EXPECT_EQ(growth("a*z^3 + z^2; a = 0"), 2);
    EXPECT_EQ(growth("a*z^3 + z^2; a = 0.1"), 3);
    // What varies over the picture is not 0, and no known exponent.
    EXPECT_EQ(growth("z^n + c; n = 5", {true}), kUnknown);
    EXPECT_EQ(growth("a*z^3 + z^2; a = 0", {true, false}), 3);
}

TEST(FormulaGrowth, IsNotGuessedWhereItIsNoPower) {
    for (const char* text :
         {"c*sin(z)", "exp(z) + c", "z^2 + cosh(z)", "z^z", "z^3 - z^3 + z^2", "tan(z)"})
        EXPECT_EQ(growth(text), kUnknown) << text;
}

TEST(FormulaGrowth, KnowsTheValueAtInfinity) {
    const auto value = [](const char* text) {
        const Formula formula = *parseFormula(text);
        std::vector<double> values{0.3, -0.4, 0, 0, 0};
        return valueAtInfinity(formula, values.data());
    };
    EXPECT_EQ(value("1/z^2 + c")->re, 0.3);
    EXPECT_EQ(value("1/z^2 + c")->im, -0.4);
    EXPECT_EQ(value("(2*z^2 + c)/(z^2 - 1)")->re, 2);
    EXPECT_EQ(value("1/z")->re, 0);
    EXPECT_EQ(value("exp(1/z) + c")->re, 1.3);
    for (const char* text : {"z^2 + c", "exp(z)", "z + 1/z"}) EXPECT_FALSE(value(text)) << text;
}

}  // namespace
}  // namespace versorium
