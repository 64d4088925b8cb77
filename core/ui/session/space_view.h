// SPDX-License-Identifier: MIT
#pragma once
// The slice plane of the focused view in space, with its picture on it, and the target shape around
// it (S Fig 2): turned by the hand, moved along its normal, tilted.

#include <cstdint>
#include <string>

#include "render/shape_view.h"
#include "ui/session/plane_in_space.h"

namespace versorium {

struct StudioContext;

struct SpaceView {
    SpaceCamera camera;
    ShapeView shape;  // being traced
    std::string of;   // what it is a picture of
    glm::dvec3 shift{0};
    double reach = 0;
    PlaneInSpace behind;  // the plane that the veil was made for
    double wide = 0, tall = 0;
    unsigned solid = 0, veil = 0;  // the surface, and of it what lies before the plane
    bool shown = false, veiled = false;
    enum class Grip { none, look, move, tilt } grip = Grip::none;
    void contextLost() { solid = veil = 0, shown = veiled = false; }
};

// The plane of the focused view; none where that shows no plane in space.
std::optional<PlaneInSpace> markedPlane(StudioContext& context);
void putPlane(StudioContext& context, const PlaneInSpace& plane);
// By how much a plane lies off the origin, along its normal; for the keyboard.
double planeOffset(const PlaneInSpace& plane);
}  // namespace versorium
