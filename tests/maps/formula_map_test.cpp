// SPDX-License-Identifier: MIT
// Typed formulas beside the built-in maps that they repeat: one step, orbits, critical points.
#include "maps/formula_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/dynamics.h"
#include "fields/programs.h"
#include "maps/critical.h"
#include "maps/samples.h"

namespace versorium {
namespace {

// A program over a typed map, as programOf makes for the catalogue.
OrbitProgram typedProgram(const std::string& text,
                          const std::vector<std::pair<std::string, double>>& values, int iterations,
                          double radius) {
    OrbitProgram program;
    const auto made = FormulaMap::make(text);
    EXPECT_TRUE(made.ok()) << (made ? "" : made.status().message());
    program.keeps = *made;
    const MapKernels& map = (*made)->kernels();
    program.map = &map;
    program.slice.origin.assign(static_cast<std::size_t>(map.dimension), 0.0);
    for (const ParameterInfo& parameter : map.info.parameters)
        for (int k = 0; k < widthOf(parameter.kind); ++k)
            program.slice.origin.push_back(parameter.value[static_cast<std::size_t>(k)]);
    for (const auto& [name, value] : values) program.slice.origin[numberAt(map, name)] = value;
    program.iterations = iterations;
    program.escapeRadius = radius;
    program.degree = map.info.degree;
    return program;
}

void addAxes(OrbitProgram& program, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        program.slice.axes.emplace_back(program.slice.origin.size(), 0.0);
        program.slice.axes.back()[numberAt(*program.map, name)] = 1;
        program.slice.origin[numberAt(*program.map, name)] = 0;
    }
}

std::vector<std::vector<double>> fieldsOn(const OrbitProgram& program, double reach,
                                          std::span<const FieldName> fields,
                                          const EvaluateOptions& options = {}) {
    constexpr int kSide = 40;
    std::vector<double> u, v;
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column) {
            u.push_back(reach * (2.0 * column / kSide - 1));
            v.push_back(reach * (2.0 * row / kSide - 1));
        }
    const double* coordinates[] = {u.data(), v.data()};
    return evaluateFields(program, static_cast<int>(u.size()), coordinates, fields, options);
}

constexpr FieldName kAll[] = {
    FieldName::escapeStep,     FieldName::smoothEscape, FieldName::squaredNorm,
    FieldName::trap,           FieldName::lyapunov,     FieldName::distance,
    FieldName::attractionStep, FieldName::versor,       FieldName::period};

void expectSameFields(const OrbitProgram& typed, const OrbitProgram& builtIn, double reach) {
    for (const bool shortcuts : {true, false}) {
        EvaluateOptions options;
        options.shortcuts = shortcuts;
        const auto a = fieldsOn(typed, reach, kAll, options);
        const auto b = fieldsOn(builtIn, reach, kAll, options);
        for (std::size_t f = 0; f < a.size(); ++f)
            for (std::size_t i = 0; i < a[f].size(); ++i)
                EXPECT_TRUE(a[f][i] == b[f][i] || (std::isnan(a[f][i]) && std::isnan(b[f][i])))
                    << infoOf(kAll[f]).name << " at " << i << ": " << a[f][i] << " and " << b[f][i];
    }
}

// The same operations on the same numbers: no tolerance is owed, in no field.
TEST(FormulaMap, GivesTheBitsOfTheBuiltInMapItRepeats) {
    OrbitProgram typed = typedProgram("z^2 + c", {}, 200, 2);
    OrbitProgram builtIn = programOf("quadratic", {}, {{"z.re"}, {"z.im"}}, 200, 2);
    addAxes(typed, {"z.re", "z.im"});
    expectSameFields(typed, builtIn, 1.5);

    typed = typedProgram("z^2 + c", {}, 300, 2);
    addAxes(typed, {"c.re", "c.im"});
    builtIn = programOf("quadratic", {}, {{"c.re"}, {"c.im"}}, 300, 2);
    expectSameFields(typed, builtIn, 2);

    typed = typedProgram("q^2 + c", {{"q.y", 0.1}}, 60, 3);
    addAxes(typed, {"q.w", "q.x"});
    builtIn = programOf("quaternion-quadratic", {{"q.y", 0.1}}, {{"q.w"}, {"q.x"}}, 60, 3);
    expectSameFields(typed, builtIn, 1.5);
}

// Hénon's map typed and as a planar system: the sums are formed in another order, so one step is
// the same but for its last bits, and so are short orbits.
TEST(FormulaMap, TypedHenonIsThePlanarOne) {
    const OrbitProgram typed =
        typedProgram("x' = 1 - a*x^2 + y, y' = b*x; a = 1.4; b = 0.3", {}, 100, 100);
    std::vector<std::pair<std::string, double>> values;
    for (const ParameterInfo& parameter : findMap("planar")->info.parameters)
        values.emplace_back(std::string(parameter.name), 0.0);
    for (const auto& [name, value] : std::vector<std::pair<std::string, double>>{
             {"g.d", 1}, {"g.a2", -1.4}, {"g.b1", 1}, {"h.a1", 0.3}})
        values.emplace_back(name, value);
    const OrbitProgram planar = programOf("planar", values, {}, 100, 100);
    const double none[3] = {};
    const auto a = orbitOf(typed, none, 20), b = orbitOf(planar, none, 20);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t n = 0; n < a.size(); ++n)
        for (std::size_t k = 0; k < 2; ++k)
            // The largest multiplier is below 2 a |x| < 4: errors grow by no more than that a step.
            EXPECT_NEAR(a[n][k], b[n][k], 1e-16 * std::pow(4, static_cast<double>(n)) + 1e-16);
    const auto fixed = [&](double x) { return 1 - 1.4 * x * x + 0.3 * x - x; };
    EXPECT_NEAR(fixed(0.631354), 0, 1e-5);
}

TEST(FormulaMap, FindsTheCyclesAndMultipliers) {
    // z² has the fixed point 0; near c = -1 the cycle 0, -1 with multiplier 4 · 0 · (-1) = 0.
    OrbitProgram basilica = typedProgram("z^2 - 1", {{"z.re", 0.1}}, 2000, 2);
    const auto cycle = cycleOf(basilica, nullptr);
    ASSERT_TRUE(cycle.has_value());
    EXPECT_EQ(cycle->period, 2);
    EXPECT_NEAR(cycle->modulus, 0, 1e-9);
    // The rabbit: the multiplier is Π f'(z_k), by duals and by the derivative written out.
    OrbitProgram rabbit = typedProgram("z^2 + c", {{"c.re", -0.12}, {"c.im", 0.74}}, 5000, 2);
    const auto three = cycleOf(rabbit, nullptr);
    ASSERT_TRUE(three && three->multiplier);
    EXPECT_EQ(three->period, 3);
    std::complex<double> z(three->point[0], three->point[1]), product = 1;
    for (int k = 0; k < 3; ++k) product *= 2.0 * z, z = z * z + std::complex<double>(-0.12, 0.74);
    EXPECT_NEAR(std::abs(product - *three->multiplier), 0, 1e-12);
}

std::vector<std::array<double, 2>> criticalOf(const std::string& text,
                                              std::vector<double> parameters) {
    const MapKernels& map = typedMap(text);
    parameters.resize(static_cast<std::size_t>(map.parameters) + 1);
    std::vector<std::array<double, 2>> all;
    for (int k = 0; k < 64; ++k) {
        std::array<double, 2> point{};
        if (!criticalPoint(map, k, parameters.data(), {}, point.data())) break;
        all.push_back(point);
    }
    return all;
}

TEST(FormulaMap, FindsItsCriticalPoints) {
    EXPECT_EQ(criticalOf("z^2 + c", {-1, 0}), (std::vector<std::array<double, 2>>{{0, 0}}));
    // 3z² = a.
    const auto cubic = criticalOf("z^3 - a*z + c", {0.3, 0.4, 0, 0});
    ASSERT_EQ(cubic.size(), 2u);
    for (const auto& point : cubic) {
        const std::complex<double> z(point[0], point[1]);
        EXPECT_NEAR(std::abs(3.0 * z * z - std::complex<double>(0.3, 0.4)), 0, 1e-12);
    }
    // A polynomial of degree 7 has 6, multiple ones counted once.
    EXPECT_EQ(criticalOf("z^7 + z^2 - z + c", {0, 0}).size(), 6u);
    // Zeros of high order, where the derivative underflows all around.
    for (const char* power : {"z^60 + c", "z^100 + c", "z^300 + c"}) {
        const auto only = criticalOf(power, {0.1, 0});
        ASSERT_EQ(only.size(), 1u) << power;
        EXPECT_NEAR(only[0][0], 0, 1e-9) << power;
        EXPECT_NEAR(only[0][1], 0, 1e-9) << power;
    }
    // 0 is a pole, infinity goes to c.
    EXPECT_EQ(criticalOf("1/z^2 + c", {0.25, -0.5}),
              (std::vector<std::array<double, 2>>{{0.25, -0.5}}));
    // cos z = 0, wherever c is, 0 itself included.
    for (const std::vector<double>& c : {std::vector<double>{1, 0.2}, {-0.3, 2}, {0, 0}}) {
        const auto sine = criticalOf("c*sin(z)", c);
        ASSERT_GE(sine.size(), 2u);
        EXPECT_EQ(sine, criticalOf("c*sin(z)", {1, 0.2}));
        EXPECT_NEAR(std::abs(sine[0][0]), 1.57079632679489662, 1e-12);
    }
    EXPECT_FALSE(hasCriticalPoints(typedMap("exp(z) + c")));
    EXPECT_TRUE(hasCriticalPoints(typedMap("conj(z)^2 + c")));
    EXPECT_FALSE(hasCriticalPoints(typedMap("q^2 + c")));
}

// A bifurcation set started at the critical point: whatever the tile, the same values.
TEST(FormulaMap, CriticalStartsDoNotDependOnTheirNeighbours) {
    for (const char* text : {"c*sin(z)", "z^3 - c*z + 0.2", "z^2 + c"}) {
        OrbitProgram program = typedProgram(text, {}, 50, 50);
        addAxes(program, {"c.re", "c.im"});
        program.critical = 0;
        constexpr FieldName kFields[] = {FieldName::smoothEscape, FieldName::distance};
        const auto all = fieldsOn(program, 2, kFields);
        for (std::size_t i : {0u, 777u, 1001u, 1599u}) {
            const double u = 2 * (2.0 * static_cast<double>(i % 40) / 40 - 1);
            const double v = 2 * (2.0 * static_cast<double>(i / 40) / 40 - 1);
            const double* coordinates[] = {&u, &v};
            const auto one = evaluateFields(program, 1, coordinates, kFields);
            for (std::size_t f = 0; f < 2; ++f) EXPECT_EQ(one[f][0], all[f][i]) << text;
        }
    }
}

// The derivative by duals against the difference quotient of the field's own map, for a sine.
TEST(FormulaMap, SineAgreesWithLongDoubleAlongAnOrbit) {
    const MapKernels& map = typedMap("c*sin(z)");
    double z[2] = {0.4, 0.3}, c[3] = {0.8, 0.3, 0};
    std::complex<long double> exact(0.4L, 0.3L);
    const std::complex<long double> factor(c[0], c[1]);
    for (int n = 0; n < 12; ++n) {
        map.step(z, c, {});
        exact = factor * std::sin(exact);
        // |f'| = |c cos z| stays below 1.2 here.
        EXPECT_NEAR(z[0], static_cast<double>(exact.real()), 1e-15 * (n + 2));
        EXPECT_NEAR(z[1], static_cast<double>(exact.imag()), 1e-15 * (n + 2));
    }
}

TEST(FormulaMap, IsTheSameObjectForTheSameFormula) {
    const auto one = FormulaMap::make("z^2+c"), two = FormulaMap::make("  z ^ 2 + c ");
    ASSERT_TRUE(one && two);
    EXPECT_EQ(*one, *two);
    // However many are asked for, what somebody holds stays good.
    for (int k = 0; k < 600; ++k)
        ASSERT_TRUE(FormulaMap::make("z^2 + c + " + std::to_string(k)).ok());
    double z[2] = {1, 0};
    const double c[3] = {1, 0, 0};
    (*one)->kernels().step(z, c, {});
    EXPECT_EQ(z[0], 2);
}

}  // namespace
}  // namespace versorium
