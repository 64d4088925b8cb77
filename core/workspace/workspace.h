// SPDX-License-Identifier: MIT
#pragma once
// Workspace: what the studio shows, as one value. Every view is a whole Scene of the same map; the
// views are welded: map, parameters, lists, shape and the orbit's starting point are the same in
// all of them, while slice, starting rule, iterations, layers, colours and the parameters that the
// map says so of (ParameterInfo::ofView) are each view's own.
// Undo is a list of workspaces, a link is a workspace.
//
// Five views are an analysis (A section 5.1): the first one shows parameters, and each of the four
// others has its own place there. Numbers on the first view's axes are then each view's own.

#include <array>
#include <string>
#include <vector>

#include "scene/animation.h"
#include "scene/numbers.h"
#include "scene/scene.h"
#include "scene/view_kind.h"

namespace versorium {

inline constexpr int kMostViews = 5;
inline constexpr int kAnalysisViews = 5;
inline constexpr int kMostPins = 4;
inline constexpr int kMostOrbitSteps = 1000;
inline constexpr std::size_t kMostRanges = 256;
inline constexpr int kMostShownPeriod = 12;
inline constexpr std::size_t kMostCircles = 8;
// What a view shows from bottom to top: as deep as double precision goes, and as far.
inline constexpr double kLeastHeight = 1e-13, kMostHeight = 1e6;

// A setting of all parameters that was set aside.
using Pin = std::map<std::string, std::vector<double>>;

// What stands below the views: the orbit as a time series or as a web, the bifurcation diagram, the
// mean of φ over circles, or the motion.
enum class PlotPanel { series, web, diagram, profile, motion };
template <>
struct EnumWords<PlotPanel> {
    static constexpr std::array<std::string_view, 5> table{"series", "web", "diagram", "profile",
                                                           "motion"};
};

struct Workspace {
    std::vector<Scene> views;   // 1, 2, 4 or 5
    int focused = 0;            // the view that commands act on
    bool maximised = false;     // only the focused view is shown
    std::vector<double> point;  // z_0 of the orbit that is drawn: one number for each of a state
    int orbitSteps = 24;
    int orbitAt = 0;      // the step that is marked, at most orbitSteps
    bool arrows = false;  // from points x to f(x), on views of starting points
    std::vector<Pin> pins;
    // The ranges of sliders that are not the program's own, by the number's name: low < high.
    std::map<std::string, std::array<double, 2>> ranges;
    // A motion of the numbers that all views share, and of what is the moving view's own.
    Motion motion;
    int motionView = 0;
    // The second orbit of the time series starts here; none where it is empty.
    std::vector<double> compared;
    // What is drawn over planes of starting points (core/dynamics).
    struct Study {
        bool cycles = false;  // fixed points and cycles
        int mostPeriod = 3;   // 1 … kMostShownPeriod
        bool manifolds = false;
        bool criticalCurve = false;
        friend bool operator==(const Study&, const Study&) = default;
    } study;
    bool showRoots = true;  // marks of roots and poles, on planes of starting points
    // Circles that were dropped there (S Fig 3): each lies in the plane through its centre that is
    // parallel to the view's. At most kMostCircles.
    struct Circle {
        std::array<double, 4> centre{};
        double radius = 0.5;  // above 0
        friend bool operator==(const Circle&, const Circle&) = default;
    };
    std::vector<Circle> circles;
    bool basins = false;  // where capture, or escape, is certain
    // The bifurcation diagram: empty for a number of the program's own choice.
    struct Diagram {
        std::string number;
        double left = 0, right = 1;  // of the number; left < right
        friend bool operator==(const Diagram&, const Diagram&) = default;
    } diagram;
    PlotPanel plot = PlotPanel::series;

    bool analysis() const { return views.size() == kAnalysisViews; }
    // The view whose numbers are shown and set: the focused one of an analysis, never its first.
    std::size_t speaker() const {
        return analysis() ? static_cast<std::size_t>(focused > 0 ? focused : 1) : 0;
    }
    Scene& view() { return views[static_cast<std::size_t>(focused)]; }
    const Scene& view() const { return views[static_cast<std::size_t>(focused)]; }
};

// The plane of starting points, at home.
Scene dynamicalView(const Scene& like);
// The plane of the first two numbers among the parameters that are worth varying, started at the
// first critical point where there is one. A map without two parameters gives a dynamical view.
Scene parameterView(const Scene& like);
// The home view of a kind, for the same map and the same numbers.
Scene homeView(ViewKind kind, const Scene& like);
// The place where a view with these axes begins.
SliceSpec homeOf(const Scene& scene);
// The first view of a kind; -1 for none. A view that is meant is the focused one, else the first.
int firstOfKind(const Workspace& workspace, ViewKind kind);
int viewOfKind(const Workspace& workspace, ViewKind kind);

// The scene beside its welded partner, in the order of their kinds.
Workspace workspaceOf(const Scene& scene);
// 1, 2 or 4 views; new ones repeat the kinds of the first two.
void setViewCount(Workspace& workspace, int count);
// Five views: parameters, and starting points at the pins, or at places around where it is. False
// where the map has no two parameters.
bool setAnalysis(Workspace& workspace);

// Numbers that all views share: components of the state mean the orbit's starting point.
double sharedNumber(const Workspace& workspace, const std::string& name);
void setSharedNumber(Workspace& workspace, const std::string& name, double value);
void setSharedParameter(Workspace& workspace, const std::string& name,
                        const std::vector<double>& value);

// Where the current numbers, or those of a scene, lie in a view, along its axes, and the way back.
std::array<double, 2> markerOf(const Workspace& workspace, std::size_t view);
std::array<double, 2> markerOf(const Scene& numbers, const SliceSpec& slice);
void moveMarker(Workspace& workspace, std::size_t view, double u, double v);

// A view's height is what its shorter side shows, so that a tall one, as on a phone, cuts nothing
// off at its sides. What it shows from bottom to top, where it is `aspect` times as wide as high:
double shownHeight(const Scene& view, double aspect);
// The scene to draw for such a view: of that height, and without the numbers that its picture does
// not depend on, since they run along its axes. Views that differ in these alone look the same.
Scene pictureScene(const Scene& view, double aspect);

// Files that no view needs any more are forgotten.
void dropUnnamedAssets(Workspace& workspace);
// Puts a file into all views and returns its name for a layer or a shape. Empty where they would
// carry more than kMostAssetBytes.
std::string addSharedAsset(Workspace& workspace, Asset asset);

// All numbers that an axis of a slice may stand for.
std::vector<std::string> axisNames(const Scene& scene);
// Lets an axis of the focused view stand for a number. The same number on both axes would be a
// line: the axes change places instead.
void setAxis(Workspace& workspace, std::size_t axis, const std::string& name);

// An axis of the view of parameters that is meant, or of the first view, which becomes one of
// parameters where there is none, stands for a number from now on. Places of an analysis keep their
// own numbers on its axes only.
void makeAxis(Workspace& workspace, std::size_t axis, const std::string& name);

// A scene whose points are the starting points around `workspace.point`; for orbits and probes.
Scene orbitScene(const Workspace& workspace);

// The moving view with all that a motion could move, as it is now.
Scene movingScene(const Workspace& workspace);
// The motion at a time: numbers go to all views, the others to the moving view.
void showMotion(Workspace& workspace, double time);

// The borders of a view that is `aspect` times as wide as high: left, right, bottom, top.
std::array<double, 4> bordersOf(const Scene& scene, double aspect);
// Moves one of them; the opposite one stays, and the others follow from the aspect. False where
// that would turn the view round, or make it no view.
bool setBorder(Scene& scene, int border, double value, double aspect);

Json workspaceToJson(const Workspace& workspace);
// Equal for equal workspaces; assets stand in it by their SHA-256 (scene/parts.h, sceneKey).
Json workspaceKey(const Workspace& workspace);
// Strict, like sceneFromJson: ErrorKind::data with the path of the fault.
Expected<Workspace> workspaceFromJson(const Json& json);

// The same as the fragment of a link: "v1:" and the deflated JSON of what differs from the map's
// defaults, as URL-safe Base64. Assets above kLinkAssetBytes make it fail with ErrorKind::usage.
inline constexpr std::size_t kLinkAssetBytes = 8192;
inline constexpr std::size_t kLinkBytes = 1u << 16;  // unpacked
Expected<std::string> workspaceToLink(const Workspace& workspace);
Expected<Workspace> workspaceFromLink(const std::string& fragment);

// All workspaces that were, with the one that is.
class History {
  public:
    explicit History(Workspace first) : states_{std::move(first)} {}

    const Workspace& now() const { return states_[at_]; }
    // What could be redone is dropped. A workspace that equals the present one changes nothing.
    void record(const Workspace& workspace);
    bool canUndo() const { return at_ > 0; }
    bool canRedo() const { return at_ + 1 < states_.size(); }
    const Workspace& undo() { return states_[canUndo() ? --at_ : at_]; }
    const Workspace& redo() { return states_[canRedo() ? ++at_ : at_]; }

  private:
    static constexpr std::size_t kMost = 10000;
    std::vector<Workspace> states_;
    std::size_t at_ = 0;
};

}  // namespace versorium
