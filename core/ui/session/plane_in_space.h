// SPDX-License-Identifier: MIT
#pragma once
// A slice of the quaternions as a plane in the space in which the shape stands: the three
// components that φ is looked up at. It may be moved along its normal and tilted, so its axes need
// not be those of space.

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "fields/evaluate.h"
#include "scene/scene.h"

namespace versorium {

struct PlaneInSpace {
    glm::dvec3 right{1, 0, 0}, up{0, 1, 0};  // of length 1, at right angles
    glm::dvec3 origin{0};                    // where u = v = 0
    glm::dvec3 at(double u, double v) const { return origin + u * right + v * up; }
    glm::dvec3 normal() const;
};

// None where the scene has no shape in space, or its slice is no such plane.
std::optional<PlaneInSpace> planeInSpace(const Scene& scene, const OrbitProgram& program);
// The slice becomes this plane; centre and height stay.
void setPlane(Scene& scene, const PlaneInSpace& plane);

// Turned by an angle (radians) about an axis of length 1, so that the point (u, v) stays where it
// is.
PlaneInSpace turned(const PlaneInSpace& plane, double u, double v, const glm::dvec3& axis,
                    double angle);

}  // namespace versorium
