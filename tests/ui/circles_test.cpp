// SPDX-License-Identifier: MIT
// Circles on planes of starting points: their fate is that of the radial map where the direction is
// the identity, and what is certain holds for any direction.
#include "ui/session/circles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/system_of.h"
#include "ui/controls/controls.h"
#include "ui/headless_gui.h"
#include "ui/session/view_plane.h"

namespace versorium {
namespace {

// A disc of radius 0.5 whose modulus pulls inwards within and pushes outwards beyond it.
StudioContext& discStudio(StudioContext& context) {
    context.newMap("shape-modulus-complex-rational");
    context.edit([](Workspace& w) {
        for (Scene& scene : w.views) {
            scene.shape.source = "disc(0.5)";
            scene.iterations = 40;
            // One simple root at 0: d is the identity's direction.
            scene.lists.at("roots").roots = {{{0, 0, 0, 0}, 1}};
        }
    });
    context.edit([&](Workspace& w) { setSharedNumber(w, "alpha", 3); });
    context.edit([&](Workspace& w) { setSharedNumber(w, "beta", 0.3); });
    return context;
}

TEST(Circles, FollowTheRadialMapWhereTheDirectionIsTheIdentity) {
    SilentHost host;
    StudioContext context(host);
    discStudio(context);
    // r -> e^{3 (r - 0.5 - 0.3)}: its larger fixed point, 0.66, parts what stays from what leaves.
    for (const double radius : {0.05, 0.2, 0.35, 0.5, 0.8, 1.5, 3.0}) {
        context.edit([&](Workspace& w) { w.circles = {{{}, radius}}; });
        double r = radius;
        for (int n = 0; n < 40 && r <= 20; ++n) r = std::exp(3 * (r - 0.8));
        const auto& all = studyCircles(context, 1);
        ASSERT_EQ(all.size(), 1u);
        EXPECT_EQ(all[0].fate, r <= 20 ? CircleFate::captured : CircleFate::escapes) << radius;
        EXPECT_TRUE(all[0].oneModulus) << radius;
        EXPECT_NEAR(all[0].most, std::exp(3 * (radius - 0.8)), 1e-12 * all[0].most);
    }
}

// Whatever is said to be certain is so for other roots as well.
TEST(Circles, WhatIsCertainHoldsForEveryVersor) {
    SilentHost host;
    StudioContext context(host);
    discStudio(context);
    context.edit([](Workspace& w) {
        for (Scene& scene : w.views) {
            scene.shape.source = "star(5, 1.4, 0.7)";
            scene.iterations = 12;
        }
    });
    context.edit([&](Workspace& w) { setSharedNumber(w, "alpha", 4); });
    context.edit([&](Workspace& w) { setSharedNumber(w, "beta", 0); });
    int certain = 0, decided = 0;
    for (int seed = 1; seed <= 8; ++seed) {
        drawRoots(context, seed);
        for (const double radius : {0.1, 0.3, 0.5, 0.8, 1.0, 1.2, 2.0, 5.0}) {
            context.edit([&](Workspace& w) { w.circles = {{{}, radius}}; });
            const CircleStudy study = studyCircles(context, 1)[0];
            certain += study.certain ? 1 : 0;
            decided += study.fate == CircleFate::decided ? 1 : 0;
            if (!study.certain) continue;
            EXPECT_NE(study.fate, CircleFate::decided) << radius;
            EXPECT_EQ(study.fate == CircleFate::captured, radius <= studyBasins(context).capture);
        }
    }
    EXPECT_GT(certain, 0);
    EXPECT_GT(decided, 0) << "the versor has something to decide somewhere";
}

// The arrows step along the orbit: from f(x) to f²(x) and on, each being f of its beginning.
TEST(Circles, ArrowsStepAlongTheOrbit) {
    SilentHost host;
    StudioContext context(host);
    discStudio(context);
    drawRoots(context, 3);
    context.edit([&](Workspace& w) { w.circles = {{{0.1, 0.05, 0, 0}, 0.2}}; });
    const CircleStudy first = studyCircles(context, 1)[0];
    context.stepOrbit(1);
    const CircleStudy second = studyCircles(context, 1)[0];
    ASSERT_EQ(second.from.size(), first.from.size());
    EXPECT_EQ(second.from, first.to);
    const auto system = shownSystem(context);
    ASSERT_TRUE(system);
    auto at = second.from[7];
    system->step(at.data());
    EXPECT_EQ(at, second.to[7]);
}

TEST(Circles, LieInTheSliceOfAQuaternionMap) {
    SilentHost host;
    StudioContext context(host);
    context.newMap("shape-modulus");
    context.edit([](Workspace& w) {
        w.views[1].slice.axes = {{{{"q.x", 1.0}}}, {{{"q.y", 1.0}}}};
    });
    context.edit([&](Workspace& w) { w.circles = {{{0.1, 0, 0, 0.05}, 0.3}}; });
    const auto& all = studyCircles(context, 1);
    ASSERT_EQ(all.size(), 1u);
    for (const auto& x : all[0].from) {
        EXPECT_EQ(x[0], 0.1);
        EXPECT_EQ(x[3], 0.05);
        EXPECT_NEAR(std::hypot(x[1], x[2]), 0.3, 1e-15);
    }
}

TEST(Circles, AreDroppedDraggedUndoneAndSaved) {
    SilentHost host;
    HeadlessGui gui({600, 600});
    StudioContext context(host);
    host.still = true;
    discStudio(context);
    context.edit([&](Workspace& w) { w.showRoots = false; });
    context.edit([&](Workspace& w) { setSharedNumber(w, "z.re", 0.5); });
    context.record();
    dropCircle(context);
    ASSERT_EQ(context.workspace.circles.size(), 1u);
    EXPECT_EQ(context.workspace.circles[0].radius, 0.5) << "through the orbit's point";
    context.edit([&](Workspace& w) { setSharedNumber(w, "z.re", 0.1); });
    context.edit([&](Workspace& w) { w.circles[0].radius = 0.3; });
    context.record();
    const auto view = [&] { drawView(context, 1, {0, 0}, {600, 600}); };
    for (int k = 0; k < 3; ++k) gui.frame(view);
    const Scene& scene = context.workspace.views[1];
    const auto plane = [&] { return ViewPlane{{0, 0}, {600, 600}, viewportOf(scene, {600, 600})}; };
    const auto drag = [&](ImVec2 from, ImVec2 to) {
        ImGuiIO& io = ImGui::GetIO();
        io.AddMousePosEvent(from.x, from.y);
        gui.frame(view);
        gui.frame(view);
        io.AddMouseButtonEvent(0, true);
        gui.frame(view);
        io.AddMousePosEvent(to.x, to.y);
        gui.frame(view);
        io.AddMouseButtonEvent(0, false);
        gui.frame(view);
    };
    drag(plane().at(0, 0.3), plane().at(0, 0.45));
    EXPECT_NEAR(context.workspace.circles[0].radius, 0.45, 1e-3);
    drag(plane().at(0, 0), plane().at(-0.2, 0.1));
    EXPECT_NEAR(context.workspace.circles[0].centre[0], -0.2, 1e-3);
    EXPECT_NEAR(context.workspace.circles[0].radius, 0.45, 1e-3);
    drag(plane().at(-0.2, 0.1), plane().at(0.001, 0.001));
    EXPECT_EQ(context.workspace.circles[0].centre[0], 0) << "it snaps to 0";
    context.record();
    const Expected<Workspace> again = workspaceFromLink(*workspaceToLink(context.workspace));
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->circles, context.workspace.circles);
    context.undo();
    EXPECT_EQ(context.workspace.circles[0].radius, 0.3);
    for (int k = 0; k < 20; ++k) dropCircle(context);
    EXPECT_EQ(context.workspace.circles.size(), kMostCircles);
    Json wrong = workspaceToJson(context.workspace);
    wrong["circles"].push_back({{"center", {0, 0, 0, 0}}, {"radius", 1}});
    EXPECT_FALSE(workspaceFromJson(wrong).ok());
    wrong["circles"] = {{{"center", {0, 0, 0, 0}}, {"radius", -1}}};
    EXPECT_FALSE(workspaceFromJson(wrong).ok());
}

TEST(Circles, AreSpokenOfInWords) {
    SilentHost host;
    StudioContext context(host);
    discStudio(context);
    ASSERT_TRUE(setControl(context, "drop circle", ""));
    ASSERT_TRUE(setControl(context, "circles[0].radius", "0.1"));
    EXPECT_NE(describeView(context, 1).find("Circle 1: captured"), std::string::npos)
        << describeView(context, 1);
    ASSERT_TRUE(setControl(context, "circles[0].radius", "3"));
    EXPECT_NE(describeView(context, 1).find("Circle 1: escapes"), std::string::npos)
        << describeView(context, 1);
    ASSERT_TRUE(setControl(context, "circles[0].remove", ""));
    EXPECT_TRUE(context.workspace.circles.empty());
    context.newMap("logistic");
    dropCircle(context);
    EXPECT_TRUE(context.workspace.circles.empty()) << "the line has no circles";
}

// A map whose numbers are no good leaves well-defined circles.
TEST(Circles, OfExtremeMapsAreDefined) {
    SilentHost host;
    HeadlessGui gui({300, 300});
    StudioContext context(host);
    discStudio(context);
    context.edit([&](Workspace& w) { setSharedNumber(w, "alpha", 1e9); });
    context.edit([&](Workspace& w) { w.circles = {{{}, 0.3}, {{1e5, 0, 0, 0}, 1e6}}; });
    context.edit([&](Workspace& w) { w.basins = true; });
    for (int k = 0; k < 3; ++k) gui.frame([&] { drawView(context, 1, {0, 0}, {300, 300}); });
    EXPECT_EQ(studyCircles(context, 1).size(), 2u);
}

}  // namespace
}  // namespace versorium
