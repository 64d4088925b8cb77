// SPDX-License-Identifier: MIT
// A view: the picture, what lies on it, and the hand that moves it. Drag pans; the ring is dragged;
// the wheel zooms at the pointer; a box drawn with the right button is zoomed to; a double click
// goes in; Ctrl and a click set the point; Shift and a click pin the parameters.
#include <algorithm>
#include <cmath>

#include "ui/context.h"

namespace versorium {
namespace {

constexpr float kReach = 16;  // how near the pointer must come to a mark, at scale 1
constexpr double kWheel = 0.8;
// Seconds of a frame for the graphics processor's pictures: half of it where frames are slow.
constexpr double kLeastBudget = 0.012, kMostBudget = 0.05;
constexpr int kProbeIterations = 20000;
constexpr ImU32 kOrbit = IM_COL32(255, 214, 102, 255);

struct ViewPlane {
    ImVec2 low, high;
    Viewport place;
    double unit() const { return (high.y - low.y) / place.height; }
    ImVec2 at(double u, double v) const {
        const double x =
            0.5 * (low.x + high.x) + ((u - place.centre[0]) - place.centreLow[0]) * unit();
        const double y =
            0.5 * (low.y + high.y) - ((v - place.centre[1]) - place.centreLow[1]) * unit();
        const auto cut = [](double value) {
            return static_cast<float>(std::isfinite(value) ? std::clamp(value, -1e6, 1e6) : -1e6);
        };
        return {cut(x), cut(y)};
    }
    double u(float x) const {
        return place.centre[0] + (place.centreLow[0] + (x - 0.5 * (low.x + high.x)) / unit());
    }
    double v(float y) const {
        return place.centre[1] + (place.centreLow[1] - (y - 0.5 * (low.y + high.y)) / unit());
    }
};

// As many digits as neighbouring pixels need to differ.
std::string coordinate(double value, const Viewport& place) {
    const double size = std::max(std::abs(value), place.pixel());
    const int digits = static_cast<int>(std::ceil(std::log10(size / place.pixel()))) + 1;
    return formatNumber(value, std::clamp(digits, 3, 17));
}

bool near(ImVec2 a, ImVec2 b, float reach) { return std::hypot(a.x - b.x, a.y - b.y) <= reach; }

void probe(StudioContext& context, int view, const ViewPlane& plane, ImVec2 mouse) {
    const Scene& scene = context.workspace.views[static_cast<std::size_t>(view)];
    Probe& found = context.probe;
    found.view = view;
    found.u = plane.u(mouse.x);
    found.v = plane.v(mouse.y);
    found.text.clear();
    for (std::size_t k = 0; k < 2 && k < scene.slice.axes.size(); ++k)
        found.text += (k ? "   " : "") + scene.slice.axes[k].terms[0].first + " = " +
                      coordinate(k ? found.v : found.u, plane.place);
    const OrbitProgram* bound = context.program(view);
    if (!bound) return;
    OrbitProgram program = *bound;
    program.iterations = std::min(program.iterations, kProbeIterations);
    const double* coordinates[2] = {&found.u, &found.v};
    const FieldName fields[] = {FieldName::membership, FieldName::escapeStep,
                                FieldName::squaredNorm, FieldName::period};
    const auto values = evaluateFields(program, 1, coordinates, fields);
    if (values[0][0] == 1) {
        found.text += "   stays for " + std::to_string(program.iterations) + " steps";
        if (values[3][0] > 0)
            found.text += ", drawn to a cycle of period " + formatNumber(values[3][0], 5);
    } else {
        found.text += "   escapes at step " + formatNumber(values[1][0], 8);
    }
    found.text += "   |z| = " + formatNumber(std::sqrt(values[2][0]), 5);
}

void drawOrbit(StudioContext& context, const ViewPlane& plane, ImDrawList& list) {
    const OrbitProgram* program = context.orbitProgram();
    if (!program || program->map->dimension < 2) return;
    const double start[2] = {context.workspace.point[0], context.workspace.point[1]};
    const auto orbit = orbitOf(*program, start, context.workspace.orbitSteps);
    ImVec2 last{};
    for (std::size_t n = 0; n < orbit.size(); ++n) {
        if (!std::isfinite(orbit[n][0]) || !std::isfinite(orbit[n][1])) break;
        const ImVec2 at = plane.at(orbit[n][0], orbit[n][1]);
        if (n > 0) {
            list.AddLine(last, at, IM_COL32(8, 10, 14, 190), 3.5f);
            list.AddLine(last, at, (kOrbit & 0x00ffffffu) | 0xc0000000u, 1.5f);
        }
        last = at;
    }
    for (std::size_t n = 1; n < orbit.size(); ++n) {
        if (!std::isfinite(orbit[n][0]) || !std::isfinite(orbit[n][1])) break;
        const ImVec2 at = plane.at(orbit[n][0], orbit[n][1]);
        list.AddCircleFilled(at, 4, IM_COL32(8, 10, 14, 220));
        list.AddCircleFilled(at, 2.6f, kOrbit);
        if (n <= 9) drawText(list, {at.x + 5, at.y - 14}, kOrbit, std::to_string(n));
    }
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
    if (hovered && io.MouseWheel != 0)
        context.zoom(view, std::pow(kWheel, static_cast<double>(io.MouseWheel)), plane.u(mouse.x),
                     plane.v(mouse.y));
    const bool left = ImGui::IsMouseClicked(0), right = ImGui::IsMouseClicked(1);
    if (hovered && (left || right)) {
        if (workspace.focused != view) workspace.focused = view;
        context.welcome = false;
        context.animation.running = context.animation.running && !left;
        state.dragFrom = mouse;
        if (right) {
            state.drag = ViewState::Drag::box;
        } else if (io.KeyShift) {
            if (workspace.pins.size() == kMostPins) workspace.pins.erase(workspace.pins.begin());
            workspace.pins.push_back(workspace.views[0].parameters);
            context.touch();
        } else if (io.KeyCtrl) {
            moveMarker(workspace, static_cast<std::size_t>(view), plane.u(mouse.x),
                       plane.v(mouse.y));
            context.touch();
            state.drag = ViewState::Drag::marker;
        } else {
            const bool caught = near(mouse, ring, kReach * context.scale);
            state.drag = caught ? ViewState::Drag::marker : ViewState::Drag::pan;
            if (!caught) context.visit(view);
        }
    }
    if (hovered && ImGui::IsMouseDoubleClicked(0) && !near(mouse, ring, kReach * context.scale)) {
        context.visit(view);
        context.zoom(view, 0.5, plane.u(mouse.x), plane.v(mouse.y));
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
    if (state.drag == ViewState::Drag::marker) {
        moveMarker(workspace, static_cast<std::size_t>(view), plane.u(mouse.x), plane.v(mouse.y));
        context.touch();
    } else if (state.drag == ViewState::Drag::pan) {
        Scene& scene = workspace.views[static_cast<std::size_t>(view)];
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
    if (state.revision != context.revision || state.text.empty() || aspect != state.aspect) {
        state.revision = context.revision;
        state.aspect = aspect;
        Json json = sceneToJson(drawn);
        state.text = json.dump();
        json.erase("colour");
        json.erase("iso");
        state.orbits = json.dump();
    }
    state.picture.want(context.host, context.gpuUse(), view,
                       {drawn, state.text, state.orbits, context.program(view), plane.place});
    const std::size_t shown = workspace.maximised ? 1 : workspace.views.size();
    const double budget =
        std::clamp(0.5 * static_cast<double>(ImGui::GetIO().DeltaTime), kLeastBudget, kMostBudget);
    state.picture.work(context.host, budget / static_cast<double>(shown));

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Theme& theme = themes()[context.theme];
    list.AddRectFilled(low, high, IM_COL32(10, 11, 15, 255));
    state.picture.draw(list, low, high);
    list.PushClipRect(low, high, true);
    if (!showsParameters(scene)) {
        drawOrbit(context, plane, list);
    } else {
        for (std::size_t k = 0; k < workspace.pins.size(); ++k) {
            Workspace pinned = workspace;
            for (const auto& [name, value] : workspace.pins[k])
                setSharedParameter(pinned, name, value);
            const auto at = markerOf(pinned, static_cast<std::size_t>(view));
            drawMark(list, plane.at(at[0], at[1]), 7 * context.scale, static_cast<MarkShape>(k),
                     pinColour(static_cast<int>(k)));
        }
    }
    const auto marker = markerOf(workspace, static_cast<std::size_t>(view));
    drawMark(list, plane.at(marker[0], marker[1]), 9 * context.scale, MarkShape::ring,
             IM_COL32(255, 255, 255, 255));
    if (state.drag == ViewState::Drag::box)
        list.AddRect(state.dragFrom, ImGui::GetIO().MousePos, theme.accent, 0, 0, 2);
    const std::string title = showsParameters(scene) ? "Parameters" : "Starting points";
    drawText(list, {low.x + 12, low.y + 9}, IM_COL32(231, 233, 238, 255),
             title + "  ·  height " + formatNumber(plane.place.height, 3));
    if (!state.picture.message().empty())
        drawText(list, {low.x + 12, 0.5f * (low.y + high.y)}, IM_COL32(255, 190, 120, 255),
                 state.picture.message());
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
        context.probe = {};
    ImGui::PopID();
}

}  // namespace versorium
