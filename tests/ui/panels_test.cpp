// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "io/document.h"
#include "ui/controls/commands.h"
#include "ui/dialogs/dialogs.h"
#include "ui/headless_gui.h"
#include "ui/keyboard.h"
#include "ui/panels/panels.h"
#include "ui/plots/plots.h"
#include "ui/plots/web_diagram.h"
#include "ui/widgets/help.h"
#include "ui/widgets/palette_stops.h"

namespace versorium {
namespace {

// Lets the pointer rest on a grid of places: whatever reacts to it must explain itself.
// `margin`: what scroll bars and the cross of a dialog take on the right.
void expectHelpEverywhere(HeadlessGui& gui, const std::function<void()>& panel, const char* what,
                          float margin = 14) {
    for (int k = 0; k < 3; ++k) gui.frame(panel);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float tall = std::min(gui.bottom, size.y);
    int controls = 0;
    std::vector<ImGuiID> told;
    for (float y = 4; y < tall; y += 9)
        for (float x = 6; x < size.x - margin; x += 17) {
            ImGui::GetIO().AddMousePosEvent(x, y);
            gui.frame(panel);
            const ImGuiID id = gui.hovered();
            if (id == 0 || std::find(told.begin(), told.end(), id) != told.end()) continue;
            // A tooltip is laid out in its first frame and shown in the next.
            gui.frame(panel);
            gui.frame(panel);
            told.push_back(id);
            if (gui.isFrame(id)) continue;
            ++controls;
            EXPECT_TRUE(gui.tooltipShown())
                << what << ": the control at " << x << ", " << y << " explains nothing";
        }
    EXPECT_GT(controls, 3) << what;
    ImGui::GetIO().AddMousePosEvent(-1, -1);
    gui.frame(panel);
}

TEST(Help, EveryControlOfTheInspectorExplainsItself) {
    SilentHost host;
    HeadlessGui gui({330, 1500});
    StudioContext context(host);
    const auto inspector = [&] { drawInspector(context); };
    expectHelpEverywhere(gui, inspector, "quadratic");
    context.edit([](Workspace& w) {
        w.view().colour.ownPalette = paletteToJson(ownPaletteFrom(*paletteNamed("versorium")));
        w.view().colour.range = {1, 500};
    });
    context.panels.of<PaletteStopChoice>().at = 1;
    expectHelpEverywhere(gui, inspector, "a palette of its own");
    context.edit([](Workspace& w) { w.view().colour.rule = ColourRule::gradient; });
    expectHelpEverywhere(gui, inspector, "gradient");
    context.newMap("logistic");
    expectHelpEverywhere(gui, inspector, "logistic");
    context.newMap("planar");
    context.focus(0);
    context.edit([&](Workspace& w) { w.study = {true, 3, true, true}; });
    context.edit([&](Workspace& w) { w.compared = {0.5, 0.5}; });
    context.record();
    expectHelpEverywhere(gui, inspector, "planar");
    context.newMap("shape-modulus");
    context.edit([&](Workspace& w) { w.view().layers.resize(2); });
    expectHelpEverywhere(gui, inspector, "shape-modulus");
}

TEST(Help, EveryControlOfTheFormulaPanelExplainsItself) {
    SilentHost host;
    HeadlessGui gui({330, 1500});
    StudioContext context(host);
    ASSERT_TRUE(applyFormula(context, "z^3 - a*z + c; a: real = 0.5").ok());
    ASSERT_TRUE(context.formulas.save(host, "mine", context.formula.text).ok());
    expectHelpEverywhere(
        gui, [&] { drawInspector(context); }, "a formula");
}

// Typed as a user types: characters into the field, then Enter.
TEST(Formulas, AreTypedShownRefusedAndUndone) {
    SilentHost host;
    HeadlessGui gui({330, 1500});
    StudioContext context(host);
    const auto inspector = [&] { drawInspector(context); };
    gui.frame(inspector);
    editFormula(context);
    EXPECT_EQ(context.formula.text, "z^2 + c");
    expectHelpEverywhere(gui, inspector, "an empty formula");
    context.formula = {};
    ImGuiIO& io = ImGui::GetIO();
    const auto press = [&](ImGuiKey key) {
        for (const bool down : {true, false}) {
            io.AddKeyEvent(key, down);
            gui.frame(inspector);
        }
    };
    const auto retype = [&](const char* text) {
        io.AddKeyEvent(ImGuiMod_Ctrl, true);
        press(ImGuiKey_A);
        io.AddKeyEvent(ImGuiMod_Ctrl, false);
        io.AddInputCharactersUTF8(text);
        for (int k = 0; k < 3; ++k) gui.frame(inspector);
    };
    // By way of the dialog that finds commands, as it is while a dialog closes.
    const auto all = [&] {
        drawInspector(context);
        drawDialogs(context);
    };
    context.dialogs.find = true;
    for (int k = 0; k < 3; ++k) gui.frame(all);
    io.AddInputCharactersUTF8("type a formula");
    for (int k = 0; k < 3; ++k) gui.frame(all);
    for (const bool down : {true, false}) {
        io.AddKeyEvent(ImGuiKey_Enter, down);
        gui.frame(all);
    }
    for (int k = 0; k < 5; ++k) gui.frame(all);
    EXPECT_TRUE(context.formula.open);
    retype("z^3 - * c");
    EXPECT_EQ(context.formula.fault.position, 6u);
    EXPECT_EQ(context.workspace.views[0].formula, nullptr);
    press(ImGuiKey_Enter);
    EXPECT_EQ(context.workspace.views[0].formula, nullptr) << "what does not read is not taken";
    for (int k = 0; k < 3; ++k) gui.frame(inspector);
    retype("z^3 - a*z + c");
    EXPECT_TRUE(context.formula.fault.message.empty());
    press(ImGuiKey_Enter);
    ASSERT_NE(context.workspace.views[0].formula, nullptr);
    EXPECT_EQ(context.workspace.views[0].formula->formula().text, "z^3 - a*z + c");
    context.record();
    context.edit([&](Workspace& w) { setSharedNumber(w, "c.re", 0.25); });
    context.record();
    // The next formula keeps what it has in common with this one.
    ASSERT_TRUE(applyFormula(context, "z^4 + c").ok());
    EXPECT_EQ(sharedNumber(context.workspace, "c.re"), 0.25);
    context.record();
    context.undo();
    EXPECT_EQ(context.workspace.views[0].formula->formula().text, "z^3 - a*z + c");
    context.undo();
    context.undo();
    EXPECT_EQ(context.workspace.views[0].map, "quadratic");
}

TEST(Formulas, SavedOnesComeBackWithTheNextStart) {
    SilentHost host;
    {
        StudioContext context(host);
        EXPECT_FALSE(context.formulas.save(host, "  ", "z^2 + c").ok());
        EXPECT_FALSE(context.formulas.save(host, std::string(61, 'x'), "z^2 + c").ok());
        ASSERT_TRUE(context.formulas.save(host, "tricorn", "conj(z)^2 + c").ok());
        ASSERT_TRUE(context.formulas.save(host, "sine", "sin(z)").ok());
        ASSERT_TRUE(context.formulas.save(host, " sine ", "c*sin(z)").ok());
    }
    StudioContext context(host);
    ASSERT_EQ(context.formulas.all().size(), 2u);
    EXPECT_EQ(context.formulas.all()[1].text, "c*sin(z)");
    const auto found = [&](const std::string& question, const std::string& name) {
        for (const Command& command : findable(context, question))
            if (command.id.starts_with("formula.") && command.label.find(name) != std::string::npos)
                return command.run(), true;
        return false;
    };
    EXPECT_TRUE(found("", "tricorn"));
    EXPECT_EQ(context.workspace.views[0].formula->formula().text, "conj(z)^2 + c");
    EXPECT_TRUE(found("z^5 + c", "Formula: z^5 + c"));
    EXPECT_EQ(context.workspace.views[0].formula->formula().text, "z^5 + c");
    EXPECT_FALSE(found("z^5 + * c", "Formula: z^5"));
    context.formulas.forget(host, "sine");
    SavedFormulas again;
    again.load(host);
    EXPECT_EQ(again.all().size(), 1u);
    host.kept["formulas"] = "[{\"name\": \"bad\", \"formula\": \"z^^2\"}, 7, {}]";
    again.load(host);
    EXPECT_TRUE(again.all().empty());
}

TEST(Help, EveryControlOfTheOrbitStripExplainsItself) {
    SilentHost host;
    HeadlessGui gui({900, 300});
    StudioContext context(host);
    const auto strip = [&] { drawPlot(context); };
    expectHelpEverywhere(gui, strip, "series");
    context.newMap("logistic");
    context.edit([&](Workspace& w) { w.plot = PlotPanel::web; });
    expectHelpEverywhere(gui, strip, "web");
    context.edit([&](Workspace& w) { w.plot = PlotPanel::diagram; });
    expectHelpEverywhere(gui, strip, "diagram");
    context.player.setKey();
    context.player.key = 0;
    expectHelpEverywhere(gui, strip, "motion");
}

TEST(Orbit, StepsForwardAndBackAndGrowsAtItsEnd) {
    SilentHost host;
    StudioContext context(host);
    context.edit([&](Workspace& w) { w.orbitSteps = 3; });
    for (int k = 1; k <= 5; ++k) {
        context.stepOrbit(1);
        EXPECT_EQ(context.workspace.orbitAt, k);
    }
    EXPECT_EQ(context.workspace.orbitSteps, 5);
    context.stepOrbit(-100);
    EXPECT_EQ(context.workspace.orbitAt, 0);
    EXPECT_EQ(context.workspace.orbitSteps, 5);
    context.stepOrbit(5000);
    EXPECT_EQ(context.workspace.orbitAt, kMostOrbitSteps);
    const Expected<Workspace> again = workspaceFromJson(workspaceToJson(context.workspace));
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->orbitAt, kMostOrbitSteps);
}

TEST(Web, KnowsWhichMapsKeepTheRealLine) {
    SilentHost host;
    StudioContext context(host);
    const auto keeps = [&] {
        const OrbitProgram* program = context.bound.orbitProgram();
        return program && keepsRealLine(*program, 0);
    };
    context.edit([&](Workspace& w) { setSharedNumber(w, "c.im", 0); });
    EXPECT_TRUE(keeps());
    context.edit([&](Workspace& w) { setSharedNumber(w, "c.im", 0.1); });
    EXPECT_FALSE(keeps());
    context.newMap("logistic");
    EXPECT_TRUE(keeps());
}

// The graph and the corners of the web are the map itself.
TEST(Web, DrawsTheLogisticMap) {
    SilentHost host;
    StudioContext context(host);
    context.newMap("logistic");
    context.edit([&](Workspace& w) { setSharedNumber(w, "r", 3.5); });
    const OrbitProgram* program = context.bound.orbitProgram();
    ASSERT_TRUE(program);
    const std::vector<double> graph = graphOf(*program, 3.5, 0, 1, 5);
    for (std::size_t k = 0; k < 5; ++k) {
        const double x = 0.25 * static_cast<double>(k);
        EXPECT_DOUBLE_EQ(graph[k], 3.5 * x * (1 - x));
    }
    const std::vector<double> orbit = lineOrbit(*program, 3.5, 0.5, 3);
    ASSERT_EQ(orbit.size(), 4u);
    EXPECT_DOUBLE_EQ(orbit[1], 0.875);
}

TEST(PaletteStops, StayAPaletteWhateverIsDone) {
    for (const std::string& name : paletteNames()) {
        Palette palette = ownPaletteFrom(*paletteNamed(name));
        const std::size_t before = palette.stops().size();
        const Colour there = palette.at(0.37);
        const int added = addStop(palette, 0.37);
        ASSERT_GT(added, 0) << name;
        EXPECT_EQ(palette.stops().size(), before + 1) << name;
        // A stop with the colour that was there changes nothing; 1e-9 is what OKLab's way there
        // and back loses.
        EXPECT_LT(oklabDistance(palette.at(0.37), there), 1e-6) << name;
        moveStop(palette, added, 5);
        EXPECT_LE(palette.stops()[static_cast<std::size_t>(added)].position, 1) << name;
        colourStop(palette, 0, colourFromRgb(0x123456));
        EXPECT_TRUE(paletteFromJson(paletteToJson(palette)).ok()) << name;
        turnStops(palette);
        EXPECT_EQ(hexFromColour(palette.stops().back().colour), "#123456") << name;
        EXPECT_TRUE(paletteFromJson(paletteToJson(palette)).ok()) << name;
        EXPECT_FALSE(deleteStop(palette, 0)) << name;
        while (palette.stops().size() > 2) ASSERT_TRUE(deleteStop(palette, 1)) << name;
        EXPECT_FALSE(deleteStop(palette, 1)) << name;
    }
}

TEST(Borders, AreTypedWhileTheOppositeOneStays) {
    Scene scene = sceneOf(*findMap("quadratic"));
    for (const double aspect : {0.5, 1.0, 1.6})
        for (int border = 0; border < 4; ++border) {
            const auto before = bordersOf(scene, aspect);
            const double value =
                before[static_cast<std::size_t>(border)] + (border % 2 ? 0.5 : -0.5);
            ASSERT_TRUE(setBorder(scene, border, value, aspect));
            const auto after = bordersOf(scene, aspect);
            EXPECT_NEAR(after[static_cast<std::size_t>(border)], value, 1e-12);
            EXPECT_NEAR(after[static_cast<std::size_t>(border ^ 1)],
                        before[static_cast<std::size_t>(border ^ 1)], 1e-12);
            EXPECT_FALSE(
                setBorder(scene, border, after[static_cast<std::size_t>(border ^ 1)], aspect));
        }
}

TEST(Ranges, TravelWithTheWorkspace) {
    SilentHost host;
    StudioContext context(host);
    context.edit([&](Workspace& w) { w.ranges["c.re"] = {-0.5, 0.25}; });
    const Json json = workspaceToJson(context.workspace);
    const Expected<Workspace> again = workspaceFromJson(json);
    ASSERT_TRUE(again.ok()) << again.status().message();
    EXPECT_EQ(again->ranges, context.workspace.ranges);
    Json wrong = json;
    wrong["ranges"]["c.re"] = {1, -1};
    EXPECT_FALSE(workspaceFromJson(wrong).ok());
}

// All that a fast hand, or a slow machine, does between two frames.
TEST(Keys, AreNotLostWhenTheyGoDownAndUpWithinAFrame) {
    SilentHost host;
    HeadlessGui gui;
    StudioContext context(host);
    const auto keys = [&] { handleKeys(context); };
    gui.frame(keys);
    const double before = sharedNumber(context.workspace, "c.re");
    for (int round = 0; round < 3; ++round) {
        context.edit([&](Workspace& w) { setSharedNumber(w, "c.re", 0.125); });
        context.edited.record();
        ImGuiIO& io = ImGui::GetIO();
        for (const bool down : {true, false}) {
            // Letting go may come in either order.
            if (down || round % 2 == 0) io.AddKeyEvent(ImGuiMod_Ctrl, down);
            io.AddKeyEvent(ImGuiKey_Z, down);
            if (!down && round % 2 == 1) io.AddKeyEvent(ImGuiMod_Ctrl, down);
        }
        for (int k = 0; k < 4; ++k) gui.frame(keys);
        EXPECT_EQ(sharedNumber(context.workspace, "c.re"), before) << round;
    }
}

// The modifier lies down already; then, within one frame, the key goes down and the modifier up.
TEST(Keys, KnowTheModifierThatWasHeldWhenTheyWentDown) {
    SilentHost host;
    HeadlessGui gui;
    StudioContext context(host);
    const auto keys = [&] { handleKeys(context); };
    gui.frame(keys);
    const double before = sharedNumber(context.workspace, "c.re");
    context.edit([&](Workspace& w) { setSharedNumber(w, "c.re", 0.125); });
    context.edited.record();
    ImGuiIO& io = ImGui::GetIO();
    io.AddKeyEvent(ImGuiMod_Ctrl, true);
    gui.frame(keys);
    io.AddKeyEvent(ImGuiKey_Z, true);
    io.AddKeyEvent(ImGuiMod_Ctrl, false);
    io.AddKeyEvent(ImGuiKey_Z, false);
    for (int k = 0; k < 3; ++k) gui.frame(keys);
    EXPECT_EQ(sharedNumber(context.workspace, "c.re"), before);
    // The other way round it is a letter, and no command.
    io.AddKeyEvent(ImGuiMod_Ctrl, true);
    gui.frame(keys);
    io.AddKeyEvent(ImGuiMod_Ctrl, false);
    io.AddKeyEvent(ImGuiKey_A, true);
    io.AddKeyEvent(ImGuiKey_A, false);
    for (int k = 0; k < 3; ++k) gui.frame(keys);
    EXPECT_TRUE(context.workspace.arrows);
}

// What is worked on is one entry; a new piece of work is another, and the host keeps all.
TEST(Gallery, KeepsRecentScenesFromOneStartToTheNext) {
    SilentHost host;
    {
        StudioContext context(host);
        for (int k = 0; k < 3; ++k) {
            context.edit([&](Workspace& w) { setSharedNumber(w, "c.re", 0.1 * k); });
            context.record();
        }
        ASSERT_EQ(context.gallery.recent().size(), 1u);
        for (const char* map : {"logistic", "newton"}) {
            context.newMap(map);
            context.record();
        }
        EXPECT_EQ(context.gallery.recent().size(), 3u);
        for (int k = 0; k < 40; ++k) {
            context.newMap("quadratic");
            context.edit([&](Workspace& w) { setSharedNumber(w, "c.re", 1.0 + k); });
            context.record();
        }
        EXPECT_EQ(context.gallery.recent().size(), Gallery::kMostRecent);
    }
    host.kept["recent"] = "v1:damaged\n" + host.kept["recent"];
    StudioContext again(host);
    ASSERT_EQ(again.gallery.recent().size(), Gallery::kMostRecent);
    const Expected<Workspace> newest = workspaceFromLink(again.gallery.recent()[0].link);
    ASSERT_TRUE(newest.ok());
    EXPECT_EQ(sharedNumber(*newest, "c.re"), 40);
}

TEST(Gallery, OpensByKeysAndAsksForItsPicturesOneByOne) {
    SilentHost host;
    HeadlessGui gui;
    StudioContext context(host);
    context.dialogs.gallery = true;
    const auto dialog = [&] { drawGallery(context); };
    const auto press = [&](ImGuiKey key) {
        ImGui::GetIO().AddKeyEvent(key, true);
        gui.frame(dialog);
        ImGui::GetIO().AddKeyEvent(key, false);
        gui.frame(dialog);
    };
    for (int k = 0; k < 3; ++k) gui.frame(dialog);
    ASSERT_EQ(host.requests.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<ThumbnailJob>(host.requests[0].job));
    press(ImGuiKey_RightArrow);
    press(ImGuiKey_RightArrow);
    press(ImGuiKey_LeftArrow);
    EXPECT_EQ(context.panels.of<GalleryPlace>().at, 1);
    const std::string name = context.gallery.presets()[1].preset;
    press(ImGuiKey_Enter);
    EXPECT_FALSE(context.dialogs.gallery);
    EXPECT_EQ(sceneToJson(context.workspace.view()), sceneToJson(*presetNamed(name)));
}

TEST(Help, EveryEntryOfTheGalleryExplainsItself) {
    SilentHost host;
    HeadlessGui gui({700, 500});
    StudioContext context(host);
    context.dialogs.gallery = true;
    expectHelpEverywhere(
        gui,
        [&] {
            drawGallery(context);
            ImGui::Dummy({1, 480});
        },
        "gallery", 50);
}

TEST(Help, EveryControlOfTheExportExplainsItself) {
    SilentHost host;
    HeadlessGui gui({560, 420});
    StudioContext context(host);
    context.dialogs.exporting = true;
    for (const bool plate : {false, true}) {
        context.exporting.plate = plate;
        const auto dialog = [&] {
            drawExport(context);
            ImGui::Dummy({1, 400});
        };
        expectHelpEverywhere(gui, dialog, plate ? "plate" : "picture");
    }
}

TEST(Help, EveryControlOfTheSearchExplainsItself) {
    SilentHost host;
    HeadlessGui gui({600, 500});
    StudioContext context(host);
    context.dialogs.find = true;
    const auto dialog = [&] {
        drawDialogs(context);
        ImGui::Dummy({1, 480});
    };
    expectHelpEverywhere(gui, dialog, "search");
}

}  // namespace
}  // namespace versorium
