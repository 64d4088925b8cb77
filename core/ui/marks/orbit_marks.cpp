// SPDX-License-Identifier: MIT
// The orbit on planes of starting points, and arrows there from points to their images.
#include <algorithm>
#include <cmath>

#include "fields/dynamics.h"
#include "ui/marks/mark.h"
#include "ui/marks/shapes.h"

namespace versorium {
namespace {

constexpr ImU32 kOrbitHalo = IM_COL32(8, 10, 14, 200);
constexpr float kArrowGap = 46;  // between the arrows of the grid, at scale 1

// The component of the state that runs along an axis of the view by itself; -1 where none does.
int stateAlong(const Scene& scene, std::size_t axis) {
    if (axis >= scene.slice.axes.size() || scene.slice.axes[axis].terms.size() != 1) return -1;
    const std::optional<NumberRef> number =
        numberNamed(scene, scene.slice.axes[axis].terms[0].first);
    return number && number->kind == NumberKind::state ? number->index : -1;
}

// From the state's component to the coordinate on the axis.
double coordinateOf(const Scene& scene, std::size_t axis, double value) {
    const auto& [name, weight] = scene.slice.axes[axis].terms[0];
    const auto origin = scene.slice.origin.find(name);
    return (value - (origin == scene.slice.origin.end() ? 0 : origin->second)) / weight;
}

void drawOrbit(const ViewFrame& frame) {
    const Workspace& workspace = frame.workspace();
    const Scene& scene = frame.scene();
    if (!traitsOf(scene).orbit || !frame.spoken()) return;
    const int first = stateAlong(scene, 0), second = stateAlong(scene, 1);
    const std::vector<std::vector<double>>& orbit = frame.context.bound.orbit();
    if (first < 0 || second < 0 || orbit.empty()) return;
    const int steps = workspace.orbitSteps;
    const float scale = frame.scale();
    ImDrawList& list = frame.list();
    std::vector<ImVec2> points;
    for (const auto& row : orbit) {
        const double u = coordinateOf(scene, 0, row[static_cast<std::size_t>(first)]);
        const double v = coordinateOf(scene, 1, row[static_cast<std::size_t>(second)]);
        if (!std::isfinite(u) || !std::isfinite(v)) break;
        points.push_back(frame.plane.at(u, v));
    }
    const int count = static_cast<int>(points.size());
    const auto at = [&](int n) { return points[static_cast<std::size_t>(n)]; };
    for (int n = 1; n < count; ++n) list.AddLine(at(n - 1), at(n), kOrbitHalo, 3.5f * scale);
    for (int n = 1; n < count; ++n)
        list.AddLine(at(n - 1), at(n), stepColour(n, steps, 200), 1.5f * scale);
    for (int n = 1; n < count; ++n) {
        list.AddCircleFilled(at(n), 4 * scale, kOrbitHalo);
        list.AddCircleFilled(at(n), 2.6f * scale, stepColour(n, steps));
    }
    // Numbers only where no other stands yet: an orbit comes back to its cycle again and again.
    std::vector<ImVec2> numbered;
    for (int n = 1; n < std::min(count, 24); ++n) {
        bool taken = n == workspace.orbitAt;
        for (const ImVec2 other : numbered)
            taken = taken || std::hypot(other.x - at(n).x, other.y - at(n).y) < 16 * scale;
        if (taken) continue;
        numbered.push_back(at(n));
        drawText(list, {at(n).x + 5 * scale, at(n).y - 16 * scale}, stepColour(n, steps),
                 std::to_string(n));
    }
    if (workspace.orbitAt > 0 && workspace.orbitAt < count) {
        const ImVec2 here = at(workspace.orbitAt);
        drawMark(list, here, 6 * scale, MarkShape::ring, IM_COL32(255, 255, 255, 255));
        drawText(list, {here.x + 9 * scale, here.y - 19 * scale}, IM_COL32(255, 255, 255, 255),
                 "n = " + std::to_string(workspace.orbitAt));
    }
}

void drawArrows(const ViewFrame& frame) {
    const Scene& scene = frame.scene();
    if (!traitsOf(scene).arrows || !frame.workspace().arrows) return;
    const int first = stateAlong(scene, 0), second = stateAlong(scene, 1);
    const OrbitProgram* program = frame.context.bound.program(frame.view);
    if (first < 0 || second < 0 || !program || program->critical) return;
    const ViewPlane& plane = frame.plane;
    const float gap = kArrowGap * frame.scale();
    std::vector<double> u, v;
    // The grid keeps its points in the middle: it stands still while the view is resized.
    const int across = static_cast<int>((plane.high.x - plane.low.x) / gap) / 2;
    const int down = static_cast<int>((plane.high.y - plane.low.y) / gap) / 2;
    const ImVec2 middle{0.5f * (plane.low.x + plane.high.x), 0.5f * (plane.low.y + plane.high.y)};
    for (int j = -down; j <= down; ++j)
        for (int i = -across; i <= across; ++i) {
            u.push_back(plane.u(middle.x + gap * static_cast<float>(i)));
            v.push_back(plane.v(middle.y + gap * static_cast<float>(j)));
        }
    // The ring's own arrow comes last, in full.
    const auto marker = markerOf(frame.workspace(), frame.index());
    u.push_back(marker[0]);
    v.push_back(marker[1]);
    const double* coordinates[3] = {u.data(), v.data(), v.data()};
    const auto images = imagesOf(*program, static_cast<int>(u.size()), coordinates);
    for (std::size_t k = 0; k < u.size(); ++k) {
        const double x = images[static_cast<std::size_t>(first)][k];
        const double y = images[static_cast<std::size_t>(second)][k];
        if (!std::isfinite(x) || !std::isfinite(y)) continue;
        const ImVec2 from = plane.at(u[k], v[k]);
        ImVec2 to = plane.at(coordinateOf(scene, 0, x), coordinateOf(scene, 1, y));
        const float length = std::hypot(to.x - from.x, to.y - from.y);
        const bool last = k + 1 == u.size();
        const float most = 0.86f * gap;
        if (!last && length > most)
            to = {from.x + (to.x - from.x) * most / length,
                  from.y + (to.y - from.y) * most / length};
        double before = 0, after = 0;
        for (int c = 0; c < program->map->dimension; ++c) {
            const double coordinate[3] = {u[k], v[k], 0};
            const double start = program->slice.at(static_cast<std::size_t>(c), coordinate);
            before += start * start;
            after +=
                images[static_cast<std::size_t>(c)][k] * images[static_cast<std::size_t>(c)][k];
        }
        const ImU32 inwards = IM_COL32(255, 255, 255, 235), outwards = IM_COL32(120, 200, 255, 235);
        drawArrow(frame.list(), from, to,
                  last              ? IM_COL32(255, 222, 110, 255)
                  : after <= before ? inwards
                                    : outwards,
                  kOrbitHalo, frame.scale());
    }
}

}  // namespace

const Mark orbitMark{.draw = drawOrbit};
const Mark arrowMark{.draw = drawArrows};

}  // namespace versorium
