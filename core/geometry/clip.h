// SPDX-License-Identifier: MIT
#pragma once
// Which part of a segment lies in a rectangle (Y.-D. Liang and B. Barsky, 1984).

#include <array>
#include <optional>

namespace versorium {

struct SegmentPart {
    double from = 0, to = 1;  // shares of the way from one end to the other
};
// Nothing where no point of it does. Both ends are finite.
std::optional<SegmentPart> clipSegment(const std::array<double, 2>& start,
                                       const std::array<double, 2>& finish,
                                       const std::array<double, 2>& low,
                                       const std::array<double, 2>& high);

}  // namespace versorium
