// SPDX-License-Identifier: MIT
#pragma once
// At most three flashes a second, whatever is animated (WCAG 2.2, 2.3.1). A flash is a pair of
// opposing changes of relative luminance by a tenth or more, the darker below 0.8; here it counts
// where more than a quarter of a view's cells go through it, and a picture that would be one too
// many is not shown: the one before stays until there is room.

#include <array>
#include <deque>
#include <optional>
#include <span>

#include "image/raster.h"

namespace versorium {

class FlashGuard {
  public:
    static constexpr int kColumns = 12, kRows = 9;
    static constexpr int kMostFlashes = 3;  // in any second
    using Lights = std::array<float, kColumns * kRows>;

    // Whether a picture may be shown at `now`, in seconds; it then counts as shown.
    bool admit(const Lights& lights, double now);

  private:
    struct Cell {
        std::optional<float> extreme;  // since the last change
        int direction = 0;             // of that change
        std::deque<double> changes;
    };
    static bool changes(const Cell& cell, float light);

    std::array<Cell, kColumns * kRows> cells_;
};

// The mean relative luminance of each cell of a picture in sRGB, 4 bytes a pixel.
FlashGuard::Lights lightsOf(std::span<const unsigned char> rgba, Size size);

}  // namespace versorium
