// SPDX-License-Identifier: MIT
#include "ui/session/plane_in_space.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/shape_controls.h"

namespace versorium {
namespace {

constexpr double kStraight = 1e-6;  // how far axes may be from orthonormal
constexpr double kNothing = 1e-12;  // a weight that is rounding alone

glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
    return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
           axis * glm::dot(axis, v) * (1 - std::cos(angle));
}

}  // namespace

glm::dvec3 PlaneInSpace::normal() const { return glm::cross(right, up); }

std::optional<PlaneInSpace> planeInSpace(const Scene& scene, const OrbitProgram& program) {
    const MapInfo& info = mapOf(scene).info;
    if (!info.field || info.algebra != Algebra::quaternion || program.slice.axes.size() < 2)
        return std::nullopt;
    PlaneInSpace plane;
    const std::array<int, 3> components = shapeControls(scene).seen;
    for (std::size_t number = 0; number < program.slice.origin.size(); ++number) {
        const auto found = std::find(components.begin(), components.end(), number);
        if (found == components.end()) {
            // Whatever else is on an axis, a parameter or the component that is not seen.
            if (program.slice.varies(number)) return std::nullopt;
            continue;
        }
        const auto k = static_cast<int>(found - components.begin());
        plane.right[k] = program.slice.axes[0][number];
        plane.up[k] = program.slice.axes[1][number];
        plane.origin[k] = program.slice.origin[number];
    }
    const bool straight = std::abs(glm::length(plane.right) - 1) < kStraight &&
                          std::abs(glm::length(plane.up) - 1) < kStraight &&
                          std::abs(glm::dot(plane.right, plane.up)) < kStraight;
    if (!straight) return std::nullopt;
    return plane;
}

void setPlane(Scene& scene, const PlaneInSpace& plane) {
    const MapInfo& info = mapOf(scene).info;
    const std::array<int, 3> components = shapeControls(scene).seen;
    SliceSpec& slice = scene.slice;
    slice.axes.assign(2, {});
    for (int k = 0; k < 3; ++k) {
        const std::string name = stateComponent(info, components[static_cast<std::size_t>(k)]);
        for (const auto& [axis, weight] : {std::pair{0, plane.right[k]}, {1, plane.up[k]}})
            if (std::abs(weight) > kNothing)
                slice.axes[static_cast<std::size_t>(axis)].terms.emplace_back(name, weight);
        // A component that keeps its value need not be named.
        const bool onAxis = std::abs(plane.right[k]) > kNothing || std::abs(plane.up[k]) > kNothing;
        const auto component = static_cast<std::size_t>(components[static_cast<std::size_t>(k)]);
        if (plane.origin[k] == (onAxis ? 0 : scene.start[component]))
            slice.origin.erase(name);
        else
            slice.origin[name] = plane.origin[k];
    }
}

PlaneInSpace turned(const PlaneInSpace& plane, double u, double v, const glm::dvec3& axis,
                    double angle) {
    PlaneInSpace result;
    result.right = glm::normalize(rotated(plane.right, axis, angle));
    // Rounding must not add up over a long drag.
    const glm::dvec3 up = rotated(plane.up, axis, angle);
    result.up = glm::normalize(up - result.right * glm::dot(up, result.right));
    result.origin = plane.at(u, v) - u * result.right - v * result.up;
    return result;
}

}  // namespace versorium
