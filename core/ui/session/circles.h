// SPDX-License-Identifier: MIT
#pragma once
// Circles dropped on planes of starting points (S Fig 3). A circle shows where f takes it, and what
// becomes of its points: all of them stay, all escape, or the direction d decides. Around 0 lies a
// ball that provably keeps every orbit, whatever d is; where the field grows with the distance,
// there is a radius beyond which every orbit leaves (shape/radial_profile.h).

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/session/state_plane.h"
#include "workspace/workspace.h"

namespace versorium {

struct StudioContext;
class System;

// Radii around 0 that decide alone; nothing is known where capture is 0, or escape infinite.
struct Basins {
    double capture = 0;
    double escape = 0;
};

enum class CircleFate { captured, escapes, decided };

struct CircleStudy {
    using Point = StatePlane::Point;
    // Around the circle; while something moves, fewer.
    static constexpr int kPoints = 576, kFewPoints = 144;

    CircleFate fate = CircleFate::captured;
    bool certain = false;         // by the basins: for every point, not for those that were tried
    int iterations = 0;           // for which its points were followed
    double stay = 0;              // the part of the points that never escape
    double least = 0, most = 0;   // of |f(x)| along it
    double low = 0, high = 0;     // of |x|
    bool oneModulus = false;      // |f| is the same all along
    std::vector<Point> from, to;  // fⁿ(x) and fⁿ⁺¹(x), n the marked step of the orbit
    std::vector<bool> member;
};

// What was found, until something changes.
struct CircleStudies {
    struct OfView {
        std::uint64_t revision = 0;
        bool fine = false;
        std::vector<CircleStudy> all;
    };
    std::array<OfView, kMostViews> views;
    std::string basinsFor;  // what the basins follow from
    Basins basins;
    int chosen = -1;
};

// Of one circle in this plane. `iterate` gives fⁿ up to the workspace's step and beyond.
CircleStudy studyCircle(const System& system, const Workspace::Circle& circle,
                        const StatePlane& plane, int step, int iterations, double escapeRadius,
                        const Basins& basins, int points = CircleStudy::kPoints);
// In a sentence: "captured: no orbit that starts here escapes within 12 steps".
std::string sentenceOf(const CircleStudy& study);

// Whether circles can be dropped here: a complex or quaternion map.
bool takesCircles(const Workspace& workspace);
// A view that they are drawn on: the focused one where it is one, else the first; -1 for none.
int circleViewOf(const Workspace& workspace);
const std::vector<CircleStudy>& studyCircles(StudioContext& context, int view);
Basins studyBasins(StudioContext& context);

// Around 0, through the pointer where that is over a view, else through the orbit's point.
void dropCircle(StudioContext& context);
void removeCircle(StudioContext& context, int circle);
// "Circle 1: …" for each of them, in sentences.
std::string describeCircles(StudioContext& context);
// The panel: basins, circles and what becomes of them.
void drawCircleControls(StudioContext& context);

}  // namespace versorium
