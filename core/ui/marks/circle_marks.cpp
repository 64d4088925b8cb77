// SPDX-License-Identifier: MIT
// Circles under the hand: the line changes the radius, the cross moves the centre.
#include "ui/marks/circle_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/marks/ring_mark.h"
#include "ui/session/circles.h"

namespace versorium {

ImVec2 CirclePlaces::operator()(const StatePlane::Point& x) const {
    const auto [u, v] = states_.coordinates(x);
    return plane_.at(u, v);
}

bool CirclePlaces::shows(const StatePlane::Point& x) const {
    return std::all_of(x.begin(), x.end(), [](double part) { return std::abs(part) < 1e9; });
}

std::vector<ImVec2> CirclePlaces::circle(const StatePlane::Point& centre, double radius,
                                         int count) const {
    const auto [right, up] = states_.frame();
    std::vector<ImVec2> all;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count;
        StatePlane::Point x = centre;
        for (std::size_t c = 0; c < 4; ++c)
            x[c] += radius * (std::cos(angle) * right[c] + std::sin(angle) * up[c]);
        all.push_back((*this)(x));
    }
    return all;
}

std::vector<ImVec2> CirclePlaces::sphere(double radius) const {
    constexpr int kSpherePoints = 96;
    const auto foot = states_.coordinates(StatePlane::Point{});
    const double away = states_.distance(StatePlane::Point{});
    if (!(radius > away) || !(radius < 1e6)) return {};
    return circle(states_.at(foot[0], foot[1]), std::sqrt(radius * radius - away * away),
                  kSpherePoints);
}

namespace {

constexpr float kLineReach = 7, kCentreReach = 11, kSnap = 7;

// Of the pointer from a closed line.
float distanceFrom(const ViewFrame& frame, const std::vector<ImVec2>& line) {
    const ScreenPoint mouse = frame.pointer.at;
    float nearest = 1e9f;
    for (std::size_t k = 0; k < line.size(); ++k) {
        const ImVec2 a = line[k], b = line[(k + 1) % line.size()];
        const float x = b.x - a.x, y = b.y - a.y, square = std::max(1e-6f, x * x + y * y);
        const float t =
            std::clamp(((mouse.x - a.x) * x + (mouse.y - a.y) * y) / square, 0.0f, 1.0f);
        nearest = std::min(nearest, frame.away({a.x + t * x, a.y + t * y}));
    }
    return nearest;
}

struct CircleHit {
    MarkHit hit;
    bool line;  // else its centre
};

// The circle that was dropped last is the first to be met, by its line or its centre.
std::optional<CircleHit> circleAt(const ViewFrame& frame) {
    const Workspace& workspace = frame.workspace();
    const std::optional<StatePlane> states = statePlaneOf(frame.scene());
    if (!states || !takesCircles(workspace)) return std::nullopt;
    const CirclePlaces places(*states, frame.plane);
    for (int k = static_cast<int>(workspace.circles.size()) - 1; k >= 0; --k) {
        const Workspace::Circle& circle = workspace.circles[static_cast<std::size_t>(k)];
        const float line =
            distanceFrom(frame, places.circle(circle.centre, circle.radius, CircleStudy::kPoints));
        if (line <= kLineReach * frame.scale()) return CircleHit{{k, line}, true};
        const float centre = frame.away(places(circle.centre));
        if (centre <= kCentreReach * frame.scale()) return CircleHit{{k, centre}, false};
    }
    return std::nullopt;
}

template <bool kLine>
std::optional<MarkHit> hitCircle(const ViewFrame& frame) {
    const std::optional<CircleHit> found = circleAt(frame);
    return found && found->line == kLine ? std::optional(found->hit) : std::nullopt;
}

// The chosen circle, as long as it is there.
Workspace::Circle* chosenCircle(const ViewFrame& frame, Workspace& workspace) {
    const int chosen = frame.context.circles.chosen;
    if (chosen < 0 || chosen >= static_cast<int>(workspace.circles.size())) return nullptr;
    return &workspace.circles[static_cast<std::size_t>(chosen)];
}

// From the centre's foot in the plane to the pointer.
StatePlane::Point fromCentre(const ViewFrame& frame, const StatePlane& states,
                             const Workspace::Circle& circle) {
    const StatePlane::Point at = states.at(frame.u(), frame.v());
    const auto middle = states.coordinates(circle.centre);
    const StatePlane::Point before = states.at(middle[0], middle[1]);
    StatePlane::Point moved{};
    for (std::size_t k = 0; k < 4; ++k) moved[k] = at[k] - before[k];
    return moved;
}

void dragRadius(const ViewFrame& frame) {
    const std::optional<StatePlane> states = statePlaneOf(frame.scene());
    if (!states) return;
    frame.context.edit([&](Workspace& workspace) {
        Workspace::Circle* circle = chosenCircle(frame, workspace);
        if (!circle) return;
        double square = 0;
        for (const double part : fromCentre(frame, *states, *circle)) square += part * part;
        circle->radius = std::clamp(std::sqrt(square), 1e-12, 1e6);
    });
}

void dragCentre(const ViewFrame& frame) {
    const std::optional<StatePlane> states = statePlaneOf(frame.scene());
    if (!states) return;
    frame.context.edit([&](Workspace& workspace) {
        Workspace::Circle* circle = chosenCircle(frame, workspace);
        if (!circle) return;
        const StatePlane::Point moved = fromCentre(frame, *states, *circle);
        for (std::size_t k = 0; k < 4; ++k) circle->centre[k] += moved[k];
        // 0 is where a circle says most.
        const ImVec2 origin = CirclePlaces(*states, frame.plane)(StatePlane::Point{});
        if (frame.away(origin) < kSnap * frame.scale()) circle->centre = {};
    });
}

template <bool kLine>
std::optional<Drag> pressCircle(const ViewFrame& frame) {
    if (frame.pointer.modified()) return std::nullopt;
    frame.context.circles.chosen = -1;
    const std::optional<MarkHit> hit = hitCircle<kLine>(frame);
    if (!hit || onRing(frame)) return std::nullopt;
    frame.context.circles.chosen = hit->item;
    return Drag{.mark = kLine ? &circleRadiusMark : &circleCentreMark,
                .item = hit->item,
                .move = kLine ? dragRadius : dragCentre};
}

}  // namespace

const Mark circleRadiusMark{
    .name = [](const ViewFrame&,
               int item) { return tr("Circle {1}, radius", {std::to_string(item + 1)}); },
    .draw = drawCircles,
    .hit = hitCircle<true>,
    .press = pressCircle<true>,
};

// Drawn with its line.
const Mark circleCentreMark{
    .name = [](const ViewFrame&,
               int item) { return tr("Circle {1}, centre", {std::to_string(item + 1)}); },
    .hit = hitCircle<false>,
    .press = pressCircle<false>,
};

}  // namespace versorium
