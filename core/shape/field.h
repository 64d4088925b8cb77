// SPDX-License-Identifier: MIT
#pragma once
// A signed distance field φ that maps look into: a stored grid, read by trilinear interpolation
// (bilinear for a planar grid, which ignores z), or an analytic shape. Negative inside.
//
// Outside of its box a grid either repeats its border (`border`), or adds the distance to the box
// (`distance`), without which infinity has no basin (numerics: "outside").

#include <memory>
#include <optional>

#include "shape/distance.h"
#include "shape/grid_sampling.h"
#include "shape/tree.h"

namespace versorium {

class Modulation;  // shape/modulation.h

class DistanceField {
  public:
    DistanceField(std::shared_ptr<const Grid> grid, Outside outside)
        : grid_(std::move(grid)), outside_(outside) {}
    explicit DistanceField(ShapeTree shape) : shape_(std::move(shape)) {}

    const Grid* grid() const { return grid_.get(); }
    const ShapeTree* shape() const { return shape_ ? &*shape_ : nullptr; }
    Outside outside() const { return outside_; }

    // What α and β of a shape modulus are over space; null where they are the same everywhere.
    const Modulation* alpha() const { return alpha_.get(); }
    const Modulation* beta() const { return beta_.get(); }
    void modulate(std::shared_ptr<const Modulation> alpha, std::shared_ptr<const Modulation> beta) {
        alpha_ = std::move(alpha);
        beta_ = std::move(beta);
    }

    template <class R>
    R at(const R& x, const R& y, const R& z) const {
        return grid_ ? sampling::gridValue(*grid_, outside_, x, y, z) : distance(*shape_, x, y, z);
    }

  private:
    std::shared_ptr<const Grid> grid_;
    std::optional<ShapeTree> shape_;
    Outside outside_ = Outside::distance;
    std::shared_ptr<const Modulation> alpha_, beta_;
};

}  // namespace versorium
