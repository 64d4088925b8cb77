// SPDX-License-Identifier: MIT
#pragma once
// The squares that are timed; pixel centres at +0.5, v upwards, as everywhere.

namespace versorium::textbook {

struct View {
    double x, y, height;
    double u(int column, int side) const { return x + ((column + 0.5) / side - 0.5) * height; }
    double v(int row, int side) const { return y + (0.5 - (row + 0.5) / side) * height; }
};
inline constexpr View kHome{-0.75, 0, 2.5};

}  // namespace versorium::textbook
