// SPDX-License-Identifier: MIT
#pragma once
// A picture is an affine slice through (starting point × parameters): Slice takes coordinates
// (u, v, …) to all the numbers that fix an orbit,
//   x = origin + u axis₀ + v axis₁ + …
// A Julia set slices the starting point, a bifurcation set two parameters; nothing here tells them
// apart. The centre of a view is kept as a high and a low part, so that deep views need no other
// format; what is computed today is their sum in double.
//
// Conventions of all views: pixel centres lie at +0.5, v points up, row 0 of a raster is on top.

#include <cstddef>
#include <vector>

#include "image/raster.h"

namespace versorium {

struct Slice {
    std::vector<double> origin;             // one for each number of an orbit
    std::vector<std::vector<double>> axes;  // 1 … 3 directions of the same length

    double at(std::size_t number, const double* coordinates) const {
        double value = origin[number];
        for (std::size_t k = 0; k < axes.size(); ++k)
            if (axes[k][number] != 0) value = value + coordinates[k] * axes[k][number];
        return value;
    }
    // Whether a number differs from point to point.
    bool varies(std::size_t number) const {
        for (const auto& axis : axes)
            if (axis[number] != 0) return true;
        return false;
    }
};

struct Viewport {
    Size size;              // in samples
    double centre[2] = {};  // high parts
    double centreLow[2] = {};
    double height = 4;  // of the view, in units of the axes; pixels are square

    double pixel() const { return height / size.height; }
    double u(double x) const {
        return centre[0] + (centreLow[0] + (x + 0.5 - 0.5 * size.width) * pixel());
    }
    double v(double y) const {
        return centre[1] + (centreLow[1] + (0.5 * size.height - (y + 0.5)) * pixel());
    }
};

}  // namespace versorium
