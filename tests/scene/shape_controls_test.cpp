// SPDX-License-Identifier: MIT
// What a scene says of the shape's parameters is what the map does with them.
#include "scene/shape_controls.h"

#include <gtest/gtest.h>

#include <cmath>

#include "maps/samples.h"
#include "math/elementary.h"

namespace versorium {
namespace {

// |f(q)| = e^{α(φ(x) - β)}, with φ at the components of x = q - shift that are seen.
void expectModulus(const Scene& scene, const TestBindings& bindings) {
    const MapKernels& map = mapOf(scene);
    const ShapeControls controls = shapeControls(scene);
    std::vector<double> numbers;
    for (const ParameterInfo& parameter : map.info.parameters)
        for (double part : scene.parameters.at(std::string(parameter.name)))
            numbers.push_back(part);
    const std::vector<double> point{0.11, -0.32, 0.23, 0.37};
    std::vector<double> state(point.begin(), point.begin() + map.dimension);
    std::array<double, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto seen = static_cast<std::size_t>(controls.seen[k]);
        if (seen < state.size()) at[k] = state[seen] - controls.seenShift()[k];
    }
    map.step(state.data(), numbers.data(), bindings.environment<double>());
    double square = 0;
    for (double part : state) square += part * part;
    const double phi = bindings.field.at(at[0], at[1], at[2]);
    const double beta = controls.asPrinted ? -controls.beta : controls.beta;
    const double expected = exp(controls.alpha * (phi - beta));
    EXPECT_NEAR(std::sqrt(square), expected, 1e-13 * expected) << map.info.name;
}

TEST(ShapeControls, AreWhatTheMapDoes) {
    const TestBindings bindings;
    for (const MapKernels& map : catalogue()) {
        if (!map.info.field) continue;
        Scene scene = sceneOf(map);
        scene.parameters.at("beta") = {0.07};
        std::vector<double>& shift = scene.parameters.at("shift");
        for (std::size_t k = 0; k < shift.size(); ++k) shift[k] = 0.02 * static_cast<double>(k + 1);
        for (const double printed : {0.0, 1.0}) {
            scene.parameters.at(kAsPrinted) = {printed};
            if (!scene.parameters.contains("drop")) {
                expectModulus(scene, bindings);
                continue;
            }
            // Whole numbers are meant, and others have a meaning.
            for (const double drop : {0.0, 1.0, 2.0, 3.0, -1.0, 0.5, 1.5, 2.5, 7.0}) {
                scene.parameters.at("drop") = {drop};
                expectModulus(scene, bindings);
            }
        }
    }
}

}  // namespace
}  // namespace versorium
