// SPDX-License-Identifier: MIT
// One step of every map of the catalogue against the oracle.
#include <gtest/gtest.h>

#include "oracle/cases.h"

namespace versorium {
namespace {

TEST(Oracle, KnowsEveryMapOfTheCatalogueAndNoOther) {
    for (const MapKernels& map : catalogue())
        EXPECT_TRUE(oracle::steps().contains(std::string(map.info.name)))
            << map.info.name << " has no oracle: write it in tests/oracle/oracle.h";
    for (const auto& [name, step] : oracle::steps()) EXPECT_NE(findMap(name), nullptr) << name;
}

// A step is the exact step of arguments that were moved by at most 32 roundings, and its result
// rounded: a map of some twenty operations, each right to half a unit, stays well below (powers of
// real exponents are right to 3 + 2 |y ln x| units, see math/elementary.h).
TEST(Oracle, OneStepToRounding) {
    const TestBindings bindings;
    const oracle::Bound bound = oracleBound(bindings);
    for (const MapKernels& map : catalogue()) {
        int index = 0;
        for (const Sample& sample : samples(map, 120, 31)) {
            oracle::Case c = caseOf(map, sample, bound);
            c.iterations = 1;
            c.radius = std::numeric_limits<oracle::Real>::infinity();
            const auto all = oracle::orbit(c, {});
            const oracle::Real tolerance =
                32 * kRounding * (oracle::amplification(c, {}, all)[1] + oracle::length(all[1]));
            auto z = sample.state;
            map.step(z.data(), sample.parameters.data(), bindings.environment<double>());
            for (std::size_t k = 0; k < z.size(); ++k)
                EXPECT_LE(std::abs(all[1][k] - z[k]), tolerance)
                    << map.info.name << ", sample " << index << ", component " << k << ": "
                    << static_cast<double>(all[1][k]) << " and " << z[k];
            ++index;
        }
    }
}

// Single precision is the same formula with other rounding.
TEST(Oracle, OneStepInFloat) {
    const TestBindings bindings;
    const oracle::Bound bound = oracleBound(bindings);
    for (const MapKernels& map : catalogue())
        for (const Sample& sample : samples(map, 40, 32)) {
            oracle::Case c = caseOf(map, sample, bound);
            c.iterations = 1;
            c.radius = std::numeric_limits<oracle::Real>::infinity();
            const auto all = oracle::orbit(c, {});
            const oracle::Real tolerance =
                32 * 0x1p-24L * (oracle::amplification(c, {}, all)[1] + oracle::length(all[1]));
            std::vector<float> z(sample.state.begin(), sample.state.end());
            const std::vector<float> p(sample.parameters.begin(), sample.parameters.end());
            map.stepFloat(z.data(), p.data(), bindings.environment<float>());
            for (std::size_t k = 0; k < z.size(); ++k)
                EXPECT_LE(std::abs(all[1][k] - static_cast<oracle::Real>(z[k])), tolerance)
                    << map.info.name;
        }
}

// Where directions are lost: p = 0, q = 0 and both.
TEST(Oracle, ShapeModulusWithoutADirection) {
    TestBindings bindings;
    const oracle::Bound bound = oracleBound(bindings);
    const MapKernels& map = *findMap("shape-modulus");
    Sample sample = samples(map, 1, 1)[0];
    for (const auto& root : bindings.roots) {
        sample.state.assign(root.q.begin(), root.q.end());
        const oracle::Vector expected = oracle::orbit(caseOf(map, sample, bound), {})[1];
        auto z = sample.state;
        map.step(z.data(), sample.parameters.data(), bindings.environment<double>());
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_NEAR(static_cast<double>(expected[k]), z[k], 1e-13);
    }
    bindings.roots = {{{0, 0, 0, 0}, 2}};
    const oracle::Bound atZero = oracleBound(bindings);
    sample.state.assign(4, 0.0);
    const oracle::Vector expected = oracle::orbit(caseOf(map, sample, atZero), {})[1];
    auto z = sample.state;
    map.step(z.data(), sample.parameters.data(), bindings.environment<double>());
    EXPECT_GT(z[0], 0);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(static_cast<double>(expected[k]), z[k], 1e-13);
}

}  // namespace
}  // namespace versorium
