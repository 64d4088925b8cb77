// SPDX-License-Identifier: MIT
// A tool in the hand, with what it has drawn so far, and where α or β differ from place to place.
#include <algorithm>
#include <cmath>

#include "scene/shape_controls.h"
#include "shape/modulation.h"
#include "ui/backend/texture.h"
#include "ui/marks/mark.h"
#include "ui/session/drawing.h"
#include "ui/session/shape_change.h"

namespace versorium {
namespace {

constexpr int kOverlayWide = 160;  // pixels, stretched over the view
constexpr ImU32 kInk = IM_COL32(255, 255, 255, 255), kInkHalo = IM_COL32(8, 10, 14, 200);

// The number that is shown over the views: the brush's, else the one that differs over space.
Drawing::Tool toolShown(const StudioContext& context) {
    const Drawing& drawing = context.drawing;
    if (drawing.isBrush()) return drawing.tool;
    const Scene& scene = context.workspace.view();
    if (!drawing.overlay || !mapOf(scene).info.field) return Drawing::Tool::none;
    return scene.alphaOverSpace.modulates() || !scene.betaOverSpace.modulates()
               ? Drawing::Tool::alpha
               : Drawing::Tool::beta;
}

// Warm and the more opaque the further above its usual value, cool below it.
void fillOverlay(Drawing::Overlay& overlay, const Scene& scene, const OrbitProgram& program,
                 const Modulation* modulation, double base, const ViewPlane& plane) {
    const double aspect = (plane.high.x - plane.low.x) / (plane.high.y - plane.low.y);
    const Size size{kOverlayWide, std::clamp(static_cast<int>(kOverlayWide / aspect), 2, 640)};
    Raster<unsigned char> pixels(size, 4);
    overlay.low = overlay.high = base;
    if (modulation) {
        const auto range = modulation->rangeFrom(base);
        overlay.low = range[0], overlay.high = range[1];
        Viewport place = plane.place;
        place.size = size;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const auto at = shapePlace(scene, program, place.u(x), place.v(y));
                const double value = modulation->at(at[0], at[1], at[2], base);
                const double most = value > base ? range[1] - base : base - range[0];
                const double part = most > 0 ? std::abs(value - base) / most : 0;
                const bool above = value > base;
                unsigned char* pixel = &pixels.at(x, y);
                pixel[0] = above ? 255 : 70;
                pixel[1] = above ? 176 : 160;
                pixel[2] = above ? 40 : 255;
                pixel[3] = static_cast<unsigned char>(std::clamp(150 * part, 0.0, 150.0));
            }
    }
    overlay.texture = putTexture(overlay.texture, size, pixels.values().data());
}

void drawOverlay(const ViewFrame& frame) {
    StudioContext& context = frame.context;
    const ViewPlane& plane = frame.plane;
    const Drawing::Tool shown = toolShown(context);
    const Scene& scene = frame.scene();
    if (shown == Drawing::Tool::none || !traitsOf(scene).shape || !mapOf(scene).info.field) return;
    const OrbitProgram* program = context.bound.program(frame.view);
    if (!program || !program->field) return;
    const bool alpha = shown == Drawing::Tool::alpha;
    Drawing::Overlay& overlay = context.drawing.overlays[frame.index()];
    if (overlay.texture == 0 || overlay.revision != context.revision() || overlay.tool != shown) {
        overlay.revision = context.revision();
        overlay.tool = shown;
        fillOverlay(overlay, scene, *program,
                    alpha ? program->field->alpha() : program->field->beta(),
                    (alpha ? shapeControls(scene).alpha : shapeControls(scene).beta), plane);
    }
    frame.list().AddImage(textureId(overlay.texture), plane.low, plane.high);
    const std::string name = alpha ? "α" : "β";
    const std::string low = shownNumber(overlay.low, 4);
    const std::string text =
        overlay.low == overlay.high
            ? tr("{1} = {2} everywhere", {name, low})
            : tr("{1} from {2} to {3}: amber above its usual value, blue below",
                 {name, low, shownNumber(overlay.high, 4)});
    const float wide = plane.high.x - plane.low.x - 24;
    const float tall = ImGui::CalcTextSize(text.c_str(), nullptr, false, wide).y;
    drawText(frame.list(), {plane.low.x + 12, plane.high.y - tall - 10 * context.scale}, kInk, text,
             wide);
}

void drawCorners(const ViewFrame& frame) {
    const Drawing& drawing = frame.context.drawing;
    std::vector<ImVec2> points;
    for (const glm::dvec2& corner : drawing.corners)
        points.push_back(frame.plane.at(corner.x, corner.y));
    if (points.empty()) return;
    const float scale = frame.scale();
    ImDrawList& list = frame.list();
    const ImVec2 first = points[0];
    if (!drawing.pressed) points.push_back(frame.pointer.at);
    // Both ends of a list have 16 bits.
    const int count = std::min(static_cast<int>(points.size()), 8000);
    list.AddPolyline(points.data(), count, kInkHalo, 0, 4.5f * scale);
    list.AddPolyline(points.data(), count, kInk, 0, 2 * scale);
    list.AddLine(points[static_cast<std::size_t>(count) - 1], first, IM_COL32(255, 255, 255, 110),
                 1.2f * scale);
    list.AddCircleFilled(first, 6 * scale, kInkHalo);
    list.AddCircleFilled(first, 4 * scale, themes()[frame.context.theme].accent);
}

void drawDrawing(const ViewFrame& frame) {
    drawOverlay(frame);
    const Drawing& drawing = frame.context.drawing;
    if (drawing.tool == Drawing::Tool::none) return;
    if (drawing.tool == Drawing::Tool::outline) {
        if (frame.view == drawing.view) drawCorners(frame);
        return;
    }
    const ViewPlane& plane = frame.plane;
    const ImVec2 mouse = frame.pointer.at;
    const bool over = mouse.x >= plane.low.x && mouse.x < plane.high.x && mouse.y >= plane.low.y &&
                      mouse.y < plane.high.y;
    if (!over || !traitsOf(frame.scene()).shape) return;
    const auto radius = static_cast<float>(drawing.radius * plane.unit());
    frame.list().AddCircle(mouse, radius, kInkHalo, 0, 4 * frame.scale());
    frame.list().AddCircle(mouse, radius, kInk, 0, (drawing.erases ? 1.0f : 2.0f) * frame.scale());
}

bool useTool(const ViewFrame& frame) {
    return handleDrawing(frame.context, frame.view, frame.plane, frame.pointer);
}

}  // namespace

const Mark drawingMark{.draw = drawDrawing, .tool = useTool};

}  // namespace versorium
