// SPDX-License-Identifier: MIT
#include "render/shape_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace versorium {
namespace {

ShapeView viewOf(const char* shape, const SpaceCamera& camera,
                 const glm::dvec3& shift = {0, 0, 0}) {
    ShapeView view;
    view.start(std::make_shared<const DistanceField>(*parseShape(shape)), shift, 2, camera,
               {120, 100});
    view.advance(40);
    EXPECT_FALSE(view.finished());
    EXPECT_TRUE(view.advance(60));
    return view;
}

TEST(ShapeView, TheCamerasAxesAreOrthonormalAndRightHanded) {
    for (double yaw : {-2.0, 0.0, 0.7})
        for (double pitch : {-1.2, 0.0, 0.9}) {
            const SpaceCamera camera{.yaw = yaw, .pitch = pitch};
            EXPECT_NEAR(glm::length(camera.forward()), 1, 1e-12);
            EXPECT_NEAR(glm::dot(camera.right(), camera.forward()), 0, 1e-12);
            EXPECT_NEAR(glm::distance(glm::cross(camera.right(), camera.up()), -camera.forward()),
                        0, 1e-12);
            EXPECT_GT(camera.up().y, 0);
        }
}

TEST(ShapeView, ASphereIsADiscOfItsRadius) {
    SpaceCamera camera;
    camera.halfHeight = 1;
    const ShapeView view = viewOf("sphere(0.6)", camera);
    int covered = 0;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 120; ++x) {
            const double depth = view.depth().at(x, y);
            if (std::isnan(depth)) continue;
            ++covered;
            const glm::dvec3 hit = view.pointAt(x, y) + depth * camera.forward();
            // A hit lies within 1e-3 of the reach, which is 2.
            EXPECT_NEAR(glm::length(hit), 0.6, 2.1e-3);
            EXPECT_GT(view.light().at(x, y), 0);
        }
    // Pixels are 1/50 wide; the rim is uncertain by half a pixel.
    EXPECT_NEAR(covered / 2500.0, M_PI * 0.36, 2 * M_PI * 0.6 * 0.01);
}

TEST(ShapeView, TheNearerPartHidesTheOther) {
    SpaceCamera camera;
    camera.yaw = camera.pitch = 0;  // looks along -z
    const ShapeView view = viewOf(
        "union(translate(0, 0, 0.5, sphere(0.2)), translate(0, 0, -0.5, sphere(0.4)))", camera);
    EXPECT_NEAR(view.depth().at(60, 50), -0.7, 5e-3);
    EXPECT_NEAR(view.depth().at(75, 50), 0.5 - std::sqrt(0.16 - 0.31 * 0.31), 0.02);
    // Moved by the shift.
    const ShapeView moved = viewOf("sphere(0.3)", camera, {0.4, 0, 0});
    EXPECT_NEAR(moved.depth().at(80, 50), -0.3, 5e-3);
    EXPECT_TRUE(std::isnan(moved.depth().at(60, 20)));
}

}  // namespace
}  // namespace versorium
