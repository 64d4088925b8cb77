// SPDX-License-Identifier: MIT
#include "geometry/clip.h"

#include <gtest/gtest.h>

#include "base/random.h"

namespace versorium {
namespace {

using Point = std::array<double, 2>;
constexpr Point kLow{-1, 0}, kHigh{2, 1};

bool inside(const Point& p, double margin) {
    for (std::size_t k = 0; k < 2; ++k)
        if (!(p[k] >= kLow[k] - margin && p[k] <= kHigh[k] + margin)) return false;
    return true;
}

TEST(ClipSegment, EndsOnTheBorderItCrosses) {
    const auto part = clipSegment({-2, 0.5}, {3, 0.5}, kLow, kHigh);
    ASSERT_TRUE(part);
    EXPECT_DOUBLE_EQ(part->from, 0.2);
    EXPECT_DOUBLE_EQ(part->to, 0.8);
    EXPECT_FALSE(clipSegment({-2, 0.5}, {0, 4}, kLow, kHigh));
    // A point and a line along the border belong to the rectangle.
    EXPECT_TRUE(clipSegment({2, 1}, {2, 1}, kLow, kHigh));
    EXPECT_TRUE(clipSegment({-5, 1}, {5, 1}, kLow, kHigh));
}

// A place of the segment lies in the rectangle exactly where the part says so.
TEST(ClipSegment, IsWhereThePointsLieInside) {
    Random random(4);
    int cut = 0;
    for (int i = 0; i < 2000; ++i) {
        const Point a{random.uniform(-4, 5), random.uniform(-3, 4)};
        const Point b{random.uniform(-4, 5), random.uniform(-3, 4)};
        const auto part = clipSegment(a, b, kLow, kHigh);
        cut += part && part->from > 0;
        for (int k = 0; k <= 50; ++k) {
            const double t = k / 50.0;
            const Point p{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
            // Rounding of t moves a point by less than 1e-14.
            if (part && t >= part->from && t <= part->to)
                EXPECT_TRUE(inside(p, 1e-14));
            else
                EXPECT_FALSE(inside(p, -1e-14));
        }
    }
    EXPECT_GT(cut, 200);
}

}  // namespace
}  // namespace versorium
