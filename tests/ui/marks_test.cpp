// SPDX-License-Identifier: MIT
// The table of marks: which of several under the pointer is taken, and each kind moved by a drag.
#include "ui/marks/mark.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "ui/headless_gui.h"
#include "ui/session/state_plane.h"
#include "ui/session/view_plane.h"

namespace versorium {
namespace {

constexpr float kSide = 600;

// One view that fills a square, under a pointer.
struct HandOnView {
    SilentHost host;
    HeadlessGui gui{{kSide, kSide}};
    StudioContext context{host};
    int view = 1;

    void open(Workspace workspace) {
        host.still = true;
        context.open(std::move(workspace));
        context.player.animation.running = false;
        context.record();
        frames(3);
    }
    void openMap(const char* map) { open(workspaceOf(sceneOf(*findMap(map)))); }
    void openPreset(const char* preset) { open(workspaceOf(*presetNamed(preset))); }
    void frames(int count = 1) {
        for (int k = 0; k < count; ++k)
            gui.frame([&] { drawView(context, view, {0, 0}, {kSide, kSide}); });
    }
    void changed() {
        context.record();
        frames(2);
    }
    const Scene& scene() const { return context.workspace.views[static_cast<std::size_t>(view)]; }
    const Drag& drag() const { return context.views[static_cast<std::size_t>(view)].drag; }
    ViewPlane plane() const {
        return {{0, 0}, {kSide, kSide}, viewportOf(scene(), {int(kSide), int(kSide)})};
    }
    ImVec2 at(double u, double v) const { return plane().at(u, v); }
    ImVec2 ring() const {
        const auto place = markerOf(context.workspace, static_cast<std::size_t>(view));
        return at(place[0], place[1]);
    }
    void move(ImVec2 to) {
        ImGui::GetIO().AddMousePosEvent(to.x, to.y);
        frames(2);
    }
    void button(bool down, int which = 0) {
        ImGui::GetIO().AddMouseButtonEvent(which, down);
        frames();
    }
    // What a press there takes; let go of at the same place.
    const Mark* takenAt(ImVec2 place) {
        move(place);
        button(true);
        const Mark* taken = drag().mark;
        button(false);
        // So that the next press is no double click.
        move({2, kSide - 2});
        for (int k = 0; k < 30; ++k) frames();
        return taken;
    }
    // From a press to its end: the mark that followed the pointer by 50 pixels to the right and 30
    // up.
    const Mark* dragFrom(ImVec2 place) {
        move(place);
        host.announced.clear();
        button(true);
        const Mark* taken = drag().mark;
        move({place.x + 50, place.y - 30});
        button(false);
        EXPECT_TRUE(drag().idle());
        return taken;
    }
    double unit() const { return scene().slice.height / kSide; }
    // The pointer stands on whole pixels, where it is pressed and where it goes to.
    double near() const { return 1.01 * unit(); }
};

// A complex map with one root, one circle and the ring, all apart.
void openCircleAndRoot(HandOnView& hand) {
    hand.openMap("shape-modulus-complex-rational");
    hand.context.edit([](Workspace& workspace) {
        for (Scene& scene : workspace.views)
            scene.lists.at("roots").roots = {{{0.4, 0.4, 0, 0}, 1}};
        workspace.circles = {{{}, 0.3}};
        workspace.point = {-0.45, -0.45};
    });
    hand.changed();
}

TEST(MarkTable, ListsEachKindOnceInBothOrders) {
    const auto byHand = marksByHand(), byHeight = marksByHeight();
    const std::set<const Mark*> hand(byHand.begin(), byHand.end());
    EXPECT_EQ(hand.size(), byHand.size());
    EXPECT_EQ(hand, std::set<const Mark*>(byHeight.begin(), byHeight.end()));
    EXPECT_EQ(byHeight.back(), &ringMark);
    for (const Mark* mark : byHand) {
        // What can be met can be taken, and what follows the hand has a name.
        EXPECT_EQ(mark->hit != nullptr, mark->name != nullptr);
        EXPECT_TRUE(!mark->hit || mark->press);
        EXPECT_TRUE(mark->draw || mark->press);
        EXPECT_EQ(mark->openMenu != nullptr, mark->drawMenu != nullptr);
    }
}

// Of marks at one place: the ring itself, then a root, a circle's line, its centre, and the ring
// once more from further away.
TEST(MarkTable, TheHandTakesWhatLiesOnTop) {
    HandOnView hand;
    openCircleAndRoot(hand);
    StudioContext& context = hand.context;
    const double pixel = hand.unit();
    const auto put = [&](double root, double line, double ring) {
        context.edit([&](Workspace& workspace) {
            for (Scene& scene : workspace.views)
                scene.lists.at("roots").roots = {{{0.3 + root * pixel, 0, 0, 0}, 1}};
            workspace.circles = {{{}, 0.3 + line * pixel}};
            workspace.point = {0.3, ring * pixel};
        });
        hand.changed();
    };
    const ImVec2 place = hand.at(0.3, 0);
    put(0, 0, 7);
    EXPECT_EQ(hand.takenAt(place), &ringMark);
    EXPECT_EQ(context.versor.chosen, (RootRef{"roots", 0})) << "chosen, though the ring is held";
    put(9, 0, 13);
    EXPECT_EQ(hand.takenAt(place), &rootMark);
    put(14, 5, 13);
    EXPECT_EQ(hand.takenAt(place), &circleRadiusMark);
    EXPECT_EQ(context.circles.chosen, 0);
    EXPECT_EQ(context.versor.chosen, RootRef{}) << "a press elsewhere lets go of the root";
    put(14, 20, 13);
    EXPECT_EQ(hand.takenAt(place), &ringMark);
    EXPECT_EQ(context.circles.chosen, -1);
    put(14, 20, 20);
    EXPECT_EQ(hand.takenAt(place), nullptr) << "the view itself";
    // Of two circles the one that was dropped last, by whatever part of it is there.
    context.edit([&](Workspace& workspace) {
        workspace.circles = {{{}, 0.3}, {{0.3, 0, 0, 0}, 0.1}};
    });
    hand.changed();
    EXPECT_EQ(hand.takenAt(place), &circleCentreMark);
    EXPECT_EQ(context.circles.chosen, 1);
}

TEST(MarkTable, EachKindFollowsTheHand) {
    HandOnView hand;
    openCircleAndRoot(hand);
    StudioContext& context = hand.context;
    const Workspace& workspace = context.workspace;
    const double right = 50 * hand.unit(), up = 30 * hand.unit();
    EXPECT_EQ(hand.dragFrom(hand.ring()), &ringMark);
    EXPECT_EQ(hand.host.announced, "The ring");
    EXPECT_NEAR(workspace.point[0], -0.45 + right, hand.near());
    EXPECT_NEAR(workspace.point[1], -0.45 + up, hand.near());
    EXPECT_EQ(hand.dragFrom(hand.at(0.4, 0.4)), &rootMark);
    EXPECT_EQ(hand.host.announced, "roots[0]");
    const auto& root = workspace.views[0].lists.at("roots").roots[0].q;
    EXPECT_NEAR(root[0], 0.4 + right, hand.near());
    EXPECT_NEAR(root[1], 0.4 + up, hand.near());
    EXPECT_EQ(hand.dragFrom(hand.at(0.3, 0)), &circleRadiusMark);
    EXPECT_EQ(hand.host.announced, "Circle 1, radius");
    EXPECT_NEAR(workspace.circles[0].radius, std::hypot(0.3 + right, up), hand.near());
    EXPECT_EQ(hand.dragFrom(hand.at(0, 0)), &circleCentreMark);
    EXPECT_EQ(hand.host.announced, "Circle 1, centre");
    EXPECT_NEAR(workspace.circles[0].centre[0], right, hand.near());
    EXPECT_NEAR(workspace.circles[0].centre[1], up, hand.near());
    EXPECT_EQ(hand.scene().slice.centre[0], 0) << "the view has stood still";
    EXPECT_EQ(hand.dragFrom({60, 300}), nullptr);
    EXPECT_NEAR(hand.scene().slice.centre[0], -right, hand.near());
    EXPECT_NEAR(hand.scene().slice.centre[1], -up, hand.near());
}

TEST(MarkTable, StartsOfPlanarSystemsFollowTheHand) {
    HandOnView hand;
    hand.openPreset("nearly-complex");
    StudioContext& context = hand.context;
    const Workspace& workspace = context.workspace;
    context.edit([](Workspace& changed) {
        changed.views[0].criticalStart.reset();
        changed.views[0].start = {0.5, 0.5};
        changed.compared = {-0.5, 0.25};
        changed.point = {-0.8, -0.8};
    });
    hand.changed();
    const double right = 50 * hand.unit(), up = 30 * hand.unit();
    EXPECT_EQ(hand.dragFrom(hand.at(0.5, 0.5)), &startMark);
    EXPECT_EQ(hand.host.announced, "The start p*");
    EXPECT_NEAR(workspace.views[0].start[0], 0.5 + right, hand.near());
    EXPECT_NEAR(workspace.views[0].start[1], 0.5 + up, hand.near());
    EXPECT_EQ(hand.dragFrom(hand.at(-0.5, 0.25)), &comparedMark);
    EXPECT_EQ(hand.host.announced, "The second start");
    EXPECT_NEAR(workspace.compared[0], -0.5 + right, hand.near());
    EXPECT_NEAR(workspace.compared[1], 0.25 + up, hand.near());
    // At one place p* is the one that is taken.
    context.edit([](Workspace& changed) {
        changed.views[0].start = changed.compared = {0.125, 0.125};
    });
    hand.changed();
    EXPECT_EQ(hand.takenAt(hand.at(0.125, 0.125)), &startMark);
    EXPECT_EQ(workspace.point, (std::vector<double>{-0.8, -0.8}));
}

TEST(MarkTable, PlacesOfAnAnalysisStandForTheRing) {
    HandOnView hand;
    hand.view = 0;
    Workspace analysis = workspaceOf(*presetNamed("mandelbrot"));
    ASSERT_TRUE(setAnalysis(analysis));
    hand.open(std::move(analysis));
    const Workspace& workspace = hand.context.workspace;
    const auto placeOf = [&](std::size_t k) {
        const auto at = markerOf(workspace.views[k], workspace.views[0].slice);
        return hand.at(at[0], at[1]);
    };
    const ImVec2 third = placeOf(3), second = placeOf(2);
    EXPECT_EQ(hand.dragFrom({third.x + 4, third.y}), &placeMark);
    EXPECT_EQ(hand.host.announced, "Place 3");
    EXPECT_EQ(workspace.focused, 3);
    EXPECT_EQ(placeOf(2).x, second.x);
    EXPECT_NEAR(placeOf(3).x, third.x + 54, 1.01);
}

TEST(MarkTable, KeysThatAreHeldChooseTheMark) {
    HandOnView hand;
    openCircleAndRoot(hand);
    StudioContext& context = hand.context;
    const Workspace& workspace = context.workspace;
    const auto with = [&](ImGuiKey key, ImVec2 place) {
        ImGui::GetIO().AddKeyEvent(key, true);
        const Mark* taken = hand.dragFrom(place);
        ImGui::GetIO().AddKeyEvent(key, false);
        hand.frames(2);
        return taken;
    };
    // Over a root, whatever is chosen by then.
    const ImVec2 place = hand.at(0.4, 0.4);
    EXPECT_EQ(with(ImGuiMod_Shift, place), nullptr);
    ASSERT_EQ(workspace.pins.size(), 1u);
    EXPECT_EQ(workspace.pins[0], workspace.views[0].parameters);
    EXPECT_EQ(with(ImGuiMod_Ctrl, place), &ringMark);
    EXPECT_NEAR(workspace.point[0], 0.4 + 50 * hand.unit(), hand.near());
    EXPECT_EQ(with(ImGuiMod_Alt, place), &comparedMark);
    ASSERT_EQ(workspace.compared.size(), 2u);
    EXPECT_NEAR(workspace.compared[1], 0.4 + 30 * hand.unit(), hand.near());
    EXPECT_EQ(workspace.views[0].lists.at("roots").roots[0].q[0], 0.4);
    EXPECT_EQ(hand.scene().slice.centre[0], 0);
    // Only the fifth pin takes the first one's place.
    for (int k = 0; k < 5; ++k) with(ImGuiMod_Shift, place);
    EXPECT_EQ(workspace.pins.size(), kMostPins);
}

TEST(MarkTable, AToolInTheHandHasThePointerToItself) {
    HandOnView hand;
    openCircleAndRoot(hand);
    chooseTool(hand.context, Drawing::Tool::outline);
    EXPECT_EQ(hand.takenAt(hand.ring()), nullptr);
    EXPECT_EQ(hand.context.drawing.corners.size(), 1u);
    EXPECT_EQ(hand.context.workspace.point[0], -0.45);
}

// Which the next views of the same frame are not among.
TEST(ViewInput, AShapeDrawnInTheLastOfFourViewsLeavesTwo) {
    HandOnView hand;
    hand.openPreset("mandelbrot");
    hand.context.edit([](Workspace& workspace) { setViewCount(workspace, 4); });
    hand.view = 3;
    hand.frames(3);
    chooseTool(hand.context, Drawing::Tool::outline);
    hand.move({420, 300});
    hand.button(true);
    for (int k = 0; k <= 40; ++k) {
        const float angle = 0.157f * static_cast<float>(k);
        hand.move({300 + 120 * std::cos(angle), 300 + 120 * std::sin(angle)});
    }
    hand.button(false);
    EXPECT_EQ(hand.context.workspace.views.size(), 2u);
    EXPECT_TRUE(mapOf(hand.context.workspace.view()).info.field);
}

TEST(ViewInput, ABrushPaintsNothingOnAMapWithoutAShape) {
    HandOnView hand;
    hand.openMap("shape-modulus-complex-rational");
    chooseTool(hand.context, Drawing::Tool::alpha);
    hand.context.newMap("quadratic");
    ASSERT_EQ(hand.context.drawing.tool, Drawing::Tool::alpha);
    hand.frames(2);
    hand.move({200, 200});
    hand.button(true);
    hand.move({300, 300});
    hand.button(false);
    EXPECT_TRUE(hand.context.workspace.views[1].alphaOverSpace.discs.empty());
}

TEST(ViewInput, ABoxOfTheRightButtonIsZoomedTo) {
    HandOnView hand;
    openCircleAndRoot(hand);
    const double height = hand.scene().slice.height;
    const double u = hand.plane().u(450), v = hand.plane().v(130);
    hand.move({400, 100});
    hand.button(true, 1);
    hand.move({500, 160});
    EXPECT_TRUE(hand.drag().draw) << "the box is seen";
    hand.button(false, 1);
    EXPECT_NEAR(hand.scene().slice.centre[0], u, hand.near());
    EXPECT_NEAR(hand.scene().slice.centre[1], v, hand.near());
    EXPECT_NEAR(hand.scene().slice.height, height * 100 / kSide, 1e-9);
    // One that is no larger than the tremble of a hand is none.
    hand.move({400, 100});
    hand.button(true, 1);
    hand.move({406, 160});
    hand.button(false, 1);
    EXPECT_NEAR(hand.scene().slice.height, height * 100 / kSide, 1e-9);
}

TEST(ViewInput, FingersLetGoOfWhateverIsDragged) {
    HandOnView hand;
    openCircleAndRoot(hand);
    const std::vector<std::pair<const Mark*, ImVec2>> marks{{&ringMark, hand.ring()},
                                                            {&rootMark, hand.at(0.4, 0.4)},
                                                            {&circleRadiusMark, hand.at(0.3, 0)}};
    for (const auto& [mark, place] : marks) {
        const Json before = workspaceToJson(hand.context.workspace);
        hand.move(place);
        hand.button(true);
        ASSERT_EQ(hand.drag().mark, mark);
        // They have not moved yet.
        ASSERT_TRUE(hand.context.pinch(place, place, 1));
        EXPECT_EQ(hand.drag().mark, nullptr);
        hand.move({place.x + 50, place.y - 30});
        EXPECT_EQ(workspaceToJson(hand.context.workspace), before);
        hand.button(false);
        EXPECT_TRUE(hand.drag().idle());
        hand.frames(30);
    }
}

// Printing a scene is the dearest part of a frame that changes nothing.
TEST(ViewWants, AreMadeAnewOnlyWhereSomethingChanged) {
    HandOnView hand;
    openCircleAndRoot(hand);
    WantedPicture& wanted = hand.context.views[1].wanted;
    const std::string key = wanted.key;
    wanted.key = "kept";
    hand.frames(5);
    EXPECT_EQ(wanted.key, "kept");
    hand.context.edit([](Workspace& workspace) { workspace.views[1].iterations = 7; });
    hand.frames();
    EXPECT_EQ(wanted.scene.iterations, 7);
    EXPECT_NE(wanted.key, key);
    EXPECT_NE(wanted.key, "kept");
}

// Assets are told apart by their hash.
TEST(ViewWants, DoNotPrintAssets) {
    HandOnView hand;
    openCircleAndRoot(hand);
    const std::size_t without = hand.context.views[1].wanted.key.size();
    hand.context.edit([](Workspace& workspace) {
        Scene& scene = workspace.views[1];
        auto asset = std::make_shared<Asset>();
        asset->bytes.assign(1000000, 7);
        scene.assets[std::string(64, 'a')] = asset;
        scene.layers.emplace_back();
        scene.layers.back().sources = {"asset:" + std::string(64, 'a')};
    });
    hand.frames(2);
    EXPECT_LT(hand.context.views[1].wanted.key.size(), without + 2000);
}

}  // namespace
}  // namespace versorium
