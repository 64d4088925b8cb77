// SPDX-License-Identifier: MIT
#pragma once
// What the observables of a lesson measure (lesson/observables.h says it of each by name). Every
// value is one of the core's own fields or profiles, taken with a number of points and members that
// is bounded here, so that a goal can be asked while a hand moves a slider. NaN where there is
// nothing to measure, or where a shape's grid would take time to make.

#include <optional>
#include <vector>

#include "fields/evaluate.h"
#include "workspace/workspace.h"

namespace versorium {

inline constexpr int kShareSide = 64;              // points along a view, of `share` and its kin
inline constexpr int kCirclePoints = 256;          // on a circle, or around 0
inline constexpr int kMostMeasuredMembers = 2000;  // of an ensemble
inline constexpr int kMostEndSteps = 1000;

// A scene made ready to be measured; nothing where its shape needs a grid that takes time to make.
std::optional<OrbitProgram> programNow(const Scene& scene);
// The workspace's orbit, z_0 … at most z_steps; empty where it cannot be measured now.
std::vector<std::vector<double>> orbitNow(const Workspace& workspace, int steps);

// A field of the orbit that is drawn, or of the map's first critical point.
double ofOrbit(const Workspace& workspace, FieldName field);
double ofCriticalOrbit(const Workspace& workspace, FieldName field);
// A component of the orbit after N steps; NaN where it escapes before.
double endOfOrbit(const Workspace& workspace, std::size_t component);

// Of the first view of starting points: the part of it that does not escape.
double shareThatStays(const Workspace& workspace);
// The same of the shape, where φ < 0; and how well the two agree: their common part of the whole
// that they cover together, 0 … 1. Of complex maps with a shape.
double shareOfShape(const Workspace& workspace);
double agreementWithShape(const Workspace& workspace);
// φ at the orbit's start, and its mean over the circle around 0 through it.
double distanceAtStart(const Workspace& workspace);
double meanDistanceAround(const Workspace& workspace);
// The radius within which every orbit stays, whatever the direction (shape/radial_profile.h).
double captureRadius(const Workspace& workspace);
// Corners of a shape that is an outline, else 0.
double cornersOfShape(const Workspace& workspace);

// Of the first view's ensemble that varies: how many members it has, and the part of them whose set
// holds the orbit's start.
double membersCounted(const Workspace& workspace);
double memberShareAtStart(const Workspace& workspace);

// Circles all of whose points stay, none of whose points stay, and the others. Of complex maps.
enum class CircleEnd { captured, escapes, decided };
double circlesThatEnd(const Workspace& workspace, CircleEnd end);

// 1 where the first view of parameters may be read as a catalogue of Julia sets, else 0.
double isCatalogue(const Workspace& workspace);
// Between the first pinned setting and the present one.
double distanceToPin(const Workspace& workspace);

}  // namespace versorium
