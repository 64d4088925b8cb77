// SPDX-License-Identifier: MIT
// The sum over roots, which takes the product's place in the authors' two-dimensional program.
#include <gtest/gtest.h>

#include <cmath>

#include "maps/samples.h"

namespace versorium {
namespace {

// (z - 1)² + (z + 1)² = 2z² + 2, by hand.
TEST(RootSum, OfTwoSquaresIsTheirPolynomial) {
    TestBindings bindings;
    bindings.roots = {{{1, 0, 0, 0}, 2}, {{-1, 0, 0, 0}, 2}};
    bindings.poles.clear();
    const MapKernels& map = *findMap("complex-root-sum");
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        double z[] = {random.uniform(-2, 2), random.uniform(-2, 2)};
        const double re = 2 * (z[0] * z[0] - z[1] * z[1]) + 2, im = 4 * z[0] * z[1];
        const double parameters[] = {0, 1, 1};
        map.step(z, parameters, bindings.environment<double>());
        // A handful of roundings of terms up to about 20.
        EXPECT_NEAR(z[0], re, 1e-14);
        EXPECT_NEAR(z[1], im, 1e-14);
    }
}

// One root has nothing to be added to: its sum is its product, also as a direction.
TEST(RootSum, OfOneRootIsTheProduct) {
    TestBindings bindings;
    bindings.roots.resize(1);
    bindings.poles.clear();
    const std::pair<const char*, const char*> pairs[] = {
        {"complex-root-sum", "complex-rational"},
        {"quaternion-root-sum", "quaternion-rational"},
        {"shape-modulus-complex-root-sum", "shape-modulus-complex-rational"},
        {"shape-modulus-quaternion-root-sum", "shape-modulus"}};
    for (const auto& [sum, product] : pairs)
        for (const Sample& sample : samples(*findMap(sum), 100, 5)) {
            auto a = sample.state, b = sample.state;
            auto parameters = sample.parameters;
            findMap(sum)->step(a.data(), parameters.data(), bindings.environment<double>());
            findMap(product)->step(b.data(), parameters.data(), bindings.environment<double>());
            double size = 1e-30;
            for (double part : a) size += std::abs(part);
            // The product normalises its factors and takes logarithms: some ten roundings, and
            // powers right to 3 + 2 |y ln x| units.
            for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-14 * size) << sum;
        }
}

// A studio that switches between the two keeps every number, list and slice.
TEST(RootSum, HasTheProductsParametersAndLists) {
    for (const auto& [sum, product] :
         {std::pair{"complex-root-sum", "complex-rational"},
          std::pair{"shape-modulus-quaternion-root-sum", "shape-modulus"}}) {
        const MapInfo &a = findMap(sum)->info, &b = findMap(product)->info;
        ASSERT_EQ(a.parameters.size(), b.parameters.size());
        for (std::size_t k = 0; k < a.parameters.size(); ++k)
            EXPECT_EQ(a.parameters[k].name, b.parameters[k].name);
        ASSERT_EQ(a.lists.size(), b.lists.size());
        for (std::size_t k = 0; k < a.lists.size(); ++k) EXPECT_EQ(a.lists[k], b.lists[k]);
        EXPECT_EQ(a.algebra, b.algebra);
    }
}

// Turning plane and roots together by an angle t turns each power m by m t: with equal powers the
// whole sum, so |S| stays.
TEST(RootSum, TurnsWithItsRoots) {
    const MapKernels& map = *findMap("complex-root-sum");
    const double c = std::cos(0.7), s = std::sin(0.7);
    TestBindings bindings, turned;
    for (TestBindings* one : {&bindings, &turned}) {
        one->poles.clear();
        for (auto& root : one->roots) root.power = 3;
    }
    for (auto& root : turned.roots)
        root.q = {c * root.q[0] - s * root.q[1], s * root.q[0] + c * root.q[1], 0, 0};
    Random random(9);
    for (int i = 0; i < 50; ++i) {
        double z[] = {random.uniform(-1, 1), random.uniform(-1, 1)};
        double w[] = {c * z[0] - s * z[1], s * z[0] + c * z[1]};
        const double parameters[] = {0.3, 1, 1};
        map.step(z, parameters, bindings.environment<double>());
        map.step(w, parameters, turned.environment<double>());
        EXPECT_NEAR(std::hypot(z[0], z[1]), std::hypot(w[0], w[1]),
                    1e-13 * (1 + std::hypot(z[0], z[1])));
    }
}

}  // namespace
}  // namespace versorium
