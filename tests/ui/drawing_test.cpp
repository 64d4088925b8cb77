// SPDX-License-Identifier: MIT
// Shapes drawn by hand, α painted over space, and S eq 2 in both readings.
#include <gtest/gtest.h>

#include <cmath>

#include "io/document.h"
#include "plate/plate_picture.h"
#include "shape/modulation.h"
#include "shape/outline.h"
#include "ui/controls/controls.h"
#include "ui/headless_gui.h"
#include "ui/session/shape_change.h"

namespace versorium {
namespace {

// A view of the studio under a hand.
class Hand {
  public:
    explicit Hand(StudioContext& context, int view) : context_(context), view_(view) { draw(); }

    void draw() {
        gui_.frame([&] { drawView(context_, view_, {0, 0}, {600, 600}); });
    }
    void move(float x, float y) {
        ImGui::GetIO().AddMousePosEvent(x, y);
        draw();
    }
    void press(bool down) {
        ImGui::GetIO().AddMouseButtonEvent(0, down);
        draw();
    }
    void click(float x, float y) {
        move(x, y);
        press(true);
        press(false);
        draw();
    }
    void stroke(const std::vector<ImVec2>& points) {
        move(points[0].x, points[0].y);
        press(true);
        for (const ImVec2& point : points) move(point.x, point.y);
        press(false);
        draw();
    }

  private:
    StudioContext& context_;
    int view_;
    HeadlessGui gui_{{600, 600}};
};

// A circle on the screen, in one stroke.
std::vector<ImVec2> circle(float radius) {
    std::vector<ImVec2> points;
    for (int k = 0; k < 72; ++k) {
        const double angle = k * 2 * M_PI / 72;
        points.push_back({300 + radius * static_cast<float>(std::cos(angle)),
                          300 + radius * static_cast<float>(std::sin(angle))});
    }
    return points;
}

TEST(Drawing, AStrokeOnTheFirstScreenBecomesAJuliaSet) {
    SilentHost host;
    StudioContext context(host);
    const std::string before = workspaceToJson(context.workspace).dump();
    Hand hand(context, 1);
    chooseTool(context, Drawing::Tool::outline);
    EXPECT_FALSE(drawingHint(context).empty());
    const SliceSpec slice = context.workspace.views[1].slice;
    hand.stroke(circle(120));
    ASSERT_EQ(context.workspace.views[0].map, "shape-modulus-complex-rational");
    EXPECT_EQ(context.drawing.tool, Drawing::Tool::none);
    const Scene& scene = context.workspace.view();
    ASSERT_EQ(viewKind(scene), ViewKind::startingPoints);
    // The shape lies where it was drawn: a circle of 120 pixels around the middle.
    const auto corners = parseOutline(scene.shape.source);
    ASSERT_TRUE(corners) << corners.status().message();
    const double radius = 120 * slice.height / 600;
    for (const glm::dvec2& corner : *corners)
        EXPECT_NEAR(std::hypot(corner.x - slice.centre[0], corner.y - slice.centre[1]), radius,
                    2 * slice.height / 600);
    EXPECT_LT(slice.height, 6);  // or it would have been scaled
    // Roots lie in its box, and it is seen whole.
    for (const RootList::Root& root : scene.lists.at("roots").roots)
        EXPECT_LE(std::abs(root.q[0] - slice.centre[0]), radius * 1.02);
    EXPECT_GT(scene.slice.height, 2 * radius);
    // Whoever draws it can bind it, and a link carries it.
    Binder binder;
    Job job(1);
    EXPECT_TRUE(binder.bind(scene, job));
    const Expected<std::string> link = workspaceToLink(context.workspace);
    ASSERT_TRUE(link);
    EXPECT_TRUE(workspaceFromLink(*link));
    context.undo();
    EXPECT_EQ(workspaceToJson(context.workspace).dump(), before);
}

TEST(Drawing, CornersAreClickedAndClosedAtTheFirst) {
    SilentHost host;
    StudioContext context(host);
    Hand hand(context, 1);
    chooseTool(context, Drawing::Tool::outline);
    hand.click(200, 400);
    hand.click(400, 400);
    hand.click(300, 180);
    EXPECT_EQ(context.drawing.corners.size(), 3u);
    hand.click(204, 397);
    const auto corners = parseOutline(context.workspace.view().shape.source);
    ASSERT_TRUE(corners);
    EXPECT_EQ(corners->size(), 3u);
}

TEST(Drawing, TooLittleIsSaidAndChangesNothing) {
    SilentHost host;
    StudioContext context(host);
    const std::string before = workspaceToJson(context.workspace).dump();
    Hand hand(context, 1);
    chooseTool(context, Drawing::Tool::outline);
    hand.click(200, 300);
    hand.click(400, 300);
    finishOutline(context);
    EXPECT_NE(context.notices.last().find("three corners"), std::string::npos);
    // Three corners on a line.
    for (float x : {200.f, 300.f, 400.f}) hand.click(x, 300);
    finishOutline(context);
    EXPECT_NE(context.notices.last().find("one line"), std::string::npos) << context.notices.last();
    context.edit(
        [&](Workspace& w) { w.focused = 0; });  // the tool went to the view of starting points
    EXPECT_EQ(workspaceToJson(context.workspace).dump(), before);
}

TEST(Drawing, TheBrushPaintsAlphaAndTheEraserTakesItAway) {
    SilentHost host;
    StudioContext context(host);
    ASSERT_TRUE(setShape(context, "star(5, 0.9, 0.45)").ok());
    const int view = context.workspace.focused;
    Hand hand(context, view);
    chooseTool(context, Drawing::Tool::alpha);
    context.drawing.alpha = 77;
    context.drawing.radius = 0.2;
    hand.stroke({{300, 300}, {340, 300}, {380, 300}, {420, 300}});
    const auto& discs = context.workspace.view().alphaOverSpace.discs;
    EXPECT_GT(discs.size(), 3u);
    const OrbitProgram* program = context.bound.program(view);
    ASSERT_NE(program, nullptr);
    ASSERT_NE(program->field->alpha(), nullptr);
    // The value of the brush along the stroke, the usual one far from it. The grid that dabs are
    // kept in has 16 nodes across one.
    const SliceSpec& slice = context.workspace.view().slice;
    const double u = slice.centre[0] + 60 * slice.height / 600, v = slice.centre[1];
    const auto there = shapePlace(context.workspace.view(), *program, u, v);
    const double usual = context.workspace.view().parameters.at("alpha")[0];
    EXPECT_NEAR(program->field->alpha()->at(there[0], there[1], there[2], usual), 77, 2);
    EXPECT_EQ(program->field->alpha()->at(-5.0, -5.0, 0.0, usual), usual);
    EXPECT_TRUE(workspaceFromJson(workspaceToJson(context.workspace)));
    context.drawing.erases = true;
    hand.stroke({{300, 300}, {340, 300}, {380, 300}, {420, 300}});
    EXPECT_TRUE(context.workspace.view().alphaOverSpace.discs.empty());
}

TEST(Drawing, PaintTakesNoPointer) {
    SilentHost host;
    StudioContext context(host);
    ASSERT_TRUE(setShape(context, "disc(0.6)").ok());
    ASSERT_TRUE(setControl(context, "modulation.beta.brush", "0.25"));
    ASSERT_TRUE(setControl(context, "modulation.beta.dab", ""));
    const auto& discs = context.workspace.view().betaOverSpace.discs;
    ASSERT_EQ(discs.size(), 1u);
    EXPECT_EQ(discs[0].value, 0.25);
    EXPECT_EQ(discs[0].x, context.workspace.point[0]);
    ASSERT_TRUE(setControl(context, "modulation.alpha.shape", "half_space(1, 0, 0, 0)"));
    EXPECT_EQ(context.workspace.view().alphaOverSpace.shape, "half_space(1, 0, 0, 0)");
    EXPECT_FALSE(setControl(context, "modulation.alpha.shape", "half_moon(1)"));
    EXPECT_EQ(context.workspace.view().alphaOverSpace.shape, "half_space(1, 0, 0, 0)");
}

TEST(Shapes, ATextThatIsWrongChangesNothing) {
    SilentHost host;
    StudioContext context(host);
    const std::string before = workspaceToJson(context.workspace).dump();
    for (const char* text : {"star(5, 0.9", "polygon(1, 2)", "asset:abc", "", "rabbit"}) {
        const Status status = setShape(context, text);
        EXPECT_FALSE(status.ok()) << text;
        EXPECT_FALSE(status.message().empty());
    }
    EXPECT_EQ(workspaceToJson(context.workspace).dump(), before);
    for (const ShapeChoice& choice : shapeChoices())
        EXPECT_TRUE(setShape(context, choice.source).ok()) << choice.name;
}

TEST(Shapes, TheSignInPrintStandsBesideTheOtherOne) {
    SilentHost host;
    StudioContext context(host);
    ASSERT_TRUE(setShape(context, "star(5, 0.9, 0.45)").ok());
    context.edit([&](Workspace& w) { setSharedNumber(w, "beta", 0.1); });
    showAsPrinted(context);
    const auto& views = context.workspace.views;
    ASSERT_EQ(views.size(), 2u);
    EXPECT_EQ(views[0].parameters.at("as_printed")[0], 0);
    EXPECT_EQ(views[1].parameters.at("as_printed")[0], 1);
    EXPECT_EQ(views[0].slice, views[1].slice);
    // Other numbers are those of both; a link keeps the two apart.
    context.edit([&](Workspace& w) { setSharedNumber(w, "alpha", 3); });
    EXPECT_EQ(views[1].parameters.at("alpha")[0], 3);
    const Expected<Workspace> again = workspaceFromJson(workspaceToJson(context.workspace));
    ASSERT_TRUE(again) << again.status().message();
    EXPECT_EQ(again->views[1].parameters.at("as_printed")[0], 1);
    EXPECT_EQ(again->views[0].parameters.at("as_printed")[0], 0);
}

TEST(Shapes, ModulusVersorAndLogModulusAreFourViews) {
    SilentHost host;
    StudioContext context(host);
    for (const char* map : {"quadratic", "shape-modulus", "shape-modulus-quadratic"}) {
        context.newMap(map);
        showModulusAndVersor(context);
        ASSERT_EQ(context.workspace.views.size(), 4u) << map;
        EXPECT_TRUE(workspaceFromJson(workspaceToJson(context.workspace))) << map;
        EXPECT_EQ(context.workspace.views[1].colour.rule,
                  std::string(map) == "shape-modulus" ? ColourRule::versor : ColourRule::domain);
    }
}

TEST(Plates, OfTheProgramsOwnAreExportedFromTheStudio) {
    SilentHost host;
    StudioContext context(host);
    context.exporting.plate = true;
    context.exporting.builtIn = "shape-modulus-6";
    context.startExport();
    ASSERT_EQ(host.exports.size(), 1u);
    EXPECT_EQ(host.exports[0].name, "shape-modulus-6-plate.png");
    // The document that the command line makes its plate of.
    const std::string text =
        printJson(documentToJson(documentOfPlate(*plateNamed("shape-modulus-6"))));
    EXPECT_EQ(host.exports[0].document, text);
}

}  // namespace
}  // namespace versorium
