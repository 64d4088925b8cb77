// SPDX-License-Identifier: MIT
#include "ui/marks/shapes.h"

#include <algorithm>
#include <cmath>

namespace versorium {
namespace {

constexpr ImU32 kCycleHalo = IM_COL32(8, 10, 14, 210);

}  // namespace

void drawArrow(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 colour, ImU32 halo, float scale) {
    const float x = to.x - from.x, y = to.y - from.y;
    const float length = std::hypot(x, y);
    if (length < 3 * scale) return;
    const float head = std::min(7 * scale, 0.5f * length);
    const ImVec2 along{x / length * head, y / length * head};
    const ImVec2 neck{to.x - along.x, to.y - along.y};
    const ImVec2 left{neck.x - 0.45f * along.y, neck.y + 0.45f * along.x};
    const ImVec2 right{neck.x + 0.45f * along.y, neck.y - 0.45f * along.x};
    list.AddLine(from, neck, halo, 3.6f * scale);
    list.AddTriangle(to, left, right, halo, 2.4f * scale);
    list.AddLine(from, neck, colour, 1.5f * scale);
    list.AddTriangleFilled(to, left, right, colour);
}

ImU32 stepColour(int n, int steps, int alpha) {
    // Yellow, vermilion, violet: apart for colour-blind eyes by their lightness as well.
    constexpr int colours[3][3] = {{255, 222, 110}, {240, 128, 92}, {190, 120, 230}};
    const double part = 2.0 * std::clamp(static_cast<double>(n) / std::max(1, steps), 0.0, 1.0);
    const int first = part < 1 ? 0 : 1;
    const double t = part - first;
    const auto mixed = [&](int c) {
        return static_cast<int>((1 - t) * colours[first][c] + t * colours[first + 1][c]);
    };
    return IM_COL32(mixed(0), mixed(1), mixed(2), alpha);
}

ImU32 cycleColour(CycleKind kind) {
    switch (kind) {
        case CycleKind::attracting:
            return IM_COL32(95, 220, 170, 255);
        case CycleKind::repelling:
            return IM_COL32(255, 190, 90, 255);
        case CycleKind::saddle:
            return IM_COL32(255, 120, 110, 255);
        default:
            return IM_COL32(220, 220, 230, 255);
    }
}

void drawCycleMark(ImDrawList& list, ImVec2 at, float size, CycleKind kind) {
    const ImU32 colour = cycleColour(kind);
    switch (kind) {
        case CycleKind::attracting:
            list.AddCircleFilled(at, size + 1.5f, kCycleHalo);
            list.AddCircleFilled(at, size, colour);
            break;
        case CycleKind::repelling:
            list.AddCircle(at, size, kCycleHalo, 0, 5);
            list.AddCircle(at, size, colour, 0, 2);
            break;
        case CycleKind::saddle:
            for (const auto& [tint, width] :
                 {std::pair{kCycleHalo, 5.0f}, std::pair{colour, 2.2f}}) {
                list.AddLine({at.x - size, at.y - size}, {at.x + size, at.y + size}, tint, width);
                list.AddLine({at.x - size, at.y + size}, {at.x + size, at.y - size}, tint, width);
            }
            break;
        default:
            list.AddQuad({at.x, at.y - size}, {at.x + size, at.y}, {at.x, at.y + size},
                         {at.x - size, at.y}, kCycleHalo, 5);
            list.AddQuad({at.x, at.y - size}, {at.x + size, at.y}, {at.x, at.y + size},
                         {at.x - size, at.y}, colour, 2);
    }
}

}  // namespace versorium
