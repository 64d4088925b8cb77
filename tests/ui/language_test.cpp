// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "ui/controls/controls.h"
#include "ui/dialogs/dialogs.h"
#include "ui/headless_gui.h"
#include "ui/panels/panels.h"
#include "ui/widgets/shown_number.h"

namespace versorium {
namespace {

// What a panel writes, as one text.
std::string written(HeadlessGui& gui, const std::function<void()>& panel) {
    std::string text;
    gui.frame([&] {
        ImGui::LogToBuffer();
        panel();
        text = ImGui::GetCurrentContext()->LogBuffer.c_str();
        ImGui::LogFinish();
    });
    return text;
}
bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

std::map<std::string, Control> controlsById(StudioContext& context) {
    std::map<std::string, Control> controls;
    for (Control& control : controlsOf(context)) controls[control.id] = control;
    return controls;
}

TEST(StudioLanguage, IsTheStoredOneElseTheSystems) {
    class Foreign : public SilentHost {
        std::string preferredLanguage() const override { return "es_AR.UTF-8"; }
    } host;
    { StudioContext context(host); }
    EXPECT_EQ(languageNow().id, "es");
    host.kept["language"] = "en";
    { StudioContext context(host); }
    EXPECT_EQ(languageNow().id, "en");
}

TEST(StudioLanguage, ChangesWhatPanelsWriteFromTheNextFrameOn) {
    SilentHost host;
    HeadlessGui gui({330, 1500});
    StudioContext context(host);
    const auto inspector = [&] { drawInspector(context); };
    gui.frame(inspector);
    const std::string english = written(gui, inspector);
    EXPECT_TRUE(has(english, "Parameters") && has(english, "escape radius")) << english;
    EXPECT_TRUE(has(english, "0.1889")) << english;
    context.speak("es");
    EXPECT_EQ(host.kept["language"], "es");
    const std::string spanish = written(gui, inspector);
    EXPECT_TRUE(has(spanish, "Parámetros") && has(spanish, "radio de escape")) << spanish;
    EXPECT_TRUE(has(spanish, "0,1889") && !has(spanish, "0.1889")) << spanish;
    EXPECT_FALSE(has(spanish, "escape radius")) << spanish;
    context.speak("en");
    EXPECT_EQ(written(gui, inspector), english);
}

TEST(StudioLanguage, ControlsKeepTheirNamesAndValues) {
    SilentHost host;
    StudioContext context(host);
    for (const char* map : {"quadratic", "planar", "shape-modulus"}) {
        context.newMap(map);
        context.speak("en");
        const auto english = controlsById(context);
        context.speak("es");
        const auto spanish = controlsById(context);
        ASSERT_EQ(english.size(), spanish.size());
        int said = 0;
        for (const auto& [id, control] : english) {
            const auto found = spanish.find(id);
            ASSERT_NE(found, spanish.end()) << id;
            EXPECT_EQ(found->second.options, control.options) << id;
            EXPECT_EQ(found->second.shown.size(), control.options.size()) << id;
            if (id == "language") continue;
            EXPECT_EQ(found->second.value, control.value) << id;
            said += found->second.label != control.label;
        }
        EXPECT_GT(said, 100) << map;
        EXPECT_EQ(spanish.at("iterations").label, "pasos máx. N");
        EXPECT_EQ(spanish.at("iterations").group, "Órbita");
        EXPECT_EQ(spanish.at("do undo").label, "Deshacer");
        EXPECT_EQ(spanish.at("colour.outline").value, english.at("colour.outline").value);
    }
    EXPECT_TRUE(has(describeView(context, 1), "Vista 2, puntos de partida de"));
    EXPECT_TRUE(has(controlsText(context), "\"language\":\"es\",\"decimal\":\",\""));
    context.speak("en");
}

TEST(StudioLanguage, ControlsTakeAPointOrAComma) {
    SilentHost host;
    StudioContext context(host);
    for (const char* language : {"es", "en"}) {
        EXPECT_TRUE(setControl(context, "language", language));
        EXPECT_EQ(languageNow().id, language);
        EXPECT_TRUE(setControl(context, "c.re", "0.5"));
        EXPECT_EQ(sharedNumber(context.workspace, "c.re"), 0.5);
        EXPECT_TRUE(setControl(context, "c.re", "-0,25"));
        EXPECT_EQ(sharedNumber(context.workspace, "c.re"), -0.25);
        EXPECT_EQ(controlsById(context).at("c.re").value, "-0.25");
        EXPECT_FALSE(setControl(context, "c.re", "-0,2,5"));
    }
    EXPECT_FALSE(setControl(context, "language", "tlh"));
}

TEST(StudioLanguage, NumbersAreShownTypedAndDraggedInItsForm) {
    SilentHost host;
    HeadlessGui gui({300, 100});
    StudioContext context(host);
    double value = 0.5;
    ImVec2 middle;
    const auto field = [&] {
        ImGui::SetNextItemWidth(120);
        dragNumber("##number", value, 0.01, "%.3g");
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        middle = {0.5f * (low.x + high.x), 0.5f * (low.y + high.y)};
    };
    ImGuiIO& io = ImGui::GetIO();
    const auto click = [&](bool down) {
        io.AddMouseButtonEvent(0, down);
        gui.frame(field);
    };
    const auto retype = [&](const char* text) {
        io.AddMousePosEvent(middle.x, middle.y);
        gui.frame(field);
        click(true), click(false), click(true), click(false);
        EXPECT_TRUE(io.WantTextInput);
        io.AddInputCharactersUTF8(text);
        for (int k = 0; k < 2; ++k) gui.frame(field);
        const std::string shown = written(gui, field);
        for (const bool down : {true, false}) {
            io.AddKeyEvent(ImGuiKey_Enter, down);
            gui.frame(field);
        }
        // Another double click must not go on from this one.
        for (int k = 0; k < 60; ++k) gui.frame(field);
        return shown;
    };
    gui.frame(field);
    for (const char* language : {"es", "en"}) {
        context.speak(language);
        value = 0.5;
        EXPECT_TRUE(has(written(gui, field), language[1] == 's' ? "0,5" : "0.5"));
        retype("0,25");
        EXPECT_EQ(value, 0.25) << language;
        retype("-1.75");
        EXPECT_EQ(value, -1.75) << language;
        retype("1,2,3");
        EXPECT_EQ(value, -1.75) << "no number changes nothing";
        // Dragged numbers have as many digits as are shown.
        io.AddMousePosEvent(middle.x, middle.y);
        gui.frame(field);
        click(true);
        io.AddMousePosEvent(middle.x + 17, middle.y);
        for (int k = 0; k < 2; ++k) gui.frame(field);
        click(false);
        EXPECT_GT(value, -1.75) << language;
        EXPECT_EQ(value, std::stod(formatNumber(value, 3))) << language;
        for (int k = 0; k < 60; ++k) gui.frame(field);
    }
}

// While it is typed, a number keeps its comma.
TEST(StudioLanguage, TypingBeginsWithWhatIsShown) {
    SilentHost host;
    HeadlessGui gui({300, 100});
    StudioContext context(host);
    context.speak("es");
    double value = 0.5;
    const auto field = [&] { dragNumber("##number", value, 0.01, "%.3g s"); };
    ImGuiIO& io = ImGui::GetIO();
    gui.frame(field);
    EXPECT_TRUE(has(written(gui, field), "0,5 s"));
    io.AddMousePosEvent(40, 20);
    for (const bool down : {true, false, true, false}) {
        io.AddMouseButtonEvent(0, down);
        gui.frame(field);
    }
    ASSERT_TRUE(io.WantTextInput);
    const std::string typed = written(gui, field);
    EXPECT_TRUE(has(typed, "0,5") && !has(typed, "0.5")) << typed;
    EXPECT_EQ(value, 0.5);
    context.speak("en");
}

TEST(StudioLanguage, OpenPartsStayOpenWhenItChanges) {
    SilentHost host;
    HeadlessGui gui({1280, 800});
    StudioContext context(host);
    const auto dialogs = [&] { drawDialogs(context); };
    context.dialogs.exporting = true;
    for (int k = 0; k < 3; ++k) gui.frame(dialogs);
    ImGuiContext& imgui = *ImGui::GetCurrentContext();
    ASSERT_EQ(imgui.OpenPopupStack.Size, 1);
    const ImGuiID before = imgui.OpenPopupStack[0].PopupId;
    context.speak("es");
    gui.frame(dialogs);
    ASSERT_EQ(imgui.OpenPopupStack.Size, 1);
    EXPECT_EQ(imgui.OpenPopupStack[0].PopupId, before);
    context.speak("en");
}

}  // namespace
}  // namespace versorium
