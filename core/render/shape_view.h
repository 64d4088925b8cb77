// SPDX-License-Identifier: MIT
#pragma once
// The surface φ = 0 of a distance field as it is seen from afar: an orthographic picture with its
// depths, so that a plane can be put through it (S Fig 2). Rays advance by φ, which never steps
// over the surface of a distance field and seldom over that of a coarse grid.

#include <array>
#include <glm/vec3.hpp>

#include "image/raster.h"
#include "shape/field.h"

namespace versorium {

// Looks along `forward`; y is up where pitch and yaw are 0, and x to the right. Angles in radians:
// yaw turns the camera about y, pitch lifts it, |pitch| < π/2.
struct SpaceCamera {
    glm::dvec3 centre{0};
    double yaw = 0.5, pitch = 0.35;
    double halfHeight = 1;  // of the picture, in units of space

    glm::dvec3 right() const;
    glm::dvec3 up() const;
    glm::dvec3 forward() const;
    friend bool operator==(const SpaceCamera&, const SpaceCamera&) = default;
};

class ShapeView {
  public:
    // Begins anew. φ is looked up at a point less `shift`; `reach` is how far the surface may lie
    // from camera.centre.
    void start(std::shared_ptr<const DistanceField> field, const glm::dvec3& shift, double reach,
               const SpaceCamera& camera, Size size);
    // Draws so many rows more; true when all are there.
    bool advance(int rows);

    bool finished() const { return row_ >= size_.height; }
    Size size() const { return size_; }
    const SpaceCamera& camera() const { return camera_; }
    // Along `forward`, from the plane through camera.centre; NaN where no surface is met.
    const Raster<double>& depth() const { return depth_; }
    // In [0, 1]: how much light the surface sends here; 0 where there is none.
    const Raster<float>& light() const { return light_; }
    // The point of space on that plane that a pixel's middle shows.
    glm::dvec3 pointAt(double x, double y) const;

  private:
    double phi(const glm::dvec3& point) const;

    std::shared_ptr<const DistanceField> field_;
    glm::dvec3 shift_{0};
    double reach_ = 1;
    SpaceCamera camera_;
    Size size_;
    int row_ = 0;
    Raster<double> depth_;
    Raster<float> light_;
};

}  // namespace versorium
