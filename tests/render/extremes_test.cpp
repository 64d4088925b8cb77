// SPDX-License-Identifier: MIT
// Every number of a scene with odd values: a clear refusal, or a picture without a NaN.
#include <gtest/gtest.h>

#include <cmath>

#include "io/document.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {
namespace {

constexpr const char* kOdd[] = {
    "1.7976931348623157e308", "1e308", "1e300", "-1e300", "5e-324", "-0", "1e150"};

void expectBounded(const Scene& scene, const std::string& what) {
    CpuRenderer renderer;
    Job job(1);
    Frame frame;
    const Status status = renderer.render(scene, {6, 5}, {}, job, frame);
    if (!status.ok()) {
        EXPECT_FALSE(status.message().empty()) << what;
        return;
    }
    for (float part : frame.colour.values())
        EXPECT_TRUE(part >= 0 && part <= 1.0001f) << what << ": " << part;
}
void tryValue(Scene scene, const std::string& key, const std::string& value) {
    const Status status = assign(scene, {key, value});
    if (!status.ok()) {
        EXPECT_NE(status.message().find(key), std::string::npos) << status.message();
        return;
    }
    expectBounded(
        scene, scene.map + " " + key + "=" + value + " " + std::string(wordOf(scene.colour.field)));
}

TEST(Extremes, NumbersOfEveryMap) {
    for (const MapKernels& map : catalogue()) {
        Scene scene = sceneOf(map);
        scene.samples = 1;
        scene.iterations = std::min(scene.iterations, 20);
        for (int k = 0; k < map.dimension + map.parameters; ++k)
            for (const char* value : kOdd) {
                const std::string key = k < map.dimension
                                            ? stateComponent(map.info, k)
                                            : parameterComponent(map.info, k - map.dimension);
                tryValue(scene, key, value);
            }
        for (const std::string key :
             {"roots[0].power", "roots[0].w", "roots[0].re", "factors[1].power"})
            for (const char* value : kOdd) tryValue(scene, key, value);
    }
}

TEST(Extremes, NumbersOfViewsAndColours) {
    for (const char* name : {"quadratic", "shape-modulus", "logistic"}) {
        Scene scene = sceneOf(*findMap(name));
        scene.samples = 1;
        scene.iterations = 20;
        for (const char* key :
             {"height", "escape_radius", "iso", "aspect", "samples", "trap.radius", "trap.angle",
              "outline_width", "resolution", "padding", "iterations", "colour.escaped.exponent",
              "colour.attracted.exponent"})
            for (const char* value : kOdd) tryValue(scene, key, value);
        for (const char* value : kOdd) {
            tryValue(scene, "center", std::string(value) + "," + value);
            tryValue(scene, "center_low", std::string(value) + ",0");
            tryValue(scene, "range", std::string("0,") + value);
            tryValue(scene, "range", std::string(value) + "," + value);
            tryValue(scene, "trap.point", std::string(value) + ",0");
        }
    }
}

// The limits that a scene may reach, with every field on the palette.
TEST(Extremes, EveryFieldAtTheLimits) {
    for (const FieldInfo& field : allFields()) {
        if (field.field == FieldName::versor) continue;  // has a rule of its own
        for (const char* name : {"quadratic", "quaternion-rational", "shape-modulus"}) {
            Scene scene = sceneOf(*findMap(name));
            scene.samples = 1;
            scene.iterations = 20;
            scene.colour.field = field.field;
            expectBounded(scene, scene.map);
            for (const std::string key : {"height", "escape_radius", "iterations", "iso"})
                for (const char* value : {"0", "1e-300", "1e12", "1e150", "1"})
                    tryValue(scene, key, value);
            tryValue(scene, "center", "1e300,-1e300");
            tryValue(scene, "scale", "log");
            tryValue(scene, "scale", "cyclic");
            tryValue(scene, "kind", "line");
            tryValue(scene, "kind", "circle");
        }
    }
}

// Ten million iterations of orbits that never escape end soon where they become periodic.
TEST(Extremes, TheMostIterations) {
    Scene scene = sceneOf(*findMap("quadratic"));
    scene.samples = 1;
    scene.slice.height = 0.01;
    scene.parameters["c"] = {-1, 0};
    tryValue(scene, "iterations", "10000000");
}

}  // namespace
}  // namespace versorium
