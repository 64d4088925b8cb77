// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "maps/samples.h"

namespace versorium {
namespace {

// Arrays that an OrbitBatch points into.
template <class T>
struct Escape {
    OrbitBatch<T> batch;
    std::vector<std::vector<T>> state, parameters;
    std::vector<std::int32_t> steps, index;
    std::vector<T> scratch;

    Escape(const MapKernels& map, const std::vector<Sample>& all, const TestBindings& bindings,
           bool varies) {
        batch.count = static_cast<int>(all.size());
        batch.capacity = (batch.count + kBatchPadding - 1) / kBatchPadding * kBatchPadding;
        const auto capacity = static_cast<std::size_t>(batch.capacity);
        for (std::size_t k = 0; k < static_cast<std::size_t>(map.dimension); ++k) {
            state.emplace_back(capacity);
            for (std::size_t i = 0; i < all.size(); ++i)
                state[k][i] = static_cast<T>(all[i].state[k]);
        }
        for (std::size_t k = 0; k < static_cast<std::size_t>(map.parameters); ++k) {
            parameters.emplace_back(capacity);
            for (std::size_t i = 0; i < all.size(); ++i)
                parameters[k][i] = static_cast<T>(all[i].parameters[k]);
        }
        for (std::size_t k = 0; k < state.size(); ++k) batch.state[k] = state[k].data();
        for (std::size_t k = 0; k < parameters.size(); ++k)
            batch.parameters[k] = {parameters[k].data(), varies};
        batch.lists[0] = &bindings.roots;
        batch.lists[1] = &bindings.poles;
        batch.field = &bindings.field;
        batch.program = map.program();
        steps.resize(capacity);
        index.resize(6 * capacity);
        scratch.resize(scratchSize(batch.capacity, map.parameters + kMostOverrides));
        batch.steps = steps.data();
        batch.scratch = scratch.data();
        batch.scratchIndex = index.data();
    }
};

template <class T>
std::vector<T> as(const std::vector<double>& values) {
    return std::vector<T>(values.begin(), values.end());
}

// The loop of numerics: the least n with !(|z|² <= R²).
template <class T>
int plainLoop(StepFunction<T> step, std::vector<T>& z, const std::vector<T>& p,
              const Environment<T>& environment, T squaredRadius, int iterations) {
    for (int n = 0; n <= iterations; ++n) {
        T norm = z[0] * z[0];
        for (std::size_t k = 1; k < z.size(); ++k) norm = norm + z[k] * z[k];
        if (!(norm <= squaredRadius)) return n;
        if (n < iterations) step(z.data(), p.data(), environment);
    }
    return iterations + 1;
}

template <class T>
void expectThePlainLoop(StepFunction<T> MapKernels::*step, int iterations) {
    const TestBindings bindings;
    for (const MapKernels* tested : testedMaps())
        for (const KernelTarget& target : kernelTargets()) {
            const MapKernels& map = *tested;
            if (target.flavour != Flavour::exact || !target.escapeOf<T>(map.index)) continue;
            for (const bool varies : {true, false}) {
                auto all = samples(map, 203, 21);
                if (!varies)
                    for (Sample& sample : all) sample.parameters = all[1].parameters;
                for (const bool shortcuts : {false, true}) {
                    Escape<T> escape(map, all, bindings, varies);
                    const T radius = std::isinf(map.info.escapeRadius)
                                         ? T(1e3)
                                         : static_cast<T>(map.info.escapeRadius);
                    escape.batch.squaredRadius = radius * radius;
                    escape.batch.iterations = iterations;
                    escape.batch.shortcuts = shortcuts;
                    target.escapeOf<T>(map.index)(escape.batch);
                    int wrong = 0;
                    for (std::size_t i = 0; i < all.size(); ++i) {
                        auto z = as<T>(all[i].state);
                        const int n =
                            plainLoop(map.*step, z, as<T>(all[i].parameters),
                                      bindings.environment<T>(), radius * radius, iterations);
                        bool same = n == escape.steps[i];
                        // Shorter forms may differ in a NaN or a zero's sign after escape only.
                        for (std::size_t k = 0; k < z.size(); ++k)
                            same = same && (z[k] == escape.state[k][i] || std::isnan(z[k]));
                        if (!same) ++wrong;
                    }
                    EXPECT_EQ(wrong, 0)
                        << map.info.name << " " << map.info.formula << " on " << target.name
                        << ", N " << iterations << (varies ? ", varying" : ", uniform")
                        << (shortcuts ? ", shortcuts" : "");
                }
            }
        }
}

TEST(EscapeKernel, GivesTheStepsAndBitsOfThePlainLoop) {
    for (const int iterations : {0, 1, 7, 150}) expectThePlainLoop(&MapKernels::step, iterations);
}

TEST(EscapeKernel, GivesTheStepsAndBitsOfThePlainLoopInFloat) {
    for (const int iterations : {1, 7}) expectThePlainLoop(&MapKernels::stepFloat, iterations);
}

// An attracting 3-cycle becomes exactly periodic in floating point: the shortcut has to find it and
// still report the very z_N of the plain loop.
TEST(EscapeKernel, PeriodShortcutKeepsTheLastIterate) {
    const MapKernels& map = *findMap("quadratic");
    const TestBindings bindings;
    std::vector<Sample> all;
    for (int i = 0; i < 40; ++i) all.push_back({{0.001 * i, -0.002 * i}, {-0.122561, 0.744862}});
    for (const int iterations : {100000, 100001, 100002}) {
        Escape<double> escape(map, all, bindings, true);
        escape.batch.iterations = iterations;
        kernelTarget(Flavour::exact).escape[map.index](escape.batch);
        for (std::size_t i = 0; i < all.size(); ++i) {
            auto z = all[i].state;
            EXPECT_EQ(plainLoop(map.step, z, all[i].parameters, bindings.environment<double>(), 4.0,
                                iterations),
                      iterations + 1);
            EXPECT_EQ(escape.steps[i], iterations + 1);
            EXPECT_EQ(escape.state[0][i], z[0]);
            EXPECT_EQ(escape.state[1][i], z[1]);
        }
    }
}

// One component of a root as an axis gives what the same root typed in would give.
TEST(EscapeKernel, AListComponentMayVary) {
    const MapKernels& map = *findMap("quaternion-rational");
    const TestBindings bindings;
    const auto all = samples(map, 100, 22);
    Escape<double> escape(map, all, bindings, true);
    std::vector<double> moved(static_cast<std::size_t>(escape.batch.capacity), 0.0);
    for (std::size_t i = 0; i < all.size(); ++i) moved[i] = 0.01 * static_cast<double>(i) - 0.5;
    escape.batch.overrides[0] = {0, 2, 1, {moved.data(), true}};
    escape.batch.overrideCount = 1;
    escape.batch.squaredRadius = 400;
    escape.batch.iterations = 4;
    kernelTarget(Flavour::exact).escape[map.index](escape.batch);
    for (std::size_t i = 0; i < all.size(); ++i) {
        TestBindings typed;
        typed.roots[2].q[1] = moved[i];
        auto z = all[i].state;
        EXPECT_EQ(plainLoop(map.step, z, all[i].parameters, typed.environment<double>(), 400.0, 4),
                  escape.steps[i]);
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_TRUE(z[k] == escape.state[k][i] || std::isnan(z[k]));
    }
}

}  // namespace
}  // namespace versorium
