// SPDX-License-Identifier: MIT
// shape(p) of typed formulas against the built-in shape modulus, and what may not be typed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "maps/samples.h"
#include "render/bind.h"

namespace versorium {
namespace {

struct Pair {
    const char *typed, *builtIn;
    bool sameBits;
};
constexpr Pair kPairs[] = {
    {"shape(z^2 + c)", "shape-modulus-quadratic", true},
    {"shape(z^3 + a*z + b)", "shape-modulus-cubic", false},
    {"shape(q^2 + c)", "shape-modulus-quaternion-quadratic", true},
    {"shape(q^3 + c)", "shape-modulus-quaternion-cubic", false},
};

TEST(FormulaShape, HasTheParametersOfTheBuiltInMap) {
    for (const Pair& pair : kPairs) {
        const MapInfo &typed = typedMap(pair.typed).info, &own = findMap(pair.builtIn)->info;
        ASSERT_EQ(typed.parameters.size(), own.parameters.size()) << pair.typed;
        for (std::size_t k = 0; k < own.parameters.size(); ++k) {
            EXPECT_EQ(typed.parameters[k].name, own.parameters[k].name);
            EXPECT_EQ(typed.parameters[k].kind, own.parameters[k].kind);
        }
        // All but those of p have the built-in map's defaults and help.
        for (std::size_t k = 0; k < (own.algebra == Algebra::complex ? 4u : 5u); ++k) {
            EXPECT_EQ(typed.parameters[k].value, own.parameters[k].value);
            EXPECT_EQ(typed.parameters[k].help, own.parameters[k].help);
        }
        EXPECT_TRUE(typed.field);
        EXPECT_EQ(typed.escapeRadius, own.escapeRadius);
        EXPECT_EQ(typed.homeHeight, own.homeHeight);
    }
}

TEST(FormulaShape, IsTheBuiltInShapeModulus) {
    const TestBindings bindings;
    for (const Pair& pair : kPairs) {
        const MapKernels &typed = typedMap(pair.typed), &own = *findMap(pair.builtIn);
        for (const Sample& sample : samples(own, 200, 17)) {
            auto a = sample.state, b = sample.state;
            typed.step(a.data(), sample.parameters.data(), bindings.environment<double>());
            own.step(b.data(), sample.parameters.data(), bindings.environment<double>());
            double size = 0;
            for (double part : b) size += std::abs(part);
            for (std::size_t k = 0; k < a.size(); ++k)
                if (pair.sameBits)
                    EXPECT_EQ(std::memcmp(&a[k], &b[k], sizeof a[k]), 0) << pair.typed;
                else  // the cubics associate their factors otherwise: a few roundings
                    EXPECT_NEAR(a[k], b[k], 1e-13 * size) << pair.typed;
        }
    }
}

// Where p, and then z, have no direction.
TEST(FormulaShape, FallsBackAsTheBuiltInOne) {
    TestBindings bindings;
    const MapKernels& typed = typedMap("shape(z - z + 0*c)");
    const double alpha = 3, beta = 0.1;
    const double parameters[] = {alpha, beta, 0, 0.2, -0.1, 1, 0};
    double z[] = {0.3, 0.4};
    typed.step(z, parameters, bindings.environment<double>());
    const double modulus = std::exp(alpha * (bindings.field.at(0.1, 0.5, 0.0) - beta));
    EXPECT_NEAR(z[0], 0.6 * modulus, 1e-15);
    EXPECT_NEAR(z[1], 0.8 * modulus, 1e-15);
    double zero[] = {0, 0};
    typed.step(zero, parameters, bindings.environment<double>());
    EXPECT_GT(zero[0], 0);
    EXPECT_EQ(zero[1], 0);
}

TEST(FormulaShape, ReadsBackWithItsDeclarations) {
    const std::string text = "shape(z^2 + c); alpha = 6 in [0, 20]; shift = 0.1 - 0.2i; c = 0.3";
    const auto map = FormulaMap::make(text);
    ASSERT_TRUE(map.ok()) << map.status().message();
    const MapInfo& info = (*map)->kernels().info;
    EXPECT_EQ(info.formula, "shape(z^2 + c)");
    EXPECT_EQ(info.parameters[0].value[0], 6);
    EXPECT_EQ(info.parameters[0].high, 20);
    EXPECT_EQ(info.parameters[3].value[1], -0.2);
    const auto again = FormulaMap::make((*map)->formula().text);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ((*again)->formula().text, (*map)->formula().text);
    EXPECT_EQ((*again)->formula().tape.nodes, (*map)->formula().tape.nodes);
    EXPECT_TRUE(FormulaMap::make("z' = shape(c)").ok()) << "a constant direction";
    EXPECT_TRUE(FormulaMap::make("shape(sin(q)*exp(c) - 1/q)").ok());
}

TEST(FormulaShape, IsRefusedAtTheCharacter) {
    const struct {
        const char* text;
        std::size_t position;
        const char* says;
    } faults[] = {
        {"shape(z^2 + c) + 1", 0, "whole formula"},
        {"z + shape(z)", 4, "whole formula"},
        {"shape(shape(z))", 6, "whole formula"},
        {"x' = shape(x), y' = y", 5, "z or q"},
        {"shape(r*x)", 0, "z or q"},
        {"shape(z^2 + alpha)", 12, "another name"},
        {"shape(z^2 + c); alpha: complex = 1", 16, "a real number"},
        {"shape(z^2 + c); c = shape(3)", 20, "numbers alone"},
        {"shape(z^2 + c", 13, "\")\""},
        {"shape z^2", 6, "\"(\""},
        {"shape()", 6, "a number"},
    };
    for (const auto& one : faults) {
        FormulaFault fault;
        EXPECT_FALSE(FormulaMap::make(one.text, &fault).ok()) << one.text;
        EXPECT_EQ(fault.position, one.position) << one.text << ": " << fault.message;
        EXPECT_NE(fault.message.find(one.says), std::string::npos) << fault.message;
    }
}

// Pictures, α over space included: the fields of both maps are the same numbers.
TEST(FormulaShape, DrawsWhatTheBuiltInMapDraws) {
    for (const bool modulated : {false, true}) {
        Scene typed = *sceneOfMap("shape(z^2 + c); c = 0"),
              own = *sceneOfMap("shape-modulus-quadratic");
        for (Scene* scene : {&typed, &own}) {
            scene->shape.source = "star(5, 0.5, 0.25)";
            scene->parameters["c"] = {-0.12, 0.3};
            if (modulated) scene->alphaOverSpace.discs = {{0.2, 0.1, 0, 0.3, 20}};
            if (modulated)
                scene->betaOverSpace.shape = "disc(0.2)", scene->betaOverSpace.value = 0.1;
        }
        Binder binder;
        Job job(1);
        const auto a = binder.bind(typed, job), b = binder.bind(own, job);
        ASSERT_TRUE(a.ok() && b.ok()) << a.status().message() << b.status().message();
        std::vector<double> u, v;
        Random random(21);
        for (int i = 0; i < 500; ++i)
            u.push_back(random.uniform(-0.6, 0.6)), v.push_back(random.uniform(-0.6, 0.6));
        const double* at[] = {u.data(), v.data()};
        const FieldName fields[] = {FieldName::membership, FieldName::escapeStep,
                                    FieldName::imageModulus, FieldName::logModulus};
        const auto left = evaluateFields(*a, 500, at, fields),
                   right = evaluateFields(*b, 500, at, fields);
        EXPECT_EQ(left[0], right[0]);
        EXPECT_EQ(left[1], right[1]);
        // The built-in map knows the logarithm of its modulus before the modulus itself.
        for (std::size_t i = 0; i < 500; ++i)
            for (std::size_t k = 2; k < 4; ++k)
                EXPECT_NEAR(left[k][i], right[k][i], 1e-12 * (1 + std::abs(right[k][i])));
    }
}

}  // namespace
}  // namespace versorium
