// SPDX-License-Identifier: MIT
#include "ui/views/view_drawing.h"
#include "scene/shape_controls.h"

#include <cmath>

#include "ui/backend/texture.h"
#include "ui/marks/mark.h"

namespace versorium {
namespace {

// Where the picture that there is lies in the view that is wanted.
void drawPicture(const ViewFrame& frame) {
    LivePicture& picture = frame.state().picture;
    const unsigned texture = picture.shownTexture();
    if (texture == 0) return;
    const ScreenPoint low = frame.plane.low, high = frame.plane.high;
    const Viewport &shown = picture.shownPlace(), &place = picture.wantedPlace();
    const double scale = shown.height / place.height;
    const double unit = (high.y - low.y) / place.height;
    const auto away = [&](std::size_t axis) {
        return ((shown.centre[axis] - place.centre[axis]) +
                (shown.centreLow[axis] - place.centreLow[axis])) *
               unit;
    };
    const double x = 0.5 * (low.x + high.x) + away(0), y = 0.5 * (low.y + high.y) - away(1);
    const double halfHeight = 0.5 * (high.y - low.y) * scale;
    const double halfWidth = halfHeight * shown.size.width / shown.size.height;
    constexpr double kFar = 1e7;
    if (!(std::abs(x) < kFar && std::abs(y) < kFar && halfWidth < kFar)) return;
    const auto corner = [](double u, double v) {
        return ImVec2{static_cast<float>(u), static_cast<float>(v)};
    };
    frame.list().AddImage(textureId(texture), corner(x - halfWidth, y - halfHeight),
                          corner(x + halfWidth, y + halfHeight));
}

void drawMarks(const ViewFrame& frame) {
    for (const Mark* mark : marksByHeight())
        if (mark->draw) mark->draw(frame);
    if (const Drag& drag = frame.state().drag; drag.draw) drag.draw(frame);
}

void drawTitle(const ViewFrame& frame) {
    const Scene& scene = frame.scene();
    const ScreenPoint low = frame.plane.low, high = frame.plane.high;
    std::string title = tr(traitsOf(scene).title);
    if (frame.workspace().analysis() && frame.view > 0) title += " " + std::to_string(frame.view);
    if (mapOf(scene).info.field && shapeControls(scene).asPrinted)
        title += tr(", φ + β as printed");
    const std::string measure =
        "  ·  " + tr("height {1}", {shownNumber(frame.plane.place.height, 3)});
    if (ImGui::CalcTextSize((title + measure).c_str()).x < high.x - low.x - 48 * frame.scale())
        title += measure;
    drawText(frame.list(), {low.x + 12, low.y + 9}, IM_COL32(231, 233, 238, 255), title);
    const LivePicture& picture = frame.state().picture;
    if (!picture.message().empty())
        drawText(frame.list(), {low.x + 12, 0.5f * (low.y + high.y)}, IM_COL32(255, 190, 120, 255),
                 trMessage(picture.message()));
}

// The thin line of progress, and the border of the focused view.
void drawEdge(const ViewFrame& frame) {
    const ScreenPoint low = frame.plane.low, high = frame.plane.high;
    const ImU32 accent = themes()[frame.context.theme].accent;
    const LivePicture& picture = frame.state().picture;
    if (!picture.finished())
        frame.list().AddRectFilled(
            {low.x, high.y - 2},
            {low.x + (high.x - low.x) * (0.1f + 0.9f * picture.progress()), high.y}, accent);
    const Workspace& workspace = frame.workspace();
    if (workspace.focused == frame.view && workspace.views.size() > 1)
        frame.list().AddRect(low, high, accent, 0, 0, 1);
}

}  // namespace

void drawViewParts(const ViewFrame& frame) {
    ImDrawList& list = frame.list();
    const ScreenPoint low = frame.plane.low, high = frame.plane.high;
    list.AddRectFilled(low, high, IM_COL32(10, 11, 15, 255));
    list.PushClipRect(low, high, true);
    drawPicture(frame);
    drawMarks(frame);
    drawTitle(frame);
    drawEdge(frame);
    list.PopClipRect();
}

}  // namespace versorium
