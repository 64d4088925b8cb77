// SPDX-License-Identifier: MIT
#include "ui/widgets/theme.h"

#include <algorithm>

#include "base/embedded.h"
#include "i18n/language.h"

namespace versorium {
namespace {

constexpr ImU32 rgb(unsigned value) {
    return IM_COL32((value >> 16) & 255, (value >> 8) & 255, value & 255, 255);
}
constexpr ImU32 kHalo = IM_COL32(8, 10, 14, 220);

ImVec4 vector(ImU32 colour, float alpha = 1) {
    ImVec4 value = ImGui::ColorConvertU32ToFloat4(colour);
    value.w *= alpha;
    return value;
}

ImVec4 between(ImU32 a, ImU32 b, float t) {
    const ImVec4 x = vector(a), y = vector(b);
    return {x.x + t * (y.x - x.x), x.y + t * (y.y - x.y), x.z + t * (y.z - x.z), 1};
}

// All that the font has: core/cmake/fonts.cmake says what it was cut to.
constexpr ImWchar kLetters[] = {0x20, 0xffff, 0};

}  // namespace

const std::vector<StudioTheme>& themes() {
    static const std::vector<StudioTheme> all = {
        {trLater("dark"), rgb(0x0f1115), rgb(0x14171d), rgb(0x262b34), rgb(0xe7e9ee), rgb(0x9aa3b2),
         rgb(0x69d2c3), 15},
        {trLater("light"), rgb(0xf2f3f5), rgb(0xffffff), rgb(0xcdd2da), rgb(0x16181d),
         rgb(0x525a67), rgb(0x0b7a6c), 15},
        {trLater("projector"), rgb(0xffffff), rgb(0xffffff), rgb(0x6d747f), rgb(0x000000),
         rgb(0x2c323b), rgb(0x005f8a), 20},
    };
    return all;
}

void applyTheme(const StudioTheme& theme, float scale) {
    ImGuiStyle style;
    style.WindowRounding = 0;
    style.ChildRounding = style.FrameRounding = style.GrabRounding = style.PopupRounding = 6;
    style.FramePadding = {8, 5};
    style.ItemSpacing = {8, 7};
    style.WindowPadding = {12, 10};
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.FrameBorderSize = 1;
    style.ScrollbarSize = 12;
    style.ScaleAllSizes(scale);
    const ImVec4 frame = between(theme.panel, theme.line, 0.55f);
    const auto set = [&](ImGuiCol which, ImVec4 value) { style.Colors[which] = value; };
    set(ImGuiCol_Text, vector(theme.text));
    set(ImGuiCol_TextDisabled, vector(theme.secondary));
    set(ImGuiCol_WindowBg, vector(theme.background));
    set(ImGuiCol_ChildBg, vector(theme.panel));
    set(ImGuiCol_PopupBg, vector(theme.panel));
    set(ImGuiCol_TitleBg, vector(theme.panel));
    set(ImGuiCol_TitleBgActive, vector(theme.panel));
    set(ImGuiCol_Border, vector(theme.line));
    set(ImGuiCol_Separator, vector(theme.line));
    set(ImGuiCol_FrameBg, frame);
    set(ImGuiCol_FrameBgHovered, between(theme.panel, theme.line, 0.9f));
    set(ImGuiCol_FrameBgActive, vector(theme.line));
    set(ImGuiCol_Button, frame);
    set(ImGuiCol_ButtonHovered, between(theme.panel, theme.accent, 0.25f));
    set(ImGuiCol_ButtonActive, between(theme.panel, theme.accent, 0.45f));
    set(ImGuiCol_Header, between(theme.panel, theme.accent, 0.18f));
    set(ImGuiCol_HeaderHovered, between(theme.panel, theme.accent, 0.28f));
    set(ImGuiCol_HeaderActive, between(theme.panel, theme.accent, 0.4f));
    set(ImGuiCol_SliderGrab, vector(theme.accent));
    set(ImGuiCol_SliderGrabActive, vector(theme.text));
    set(ImGuiCol_CheckMark, vector(theme.accent));
    set(ImGuiCol_NavHighlight, vector(theme.accent));
    set(ImGuiCol_ScrollbarBg, vector(theme.panel));
    set(ImGuiCol_ScrollbarGrab, vector(theme.line));
    set(ImGuiCol_TableHeaderBg, frame);
    set(ImGuiCol_TableBorderLight, vector(theme.line));
    set(ImGuiCol_TableBorderStrong, vector(theme.line));
    set(ImGuiCol_ModalWindowDimBg, {0, 0, 0, 0.5f});
    ImGui::GetStyle() = style;
}

void loadFonts(const StudioTheme& theme, float scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    const auto bytes = embedded("fonts/DejaVuSans.ttf");
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    // ImGui does not write to it; its interface only lacks the const.
    atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(bytes.data()),
                               static_cast<int>(bytes.size()), theme.fontSize * scale, &config,
                               kLetters);
}

ImU32 pinColour(int pin) {
    constexpr ImU32 colours[] = {rgb(0x56b4e9), rgb(0xe69f00), rgb(0x009e73), rgb(0xd55e00)};
    return colours[pin & 3];
}

void drawMark(ImDrawList& list, ImVec2 at, float size, MarkShape shape, ImU32 colour) {
    const auto outline = [&](ImU32 tint, float width) {
        switch (shape) {
            case MarkShape::ring:
                list.AddCircle(at, size, tint, 0, width);
                break;
            case MarkShape::square:
                list.AddRect({at.x - size, at.y - size}, {at.x + size, at.y + size}, tint, 0, 0,
                             width);
                break;
            case MarkShape::triangle:
                list.AddTriangle({at.x, at.y - size}, {at.x + size, at.y + size * 0.8f},
                                 {at.x - size, at.y + size * 0.8f}, tint, width);
                break;
            case MarkShape::diamond:
                list.AddQuad({at.x, at.y - size}, {at.x + size, at.y}, {at.x, at.y + size},
                             {at.x - size, at.y}, tint, width);
                break;
        }
    };
    const float line = std::max(2.0f, size * 0.3f);
    outline(kHalo, line * 2.2f);
    outline(colour, line);
    list.AddCircleFilled(at, size * 0.42f, kHalo);
    list.AddCircleFilled(at, size * 0.28f, colour);
}

void drawText(ImDrawList& list, ImVec2 at, ImU32 colour, const std::string& text, float wrap) {
    const auto write = [&](ImVec2 place, ImU32 ink) {
        list.AddText(nullptr, 0, place, ink, text.c_str(), nullptr, wrap);
    };
    for (const ImVec2 step : {ImVec2{-1, 0}, ImVec2{1, 0}, ImVec2{0, -1}, ImVec2{0, 1}})
        write({at.x + step.x, at.y + step.y}, kHalo);
    write(at, colour);
}

}  // namespace versorium
