// SPDX-License-Identifier: MIT
#pragma once
// Drawing in a view by mouse, pen or finger: the outline of a shape, freehand or corner by corner,
// which becomes the scene's shape; and a brush that paints other values of α or β (S Fig 7).

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "ui/session/screen.h"
#include "workspace/workspace.h"

namespace versorium {

struct StudioContext;
struct ViewPlane;

struct Drawing {
    enum class Tool { none, outline, alpha, beta } tool = Tool::none;
    int view = -1;                    // that the corners are drawn in
    std::vector<glm::dvec2> corners;  // along that view's axes
    bool pressed = false;             // the button is down since the last corner
    ScreenPoint pressedAt;
    // The brush: its radius in units of the shape, the values that it paints, and whether it takes
    // paint away instead.
    double radius = 0.15, alpha = 60, beta = 0.1;
    bool erases = false;
    glm::dvec2 lastDab{};  // of the stroke under way, along the view's axes
    bool overlay = false;  // α or β are shown over the views without a brush, too
    // Pictures of that, one for each view.
    struct Overlay {
        unsigned texture = 0;
        std::uint64_t revision = 0;
        Tool tool = Tool::none;
        double low = 0, high = 0;
    };
    std::array<Overlay, kMostViews> overlays;
    void contextLost() {
        for (Overlay& overlay : overlays) overlay.texture = 0;
    }
    bool isBrush() const { return tool == Tool::alpha || tool == Tool::beta; }
};

// Takes a tool up, or lays it down where it is in the hand already.
void chooseTool(StudioContext& context, Drawing::Tool tool);
// The pointer's work while a tool is in the hand; true where it was for the tool.
bool handleDrawing(StudioContext& context, int view, const ViewPlane& plane,
                   const Pointer& pointer);
// Keys that were pressed: Enter closes an outline, Backspace takes its last corner back, Escape
// lays the tool down. True where they were for the tool.
struct DrawingKeys {
    bool enter = false, back = false, escape = false;
};
bool drawingKeys(StudioContext& context, const DrawingKeys& pressed);
// What to do now; empty without a tool.
std::string drawingHint(const StudioContext& context);

// One dab of the brush where the orbit starts, for those who have no pointer.
void paintAtPoint(StudioContext& context, Drawing::Tool tool);
// Closes the outline and makes it the scene's shape.
void finishOutline(StudioContext& context);

}  // namespace versorium
