// SPDX-License-Identifier: MIT
#pragma once
// A number that is not the same everywhere (S section 3.3, Figs 7 and 13: α and β over space):
//   value(x) = keep(x)·base + add(x).
// Within a second shape the number tends to another value along a cubic in that shape's distance;
// over it discs (balls, in space) are painted, each of which draws the number to its own value. The
// base is given with every look, so that it may be an axis of a slice or vary in an ensemble.

#include <memory>
#include <vector>

#include "shape/field.h"

namespace versorium {

// 3s² - 2s³ of s held within [0, 1]: flat at both ends.
template <class R>
R cubicStep(const R& s) {
    const R t = min(max(R(0.0), s), R(1.0));
    return t * t * (R(3.0) - (t + t));
}

struct ModulatingShape {
    std::shared_ptr<const DistanceField> field;
    // Where the distance is at most `from` the number is `value`, from `to` on it is the base.
    double from = 0, to = 0.1, value = 0;
};

// At its centre the number becomes `value`; at the radius and beyond it is what it was.
struct PaintedDisc {
    double x = 0, y = 0, z = 0;  // in the shape's own coordinates
    double radius = 0.1;         // above 0
    double value = 0;
    friend bool operator==(const PaintedDisc&, const PaintedDisc&) = default;
};

class Modulation {
  public:
    Modulation() = default;
    // Discs are painted one over the other, in their order; on a plane (`planar`) they ignore z.
    // They are baked into a grid of at most kModulationNodes nodes a side (kModulationNodesInSpace
    // in space), between which the number is interpolated.
    Modulation(std::optional<ModulatingShape> shape, const std::vector<PaintedDisc>& discs,
               bool planar);

    template <class R>
    R at(const R& x, const R& y, const R& z, const R& base) const {
        using T = ScalarOf<R>;
        R number = base;
        if (shape_) {
            const R from(static_cast<T>(shape_->from));
            const R width(static_cast<T>(shape_->to - shape_->from));
            const R phi = shape_->field->at(x, y, z);
            const R away = cubicStep((phi - from) / width);
            const R value(static_cast<T>(shape_->value));
            number = away * number + (R(1.0) - away) * value;
        }
        if (keep_)
            number = sampling::gridValue(*keep_, Outside::border, x, y, z) * number +
                     sampling::gridValue(*add_, Outside::border, x, y, z);
        return number;
    }
    // The least and the greatest number that any place may have.
    std::array<double, 2> rangeFrom(double base) const;

  private:
    std::optional<ModulatingShape> shape_;
    std::shared_ptr<const Grid> keep_, add_;
    std::vector<double> values_;  // of the discs
};

inline constexpr int kModulationNodes = 513, kModulationNodesInSpace = 97;

}  // namespace versorium
