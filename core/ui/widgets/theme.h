// SPDX-License-Identifier: MIT
#pragma once
// How the studio looks: colours, sizes and letters, all in one place.

#include <string>
#include <vector>

#include "imgui.h"

namespace versorium {

struct StudioTheme {
    std::string name;
    ImU32 background, panel, line, text, secondary, accent;
    float fontSize;  // in pixels at scale 1
};

const std::vector<StudioTheme>& themes();  // dark, light, projector
void applyTheme(const StudioTheme& theme, float scale);
// Letters from the fonts that the core carries: Latin, Greek, arrows, operators, double-struck.
void loadFonts(const StudioTheme& theme, float scale);

// Four pins: colours that colour-blind eyes tell apart, each with a shape of its own.
enum class MarkShape { ring, square, triangle, diamond };
ImU32 pinColour(int pin);
// A mark with a dark halo, so that it is seen on any picture.
void drawMark(ImDrawList& list, ImVec2 at, float size, MarkShape shape, ImU32 colour);
// Wrapped to a width above 0.
void drawText(ImDrawList& list, ImVec2 at, ImU32 colour, const std::string& text, float wrap = 0);

}  // namespace versorium
