// SPDX-License-Identifier: MIT
#include "lesson/plate_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/clip.h"
#include "i18n/language.h"
#include "lesson/measures.h"
#include "math/elementary.h"

namespace versorium {
namespace {

using Curve = std::vector<std::array<double, 2>>;

// Longer orbits are clouds of points: their lines would cover the picture.
constexpr int kMostLineSteps = 60;
constexpr int kCircleCorners = 180;

// A plane of starting points of a map of the plane, with the state's own components as its axes.
bool isStatePlane(const Scene& scene) {
    const MapInfo& info = mapOf(scene).info;
    if (dimensionOf(info.algebra) != 2 || scene.slice.axes.size() != 2) return false;
    for (int k = 0; k < 2; ++k) {
        const SliceAxis& axis = scene.slice.axes[static_cast<std::size_t>(k)];
        if (axis.terms.size() != 1 || axis.terms[0].first != stateComponent(info, k) ||
            axis.terms[0].second != 1)
            return false;
    }
    return true;
}

class MarkFrame {
  public:
    explicit MarkFrame(const Scene& view)
        : x_(view.slice.centre[0]),
          y_(view.slice.centre[1]),
          half_(0.5 * view.slice.height),
          across_(half_ * view.aspect) {}

    bool holds(const std::array<double, 2>& p) const {
        return std::fabs(p[0] - x_) <= across_ && std::fabs(p[1] - y_) <= half_;
    }
    // The parts of a line that lie within, cut where it crosses the border.
    std::vector<Curve> runs(const Curve& line) const {
        std::vector<Curve> runs;
        bool goesOn = false;
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            const auto part = clipSegment(line[k], line[k + 1], {x_ - across_, y_ - half_},
                                          {x_ + across_, y_ + half_});
            if (!part) {
                goesOn = false;
                continue;
            }
            if (!goesOn || part->from > 0)
                runs.push_back({between(line[k], line[k + 1], part->from)});
            runs.back().push_back(between(line[k], line[k + 1], part->to));
            goesOn = part->to == 1;
        }
        return runs;
    }
    Curve within(Curve points) const {
        std::erase_if(points, [&](const auto& p) { return !holds(p); });
        return points;
    }

  private:
    double x_, y_, half_, across_;

    static std::array<double, 2> between(const std::array<double, 2>& a,
                                         const std::array<double, 2>& b, double t) {
        if (t == 1) return b;
        return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
    }
};

Curve orbitCurve(const Workspace& workspace) {
    Curve curve;
    for (const auto& state : orbitNow(workspace, workspace.orbitSteps))
        if (std::isfinite(state[0]) && std::isfinite(state[1]))
            curve.push_back({state[0], state[1]});
    return curve;
}

void add(PlateOverlay& overlay, const std::string& name, bool points, std::vector<Curve> curves) {
    std::erase_if(curves, [](const Curve& curve) { return curve.empty(); });
    if (!curves.empty()) overlay.parts.push_back({name, points, std::move(curves)});
}

void markOrbit(const Curve& orbit, const MarkFrame& frame, const Words& words,
               PlateOverlay& overlay) {
    if (static_cast<int>(orbit.size()) > kMostLineSteps + 1)
        add(overlay, words.tr("orbit"), true, {frame.within(orbit)});
    else
        add(overlay, words.tr("orbit"), false, frame.runs(orbit));
    if (!orbit.empty()) add(overlay, words.tr("start"), true, {frame.within({orbit[0]})});
}

void markCircles(const Workspace& workspace, const MarkFrame& frame, const Words& words,
                 PlateOverlay& overlay) {
    std::vector<Curve> circles;
    for (const Workspace::Circle& circle : workspace.circles) {
        Curve line;
        for (int k = 0; k <= kCircleCorners; ++k) {
            const double angle = 2 * std::numbers::pi * k / kCircleCorners;
            line.push_back({circle.centre[0] + circle.radius * versorium::cos(angle),
                            circle.centre[1] + circle.radius * versorium::sin(angle)});
        }
        for (Curve& run : frame.runs(line)) circles.push_back(std::move(run));
    }
    add(overlay, words.tr(workspace.circles.size() == 1 ? trLater("circle") : trLater("circles")),
        false, std::move(circles));
}

void markRoots(const Workspace& workspace, const MarkFrame& frame, const Words& words,
               PlateOverlay& overlay) {
    if (!workspace.showRoots) return;
    for (const auto& [name, list] : workspace.views[0].lists) {
        Curve places;
        for (const RootList::Root& root : list.roots) places.push_back({root.q[0], root.q[1]});
        add(overlay, words.tr(name), true, {frame.within(std::move(places))});
    }
}

}  // namespace

void markPanels(const Workspace& workspace, Plate& plate) {
    const Words words(plate.language);
    std::vector<PlatePanel>& panels = plate.panels;
    std::optional<Curve> orbit;
    for (std::size_t k = 0; k < std::min(panels.size(), workspace.views.size()); ++k) {
        const Scene& view = workspace.views[k];
        if (panels[k].kind != PanelKind::scene || !isStatePlane(view)) continue;
        if (!orbit) orbit = orbitCurve(workspace);
        PlateOverlay& overlay = panels[k].overlay;
        const MarkFrame frame(view);
        markOrbit(*orbit, frame, words, overlay);
        markCircles(workspace, frame, words, overlay);
        markRoots(workspace, frame, words, overlay);
        const Workspace::Study& study = workspace.study;
        overlay.criticalSet = study.criticalCurve;
        overlay.cycles = study.cycles ? study.mostPeriod : 0;
        overlay.manifolds = study.manifolds ? std::min(study.mostPeriod, 8) : 0;
    }
}

}  // namespace versorium
