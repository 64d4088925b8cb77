// SPDX-License-Identifier: MIT
#include "lesson/plate_marks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lesson/lesson_plate.h"
#include "lesson/stage.h"

namespace versorium {
namespace {

std::vector<PlatePanel> marked(const std::string& lines) {
    const Expected<std::vector<StageLine>> read = readLines(lines, 1);
    EXPECT_TRUE(read);
    const Expected<Workspace> stage = changed(workspaceOf(*presetNamed("mandelbrot")), *read);
    EXPECT_TRUE(stage) << stage.status().message();
    Plate plate;
    for (const Scene& view : stage->views) plate.panels.emplace_back().scene = view;
    markPanels(*stage, plate);
    return plate.panels;
}

const OverlayPart* part(const PlatePanel& panel, const std::string& name) {
    for (const OverlayPart& one : panel.overlay.parts)
        if (one.name == name) return &one;
    return nullptr;
}

TEST(PlateMarks, ShowTheOrbitOnPlanesOfStarts) {
    const std::vector<PlatePanel> panels =
        marked("preset: julia\nc: 0\npoint: 0.5, 0\norbit_steps: 3");
    ASSERT_EQ(panels.size(), 2u);
    EXPECT_TRUE(panels[0].overlay.empty()) << "a plane of parameters has no orbit in it";
    const OverlayPart *orbit = part(panels[1], "orbit"), *start = part(panels[1], "start");
    ASSERT_TRUE(orbit && start);
    EXPECT_FALSE(orbit->points);
    ASSERT_EQ(orbit->curves.size(), 1u);
    const std::vector<std::array<double, 2>> squares{
        {0.5, 0}, {0.25, 0}, {0.0625, 0}, {0.0625 * 0.0625, 0}};
    EXPECT_EQ(orbit->curves[0], squares);
    ASSERT_EQ(start->curves.size(), 1u);
    EXPECT_EQ(start->curves[0][0], squares[0]);
}

TEST(PlateMarks, StayWithinThePicture) {
    const std::vector<PlatePanel> panels =
        marked("preset: julia\nc: 0\npoint: 1.2, 0\norbit_steps: 8\ncircle: 1.5, 0, 0.5");
    for (const OverlayPart& one : panels[1].overlay.parts)
        for (const auto& curve : one.curves)
            for (const auto& p : curve) {
                EXPECT_LE(std::fabs(p[0]), 1.5 + 1e-12) << one.name;
                EXPECT_LE(std::fabs(p[1]), 1.5 + 1e-12) << one.name;
            }
    // Half of the circle lies in the picture, and the orbit leaves it through the border.
    ASSERT_TRUE(part(panels[1], "circle"));
    ASSERT_TRUE(part(panels[1], "orbit"));
    EXPECT_NEAR(part(panels[1], "orbit")->curves[0].back()[0], 1.5, 1e-12);
}

TEST(PlateMarks, ShowRootsAndPoles) {
    const std::vector<PlatePanel> panels =
        marked("map: complex-rational\nviews: starts\nroots: 0 0 2; 1 0\npoles: 0.5 0.5");
    ASSERT_TRUE(part(panels[0], "roots"));
    EXPECT_EQ(part(panels[0], "roots")->curves[0].size(), 2u);
    EXPECT_TRUE(part(panels[0], "poles"));
    EXPECT_FALSE(part(marked("map: complex-rational\nshow_roots: false")[0], "roots"));
}

TEST(PlateMarks, LongOrbitsAreClouds) {
    const std::vector<PlatePanel> panels =
        marked("preset: henon\nviews: starts\norbit_steps: 500\npoint: 0, 0");
    ASSERT_TRUE(part(panels[0], "orbit"));
    EXPECT_TRUE(part(panels[0], "orbit")->points);
}

TEST(PlateOverlayParts, AreReadAsTheyAreWritten) {
    Plate plate;
    plate.panels.resize(1);
    plate.panels[0].name = "a";
    plate.panels[0].scene = *presetNamed("julia");
    plate.panels[0].overlay.parts = {{"orbit", false, {{{0.5, 0.25}, {1, -1}}, {{0, 0}}}},
                                     {"start", true, {{{0.5, 0.25}}}}};
    const Json json = plateToJson(plate);
    const Expected<Plate> read = plateFromJson(json);
    ASSERT_TRUE(read) << read.status().message();
    EXPECT_EQ(read->panels[0].overlay, plate.panels[0].overlay);
    for (const char* wrong : {"1", "[1]", "[[1]]", "[[[1, 2, 3]]]", "[[[1, \"a\"]]]"}) {
        Json other = json;
        other["panels"][0]["overlay"]["parts"][0]["curves"] = *parseJson(wrong);
        EXPECT_FALSE(plateFromJson(other)) << wrong;
    }
    Json many = json;
    for (int k = 0; k < 6; ++k) many["panels"][0]["overlay"]["parts"].push_back({{"name", "x"}});
    EXPECT_FALSE(plateFromJson(many));
}

}  // namespace
}  // namespace versorium
