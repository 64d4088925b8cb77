// SPDX-License-Identifier: MIT
#pragma once
// Places in the window and the pointer over a view, as plain values: whatever changes the workspace
// by hand is told of them and knows no ImGui. Pixels, x to the right, y down.

#include <type_traits>

namespace versorium {

struct ScreenPoint {
    float x = 0, y = 0;

    constexpr ScreenPoint() = default;
    constexpr ScreenPoint(float right, float down) : x(right), y(down) {}
    // From and to whatever else the window has for two floats, such as ImVec2.
    template <class Other>
    requires std::is_same_v<decltype(Other::x), float> && std::is_same_v<decltype(Other::y), float>
    constexpr ScreenPoint(const Other& other) : x(other.x), y(other.y) {}
    template <class Other>
    requires std::is_same_v<decltype(Other::x), float> &&(sizeof(Other) == 2 * sizeof(float)) &&
        std::is_constructible_v<Other, float, float> constexpr operator Other() const {
        return Other(x, y);
    }
};

// In one frame. Left and right are the buttons that went down in it.
struct Pointer {
    ScreenPoint at, moved;  // where it is, and how far it came since the last frame
    bool over = false;      // the view, with nothing in between
    bool held = false;      // a button that went down over the view still is
    bool left = false, right = false, twice = false;  // pressed; a double click of the left one
    bool rightDown = false;
    bool shift = false, ctrl = false, alt = false;
    float wheel = 0, sideways = 0;  // steps

    bool modified() const { return shift || ctrl || alt; }
};

}  // namespace versorium
