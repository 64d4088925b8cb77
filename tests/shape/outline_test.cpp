// SPDX-License-Identifier: MIT
#include "shape/outline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shape/field.h"
#include "shape/tree.h"

namespace versorium {
namespace {

TEST(Outline, ItsTextGivesItsCorners) {
    const Expected<std::vector<glm::dvec2>> corners = parseOutline(" polygon(0, 0, 1,0, 0.5, 2) ");
    ASSERT_TRUE(corners) << corners.status().message();
    ASSERT_EQ(corners->size(), 3u);
    EXPECT_EQ((*corners)[2], glm::dvec2(0.5, 2));
    const Expected<std::vector<glm::dvec2>> again = parseOutline(printOutline(*corners));
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, *corners);
}

TEST(Outline, SaysWhatIsWrongWithIt) {
    for (const auto& [text, said] : {std::pair{"polygon(0, 0, 1, 1, 2, 2)", "one line"},
                                     {"polygon(0, 0, 1, 1)", "3 to"},
                                     {"polygon(0, 0, 1, 1, 2)", "x and y"},
                                     {"polygon(0, 0, 1, 1, 2, x)", "numbers"},
                                     {"polygon(0, 0, 1, 1, 2, 1e9)", "item 6"},
                                     {"polygon(0, 0, 1, 0, 1, 1", "bracket"},
                                     {"polygon(0, 0, 1, 0, 1, 1), disc(1)", "alone"}}) {
        const auto corners = parseOutline(text);
        ASSERT_FALSE(corners) << text;
        EXPECT_NE(corners.status().message().find(said), std::string::npos)
            << corners.status().message();
    }
}

TEST(Outline, OfASquareIsTheBox) {
    Job job(1);
    const auto corners = parseOutline("polygon(-0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5)");
    const Expected<Grid> grid = outlineDistance(*corners, 201, job);
    ASSERT_TRUE(grid);
    const DistanceField drawn(std::make_shared<const Grid>(*grid), Outside::distance);
    const DistanceField exact(*parseShape("box(0.5, 0.5)"));
    const double cell = (grid->maximum.x - grid->minimum.x) / (grid->resolution.x - 1);
    for (double x = -0.7; x < 0.7; x += 0.037)
        for (double y = -0.7; y < 0.7; y += 0.041)
            // Between nodes the distance is bent at the diagonals and around the corners, by less
            // than a quarter of a cell.
            EXPECT_NEAR(drawn.at(x, y, 0.0), exact.at(x, y, 0.0), 0.25 * cell) << x << ", " << y;
}

TEST(Outline, ThatCrossesItselfIsInsideWhereItWinds) {
    // A pentagram: its middle is wound around twice, its tips once.
    std::vector<glm::dvec2> corners;
    for (int k = 0; k < 5; ++k)
        corners.emplace_back(std::sin(k * 4 * M_PI / 5), std::cos(k * 4 * M_PI / 5));
    Job job(1);
    const Expected<Grid> grid = outlineDistance(corners, 128, job);
    ASSERT_TRUE(grid);
    const DistanceField field(std::make_shared<const Grid>(*grid), Outside::distance);
    EXPECT_LT(field.at(0.0, 0.0, 0.0), -0.2);
    EXPECT_LT(field.at(0.0, 0.8, 0.0), 0);
    EXPECT_GT(field.at(0.0, -0.8, 0.0), 0);
}

TEST(Outline, IsMovedAroundTheOriginWhereItDoesNotHoldIt) {
    Job job(1);
    const auto held = parseOutline("polygon(-1, -1, 1, -1, 0, 1)");
    EXPECT_EQ(*aroundOrigin(*held, job), *held);
    // Far away and tiny.
    const auto tiny = parseOutline("polygon(5, 5, 5.01, 5, 5.01, 5.01, 5, 5.01)");
    const auto placed = aroundOrigin(*tiny, job);
    ASSERT_TRUE(placed);
    const auto near = [](double a, double b) { return std::abs(a - b) < 0.05; };
    for (const glm::dvec2& corner : *placed) {
        EXPECT_TRUE(near(std::abs(corner.x), 0.9)) << corner.x;
        EXPECT_TRUE(near(std::abs(corner.y), 0.9)) << corner.y;
    }
}

TEST(Outline, KeepsWithinTheToleranceWithFewerCorners) {
    std::vector<glm::dvec2> circle;
    for (int k = 0; k <= 1000; ++k)
        circle.emplace_back(std::cos(k * 2 * M_PI / 1000), std::sin(k * 2 * M_PI / 1000));
    const std::vector<glm::dvec2> fewer = simplifyOutline(circle, 0.01);
    EXPECT_LT(fewer.size(), 60u);
    EXPECT_GT(fewer.size(), 10u);
    // A chord whose middle is 0.01 from the circle spans at most 2 acos(0.99).
    for (std::size_t k = 1; k < fewer.size(); ++k)
        EXPECT_LE(std::hypot(fewer[k].x - fewer[k - 1].x, fewer[k].y - fewer[k - 1].y),
                  2 * std::sin(std::acos(0.99)) + 0.02);
}

}  // namespace
}  // namespace versorium
