// SPDX-License-Identifier: MIT
// A view: the picture, what lies on it, and the hand that moves it. Drag pans; the ring is dragged;
// the wheel zooms at the pointer; a box drawn with the right button is zoomed to; a double click
// goes in; Ctrl and a click set the point; Shift and a click pin the parameters; Alt and a drag set
// the second start, or p* beside the critical curve. Where roots are shown, the wheel over a root
// raises its power, and a double click makes one.
#include <algorithm>
#include <cmath>

#include "scene/parts.h"
#include "scene/shape_controls.h"
#include "ui/marks/marks.h"
#include "ui/marks/root_marks.h"
#include "ui/marks/study_marks.h"
#include "ui/session/context.h"
#include "ui/session/view_plane.h"

namespace versorium {
namespace {

constexpr float kReach = 16;  // how near the pointer must come to a mark, at scale 1
constexpr double kWheel = 0.8;
// Seconds of a frame for the graphics processor's pictures: half of it where frames are slow.
constexpr double kLeastBudget = 0.012, kMostBudget = 0.05;
// A picture that waits, to be no flash too many, is tried again after this.
constexpr double kHeldSeconds = 0.1;

bool near(ImVec2 a, ImVec2 b, float reach) { return std::hypot(a.x - b.x, a.y - b.y) <= reach; }

// The view of an analysis whose place in the first view is near the pointer; 0 where none is.
int placeNear(const StudioContext& context, const ViewPlane& plane, ImVec2 mouse) {
    const Workspace& workspace = context.workspace;
    int nearest = 0;
    float reach = kReach * context.scale;
    for (std::size_t k = 1; k < workspace.views.size(); ++k) {
        const auto at = markerOf(workspace.views[k], workspace.views[0].slice);
        const ImVec2 place = plane.at(at[0], at[1]);
        const float distance = std::hypot(mouse.x - place.x, mouse.y - place.y);
        if (distance > reach) continue;
        reach = distance;
        nearest = static_cast<int>(k);
    }
    return nearest;
}

// The four places of an analysis in its first view, and the mark of each in the others.
void drawPlaces(const StudioContext& context, int view, const ViewPlane& plane, ImDrawList& list) {
    const Workspace& workspace = context.workspace;
    for (int k = 1; k < kAnalysisViews; ++k) {
        const auto shape = static_cast<MarkShape>(k - 1);
        const float size = 8 * context.scale;
        const ImVec2 corner{plane.high.x - 18 * context.scale, plane.low.y + 18 * context.scale};
        if (view == k) drawMark(list, corner, size, shape, pinColour(k - 1));
        if (view != 0) continue;
        const auto at =
            markerOf(workspace.views[static_cast<std::size_t>(k)], workspace.views[0].slice);
        const ImVec2 place = plane.at(at[0], at[1]);
        if (static_cast<int>(workspace.speaker()) == k)
            list.AddCircle(place, 14 * context.scale, IM_COL32(255, 255, 255, 220), 0, 1.5f);
        drawMark(list, place, size, shape, pinColour(k - 1));
        drawText(list, {place.x + 11 * context.scale, place.y - 20 * context.scale},
                 pinColour(k - 1), std::to_string(k));
    }
}

// The scene without what changes no orbit and no count of members.
std::string orbitsText(Json json) {
    json.erase("colour");
    const auto ensemble = json.find("ensemble");
    if (ensemble != json.end()) ensemble->erase("count");
    if (ensemble == json.end() || (*ensemble)["set"] != "solid") json.erase("iso");
    return json.dump();
}

// The pointer's work; true while it may probe.
void handlePointer(StudioContext& context, int view, const ViewPlane& plane, bool hovered,
                   bool active) {
    ViewState& state = context.views[static_cast<std::size_t>(view)];
    Workspace& workspace = context.workspace;
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 mouse = io.MousePos;
    const auto marker = markerOf(workspace, static_cast<std::size_t>(view));
    const ImVec2 ring = plane.at(marker[0], marker[1]);
    // Some systems turn the wheel sideways while Shift is down.
    const float wheel = io.MouseWheel != 0 ? io.MouseWheel : io.KeyShift ? io.MouseWheelH : 0;
    if (hovered && wheel != 0 && raiseRoot(context, view, plane, mouse, wheel, io.KeyShift)) {
        // It is the root's.
    } else if (hovered && io.MouseWheel != 0)
        context.zoom(view, std::pow(kWheel, static_cast<double>(io.MouseWheel)), plane.u(mouse.x),
                     plane.v(mouse.y));
    if (handleDrawing(context, view, plane, hovered, active)) {
        state.drag = ViewState::Drag::none;
        return;
    }
    const bool left = ImGui::IsMouseClicked(0), right = ImGui::IsMouseClicked(1);
    if (hovered && (left || right)) {
        const bool places = workspace.analysis() && view == 0;
        const int place = places ? placeNear(context, plane, mouse) : 0;
        const int spoken = static_cast<int>(workspace.speaker());
        context.mark(place > 0 ? place : places && io.KeyCtrl ? spoken : view);
        context.welcome = false;
        context.animation.running = context.animation.running && !left;
        state.dragFrom = mouse;
        if (right) {
            state.drag = openRootMenu(context, view, plane, mouse) ? ViewState::Drag::none
                                                                   : ViewState::Drag::box;
        } else if (io.KeyShift) {
            if (workspace.pins.size() == kMostPins) workspace.pins.erase(workspace.pins.begin());
            workspace.pins.push_back(workspace.views[workspace.speaker()].parameters);
            context.touch();
        } else if (io.KeyCtrl) {
            moveMarker(workspace, static_cast<std::size_t>(view), plane.u(mouse.x),
                       plane.v(mouse.y));
            context.touch();
            state.drag = ViewState::Drag::marker;
        } else if ((!io.KeyAlt && (takeRootMark(context, view, plane, mouse) ||
                                   takeCircle(context, view, plane, mouse))) ||
                   takeStudyMark(context, view, plane, mouse, io.KeyAlt)) {
            // It follows the pointer.
        } else {
            const bool caught = places ? place > 0 : near(mouse, ring, kReach * context.scale);
            state.drag = caught ? ViewState::Drag::marker : ViewState::Drag::pan;
            if (!caught) context.visit(view);
        }
    }
    if (hovered && ImGui::IsMouseDoubleClicked(0) && !near(mouse, ring, kReach * context.scale) &&
        !addRootAt(context, view, plane, mouse)) {
        context.visit(view);
        context.zoom(view, 0.5, plane.u(mouse.x), plane.v(mouse.y), true);
    }
    if (!active) {
        if (state.drag == ViewState::Drag::box && std::abs(mouse.x - state.dragFrom.x) > 8 &&
            std::abs(mouse.y - state.dragFrom.y) > 8) {
            context.visit(view);
            Scene& scene = workspace.views[static_cast<std::size_t>(view)];
            const double wide = std::abs(mouse.x - state.dragFrom.x);
            const double tall = std::abs(mouse.y - state.dragFrom.y);
            const double u = plane.u(0.5f * (mouse.x + state.dragFrom.x));
            const double v = plane.v(0.5f * (mouse.y + state.dragFrom.y));
            const double factor =
                std::max(tall / (plane.high.y - plane.low.y), wide / (plane.high.x - plane.low.x));
            scene.slice.centre[0] = u;
            if (scene.slice.centre.size() > 1) scene.slice.centre[1] = v;
            std::fill(scene.slice.centreLow.begin(), scene.slice.centreLow.end(), 0.0);
            context.zoom(view, factor, u, v);
        }
        state.drag = ViewState::Drag::none;
        return;
    }
    if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0) return;
    dragStudyMark(context, view, plane, mouse);
    dragRootMark(context, view, plane, mouse);
    dragCircle(context, view, plane, mouse);
    if (state.drag == ViewState::Drag::marker) {
        moveMarker(workspace, static_cast<std::size_t>(view), plane.u(mouse.x), plane.v(mouse.y));
        context.touch();
    } else if (state.drag == ViewState::Drag::pan) {
        Scene& scene = workspace.views[static_cast<std::size_t>(view)];
        state.glide.reset();
        scene.slice.centre[0] -= io.MouseDelta.x / plane.unit();
        if (scene.slice.centre.size() > 1) scene.slice.centre[1] += io.MouseDelta.y / plane.unit();
        context.touch();
    }
}

}  // namespace

void drawView(StudioContext& context, int view, ImVec2 low, ImVec2 high) {
    Workspace& workspace = context.workspace;
    ViewState& state = context.views[static_cast<std::size_t>(view)];
    state.low = low;
    state.high = high;
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const Size size{static_cast<int>(std::lround((high.x - low.x) * scale.x)),
                    static_cast<int>(std::lround((high.y - low.y) * scale.y))};
    if (size.width < 8 || size.height < 8) return;
    ImGui::SetCursorScreenPos(low);
    ImGui::PushID(view);
    ImGui::InvisibleButton("view", {high.x - low.x, high.y - low.y},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
    const double aspect = static_cast<double>(size.width) / size.height;
    const auto planeNow = [&] {
        Viewport place = viewportOf(workspace.views[static_cast<std::size_t>(view)], size);
        place.height = shownHeight(workspace.views[static_cast<std::size_t>(view)], aspect);
        return ViewPlane{low, high, place};
    };
    handlePointer(context, view, planeNow(), hovered, active);
    const Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    const Scene drawn = pictureScene(scene, aspect);
    const ViewPlane plane = planeNow();
    if (state.revision != context.revision || state.key.empty() || aspect != state.aspect) {
        state.revision = context.revision;
        state.aspect = aspect;
        Json json = sceneKey(drawn);
        state.key = json.dump();
        state.orbits = orbitsText(std::move(json));
    }
    state.picture.want(context.host, context.gpuUse(), view,
                       {drawn, state.key, state.orbits, context.program(view), plane.place,
                        context.moves() || context.gliding()});
    const std::size_t shown = workspace.maximised ? 1 : workspace.views.size();
    const double budget =
        std::clamp(0.5 * static_cast<double>(ImGui::GetIO().DeltaTime), kLeastBudget, kMostBudget);
    state.picture.work(context.host, budget / static_cast<double>(shown));
    if (state.picture.held()) context.host.wakeAfter(kHeldSeconds);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const StudioTheme& theme = themes()[context.theme];
    list.AddRectFilled(low, high, IM_COL32(10, 11, 15, 255));
    state.picture.draw(list, low, high);
    list.PushClipRect(low, high, true);
    const ViewTraits& traits = traitsOf(scene);
    if (traits.circles) drawCircles(context, view, plane, list);
    if (traits.arrows && workspace.arrows) drawArrows(context, view, plane, list);
    if (traits.orbit && (!workspace.analysis() || view == static_cast<int>(workspace.speaker())))
        drawOrbit(context, view, plane, list);
    if (traits.pins) {
        for (std::size_t k = 0; k < workspace.pins.size(); ++k) {
            Scene pinned = scene;
            pinned.parameters = workspace.pins[k];
            const auto at = markerOf(pinned, scene.slice);
            drawMark(list, plane.at(at[0], at[1]), 7 * context.scale, static_cast<MarkShape>(k),
                     pinColour(static_cast<int>(k)));
        }
    }
    drawStudyMarks(context, view, plane, list);
    drawDrawing(context, view, plane, list);
    drawRootMarks(context, view, plane, list);
    drawLessonMarks(context, view, plane, list);
    const auto marker = markerOf(workspace, static_cast<std::size_t>(view));
    if (workspace.analysis()) drawPlaces(context, view, plane, list);
    if (!workspace.analysis() || view > 0)
        drawMark(list, plane.at(marker[0], marker[1]), 9 * context.scale, MarkShape::ring,
                 IM_COL32(255, 255, 255, 255));
    if (state.drag == ViewState::Drag::box)
        list.AddRect(state.dragFrom, ImGui::GetIO().MousePos, theme.accent, 0, 0, 2);
    std::string title = tr(traits.title);
    if (workspace.analysis() && view > 0) title += " " + std::to_string(view);
    if (mapOf(scene).info.field && shapeControls(scene).asPrinted)
        title += tr(", φ + β as printed");
    const std::string measure = "  ·  " + tr("height {1}", {shownNumber(plane.place.height, 3)});
    if (ImGui::CalcTextSize((title + measure).c_str()).x < high.x - low.x - 48 * context.scale)
        title += measure;
    drawText(list, {low.x + 12, low.y + 9}, IM_COL32(231, 233, 238, 255), title);
    if (!state.picture.message().empty())
        drawText(list, {low.x + 12, 0.5f * (low.y + high.y)}, IM_COL32(255, 190, 120, 255),
                 trMessage(state.picture.message()));
    // The thin line of progress.
    if (!state.picture.finished())
        list.AddRectFilled(
            {low.x, high.y - 2},
            {low.x + (high.x - low.x) * (0.1f + 0.9f * state.picture.progress()), high.y},
            theme.accent);
    if (workspace.focused == view && workspace.views.size() > 1)
        list.AddRect(low, high, theme.accent, 0, 0, 1);
    list.PopClipRect();
    if (hovered && state.drag == ViewState::Drag::none)
        probe(context, view, plane, ImGui::GetIO().MousePos);
    else if (!hovered && context.probe.view == view)
        context.probe.text.clear(), context.probe.view = -1;
    drawRootMenu(context);
    ImGui::PopID();
}

}  // namespace versorium
