// SPDX-License-Identifier: MIT
// What observables measure, where it is known in closed form.
#include "lesson/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lesson/observables.h"
#include "lesson/stage.h"

namespace versorium {
namespace {

Workspace after(const std::string& lines) {
    const Expected<std::vector<StageLine>> read = readLines(lines, 1);
    EXPECT_TRUE(read);
    Expected<Workspace> stage = changed(workspaceOf(*presetNamed("mandelbrot")), *read);
    EXPECT_TRUE(stage) << stage.status().message();
    return stage ? std::move(*stage) : workspaceOf(*presetNamed("mandelbrot"));
}

// A disc of radius 1, which the modulus sees from its own centre.
Workspace disc(const std::string& lines = "") {
    return after(
        "preset: star\nviews: starts\nshape: disc(1)\nalpha: 4\nbeta: 0\nslice.height: 4\n" +
        lines);
}

TEST(Measure, WhereAnOrbitEnds) {
    // z² goes to 0 from everywhere in the unit disc.
    Workspace state = after("preset: julia\nc: 0\npoint: 0.5, 0.3");
    EXPECT_NEAR(observe(state, "end.x"), 0, 1e-12);
    EXPECT_NEAR(observe(state, "end.y"), 0, 1e-12);
    // z² - 1 takes 0 to -1 and back, and N is even.
    state = after("preset: julia\nc: -1\npoint: 0, 0\niterations: 300");
    EXPECT_EQ(observe(state, "end.x"), 0);
    state = after("preset: julia\nc: 0\npoint: 2, 0");
    EXPECT_TRUE(std::isnan(observe(state, "end.x")));
}

TEST(Measure, WhichPicturesAreCatalogues) {
    EXPECT_EQ(observe(after("preset: mandelbrot"), "catalogue"), 1);
    EXPECT_EQ(observe(after("preset: not-critical"), "catalogue"), 0);
    EXPECT_EQ(observe(after("preset: henon-set"), "catalogue"), 0) << "has no critical point";
    EXPECT_TRUE(std::isnan(observe(after("preset: julia\nviews: starts"), "catalogue")));
}

TEST(Measure, CirclesByTheirEnds) {
    // The unit circle parts what z² keeps from what it loses.
    Workspace state = after(
        "preset: julia\nc: 0\ncircle: 0, 0, 0.9\ncircle: 0, 0, 1.1\ncircle: 0.2, 0, 0.5\n"
        "circle: 1, 0, 0.3");
    EXPECT_EQ(observe(state, "circles"), 4);
    EXPECT_EQ(observe(state, "circles_captured"), 2);
    EXPECT_EQ(observe(state, "circles_escaping"), 1);
    EXPECT_EQ(observe(state, "circles_decided"), 1);
    EXPECT_EQ(observe(state, "circle.radius"), 0.9);
    EXPECT_EQ(observe(state, "circle.x"), 0);
    state = after("preset: julia");
    EXPECT_EQ(observe(state, "circles_captured"), 0);
    EXPECT_TRUE(std::isnan(observe(state, "circle.radius")));
    EXPECT_TRUE(std::isnan(observe(after("preset: henon\ncircle: 0, 0, 1"), "circles_captured")));
}

TEST(Measure, AShapesDistanceAndItsMean) {
    // φ = |z| - 1, the same all along each circle.
    const Workspace state = disc("point: 1.2, 0.9");
    EXPECT_NEAR(observe(state, "phi"), 0.5, 1e-12);
    EXPECT_NEAR(observe(state, "mean_phi"), 0.5, 1e-12);
    // The shape moves against the origin.
    EXPECT_NEAR(observe(disc("point: 1.2, 0.9\nshift: 1.2, 0.9"), "phi"), -1, 1e-12);
    EXPECT_EQ(observe(state, "corners"), 0);
    EXPECT_TRUE(std::isnan(observe(after("preset: julia"), "phi")));
}

TEST(Measure, HowWellASetFillsItsShape) {
    // r̂ = e^{4(|z| - 1)} crosses |z| at |z| = 1: what begins within stays, what begins beyond
    // leaves, so the set is the disc itself, but for orbits too near the border to leave within N.
    const Workspace state = disc("iterations: 60");
    EXPECT_NEAR(observe(state, "shape_share"), std::numbers::pi / 16, 0.01) << "64 x 64 cells";
    EXPECT_GT(observe(state, "fit"), 0.98);
    // e^{4(r - 1)} <= r up to r = 1, but for the step of the radii.
    EXPECT_NEAR(observe(state, "capture_radius"), 1, 0.02);
    // The offset β moves the border outwards, the sign in print inwards.
    EXPECT_LT(observe(disc("iterations: 60\nbeta: 0.2"), "fit"), 0.85);
    EXPECT_LT(observe(disc("iterations: 60\nbeta: 0.2\nas_printed: 1"), "fit"), 0.85);
}

TEST(Measure, AnOutlineIsMeasuredAtOnce) {
    const Workspace state = disc("shape: polygon(-1, -1, 1, -1, 1, 1, -1, 1)\npoint: 0.5, 0");
    EXPECT_EQ(observe(state, "corners"), 4);
    // The square fills a quarter of the picture; its grid has 64 nodes along three of its sides.
    EXPECT_NEAR(observe(state, "shape_share"), 0.25, 0.02);
    EXPECT_NEAR(observe(state, "phi"), -0.5, 0.03);
}

TEST(Measure, AnAverageOverMaps) {
    // In a disc the modulus alone decides: all members agree.
    const std::string averaged =
        "preset: averaged-star\nviews: 1\nshape: disc(1)\nensemble.count: 50\n";
    EXPECT_EQ(observe(after(averaged + "point: 0.5, 0"), "mean_membership"), 1);
    EXPECT_EQ(observe(after(averaged + "point: 0, 1.5"), "mean_membership"), 0);
    EXPECT_EQ(observe(after(averaged), "members"), 50);
    EXPECT_EQ(observe(disc(), "members"), 0);
    EXPECT_TRUE(std::isnan(observe(disc(), "mean_membership")));
}

}  // namespace
}  // namespace versorium
