// SPDX-License-Identifier: MIT
#include "ui/session/motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ui/headless_gui.h"
#include "ui/marks/mark.h"
#include "ui/session/view_plane.h"

namespace versorium {
namespace {

void place(StudioContext& context) {
    for (int k = 0; k < 2; ++k) {
        ViewState& view = context.views[static_cast<std::size_t>(k)];
        view.low = {400.0f * static_cast<float>(k), 0};
        view.high = {400.0f * static_cast<float>(k) + 400, 600};
    }
}

ViewPlane planeOf(const StudioContext& context, std::size_t view) {
    const ViewState& state = context.views[view];
    return {state.low, state.high, viewportOf(context.workspace.views[view], {400, 600})};
}

// The point at the pointer stands still all the way of an eased zoom, and it ends exactly.
TEST(Motion, AnEasedZoomKeepsItsPoint) {
    const SliceSpec from = sceneOf(*findMap("quadratic")).slice;
    const SliceSpec to = zoomed(from, 0.01, 0.3, -0.7);
    double last = from.height;
    for (int k = 0; k <= 20; ++k) {
        const SliceSpec now = between(from, to, k / 20.0);
        EXPECT_LE(now.height, last);
        last = now.height;
        // In units of the view's height; 1e-12 is rounding.
        EXPECT_NEAR((0.3 - now.centre[0]) / now.height, (0.3 - from.centre[0]) / from.height,
                    1e-12);
        EXPECT_NEAR((-0.7 - now.centre[1]) / now.height, (-0.7 - from.centre[1]) / from.height,
                    1e-12);
    }
    EXPECT_EQ(between(from, to, 1), to);
    EXPECT_EQ(between(from, to, 0).height, from.height);
}

TEST(Motion, AZoomByKeysTakes120Milliseconds) {
    SilentHost host;
    StudioContext context(host);
    const double before = context.workspace.views[0].slice.height;
    context.zoom(0, 0.5, 0, 0, true);
    // Another one on the way goes on from where the first one leads.
    host.time = 0.05;
    EXPECT_TRUE(context.glide());
    EXPECT_LT(context.workspace.views[0].slice.height, before);
    EXPECT_GT(context.workspace.views[0].slice.height, before / 2);
    context.zoom(0, 0.5, 0, 0, true);
    host.time = 0.05 + 1.01 * kGlideSeconds;
    EXPECT_FALSE(context.glide());
    EXPECT_DOUBLE_EQ(context.workspace.views[0].slice.height, before / 4);
}

TEST(Motion, ReducedMotionJumps) {
    SilentHost host;
    host.still = true;
    StudioContext context(host);
    const double before = context.workspace.views[0].slice.height;
    context.zoom(0, 0.5, 0, 0, true);
    EXPECT_FALSE(context.gliding());
    EXPECT_DOUBLE_EQ(context.workspace.views[0].slice.height, before / 2);
    context.home(0);
    EXPECT_FALSE(context.gliding());
}

TEST(Motion, UndoLeavesNothingOnItsWay) {
    SilentHost host;
    StudioContext context(host);
    const Json before = workspaceToJson(context.workspace);
    context.zoom(0, 0.5, 0, 0, true);
    host.time = 0.03;
    context.glide();
    context.undo();
    host.time = 1;
    EXPECT_FALSE(context.glide());
    EXPECT_EQ(workspaceToJson(context.workspace), before);
}

// What lies under the two fingers stays under them; and the ring stays where it is, even where they
// begin on it.
TEST(Motion, TwoFingersMoveTheViewAndNotTheRing) {
    SilentHost host;
    StudioContext context(host);
    place(context);
    const auto ring = markerOf(context.workspace, 1);
    ImVec2 middle = planeOf(context, 1).at(ring[0], ring[1]);
    const double height = context.workspace.views[1].slice.height;
    const Json parameters = workspaceToJson(context.workspace)["point"];
    // A finger has begun to drag the ring.
    context.views[1].drag = {.mark = &ringMark, .move = [](const ViewFrame&) {}};
    for (int k = 0; k < 10; ++k) {
        const ImVec2 next{middle.x + 4, middle.y - 3};
        const double u = planeOf(context, 1).u(middle.x), v = planeOf(context, 1).v(middle.y);
        ASSERT_TRUE(context.pinch(middle, next, 1.1));
        // Pixels are floats.
        EXPECT_NEAR(planeOf(context, 1).u(next.x), u, 1e-6);
        EXPECT_NEAR(planeOf(context, 1).v(next.y), v, 1e-6);
        middle = next;
    }
    EXPECT_EQ(context.views[1].drag.mark, nullptr);
    EXPECT_FALSE(context.views[1].drag.move);
    EXPECT_EQ(workspaceToJson(context.workspace)["point"], parameters);
    EXPECT_NEAR(context.workspace.views[1].slice.height, height / std::pow(1.1, 10), 1e-9);
    EXPECT_FALSE(context.pinch({900, 100}, {900, 110}, 1));
    EXPECT_FALSE(context.pinch({100, 100}, {100, 110}, 0));
}

}  // namespace
}  // namespace versorium
