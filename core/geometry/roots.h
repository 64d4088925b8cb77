// SPDX-License-Identifier: MIT
#pragma once
// The roots of a product Π (q - rᵢ)^(powerᵢ · scale) over the quaternions, or over the complex
// numbers when the last two components are 0. A product runs left to right, first root first.

#include <array>
#include <vector>

namespace versorium {

struct RootList {
    struct Root {
        std::array<double, 4> q{};  // (w, x, y, z)
        double power = 1.0;
        friend bool operator==(const Root&, const Root&) = default;
    };
    std::vector<Root> roots;
    double scale = 1.0;  // multiplies every power
    friend bool operator==(const RootList&, const RootList&) = default;
};

}  // namespace versorium
