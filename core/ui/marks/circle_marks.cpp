// SPDX-License-Identifier: MIT
// Circles as they are drawn and dragged: white where all points are captured, black with a light
// halo where all escape, cyan where the versor decides; the same in words beside each.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/marks/marks.h"
#include "ui/session/circles.h"
#include "ui/session/context.h"
#include "ui/session/view_plane.h"

namespace versorium {
namespace {

using Point = StatePlane::Point;

constexpr ImU32 kHalo = IM_COL32(8, 10, 14, 220), kLight = IM_COL32(255, 255, 255, 200);
constexpr ImU32 kWhite = IM_COL32(255, 255, 255, 255), kBlack = IM_COL32(0, 0, 0, 255);
constexpr ImU32 kCyan = IM_COL32(60, 225, 255, 255);
constexpr ImU32 kImage = IM_COL32(255, 222, 110, 220), kImageHalo = IM_COL32(8, 10, 14, 140);
constexpr float kLineReach = 7, kCentreReach = 11, kSnap = 7;
constexpr int kArrows = 16;
constexpr int kBasinPoints = 96;

ImU32 colourOf(CircleFate fate) {
    return fate == CircleFate::captured ? kWhite : fate == CircleFate::escapes ? kBlack : kCyan;
}
ImU32 haloOf(CircleFate fate) { return fate == CircleFate::escapes ? kLight : kHalo; }
const char* wordOf(CircleFate fate) {
    return fate == CircleFate::captured  ? tr("captured")
           : fate == CircleFate::escapes ? tr("escapes")
                                         : tr("the versor decides");
}

// Where states lie in the window.
class Places {
  public:
    Places(const StatePlane& states, const ViewPlane& plane) : states_(states), plane_(plane) {}
    ImVec2 operator()(const Point& x) const {
        const auto [u, v] = states_.coordinates(x);
        return plane_.at(u, v);
    }
    bool shows(const Point& x) const {
        for (double part : x)
            if (!(std::abs(part) < 1e9)) return false;
        return true;
    }
    std::vector<ImVec2> circle(const Point& centre, double radius, int count) const {
        const auto [right, up] = states_.frame();
        std::vector<ImVec2> all;
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count;
            Point x = centre;
            for (std::size_t c = 0; c < 4; ++c)
                x[c] += radius * (std::cos(angle) * right[c] + std::sin(angle) * up[c]);
            all.push_back((*this)(x));
        }
        return all;
    }
    // Where the sphere of this radius around 0 meets the plane; nothing where it does not.
    std::vector<ImVec2> sphere(double radius) const {
        const auto foot = states_.coordinates(Point{});
        const double away = states_.distance(Point{});
        if (!(radius > away) || !(radius < 1e6)) return {};
        return circle(states_.at(foot[0], foot[1]), std::sqrt(radius * radius - away * away),
                      kBasinPoints);
    }

  private:
    const StatePlane& states_;
    const ViewPlane& plane_;
};

void closedLine(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 colour, float width) {
    list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, ImDrawFlags_Closed,
                     width);
}
// Every second piece.
void dashed(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 colour, float width) {
    for (std::size_t k = 0; k + 1 < points.size(); k += 2)
        list.AddLine(points[k], points[k + 1], colour, width);
}

// Words below a ring, within the view.
void below(ImDrawList& list, const std::vector<ImVec2>& ring, const ViewPlane& plane, float scale,
           const std::string& words) {
    const ImVec2 low = *std::max_element(
        ring.begin(), ring.end(), [](const ImVec2& a, const ImVec2& b) { return a.y < b.y; });
    const float wide = ImGui::CalcTextSize(words.c_str()).x;
    const float left = plane.low.x + 4, right = std::max(left, plane.high.x - wide - 6);
    drawText(list,
             {std::clamp(low.x - 0.5f * wide, left, right),
              std::clamp(low.y + 4 * scale, plane.low.y + 28 * scale, plane.high.y - 24 * scale)},
             kWhite, words);
}

void drawBasins(StudioContext& context, const Places& places, const ViewPlane& plane,
                ImDrawList& list) {
    const Basins basins = studyBasins(context);
    const float scale = context.scale;
    if (const auto inner = places.sphere(basins.capture); !inner.empty()) {
        list.AddConvexPolyFilled(inner.data(), static_cast<int>(inner.size()),
                                 IM_COL32(255, 255, 255, 60));
        closedLine(list, inner, kHalo, 3.2f * scale);
        closedLine(list, inner, kWhite, 1.2f * scale);
        below(list, inner, plane, scale, tr("kept: |x| ≤ {1}", {shownNumber(basins.capture, 3)}));
    }
    const double radius = context.orbitProgram() ? context.orbitProgram()->escapeRadius : 0;
    if (!(basins.escape < radius)) return;
    const auto outer = places.sphere(basins.escape);
    if (outer.empty()) return;
    ImVec2 middle{0, 0};
    for (const ImVec2& at : outer)
        middle.x += at.x / static_cast<float>(outer.size()),
            middle.y += at.y / static_cast<float>(outer.size());
    // Far enough outwards to cover the view.
    const float far = 8 * (std::hypot(plane.high.x - plane.low.x, plane.high.y - plane.low.y) +
                           std::hypot(middle.x - plane.low.x, middle.y - plane.low.y));
    const auto outwards = [&](const ImVec2& at) {
        const float x = at.x - middle.x, y = at.y - middle.y;
        const float length = std::max(1.0f, std::hypot(x, y));
        return ImVec2{at.x + x / length * far, at.y + y / length * far};
    };
    const ImDrawListFlags before = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;  // or seams show
    for (std::size_t k = 0; k < outer.size(); ++k) {
        const ImVec2 a = outer[k], b = outer[(k + 1) % outer.size()];
        list.AddQuadFilled(a, b, outwards(b), outwards(a), IM_COL32(0, 0, 0, 110));
    }
    list.Flags = before;
    closedLine(list, outer, kLight, 3.2f * scale);
    closedLine(list, outer, kBlack, 1.2f * scale);
    below(list, outer, plane, scale, tr("leaves: |x| > {1}", {shownNumber(basins.escape, 3)}));
}

void drawOne(StudioContext& context, const Workspace::Circle& circle, const CircleStudy& study,
             const Places& places, const ViewPlane& plane, bool chosen, ImDrawList& list) {
    const float scale = context.scale;
    const ImU32 colour = colourOf(study.fate), halo = haloOf(study.fate);
    // Beside its image, where a circle that is not around 0 has its points: |x| at the mean.
    if (study.high - study.low > 1e-6 * study.high)
        dashed(list, places.sphere(0.5 * (study.low + study.high)), kLight, 1.0f * scale);
    std::vector<ImVec2> image;
    bool whole = true;
    for (const Point& at : study.to) {
        whole = whole && places.shows(at);
        image.push_back(places.shows(at) ? places(at) : ImVec2{});
    }
    if (whole && !image.empty()) {
        closedLine(list, image, kImageHalo, 2.6f * scale);
        closedLine(list, image, kImage, 1.2f * scale);
    }
    const auto ring = places.circle(circle.centre, circle.radius, CircleStudy::kPoints);
    closedLine(list, ring, halo, (chosen ? 6.5f : 5.0f) * scale);
    closedLine(list, ring, colour, (chosen ? 3.2f : 2.2f) * scale);
    for (int k = 0; k < kArrows && !study.to.empty(); ++k) {
        const std::size_t at = static_cast<std::size_t>(k) * study.to.size() / kArrows;
        const Point &from = study.from[at], &to = study.to[at];
        if (!places.shows(from) || !places.shows(to)) continue;
        drawArrow(list, places(from), places(to), study.member[at] ? kWhite : kBlack,
                  study.member[at] ? kHalo : kLight, scale);
    }
    const ImVec2 centre = places(circle.centre);
    for (const auto& [tint, width] : {std::pair{halo, 4.0f}, std::pair{colour, 1.6f}}) {
        list.AddLine({centre.x - 5 * scale, centre.y}, {centre.x + 5 * scale, centre.y}, tint,
                     width * scale);
        list.AddLine({centre.x, centre.y - 5 * scale}, {centre.x, centre.y + 5 * scale}, tint,
                     width * scale);
    }
    // The words stand at the circle's top, within the view.
    std::string words = wordOf(study.fate);
    if (study.certain) words = tr("{1} for certain", {words});
    if (study.fate == CircleFate::decided) words += ": " + shownNumber(100 * study.stay, 3) + " %";
    if (chosen)
        words +=
            ", |x| = " + shownNumber(study.high, 3) + ", |f(x)| = " +
            (study.oneModulus ? shownNumber(study.most, 3)
                              : shownNumber(study.least, 3) + " … " + shownNumber(study.most, 3));
    const ImVec2 top = *std::min_element(
        ring.begin(), ring.end(), [](const ImVec2& a, const ImVec2& b) { return a.y < b.y; });
    const float wide = ImGui::CalcTextSize(words.c_str()).x;
    const float left = plane.low.x + 4, right = std::max(left, plane.high.x - wide - 6);
    drawText(list,
             {std::clamp(top.x - 0.5f * wide, left, right),
              std::clamp(top.y - 22 * scale, plane.low.y + 28 * scale, plane.high.y - 24 * scale)},
             study.fate == CircleFate::decided ? kCyan : kWhite, words);
}

}  // namespace

void drawCircles(StudioContext& context, int view, const ViewPlane& plane, ImDrawList& list) {
    const Workspace& workspace = context.workspace;
    if (workspace.circles.empty() && !workspace.basins) return;
    const std::optional<StatePlane> states =
        statePlaneOf(workspace.views[static_cast<std::size_t>(view)]);
    if (!states || !takesCircles(workspace)) return;
    const Places places(*states, plane);
    if (workspace.basins) drawBasins(context, places, plane, list);
    const std::vector<CircleStudy>& all = studyCircles(context, view);
    for (std::size_t k = 0; k < all.size(); ++k)
        drawOne(context, workspace.circles[k], all[k], places, plane,
                static_cast<int>(k) == context.circles.chosen, list);
}

bool takeCircle(StudioContext& context, int view, const ViewPlane& plane, const ImVec2& mouse) {
    Workspace& workspace = context.workspace;
    context.circles.chosen = -1;
    const std::optional<StatePlane> states =
        statePlaneOf(workspace.views[static_cast<std::size_t>(view)]);
    if (!states || !takesCircles(workspace)) return false;
    const Places places(*states, plane);
    const auto away = [&](const ImVec2& at) { return std::hypot(at.x - mouse.x, at.y - mouse.y); };
    const auto marker = markerOf(workspace, static_cast<std::size_t>(view));
    if (away(plane.at(marker[0], marker[1])) <= 9 * context.scale) return false;
    for (std::size_t k = workspace.circles.size(); k-- > 0;) {
        const Workspace::Circle& circle = workspace.circles[k];
        ViewState::Drag& drag = context.views[static_cast<std::size_t>(view)].drag;
        float nearest = 1e9f;
        const auto ring = places.circle(circle.centre, circle.radius, CircleStudy::kPoints);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const ImVec2 a = ring[i], b = ring[(i + 1) % ring.size()];
            const float x = b.x - a.x, y = b.y - a.y, square = std::max(1e-6f, x * x + y * y);
            const float t =
                std::clamp(((mouse.x - a.x) * x + (mouse.y - a.y) * y) / square, 0.0f, 1.0f);
            nearest = std::min(nearest, away({a.x + t * x, a.y + t * y}));
        }
        const bool line = nearest <= kLineReach * context.scale;
        if (!line && away(places(circle.centre)) > kCentreReach * context.scale) continue;
        drag = line ? ViewState::Drag::circle : ViewState::Drag::centre;
        context.circles.chosen = static_cast<int>(k);
        return true;
    }
    return false;
}

void dragCircle(StudioContext& context, int view, const ViewPlane& plane, const ImVec2& mouse) {
    Workspace& workspace = context.workspace;
    const ViewState::Drag drag = context.views[static_cast<std::size_t>(view)].drag;
    const int chosen = context.circles.chosen;
    if ((drag != ViewState::Drag::circle && drag != ViewState::Drag::centre) || chosen < 0 ||
        chosen >= static_cast<int>(workspace.circles.size()))
        return;
    const std::optional<StatePlane> states =
        statePlaneOf(workspace.views[static_cast<std::size_t>(view)]);
    if (!states) return;
    Workspace::Circle& circle = workspace.circles[static_cast<std::size_t>(chosen)];
    const Point at = states->at(plane.u(mouse.x), plane.v(mouse.y));
    const auto middle = states->coordinates(circle.centre);
    const Point before = states->at(middle[0], middle[1]);
    Point moved{};
    double square = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        moved[k] = at[k] - before[k];
        square += moved[k] * moved[k];
    }
    if (drag == ViewState::Drag::circle) {
        circle.radius = std::clamp(std::sqrt(square), 1e-12, 1e6);
    } else {
        for (std::size_t k = 0; k < 4; ++k) circle.centre[k] += moved[k];
        // 0 is where a circle says most.
        const ImVec2 origin = Places(*states, plane)(Point{});
        if (std::hypot(origin.x - mouse.x, origin.y - mouse.y) < kSnap * context.scale)
            circle.centre = {};
    }
    context.touch();
}

}  // namespace versorium
