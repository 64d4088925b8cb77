// SPDX-License-Identifier: MIT
#include "ui/session/space_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/shape_controls.h"
#include "shape/bounds.h"
#include "ui/backend/texture.h"
#include "ui/panels/number_field.h"
#include "ui/panels/panels.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

constexpr double kSecondsOfFrame = 0.008;  // for tracing
constexpr double kTurn = 0.009;            // radians for a pixel of a drag
constexpr double kRoom = 1.25;             // around the shape
constexpr float kTall = 0.8f;              // of the picture's width
constexpr unsigned char kVeil = 84;        // opacity of what lies before the plane

// What the shape is in light: a warm grey, in display values.
void putColour(unsigned char* pixel, float light, unsigned char alpha) {
    const double parts[3] = {226, 219, 205};
    for (int k = 0; k < 3; ++k)
        pixel[k] = static_cast<unsigned char>(parts[k] * std::sqrt(static_cast<double>(light)));
    pixel[3] = alpha;
}

void begin(SpaceView& view, const OrbitProgram& program, const Scene& scene, Size size) {
    const std::array<double, 3> shift = shapeControls(scene).seenShift();
    const glm::dvec3 by(shift[0], shift[1], shift[2]);
    // Every binding has a field of its own, of the same shape.
    const ShapeSpec& shape = scene.shape;
    const std::string of = shape.source + "/" + std::to_string(shape.resolution) + "/" +
                           formatNumber(shape.padding) + "/" + std::string(wordOf(shape.outside)) +
                           (shape.zFastest ? "/z" : "/x");
    if (view.of != of || view.shift != by) {
        const ShapeBounds bounds = boundsOf(*program.field, 3);
        view.of = of;
        view.shift = by;
        glm::dvec3 half(0);
        for (int k = 0; k < 3; ++k) {
            const auto at = static_cast<std::size_t>(k);
            half[k] = 0.5 * (bounds.high[at] - bounds.low[at]);
            view.camera.centre[k] = 0.5 * (bounds.high[at] + bounds.low[at]) + by[k];
        }
        view.reach = kRoom * glm::length(half);
        view.camera.halfHeight = view.reach;
        view.shown = false;
    }
    if (view.shown && view.shape.size() == size && view.shape.camera() == view.camera) return;
    view.shape.start(program.field, view.shift, view.reach, view.camera, size);
    view.shown = true;
    view.veiled = false;
}

// Traces on, from the top down, and shows what there is.
void work(StudioContext& context, SpaceView& view) {
    if (view.shape.finished() && view.solid != 0) return;
    const double until = context.host.now() + kSecondsOfFrame;
    do view.shape.advance(4);
    while (!view.shape.finished() && context.host.now() < until);
    const Size size = view.shape.size();
    Raster<unsigned char> pixels(size, 4);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (view.shape.light().at(x, y) > 0)
                putColour(&pixels.at(x, y), view.shape.light().at(x, y), 255);
    view.solid = putTexture(view.solid, size, pixels.values().data());
    view.veiled = false;
    context.host.wake();
}

// Along the view, from the plane through the camera's centre, to the slice plane; NaN beside it.
double depthOfPlane(const SpaceView& view, const PlaneInSpace& plane, const Viewport& place,
                    const glm::dvec3& from) {
    const glm::dvec3 forward = view.camera.forward(), normal = plane.normal();
    const double slant = glm::dot(forward, normal);
    if (std::abs(slant) < 1e-9) return NAN;
    const double depth = glm::dot(plane.origin - from, normal) / slant;
    const glm::dvec3 hit = from + depth * forward - plane.origin;
    const double aspect = static_cast<double>(place.size.width) / place.size.height;
    const bool beside =
        std::abs(glm::dot(hit, plane.right) - place.centre[0]) > 0.5 * place.height * aspect ||
        std::abs(glm::dot(hit, plane.up) - place.centre[1]) > 0.5 * place.height;
    return beside ? NAN : depth;
}

void makeVeil(SpaceView& view, const PlaneInSpace& plane, const Viewport& place) {
    const bool same = view.veiled && view.behind.right == plane.right &&
                      view.behind.up == plane.up &&
                      view.behind.origin == plane.at(place.centre[0], place.centre[1]) &&
                      view.tall == place.height;
    if (same) return;
    view.veiled = true;
    view.behind = plane;
    view.behind.origin = plane.at(place.centre[0], place.centre[1]);
    view.tall = place.height;
    const Size size = view.shape.size();
    Raster<unsigned char> pixels(size, 4);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double depth = view.shape.depth().at(x, y);
            if (std::isnan(depth)) continue;
            const double there = depthOfPlane(view, plane, place, view.shape.pointAt(x, y));
            if (depth < there) putColour(&pixels.at(x, y), view.shape.light().at(x, y), kVeil);
        }
    view.veil = putTexture(view.veil, size, pixels.values().data());
}

void take(StudioContext& context, SpaceView& view, const PlaneInSpace& plane, const Viewport& place,
          bool onPlane, double pixel) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActivated())
        view.grip = io.KeyShift || ImGui::IsMouseDown(1) ? SpaceView::Grip::tilt
                    : onPlane                            ? SpaceView::Grip::move
                                                         : SpaceView::Grip::look;
    if (!ImGui::IsItemActive()) {
        view.grip = SpaceView::Grip::none;
        return;
    }
    const ImVec2 moved = io.MouseDelta;
    if (moved.x == 0 && moved.y == 0) return;
    const SpaceCamera& camera = view.camera;
    const double u = place.centre[0], v = place.centre[1];
    if (view.grip == SpaceView::Grip::look) {
        view.camera.yaw -= kTurn * moved.x;
        view.camera.pitch = std::clamp(view.camera.pitch + kTurn * moved.y, -1.5, 1.5);
    } else if (view.grip == SpaceView::Grip::tilt) {
        const PlaneInSpace once = turned(plane, u, v, camera.up(), kTurn * moved.x);
        putPlane(context, turned(once, u, v, camera.right(), kTurn * moved.y));
    } else {
        // The normal's picture says how far along it the hand has gone; seen end on, up is away.
        PlaneInSpace next = plane;
        const glm::dvec3 normal = plane.normal();
        const double across = glm::dot(normal, camera.right());
        const double along = glm::dot(normal, camera.up());
        const double size = across * across + along * along;
        const double gone = size > 0.05
                                ? (moved.x * across - moved.y * along) / size
                                : -moved.y * (glm::dot(normal, camera.forward()) > 0 ? 1.0 : -1.0);
        next.origin += gone * pixel * normal;
        putPlane(context, next);
    }
    context.host.wake();
}

void drawPicture(StudioContext& context, SpaceView& view, const PlaneInSpace& plane, ImVec2 low,
                 ImVec2 high) {
    const int index = context.workspace.focused;
    const Scene& scene = context.workspace.view();
    LivePicture& picture = context.views[static_cast<std::size_t>(index)].picture;
    Viewport place = viewportOf(scene, {1000, 1000});
    const double aspect = context.aspect(index);
    place.height = shownHeight(scene, aspect);
    place.size = {std::max(1, static_cast<int>(1000 * aspect)), 1000};
    const SpaceCamera& camera = view.camera;
    const double unit = 0.5 * (high.y - low.y) / camera.halfHeight;
    const auto at = [&](const glm::dvec3& point) {
        const glm::dvec3 from = point - camera.centre;
        return ImVec2{
            0.5f * (low.x + high.x) + static_cast<float>(glm::dot(from, camera.right()) * unit),
            0.5f * (low.y + high.y) - static_cast<float>(glm::dot(from, camera.up()) * unit)};
    };
    const auto corner = [&](double x, double y) {
        return at(plane.at(place.centre[0] + x * 0.5 * place.height * aspect,
                           place.centre[1] + y * 0.5 * place.height));
    };
    const ImVec2 quad[4] = {corner(-1, 1), corner(1, 1), corner(1, -1), corner(-1, -1)};
    const glm::dvec3 pointed =
        camera.centre +
        camera.right() * ((ImGui::GetIO().MousePos.x - 0.5 * (low.x + high.x)) / unit) -
        camera.up() * ((ImGui::GetIO().MousePos.y - 0.5 * (low.y + high.y)) / unit);
    const bool onPlane = !std::isnan(depthOfPlane(view, plane, place, pointed));
    take(context, view, plane, place, onPlane, 1 / unit);
    makeVeil(view, plane, place);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(low, high, true);
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 6);
    list.AddImage(textureId(view.solid), low, high);
    if (const unsigned texture = picture.shownTexture(); texture != 0)
        list.AddImageQuad(textureId(texture), quad[0], quad[1], quad[2], quad[3]);
    list.AddQuad(quad[0], quad[1], quad[2], quad[3], themes()[context.theme].accent, 1.5f);
    list.AddImage(textureId(view.veil), low, high);
    const char* names[] = {"x", "y", "z"};
    for (int k = 0; k < 3; ++k) {
        // A compass in the corner.
        glm::dvec3 axis(0);
        axis[k] = 1;
        const ImVec2 foot{low.x + 30, high.y - 30};
        const ImVec2 tip{foot.x + static_cast<float>(22 * glm::dot(axis, camera.right())),
                         foot.y - static_cast<float>(22 * glm::dot(axis, camera.up()))};
        list.AddLine(foot, tip, ImGui::GetColorU32(ImGuiCol_TextDisabled), 1.5f);
        list.AddText({tip.x - 3, tip.y - 7}, ImGui::GetColorU32(ImGuiCol_Text), names[k]);
    }
    list.PopClipRect();
}

}  // namespace

void drawSpaceView(StudioContext& context) {
    const std::optional<PlaneInSpace> plane = markedPlane(context);
    if (!plane) return;
    heading("Slice in space");
    SpaceView& view = context.space;
    const float wide = std::min(ImGui::GetContentRegionAvail().x, 420 * context.scale);
    const float tall = std::floor(wide * kTall);
    const Scene scene = context.workspace.view();
    const OrbitProgram program = *context.bound.program(context.workspace.focused);
    begin(view, program, scene, {static_cast<int>(wide), static_cast<int>(tall)});
    work(context, view);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("space", {wide, tall},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    drawPicture(context, view, *plane, low, {low.x + wide, low.y + tall});
    explain("slice in space");
    double offset = planeOffset(*plane);
    if (numberField(context, "slice offset", "offset", offset,
                    {.help = helpOf("slice offset"), .low = -0.5, .high = 0.5, .home = 0})) {
        PlaneInSpace next = *plane;
        next.origin += (offset - planeOffset(*plane)) * plane->normal();
        putPlane(context, next);
    }
    const std::pair<const char*, PlaneInSpace> straight[] = {{"xy", {{1, 0, 0}, {0, 1, 0}, {}}},
                                                             {"xz", {{1, 0, 0}, {0, 0, 1}, {}}},
                                                             {"zy", {{0, 0, 1}, {0, 1, 0}, {}}}};
    for (const auto& [name, upright] : straight) {
        if (ImGui::SmallButton(name)) {
            PlaneInSpace next = upright;
            next.origin = glm::dot(plane->origin, next.normal()) * next.normal();
            putPlane(context, next);
        }
        explain("straight slice");
        ImGui::SameLine();
    }
    ImGui::TextDisabled("%s", tr("drag: plane, Shift: tilt"));
}

}  // namespace versorium
