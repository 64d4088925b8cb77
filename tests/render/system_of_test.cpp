// SPDX-License-Identifier: MIT
// The system of a scene has the scene's own parameters, whatever the slice.
#include "render/system_of.h"

#include <gtest/gtest.h>

namespace versorium {
namespace {

Scene preset(const char* name) {
    Expected<Scene> scene = presetNamed(name);
    EXPECT_TRUE(scene.ok()) << name;
    return *scene;
}

TEST(SystemOf, TakesTheParametersOfTheRing) {
    Binder binder;
    Job job(1);
    Scene scene = preset("mandelbrot");
    scene.parameters["c"] = {-0.12, 0.74};
    const auto system = systemOf(binder, scene, job);
    ASSERT_TRUE(system.ok());
    EXPECT_EQ(system->parameters(), (std::vector<double>{-0.12, 0.74}));
    PlanePoint z{0, 0};
    system->step(z.data());
    EXPECT_EQ(z, (PlanePoint{-0.12, 0.74}));
    double jacobian[4];
    z = {0.3, -0.4};
    system->stepWithJacobian(z.data(), jacobian);
    EXPECT_EQ(std::vector<double>(jacobian, jacobian + 4),
              (std::vector<double>{0.6, 0.8, -0.8, 0.6}));
}

// A component of a root on an axis keeps the root's own value.
TEST(SystemOf, TakesRootsOnAxes) {
    Binder binder;
    Job job(1);
    Scene scene = preset("newton");
    const auto& root = scene.lists.begin()->second.roots[1];
    scene.slice.axes = {{{{"roots[1].re", 1}}}, {{{"roots[1].im", 1}}}};
    const auto system = systemOf(binder, scene, job);
    ASSERT_TRUE(system.ok()) << system.status().message();
    // Newton's map fixes a root.
    PlanePoint z{root.q[0] + 1e-9, root.q[1]};
    system->step(z.data());
    EXPECT_NEAR(z[0], root.q[0], 1e-12);
    EXPECT_NEAR(z[1], root.q[1], 1e-12);
}

TEST(SystemOf, ProgramsRunAlongParametersOnly) {
    Binder binder;
    Job job(1);
    const Scene scene = preset("planar-set");
    const auto along = programAlong(binder, scene, {{{"g.d", 1}}}, job);
    ASSERT_TRUE(along.ok());
    ASSERT_EQ(along->slice.axes.size(), 1u);
    const double at = 0.25;
    // h.d is on an axis of the picture, and keeps the scene's value here.
    const System system(*along, &at);
    PlanePoint z{0, 0};
    system.step(z.data());
    EXPECT_EQ(z, (PlanePoint{0.25, scene.parameters.at("h.d")[0]}));
    EXPECT_EQ(programAlong(binder, scene, {{{"p.x", 1}}}, job).status().kind(), ErrorKind::usage);
    EXPECT_EQ(programAlong(binder, scene, {{{"q", 1}}}, job).status().kind(), ErrorKind::usage);
}

TEST(SystemOf, KnowsDynamicalPlanes) {
    EXPECT_TRUE(isDynamicalPlane(preset("julia")));
    EXPECT_FALSE(isDynamicalPlane(preset("mandelbrot")));
    Scene turned = preset("julia");
    std::swap(turned.slice.axes[0], turned.slice.axes[1]);
    EXPECT_FALSE(isDynamicalPlane(turned));
    Scene scene = preset("julia");
    scene.slice.centre = {0.5, -0.25};
    scene.slice.height = 3;
    scene.aspect = 2;
    const Window window = dynamicalWindow(scene);
    EXPECT_EQ(window.left, -2.5);
    EXPECT_EQ(window.right, 3.5);
    EXPECT_EQ(window.bottom, -1.75);
    EXPECT_EQ(window.top, 1.25);
}

}  // namespace
}  // namespace versorium
