// SPDX-License-Identifier: MIT
#pragma once
// What the two files of circles share: where states lie in a view, and the drawing.

#include <vector>

#include "ui/marks/mark.h"
#include "ui/session/state_plane.h"

namespace versorium {

class CirclePlaces {
  public:
    CirclePlaces(const StatePlane& states, const ViewPlane& plane)
        : states_(states), plane_(plane) {}
    ImVec2 operator()(const StatePlane::Point& x) const;
    // Not too far away to be drawn.
    bool shows(const StatePlane::Point& x) const;
    // So many points of a circle around a state, parallel to the plane.
    std::vector<ImVec2> circle(const StatePlane::Point& centre, double radius, int count) const;
    // Where the sphere of this radius around 0 meets the plane; nothing where it does not.
    std::vector<ImVec2> sphere(double radius) const;

  private:
    const StatePlane& states_;
    const ViewPlane& plane_;
};

// Basins, and the circles with what becomes of them.
void drawCircles(const ViewFrame& frame);

}  // namespace versorium
