// SPDX-License-Identifier: MIT
// Roots under the hand, roots at random, the sheet of candidates, product and sum.
#include "ui/session/versor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/ensemble.h"
#include "ui/controls/controls.h"
#include "ui/dialogs/dialogs.h"
#include "ui/headless_gui.h"
#include "ui/keyboard.h"
#include "ui/session/root_edit.h"
#include "ui/session/state_plane.h"

namespace versorium {
namespace {

constexpr float kViewSide = 600;

// One view of starting points that fills a square, with the pointer's work on it.
struct RootStudio {
    SilentHost host;
    HeadlessGui gui{{kViewSide, kViewSide}};
    StudioContext context{host};
    int view = 1;

    explicit RootStudio(const char* map) {
        host.still = true;
        context.newMap(map);
        context.player.animation.running = false;
        // The ring is not in the way.
        for (const char* name : {"z.re", "q.w"})
            if (numberNamed(context.workspace.views[0], name))
                context.edit([&](Workspace& w) { setSharedNumber(w, name, 0.5); });
        context.record();
        frames(3);
    }
    void frames(int count = 1) {
        for (int k = 0; k < count; ++k)
            gui.frame([&] { drawView(context, view, {0, 0}, {kViewSide, kViewSide}); });
    }
    const Scene& scene() const { return context.workspace.views[static_cast<std::size_t>(view)]; }
    ViewPlane plane() const {
        return {
            {0, 0}, {kViewSide, kViewSide}, viewportOf(scene(), {int(kViewSide), int(kViewSide)})};
    }
    ImVec2 placeOf(const RootRef& ref) const {
        const auto place = placeOfRoot(scene(), rootAt(context.workspace, ref));
        const auto [u, v] = statePlaneOf(scene())->coordinates(place);
        return plane().at(u, v);
    }
    void move(ImVec2 at) {
        ImGui::GetIO().AddMousePosEvent(at.x, at.y);
        frames(2);
    }
    void button(bool down, int which = 0) {
        ImGui::GetIO().AddMouseButtonEvent(which, down);
        frames();
    }
    void drag(ImVec2 from, ImVec2 to) {
        move(from);
        button(true);
        move(to);
        button(false);
    }
    void wheel(float steps) {
        ImGui::GetIO().AddMouseWheelEvent(0, steps);
        frames(2);
    }
    const std::vector<RootList::Root>& roots() const {
        return context.workspace.views[0].lists.at("roots").roots;
    }
};

TEST(RootMarks, AreDraggedInAllViewsAtOnce) {
    RootStudio studio("shape-modulus-complex-rational");
    const RootRef ref{"roots", 1};
    const auto before = studio.roots()[1].q;
    const double height = studio.scene().slice.height;
    const ImVec2 at = studio.placeOf(ref);
    studio.drag({at.x + 3, at.y - 2}, {at.x + 63, at.y - 32});
    const double unit = height / kViewSide;
    for (const Scene& scene : studio.context.workspace.views) {
        EXPECT_NEAR(scene.lists.at("roots").roots[1].q[0], before[0] + 60 * unit, 1e-5);
        EXPECT_NEAR(scene.lists.at("roots").roots[1].q[1], before[1] + 30 * unit, 1e-5);
    }
    EXPECT_EQ(studio.scene().slice.centre[0], 0) << "the view itself stays";
    EXPECT_EQ(studio.context.versor.chosen, ref);
    studio.context.record();
    studio.context.undo();
    EXPECT_EQ(studio.roots()[1].q, before);
}

// The origin of the system shifts the shape and the roots together.
TEST(RootMarks, LieWhereTheShiftTakesThem) {
    RootStudio studio("shape-modulus-complex-rational");
    studio.context.edit([&](Workspace& w) { setSharedNumber(w, "shift.re", 0.1); });
    studio.frames(2);
    const auto before = studio.roots()[2].q;
    const auto place = placeOfRoot(studio.scene(), studio.roots()[2]);
    EXPECT_NEAR(place[0], before[0] + 0.1, 1e-15);
    const ImVec2 at = studio.placeOf({"roots", 2});
    studio.drag(at, {at.x + 50, at.y});
    EXPECT_NEAR(studio.roots()[2].q[0], before[0] + 50 * studio.scene().slice.height / kViewSide,
                1e-5);
    EXPECT_NEAR(studio.roots()[2].q[1], before[1], 1e-6);
}

// In a slice along j and k the hand moves these two components and no other.
TEST(RootMarks, MoveAlongTheAxesOfAQuaternionSlice) {
    RootStudio studio("shape-modulus");
    studio.context.edit([](Workspace& w) {
        w.views[1].slice.axes = {{{{"q.y", 1.0}}}, {{{"q.x", 1.0}}}};
    });
    studio.frames(2);
    const auto before = studio.roots()[3].q;
    const ImVec2 at = studio.placeOf({"roots", 3});
    studio.drag(at, {at.x + 30, at.y - 60});
    const double unit = studio.scene().slice.height / kViewSide;
    const auto after = studio.roots()[3].q;
    EXPECT_EQ(after[0], before[0]);
    EXPECT_NEAR(after[1], before[1] + 60 * unit, 1e-5);
    EXPECT_NEAR(after[2], before[2] + 30 * unit, 1e-5);
    EXPECT_EQ(after[3], before[3]);
}

TEST(RootMarks, TheWheelRaisesPowersAndZoomsElsewhere) {
    RootStudio studio("complex-rational");
    const double height = studio.scene().slice.height;
    studio.move(studio.placeOf({"roots", 1}));
    studio.wheel(1);
    studio.wheel(1);
    EXPECT_EQ(studio.roots()[1].power, 3);
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Shift, true);
    studio.wheel(-1);
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Shift, false);
    EXPECT_EQ(studio.roots()[1].power, 2.9);
    EXPECT_EQ(studio.scene().slice.height, height);
    studio.move({40, 40});
    studio.frames(3);
    studio.wheel(1);
    EXPECT_LT(studio.scene().slice.height, height);
}

TEST(RootMarks, ADoubleClickAddsDeleteAndTheMenuTakeAway) {
    RootStudio studio("shape-modulus-complex-rational");
    const double height = studio.scene().slice.height;
    ASSERT_EQ(studio.roots().size(), 4u);
    studio.move({420, 480});
    for (int k = 0; k < 2; ++k) studio.button(true), studio.button(false);
    ASSERT_EQ(studio.roots().size(), 5u);
    EXPECT_EQ(studio.scene().slice.height, height) << "it does not zoom";
    EXPECT_NEAR(studio.roots()[4].q[0], studio.plane().u(420), 1e-6);
    EXPECT_NEAR(studio.roots()[4].q[1], studio.plane().v(480), 1e-6);
    EXPECT_EQ(studio.roots()[4].power, 1);
    // A second double click there meets the root.
    for (int k = 0; k < 2; ++k) studio.button(true), studio.button(false);
    EXPECT_EQ(studio.roots().size(), 5u);
    const auto keys = [&] {
        studio.gui.frame([&] {
            handleKeys(studio.context);
            drawView(studio.context, 1, {0, 0}, {kViewSide, kViewSide});
        });
    };
    keys();
    ImGui::GetIO().AddKeyEvent(ImGuiKey_Delete, true);
    keys();
    ImGui::GetIO().AddKeyEvent(ImGuiKey_Delete, false);
    keys();
    EXPECT_EQ(studio.roots().size(), 4u);
    studio.move(studio.placeOf({"roots", 2}));
    studio.button(true, 1);
    studio.button(false, 1);
    EXPECT_EQ(studio.context.versor.chosen, (RootRef{"roots", 2}));
    EXPECT_EQ(ImGui::GetCurrentContext()->OpenPopupStack.Size, 1) << "the root's menu";
    // Hidden roots are not in the way.
    studio.context.edit([&](Workspace& w) { w.showRoots = false; });
    const auto before = studio.roots()[1].q;
    const ImVec2 at = studio.placeOf({"roots", 1});
    studio.drag(at, {at.x + 40, at.y});
    EXPECT_EQ(studio.roots()[1].q, before);
}

TEST(Roots, ThatAPictureNeedsStay) {
    SilentHost host;
    StudioContext context(host);
    context.newMap("complex-rational");
    Workspace workspace = context.workspace;
    workspace.views[0].slice.axes[0].terms = {{"roots[2].re", 1.0}};
    EXPECT_FALSE(removeRoot(workspace, {"roots", 1}).ok());
    EXPECT_FALSE(removeRoot(workspace, {"roots", 2}).ok());
    EXPECT_TRUE(removeRoot(workspace, {"roots", 3}).ok());
    EXPECT_FALSE(setRootList(workspace, "roots", {}).ok());
    ASSERT_TRUE(workspaceFromJson(workspaceToJson(workspace)).ok());
    // With as many roots as before every name stays good.
    RootList other = workspace.views[0].lists.at("roots");
    other.roots[0].power = 5;
    EXPECT_TRUE(setRootList(workspace, "roots", other).ok());
}

TEST(Roots, TurnIntoPolesAndBack) {
    SilentHost host;
    StudioContext context(host);
    context.newMap("quaternion-rational");
    Workspace workspace = context.workspace;
    const RootList::Root root = rootAt(workspace, {"roots", 1});
    const Expected<RootRef> pole = turnRoot(workspace, {"roots", 1});
    ASSERT_TRUE(pole.ok());
    EXPECT_EQ(*pole, (RootRef{"poles", 0}));
    EXPECT_EQ(rootAt(workspace, *pole), root);
    EXPECT_EQ(exponentOf(workspace, *pole), -root.power);
    context.newMap("quaternion-interleaved");
    workspace = context.workspace;
    EXPECT_EQ(*turnRoot(workspace, {"factors", 0}), (RootRef{"factors", 0}));
    EXPECT_LT(exponentOf(workspace, {"factors", 0}), 0);
}

TEST(Versor, SumAndProductTakeEachOthersPlace) {
    SilentHost host;
    StudioContext context(host);
    for (const char* name : {"complex-rational", "quaternion-rational", "shape-modulus",
                             "shape-modulus-complex-rational"}) {
        context.newMap(name);
        const Workspace& workspace = context.workspace;
        context.edit([](Workspace& w) {
            if (mapOf(w.views[0]).info.field) {
                setSharedNumber(w, "alpha", 11);
                for (Scene& scene : w.views) scene.shape.source = "star(5, 0.5, 0.2)";
            }
            w.views[1].slice.height = 0.7;
        });
        const Json before = workspaceToJson(workspace);
        context.edit([](Workspace& w) { takeRootSum(w, true); });
        EXPECT_TRUE(isRootSum(workspace.views[0].map)) << name;
        ASSERT_TRUE(workspaceFromJson(workspaceToJson(workspace)).ok());
        EXPECT_TRUE(context.bound.orbitProgram());
        context.edit([](Workspace& w) { takeRootSum(w, false); });
        EXPECT_EQ(workspaceToJson(workspace), before) << name;
    }
    EXPECT_EQ(sumOrProductOf("quadratic"), "");
}

// The panel, the command line and a sheet all draw the same roots for a seed.
TEST(Versor, DrawsTheSeedsRootsInTheBoxOfTheShape) {
    SilentHost host;
    StudioContext context(host);
    context.newMap("shape-modulus-complex-rational");
    context.edit([&](Workspace& w) {
        for (Scene& scene : w.views) scene.shape.source = "box(0.4, 0.2)";
    });
    context.versor.draw.options.least = context.versor.draw.options.most = 7;
    drawRoots(context, 5);
    const auto& roots = context.workspace.views[0].lists.at("roots");
    ASSERT_EQ(roots.roots.size(), 7u);
    EXPECT_EQ(context.workspace.views[1].lists.at("roots"), roots);
    for (const auto& root : roots.roots) {
        // The box of an analytic shape is larger than the least one by about 1/16.
        EXPECT_LE(std::abs(root.q[0]), 0.4 * 1.15);
        EXPECT_LE(std::abs(root.q[1]), 0.2 * 1.3);
        EXPECT_EQ(root.q[2], 0);
    }
    Scene scene = context.workspace.views[1];
    scene.ensemble.roots.emplace();
    scene.ensemble.roots->draw.least = scene.ensemble.roots->draw.most = 7;
    Job job(1);
    const auto program = context.bound.binder().bind(scene, job);
    ASSERT_TRUE(program.ok());
    EXPECT_EQ(randomRoots(program->ensemble->roots, 5), roots);
    // Fig 11: another shape, the same d.
    context.edit([&](Workspace& w) {
        for (Scene& one : w.views) one.shape.source = "disc(0.3)";
    });
    EXPECT_EQ(context.workspace.views[0].lists.at("roots").roots.size(), 7u);
    context.versor.draw.options.lowPower = 0.2;
    context.versor.draw.options.highPower = 0.8;
    drawRoots(context, 6);
    EXPECT_NE(context.notices.last().find("whole number"), std::string::npos)
        << context.notices.last();
    EXPECT_EQ(context.workspace.views[0].lists.at("roots").roots.size(), 7u);
}

TEST(ContactSheet, AsksForItsPicturesOneByOneAndIsPickedByKeys) {
    SilentHost host;
    HeadlessGui gui;
    StudioContext context(host);
    context.newMap("shape-modulus-complex-rational");
    context.record();
    openContactSheet(context, 10);
    ASSERT_TRUE(context.dialogs.candidates);
    ASSERT_EQ(context.sheet.candidates.size(), 6u);
    const auto dialog = [&] { drawDialogs(context); };
    const auto press = [&](ImGuiKey key) {
        for (const bool down : {true, false}) {
            ImGui::GetIO().AddKeyEvent(key, down);
            gui.frame(dialog);
        }
    };
    for (int k = 0; k < 3; ++k) gui.frame(dialog);
    ASSERT_EQ(host.requests.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<ThumbnailJob>(host.requests[0].job));
    const Expected<Json> asked = parseJson(host.requests[0].scene);
    ASSERT_TRUE(asked.ok());
    const Expected<Scene> scene = sceneFromJson(*asked);
    ASSERT_TRUE(scene.ok()) << scene.status().message();
    EXPECT_EQ(scene->lists.at("roots"), context.sheet.candidates[0].roots);
    // An answer that is none of the sheet's goes to the gallery.
    WorkAnswer answer = answerTo(1, host.requests[0].job);
    answer.message = "no picture";
    EXPECT_FALSE(takeCandidate(context, answer));
    answer.id = host.requests[0].id;
    EXPECT_TRUE(takeCandidate(context, answer));
    for (int k = 0; k < 2; ++k) gui.frame(dialog);
    EXPECT_EQ(host.requests.size(), 2u);
    press(ImGuiKey_RightArrow);
    press(ImGuiKey_DownArrow);
    EXPECT_EQ(context.sheet.at, 4);
    const RootList wanted = context.sheet.candidates[4].roots;
    press(ImGuiKey_Enter);
    EXPECT_FALSE(context.dialogs.candidates);
    EXPECT_EQ(context.workspace.views[0].lists.at("roots"), wanted);
    EXPECT_EQ(context.versor.draw.seed, 14);
    context.record();
    context.undo();
    EXPECT_EQ(context.workspace.views[0].lists.at("roots").roots.size(), 4u);
}

// A formula that is typed takes the place of d; the shape and its numbers stay.
TEST(Versor, OfATypedFormulaKeepsTheShape) {
    SilentHost host;
    StudioContext context(host);
    context.newMap("shape-modulus-quadratic");
    context.edit([&](Workspace& w) {
        for (Scene& scene : w.views) scene.shape.source = "star(5, 0.5, 0.2)";
    });
    context.edit([&](Workspace& w) { setSharedNumber(w, "alpha", 12); });
    ASSERT_TRUE(applyFormula(context, "shape(z^3 + c)").ok());
    const Scene& scene = context.workspace.views[1];
    EXPECT_EQ(scene.shape.source, "star(5, 0.5, 0.2)");
    EXPECT_EQ(scene.parameters.at("alpha")[0], 12);
    EXPECT_EQ(scene.iterations, 3);
    EXPECT_TRUE(context.bound.orbitProgram());
    const Expected<Workspace> again = workspaceFromLink(*workspaceToLink(context.workspace));
    ASSERT_TRUE(again.ok()) << again.status().message();
    EXPECT_EQ(again->views[1].shape, scene.shape);
    // Without a shape it is another kind of picture, with steps of its own.
    ASSERT_TRUE(applyFormula(context, "z^3 + c").ok());
    EXPECT_EQ(context.workspace.views[1].iterations, 200);
}

TEST(Versor, IsInTheListOfControls) {
    SilentHost host;
    StudioContext context(host);
    context.newMap("shape-modulus-complex-rational");
    ASSERT_TRUE(setControl(context, "roots[1].re", "0.125"));
    EXPECT_EQ(context.workspace.views[1].lists.at("roots").roots[1].q[0], 0.125);
    ASSERT_TRUE(setControl(context, "roots[1].power", "2.5"));
    ASSERT_TRUE(setControl(context, "add root", "poles"));
    EXPECT_EQ(context.workspace.views[0].lists.at("poles").roots.size(), 1u);
    ASSERT_TRUE(setControl(context, "roots[0].remove", ""));
    EXPECT_EQ(context.workspace.views[0].lists.at("roots").roots[0].power, 2.5);
    ASSERT_TRUE(setControl(context, "versor from", "sum"));
    EXPECT_EQ(context.workspace.views[0].map, "shape-modulus-complex-root-sum");
    ASSERT_TRUE(setControl(context, "random seed", "12"));
    ASSERT_TRUE(setControl(context, "draw roots", ""));
    EXPECT_EQ(context.workspace.views[0].lists.at("roots").roots.size(), 10u);
    ASSERT_TRUE(setControl(context, "show_roots", "off"));
    const Expected<std::string> link = workspaceToLink(context.workspace);
    ASSERT_TRUE(link.ok());
    EXPECT_FALSE(workspaceFromLink(*link)->showRoots);
}

}  // namespace
}  // namespace versorium
