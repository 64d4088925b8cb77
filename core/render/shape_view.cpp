// SPDX-License-Identifier: MIT
#include "render/shape_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "math/elementary.h"

namespace versorium {
namespace {

constexpr int kMostSteps = 128;
constexpr double kCautious = 0.9;    // of φ: grids are not quite distances
constexpr double kNear = 1e-3;       // of the reach: a hit
constexpr double kLeastStep = 2e-3;  // of the reach
constexpr double kAmbient = 0.25;

}  // namespace

glm::dvec3 SpaceCamera::forward() const {
    const double across = cos(pitch);
    return {-sin(yaw) * across, -sin(pitch), -cos(yaw) * across};
}
glm::dvec3 SpaceCamera::right() const { return {cos(yaw), 0, -sin(yaw)}; }
glm::dvec3 SpaceCamera::up() const { return glm::cross(right(), forward()); }

void ShapeView::start(std::shared_ptr<const DistanceField> field, const glm::dvec3& shift,
                      double reach, const SpaceCamera& camera, Size size) {
    field_ = std::move(field);
    shift_ = shift;
    reach_ = reach;
    camera_ = camera;
    size_ = size;
    row_ = 0;
    depth_ = Raster<double>(size, 1, std::numeric_limits<double>::quiet_NaN());
    light_ = Raster<float>(size, 1);
}

double ShapeView::phi(const glm::dvec3& point) const {
    const glm::dvec3 at = point - shift_;
    return field_->at(at.x, at.y, at.z);
}

glm::dvec3 ShapeView::pointAt(double x, double y) const {
    const double pixel = 2 * camera_.halfHeight / size_.height;
    return camera_.centre + camera_.right() * ((x + 0.5 - 0.5 * size_.width) * pixel) +
           camera_.up() * ((0.5 * size_.height - (y + 0.5)) * pixel);
}

bool ShapeView::advance(int rows) {
    const glm::dvec3 forward = camera_.forward();
    // From the camera's upper left.
    const glm::dvec3 lamp = glm::normalize(-forward + 0.5 * camera_.up() - 0.4 * camera_.right());
    const int last = std::min(row_ + rows, size_.height);
    for (; row_ < last; ++row_)
        for (int x = 0; x < size_.width; ++x) {
            const glm::dvec3 begin = pointAt(x, row_);
            const double square =
                reach_ * reach_ - glm::dot(begin - camera_.centre, begin - camera_.centre);
            if (square <= 0) continue;
            const double end = std::sqrt(square);
            double depth = -end, value = 1;
            for (int k = 0; k < kMostSteps && depth <= end; ++k) {
                value = phi(begin + depth * forward);
                if (!(value > kNear * reach_)) break;
                depth += std::max(kCautious * value, kLeastStep * reach_);
            }
            if (!(value <= kNear * reach_) || depth > end) continue;
            const glm::dvec3 hit = begin + depth * forward;
            const double h = 5 * kNear * reach_;
            glm::dvec3 normal;
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 step(0);
                step[axis] = h;
                normal[axis] = phi(hit + step) - phi(hit - step);
            }
            const double length = glm::length(normal);
            const double facing = length > 0 ? glm::dot(normal, lamp) / length : 0;
            depth_.at(x, row_) = depth;
            light_.at(x, row_) =
                static_cast<float>(kAmbient + (1 - kAmbient) * std::clamp(facing, 0.0, 1.0));
        }
    return finished();
}

}  // namespace versorium
