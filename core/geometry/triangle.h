// SPDX-License-Identifier: MIT
#pragma once
// A triangle in space made ready for two questions: how far a point is from it, and under which
// solid angle it is seen. The plane is cut into the regions nearest to the face, to each side and
// to each corner (as in Ericson, Real-Time Collision Detection, 2005, section 5.1.5), here by the
// sides' own planes, so that thin triangles lose no digits.

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "math/elementary.h"

namespace versorium {

// Square of the distance from the point to the segment a + t·side, 0 ≤ t ≤ 1; a side of length 0
// has inverseSquare 0.
inline double squaredDistanceToSegment(const glm::dvec3& point, const glm::dvec3& a,
                                       const glm::dvec3& side, double inverseSquare) {
    const glm::dvec3 from = point - a;
    const double along = std::clamp(glm::dot(from, side) * inverseSquare, 0.0, 1.0);
    const glm::dvec3 apart = from - along * side;
    return glm::dot(apart, apart);
}

class Triangle {
  public:
    Triangle() = default;
    // The corners, counter-clockwise seen from outside; they must span an area.
    Triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) : corners_{a, b, c} {
        normal_ = glm::cross(b - a, c - a);
        const double doubled = sqrt(glm::dot(normal_, normal_));
        area_ = doubled / 2;
        normal_ /= doubled;
        for (std::size_t i = 0; i < 3; ++i) {
            sides_[i] = corners_[(i + 1) % 3] - corners_[i];
            outward_[i] = glm::cross(sides_[i], normal_);
            inverseSquares_[i] = 1 / glm::dot(sides_[i], sides_[i]);
        }
    }

    const std::array<glm::dvec3, 3>& corners() const { return corners_; }
    const glm::dvec3& normal() const { return normal_; }  // of length 1
    double area() const { return area_; }
    glm::dvec3 centroid() const { return (corners_[0] + corners_[1] + corners_[2]) / 3.0; }

    // Exact where it is below `best`; otherwise anything not below `best`.
    double squaredDistance(const glm::dvec3& point, double best) const {
        const double height = glm::dot(point - corners_[0], normal_);
        const double squaredHeight = height * height;
        if (squaredHeight >= best) return best;
        double nearest = best;
        bool inside = true;
        // The nearest point lies on a side whose outer half-plane the point is in.
        for (std::size_t i = 0; i < 3; ++i) {
            if (!(glm::dot(point - corners_[i], outward_[i]) > 0)) continue;
            inside = false;
            nearest = std::min(nearest, squaredDistanceToSegment(point, corners_[i], sides_[i],
                                                                 inverseSquares_[i]));
        }
        return inside ? squaredHeight : nearest;
    }

    // Signed solid angle in (-2π, 2π], positive for a point behind the face (van Oosterom and
    // Strackee 1983).
    double solidAngle(const glm::dvec3& point) const {
        const glm::dvec3 a = corners_[0] - point, b = corners_[1] - point, c = corners_[2] - point;
        const double la = sqrt(glm::dot(a, a)), lb = sqrt(glm::dot(b, b)),
                     lc = sqrt(glm::dot(c, c));
        const double volume = glm::dot(a, glm::cross(b, c));
        const double rest =
            la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
        return 2 * atan2(volume, rest);
    }

  private:
    std::array<glm::dvec3, 3> corners_;
    std::array<glm::dvec3, 3> sides_;
    std::array<glm::dvec3, 3> outward_;  // in the plane, away from the face, of any length
    std::array<double, 3> inverseSquares_{};
    glm::dvec3 normal_;
    double area_ = 0;
};

}  // namespace versorium
