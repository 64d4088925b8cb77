// SPDX-License-Identifier: MIT
// Circles as they are drawn: white where all points are captured, black with a light halo where all
// escape, cyan where the versor decides; the same in words beside each.
#include <algorithm>
#include <cmath>

#include "ui/marks/circle_marks.h"
#include "ui/marks/shapes.h"
#include "ui/session/circles.h"

namespace versorium {
namespace {

constexpr ImU32 kCircleHalo = IM_COL32(8, 10, 14, 220), kEscapesHalo = IM_COL32(255, 255, 255, 200);
constexpr ImU32 kCaptured = IM_COL32(255, 255, 255, 255), kEscapes = IM_COL32(0, 0, 0, 255);
constexpr ImU32 kDecides = IM_COL32(60, 225, 255, 255);
constexpr ImU32 kImage = IM_COL32(255, 222, 110, 220), kImageHalo = IM_COL32(8, 10, 14, 140);
constexpr int kCircleArrows = 16;

ImU32 colourOf(CircleFate fate) {
    return fate == CircleFate::captured  ? kCaptured
           : fate == CircleFate::escapes ? kEscapes
                                         : kDecides;
}
ImU32 haloOf(CircleFate fate) { return fate == CircleFate::escapes ? kEscapesHalo : kCircleHalo; }
const char* wordOf(CircleFate fate) {
    return fate == CircleFate::captured  ? tr("captured")
           : fate == CircleFate::escapes ? tr("escapes")
                                         : tr("the versor decides");
}

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
             kCaptured, words);
}

void drawBasins(const ViewFrame& frame, const CirclePlaces& places) {
    StudioContext& context = frame.context;
    const ViewPlane& plane = frame.plane;
    ImDrawList& list = frame.list();
    const Basins basins = studyBasins(context);
    const float scale = frame.scale();
    if (const auto inner = places.sphere(basins.capture); !inner.empty()) {
        list.AddConvexPolyFilled(inner.data(), static_cast<int>(inner.size()),
                                 IM_COL32(255, 255, 255, 60));
        closedLine(list, inner, kCircleHalo, 3.2f * scale);
        closedLine(list, inner, kCaptured, 1.2f * scale);
        below(list, inner, plane, scale, tr("kept: |x| ≤ {1}", {shownNumber(basins.capture, 3)}));
    }
    const double radius =
        context.bound.orbitProgram() ? context.bound.orbitProgram()->escapeRadius : 0;
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
    closedLine(list, outer, kEscapesHalo, 3.2f * scale);
    closedLine(list, outer, kEscapes, 1.2f * scale);
    below(list, outer, plane, scale, tr("leaves: |x| > {1}", {shownNumber(basins.escape, 3)}));
}

// Where f takes it, with arrows to there.
void drawImage(const ViewFrame& frame, const CircleStudy& study, const CirclePlaces& places) {
    const float scale = frame.scale();
    std::vector<ImVec2> image;
    bool whole = true;
    for (const StatePlane::Point& at : study.to) {
        whole = whole && places.shows(at);
        image.push_back(places.shows(at) ? places(at) : ImVec2{});
    }
    if (!whole || image.empty()) return;
    closedLine(frame.list(), image, kImageHalo, 2.6f * scale);
    closedLine(frame.list(), image, kImage, 1.2f * scale);
}

void drawCircleArrows(const ViewFrame& frame, const CircleStudy& study,
                      const CirclePlaces& places) {
    for (int k = 0; k < kCircleArrows && !study.to.empty(); ++k) {
        const std::size_t at = static_cast<std::size_t>(k) * study.to.size() / kCircleArrows;
        const StatePlane::Point &from = study.from[at], &to = study.to[at];
        if (!places.shows(from) || !places.shows(to)) continue;
        drawArrow(frame.list(), places(from), places(to), study.member[at] ? kCaptured : kEscapes,
                  study.member[at] ? kCircleHalo : kEscapesHalo, frame.scale());
    }
}

// At the circle's top, within the view.
void drawWords(const ViewFrame& frame, const CircleStudy& study, const std::vector<ImVec2>& ring,
               bool chosen) {
    const ViewPlane& plane = frame.plane;
    const float scale = frame.scale();
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
    drawText(frame.list(),
             {std::clamp(top.x - 0.5f * wide, left, right),
              std::clamp(top.y - 22 * scale, plane.low.y + 28 * scale, plane.high.y - 24 * scale)},
             study.fate == CircleFate::decided ? kDecides : kCaptured, words);
}

void drawCircle(const ViewFrame& frame, const Workspace::Circle& circle, const CircleStudy& study,
                const CirclePlaces& places, bool chosen) {
    const float scale = frame.scale();
    ImDrawList& list = frame.list();
    const ImU32 colour = colourOf(study.fate), halo = haloOf(study.fate);
    // Beside its image, where a circle that is not around 0 has its points: |x| at the mean.
    if (study.high - study.low > 1e-6 * study.high)
        dashed(list, places.sphere(0.5 * (study.low + study.high)), kEscapesHalo, 1.0f * scale);
    drawImage(frame, study, places);
    const auto ring = places.circle(circle.centre, circle.radius, CircleStudy::kPoints);
    closedLine(list, ring, halo, (chosen ? 6.5f : 5.0f) * scale);
    closedLine(list, ring, colour, (chosen ? 3.2f : 2.2f) * scale);
    drawCircleArrows(frame, study, places);
    const ImVec2 centre = places(circle.centre);
    for (const auto& [tint, width] : {std::pair{halo, 4.0f}, std::pair{colour, 1.6f}}) {
        list.AddLine({centre.x - 5 * scale, centre.y}, {centre.x + 5 * scale, centre.y}, tint,
                     width * scale);
        list.AddLine({centre.x, centre.y - 5 * scale}, {centre.x, centre.y + 5 * scale}, tint,
                     width * scale);
    }
    drawWords(frame, study, ring, chosen);
}

}  // namespace

void drawCircles(const ViewFrame& frame) {
    const Workspace& workspace = frame.workspace();
    if (!traitsOf(frame.scene()).circles || (workspace.circles.empty() && !workspace.basins))
        return;
    const std::optional<StatePlane> states = statePlaneOf(frame.scene());
    if (!states || !takesCircles(workspace)) return;
    const CirclePlaces places(*states, frame.plane);
    if (workspace.basins) drawBasins(frame, places);
    const std::vector<CircleStudy>& all = studyCircles(frame.context, frame.view);
    for (std::size_t k = 0; k < all.size(); ++k)
        drawCircle(frame, workspace.circles[k], all[k], places,
                   static_cast<int>(k) == frame.context.circles.chosen);
}

}  // namespace versorium
