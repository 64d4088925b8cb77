// SPDX-License-Identifier: MIT
// What a map's header says of the map is true of its step.
#include "maps/map_info.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "maps/catalogue.h"
#include "maps/planar.h"
#include "math/quaternion.h"
#include "scene/scene.h"

namespace versorium {
namespace {

// A map at numbers of its parameters, with its own roots.
class At {
  public:
    explicit At(const MapKernels& map) : map_(map), scene_(sceneOf(map)) {
        for (std::string_view list : map.info.lists)
            lists_.push_back(scene_.lists.at(std::string(list)).roots);
        for (std::size_t k = 0; k < lists_.size(); ++k) environment_.lists[k] = &lists_[k];
    }

    std::vector<double>& parameter(std::string_view name) {
        return scene_.parameters.at(std::string(name));
    }
    std::vector<double> image(std::vector<double> state) const {
        std::vector<double> numbers;
        for (const ParameterInfo& parameter : map_.info.parameters)
            for (double part : scene_.parameters.at(std::string(parameter.name)))
                numbers.push_back(part);
        map_.step(state.data(), numbers.data(), environment_);
        return state;
    }

  private:
    const MapKernels& map_;
    Scene scene_;
    std::vector<BoundList> lists_;
    Environment<double> environment_;
};

Quaternion<double> wide(const std::vector<double>& parts) {
    const auto at = [&](std::size_t k) { return k < parts.size() ? parts[k] : 0.0; };
    return {at(0), at(1), at(2), at(3)};
}

TEST(MapInfo, APolynomialHasTheTermsThatItNames) {
    int met = 0;
    for (const MapKernels& map : catalogue()) {
        const auto& terms = map.info.polynomial;
        if (terms.empty()) continue;
        ++met;
        At at(map);
        const auto dimension = static_cast<std::size_t>(map.dimension);
        const std::vector<double> state = std::vector<double>{0.4, -0.3, 0.2, 0.1};
        const std::vector<double> z(state.begin(), state.begin() + static_cast<long>(dimension));
        Quaternion<double> sum{0, 0, 0, 0}, power{1, 0, 0, 0};
        std::size_t degree = terms.size() - 1;
        if (const ParameterInfo* exponent = findParameter(map.info, map.info.degreeParameter))
            degree = static_cast<std::size_t>(at.parameter(exponent->name)[0]);
        for (std::size_t j = 0; j <= degree; ++j) {
            const std::string_view said = j < terms.size() ? terms[j] : j == degree ? "1" : "";
            if (said == "1")
                sum = sum + power;
            else if (!said.empty())
                sum = sum + wide(at.parameter(said)) * power;
            power = power * wide(z);
        }
        const Quaternion<double> found = wide(at.image(z));
        // A few roundings of numbers below 1.
        EXPECT_LT(std::sqrt(squaredNorm(found - sum)), 1e-14) << map.info.name;
    }
    EXPECT_GE(met, 5);
}

TEST(MapInfo, TheConstantOfAQuadraticMapIsTold) {
    EXPECT_EQ(quadraticConstant(findMap("quadratic")->info), "c");
    EXPECT_EQ(quadraticConstant(findMap("cubic")->info), "");
    // What is typed is the family of the catalogue.
    const auto typed = FormulaMap::make("z^2 + c");
    ASSERT_TRUE(typed.ok());
    const MapInfo& info = (*typed)->kernels().info;
    EXPECT_EQ(quadraticConstant(info), "c");
    EXPECT_EQ(info.parameterCentre, findMap("quadratic")->info.parameterCentre);
    const auto other = FormulaMap::make("z^2 + c + 1");
    ASSERT_TRUE(other.ok());
    EXPECT_EQ(quadraticConstant((*other)->kernels().info), "");
}

TEST(MapInfo, AnIntervalIsTakenIntoItself) {
    int met = 0;
    for (const MapKernels& map : catalogue()) {
        const auto [left, right] = map.info.interval;
        if (!(left < right)) continue;
        ++met;
        ASSERT_EQ(map.info.algebra, Algebra::real);
        const ParameterInfo& parameter = map.info.parameters[0];
        At at(map);
        for (int i = 0; i <= 40; ++i)
            for (int j = 0; j <= 40; ++j) {
                at.parameter(parameter.name)[0] =
                    parameter.low + (parameter.high - parameter.low) * i / 40;
                const double x = at.image({left + (right - left) * j / 40})[0];
                EXPECT_TRUE(x >= left && x <= right) << map.info.name << " " << x;
            }
    }
    EXPECT_EQ(met, 1);
}

TEST(MapInfo, ParametersThatAreNamedAreThere) {
    for (const MapKernels& map : catalogue()) {
        const MapInfo& info = map.info;
        if (!info.degreeParameter.empty()) {
            EXPECT_NE(findParameter(info, info.degreeParameter), nullptr) << info.name;
        }
        EXPECT_TRUE(info.parameterAxes.empty() || info.parameterAxes.size() == 2) << info.name;
        for (std::string_view axis : info.parameterAxes)
            EXPECT_NE(findParameter(info, axis), nullptr) << info.name << " " << axis;
        if (info.planarCoefficients) {
            EXPECT_EQ(map.parameters, Layout<PlanarCoefficients<double>>::kWidth) << info.name;
        }
    }
    EXPECT_EQ(findParameter(findMap("quadratic")->info, "no"), nullptr);
}

TEST(MapInfo, NewtonBeginsWithTheThirdRootsOfUnity) {
    for (const MapKernels& map : catalogue()) {
        if (map.info.rootForm != RootForm::newton || map.info.field) continue;
        const At at(map);
        for (const RootList::Root& root : map.info.homeRoots) {
            const Quaternion<double> r{root.q[0], root.q[1], 0, 0};
            const Quaternion<double> cube = r * r * r;
            EXPECT_NEAR(cube.w, 1, 1e-15);
            EXPECT_NEAR(cube.x, 0, 1e-15);
            // Roots are fixed points.
            const auto image = at.image({root.q[0], root.q[1]});
            EXPECT_NEAR(image[0], root.q[0], 1e-15);
            EXPECT_NEAR(image[1], root.q[1], 1e-15);
        }
    }
}

// With one root of power 1 and no pole, sum and product are the same function.
TEST(MapInfo, SumAndProductAreEachOthersCounterparts) {
    int met = 0;
    for (const MapKernels& map : catalogue()) {
        const MapKernels* other = sumOrProductOf(map.info);
        if (!other) continue;
        ++met;
        EXPECT_EQ(sumOrProductOf(other->info), &map) << map.info.name;
        EXPECT_NE(other->info.rootForm, map.info.rootForm);
        EXPECT_TRUE(isPoles(map.info, map.info.lists[1]));
        EXPECT_FALSE(isPoles(map.info, map.info.lists[0]));
        if (map.info.field) continue;
        const BoundList root{{{0.2, -0.1, 0, 0}, 1}}, none;
        Environment<double> environment;
        environment.lists[0] = &root;
        environment.lists[1] = &none;
        const double numbers[] = {0.3, 1, 1};
        double one[4] = {0.5, 0.7, 0, 0}, two[4] = {0.5, 0.7, 0, 0};
        map.step(one, numbers, environment);
        other->step(two, numbers, environment);
        // The product takes a logarithm and an exponential of the modulus.
        for (int k = 0; k < map.dimension; ++k) EXPECT_NEAR(one[k], two[k], 1e-14) << map.info.name;
    }
    EXPECT_EQ(met, 8);
}

}  // namespace
}  // namespace versorium
