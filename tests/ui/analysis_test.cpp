// SPDX-License-Identifier: MIT
// Analysis: a set of parameters with four places in it; motions of a view; images behind it.
#include <gtest/gtest.h>

#include <cmath>

#include "io/png.h"
#include "render/movie.h"
#include "ui/headless_gui.h"
#include "ui/plots/plots.h"
#include "ui/session/open_file.h"
#include "workspace/export_document.h"

namespace versorium {
namespace {

Workspace ofPreset(const char* name) {
    const Expected<Scene> scene = presetNamed(name);
    EXPECT_TRUE(scene.ok());
    return workspaceOf(*scene);
}
const std::vector<double>& c(const Workspace& workspace, std::size_t view) {
    return workspace.views[view].parameters.at("c");
}

TEST(Analysis, FourPlacesAreMovedOneByOne) {
    Workspace workspace = ofPreset("mandelbrot");
    workspace.pins.push_back({{"c", {-1, 0.25}}});
    ASSERT_TRUE(setAnalysis(workspace));
    ASSERT_EQ(workspace.views.size(), 5u);
    EXPECT_EQ(viewKind(workspace.views[0]), ViewKind::parameters);
    EXPECT_EQ(c(workspace, 1), (std::vector<double>{-1, 0.25}));
    for (std::size_t k = 1; k < 5; ++k)
        for (std::size_t other = 1; other < k; ++other)
            EXPECT_NE(c(workspace, k), c(workspace, other));
    const std::vector<double> second = c(workspace, 2);
    workspace.focused = 3;
    moveMarker(workspace, 0, 0.125, 0.5);
    EXPECT_EQ(c(workspace, 3), (std::vector<double>{0.125, 0.5}));
    EXPECT_EQ(c(workspace, 2), second);
    EXPECT_EQ(markerOf(workspace, 0), (std::array<double, 2>{0.125, 0.5}));
    EXPECT_EQ(orbitScene(workspace).parameters.at("c"), c(workspace, 3));
    // Starting points are all views' own.
    moveMarker(workspace, 3, 0.5, 0.5);
    EXPECT_EQ(markerOf(workspace, 2), (std::array<double, 2>{0.5, 0.5}));
    // Back to fewer views: all stand where the focused one stood.
    setViewCount(workspace, 2);
    EXPECT_EQ(c(workspace, 0), (std::vector<double>{0.125, 0.5}));
    EXPECT_EQ(c(workspace, 1), (std::vector<double>{0.125, 0.5}));
}

// What is not on the set's axes is still the same in all views.
TEST(Analysis, OtherNumbersStayShared) {
    Workspace workspace = ofPreset("henon");
    ASSERT_TRUE(setAnalysis(workspace));
    workspace.focused = 2;
    setSharedNumber(workspace, "h.c1", 0.25);
    for (const Scene& scene : workspace.views) EXPECT_EQ(scene.parameters.at("h.c1")[0], 0.25);
    const std::string own = workspace.views[0].slice.axes[0].terms[0].first;
    const double before = workspace.views[1].parameters.at(own)[0];
    setSharedNumber(workspace, own, before + 1);
    EXPECT_EQ(workspace.views[2].parameters.at(own)[0], before + 1);
    EXPECT_EQ(workspace.views[1].parameters.at(own)[0], before);
    EXPECT_EQ(sharedNumber(workspace, own), before + 1);
}

TEST(Analysis, TravelsInALink) {
    Workspace workspace = ofPreset("mandelbrot");
    ASSERT_TRUE(setAnalysis(workspace));
    workspace.focused = 4;
    moveMarker(workspace, 0, 0.25, 0.5);
    const Expected<std::string> link = workspaceToLink(workspace);
    ASSERT_TRUE(link);
    const Expected<Workspace> again = workspaceFromLink(*link);
    ASSERT_TRUE(again) << again.status().message();
    EXPECT_EQ(workspaceToJson(*again), workspaceToJson(workspace));
}

// Real hands: the place near the pointer is caught and follows it; the others stay.
TEST(Analysis, APlaceIsDraggedWithThePointer) {
    SilentHost host;
    HeadlessGui gui({600, 600});
    StudioContext context(host);
    ASSERT_TRUE(context.edit([](Workspace& w) { return setAnalysis(w); }));
    const auto view = [&] { drawView(context, 0, {0, 0}, {600, 600}); };
    for (int k = 0; k < 3; ++k) gui.frame(view);
    const auto place = [&](std::size_t k) {
        const Scene& set = context.workspace.views[0];
        const auto at = markerOf(context.workspace.views[k], set.slice);
        const double unit = 600 / set.slice.height;
        return ImVec2(static_cast<float>(300 + (at[0] - set.slice.centre[0]) * unit),
                      static_cast<float>(300 - (at[1] - set.slice.centre[1]) * unit));
    };
    const ImVec2 from = place(3), other = place(2);
    ImGuiIO& io = ImGui::GetIO();
    io.AddMousePosEvent(from.x + 4, from.y);
    gui.frame(view);
    io.AddMouseButtonEvent(0, true);
    gui.frame(view);
    io.AddMousePosEvent(from.x + 50, from.y - 30);
    gui.frame(view);
    io.AddMouseButtonEvent(0, false);
    gui.frame(view);
    EXPECT_EQ(context.workspace.focused, 3);
    // The pointer stands on whole pixels.
    EXPECT_NEAR(place(3).x, from.x + 50, 1.01);
    EXPECT_NEAR(place(3).y, from.y - 30, 1.01);
    EXPECT_EQ(place(2).x, other.x);
}

TEST(MotionPanel, WhatIsRecordedPlaysAgain) {
    SilentHost host;
    StudioContext context(host);
    context.player.animation.running = false;
    context.edit([&](Workspace& w) { w.focused = 0; });
    context.player.record(true);
    for (int k = 0; k <= 30; ++k) {
        host.time = 1 + k / 30.0;
        context.edit([&](Workspace& w) { setSharedNumber(w, "c.re", -1 + k / 30.0); });
        context.edit([&](Workspace& w) { w.views[0].slice.height = 3 * std::exp2(-k / 15.0); });
        context.player.advance(1 / 30.0);
    }
    context.player.record(false);
    const Motion motion = context.workspace.motion;
    ASSERT_GE(motion.keys.size(), 2u);
    EXPECT_NEAR(motion.duration(), 2, 0.1);
    context.player.showMotionAt(1.5);
    EXPECT_NEAR(context.workspace.views[1].parameters.at("c")[0], -0.5, 0.02);
    EXPECT_NEAR(context.workspace.views[0].slice.height, 1.5, 0.05);
    EXPECT_NE(context.workspace.views[1].slice.height, context.workspace.views[0].slice.height);
    // It is part of what undo brings back and of what a link carries.
    context.record();
    const Expected<std::string> link = workspaceToLink(context.workspace);
    ASSERT_TRUE(link) << link.status().message();
    EXPECT_EQ(workspaceFromLink(*link)->motion, motion);
    context.undo();
    EXPECT_TRUE(context.workspace.motion.keys.empty());
    context.redo();
    EXPECT_EQ(context.workspace.motion, motion);
}

TEST(MotionPanel, KeyFramesAreSetMovedAndTakenAway) {
    SilentHost host;
    HeadlessGui gui({900, 160});
    StudioContext context(host);
    context.player.animation.running = false;
    context.player.setKey();
    context.player.at = 2;
    context.edit([&](Workspace& w) { setSharedNumber(w, "c.re", -1); });
    context.player.setKey();
    ASSERT_EQ(context.workspace.motion.keys.size(), 2u);
    context.player.showMotionAt(1);
    EXPECT_NEAR(sharedNumber(context.workspace, "c.re"), (-1 - 0.7269) / 2, 1e-12);
    // The second one is dragged along the line of time.
    context.edit([&](Workspace& w) { w.plot = PlotPanel::motion; });
    const auto strip = [&] { drawTimeline(context); };
    for (int k = 0; k < 3; ++k) gui.frame(strip);
    ImGuiIO& io = ImGui::GetIO();
    context.player.key = -1;
    float x = 880;
    for (; x > 100; x -= 10) {
        io.AddMousePosEvent(x, 90);
        gui.frame(strip);
        io.AddMouseButtonEvent(0, true);
        gui.frame(strip);
        if (context.player.key == 1) break;
        io.AddMouseButtonEvent(0, false);
        gui.frame(strip);
    }
    ASSERT_EQ(context.player.key, 1);
    io.AddMousePosEvent(x - 200, 90);
    gui.frame(strip);
    io.AddMouseButtonEvent(0, false);
    gui.frame(strip);
    EXPECT_LT(context.workspace.motion.duration(), 1.7);
    EXPECT_GT(context.workspace.motion.duration(), 1.2);
    context.player.removeKey();
    EXPECT_EQ(context.workspace.motion.keys.size(), 1u);
}

// The file and the export are what the command line takes.
TEST(MotionPanel, IsSavedAsAnAnimation) {
    SilentHost host;
    StudioContext context(host);
    context.player.animation.running = false;
    context.player.setKey();
    context.player.at = 1;
    context.edit([&](Workspace& w) { setSharedNumber(w, "c.im", 0.5); });
    context.player.setKey();
    context.exporting.motion = true;
    context.exporting.width = 64;
    const auto document = exportDocument(context.workspace, {1, 1}, context.exporting);
    ASSERT_TRUE(document) << document.status().message();
    const auto movie = movieFromDocument(*document);
    ASSERT_TRUE(movie) << movie.status().message();
    EXPECT_EQ(movie->animation.motion, context.workspace.motion);
    EXPECT_EQ(pictureSize(movie->animation.scene, movie->options), (Size{64, 64}));
    const std::string text = printJson(documentToJson(motionDocument(context.workspace)));
    StudioContext other(host);
    const Status opened = openBytes(
        other, "m.json", {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    ASSERT_TRUE(opened.ok()) << opened.message();
    EXPECT_EQ(other.workspace.motion, context.workspace.motion);
}

std::vector<unsigned char> onePixel(unsigned char red) {
    Raster<unsigned char> image({1, 1}, 3);
    image.at(0, 0) = red;
    return *encodePng(image);
}

TEST(LayersPanel, ImagesLieBehindAndNumberedOnesFollowOneAnother) {
    SilentHost host;
    StudioContext context(host);
    context.imagesAreLayers = true;
    ASSERT_TRUE(openBytes(context, "a/film-2.png", onePixel(2)).ok());
    ASSERT_TRUE(openBytes(context, "a/film-10.png", onePixel(10)).ok());
    ASSERT_TRUE(openBytes(context, "a/film-1.png", onePixel(1)).ok());
    ASSERT_TRUE(openBytes(context, "a/other.png", onePixel(9)).ok());
    const Scene& scene = context.workspace.view();
    ASSERT_EQ(scene.layers.size(), 2u);
    std::vector<std::string> names;
    for (const std::string& source : scene.layers[0].sources)
        names.push_back(scene.assets.at(source.substr(6))->name);
    EXPECT_EQ(names, (std::vector<std::string>{"film-1.png", "film-2.png", "film-10.png"}));
    EXPECT_FALSE(openBytes(context, "bad.png", std::vector<unsigned char>{1, 2, 3}).ok());
    // All views carry the files; those of a layer that goes are forgotten.
    EXPECT_EQ(context.workspace.views[0].assets.size(), 4u);
    context.edit([](Workspace& w) {
        w.view().layers.erase(w.view().layers.begin());
        dropUnnamedAssets(w);
    });
    for (const Scene& view : context.workspace.views) EXPECT_EQ(view.assets.size(), 1u);
    const Expected<Workspace> again = workspaceFromJson(workspaceToJson(context.workspace));
    ASSERT_TRUE(again) << again.status().message();
    EXPECT_EQ(again->view().layers, context.workspace.view().layers);
}

}  // namespace
}  // namespace versorium
