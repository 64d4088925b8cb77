// SPDX-License-Identifier: MIT
#pragma once
// What is found out about the system that is shown (core/dynamics): cycles with the manifolds of
// saddles, critical curves, the badge of a set of parameters, bifurcation diagrams. Each is kept
// until what it depends on changes, and worked out a few milliseconds in a frame: coarsely while
// something moves, finer once it stands still.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/bifurcation_diagram.h"
#include "dynamics/catalogue_badge.h"
#include "dynamics/critical_set.h"
#include "dynamics/cycles.h"
#include "dynamics/manifolds.h"
#include "workspace/diagram.h"
#include "workspace/workspace.h"

namespace versorium {

struct StudioContext;
struct RadialProfile;

// A system with all its numbers, and what else a result depends on.
struct StudyKey {
    const MapKernels* map = nullptr;
    std::shared_ptr<const FormulaMap> formula;  // kept, so that no other takes its place
    std::vector<double> numbers;
    friend bool operator==(const StudyKey&, const StudyKey&) = default;
};

struct CycleStudy {
    StudyKey system;         // the map and its parameters
    std::vector<double> of;  // the window and the most period
    int across = 0;          // starts along a side in the last search; 0: none yet
    bool finished = false;   // no finer search is to come
    bool coarse = false;     // a finer one would take too long
    std::string problem;     // why there is no list
    std::vector<PeriodicCycle> cycles;
    std::vector<SaddleManifolds> manifolds;  // of the first saddles
    std::size_t saddlesDone = 0;             // cycles that were looked at for manifolds
};

struct CriticalStudy {
    StudyKey key;
    int across = 0;
    CriticalSet set;
};

struct BadgeStudy {
    std::uint64_t revision = 0;
    std::optional<CatalogueBadge> badge;
};

struct DiagramStudy {
    StudyKey key;
    std::optional<OrbitProgram> program;
    std::string problem;
    DiagramOptions options;
    std::optional<BifurcationDiagram> diagram;
    int filled = 0;          // columns
    unsigned texture = 0;    // of the columns that are filled
    int textured = 0;        // columns that the texture has
    std::size_t theme = 99;  // that it was coloured for
};

// The radial profile of the shape (render/shape_profile.h).
struct ProfileStudy {
    std::uint64_t revision = 0;
    std::string key;      // what it follows from
    int level = 0;        // how finely it is sampled next
    int tries = 0;        // that took too long
    bool ended = false;   // no finer one is to come
    std::string problem;  // why there is none
    std::shared_ptr<const RadialProfile> profile;
};

struct Studies {
    CycleStudy cycles;
    std::array<CriticalStudy, kMostViews> critical;
    std::array<BadgeStudy, kMostViews> badges;
    DiagramStudy diagram;
    ProfileStudy profile;
    int newestAxis = 1;  // of the parameter view: the other one is replaced next
    std::uint64_t comparedRevision = 0;
    std::vector<std::vector<double>> compared;  // the second orbit

    void contextLost() { diagram.texture = 0, diagram.textured = 0; }
};

// Nothing has changed for a moment, and no button is down.
bool atRest(const StudioContext& context);
// The system of the orbit that is drawn; nothing while a shape needs a grid.
std::optional<System> shownSystem(StudioContext& context);
// A view whose coordinates are those of states, by itself or beside a parameter on the line: the
// focused one, else the first; -1 for none.
int dynamicalViewOf(const Workspace& workspace);
// What such a view shows.
Window windowOf(const StudioContext& context, int view);

const CycleStudy& studyCycles(StudioContext& context);
const CriticalSet& studyCritical(StudioContext& context, int view);
// Null before it is known.
const CatalogueBadge* studyBadge(StudioContext& context, int view);
const std::vector<std::vector<double>>& comparedOrbit(StudioContext& context);

// Fills some more columns of a diagram of this size.
DiagramStudy& studyDiagram(StudioContext& context, Size size);
// As wide as the part of the usual range in which the orbit stays bounded.
void fitDiagram(StudioContext& context);

// Coarse at once, finer while everything stands still.
const ProfileStudy& studyProfile(StudioContext& context);
// What it says at a radius, and in sentences.
std::string profileAt(const RadialProfile& profile, double radius);
std::string describeProfile(StudioContext& context);

// Where the set of a parameter view starts: its own p*, or its critical point at the ring. Nothing
// where the start is on an axis.
std::optional<std::vector<double>> startOf(StudioContext& context, int view);
void setStart(StudioContext& context, int view, std::vector<double> start);
// p* goes to the nearest point of the critical curve.
void startAtNearest(StudioContext& context, int view, PlanePoint near);

// One click on a number: it takes the axis that was set longest ago.
void nextAxis(StudioContext& context, const std::string& name);
// "→", "↑" or nothing: the axis of the parameter view that is this number alone.
const char* axisSign(const Workspace& workspace, const std::string& name);

// Panels (study_panel.cpp, diagram_plot.cpp, profile_plot.cpp, planar_panel.cpp).
void drawStartControls(StudioContext& context);
void drawCycleControls(StudioContext& context);
void drawComparedControls(StudioContext& context);
void drawPlanarPanel(StudioContext& context);
void drawDiagram(StudioContext& context);
void drawProfile(StudioContext& context);

}  // namespace versorium
