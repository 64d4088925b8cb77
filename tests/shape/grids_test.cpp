// SPDX-License-Identifier: MIT
// Polygons, pictures and the sampling of grids.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/random.h"
#include "shape/distance.h"
#include "shape/grid_sampling.h"
#include "shape/image_distance.h"
#include "shape/polygon.h"

namespace versorium {
namespace {

constexpr double kRounding = 1e-14;  // values of order 1 after a few dozen operations

Grid polygonGrid(const Polygon& polygon, const PolygonDistanceOptions& options, int threads = 1) {
    Job job(threads);
    Expected<Grid> grid = polygonDistance(polygon, options, job);
    EXPECT_TRUE(grid.ok()) << grid.status().message();
    return std::move(*grid);
}

std::vector<glm::dvec2> starRing(int points, double outer, double inner) {
    std::vector<glm::dvec2> ring;
    for (int k = 0; k < 2 * points; ++k) {
        const double angle = M_PI / 2 + k * M_PI / points, radius = k % 2 == 0 ? outer : inner;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return ring;
}

double xAt(const Grid& grid, int i) {
    return grid.minimum.x + (grid.maximum.x - grid.minimum.x) * i / (grid.resolution.x - 1);
}
double yAt(const Grid& grid, int j) {
    return grid.minimum.y + (grid.maximum.y - grid.minimum.y) * j / (grid.resolution.y - 1);
}

// Two methods that share nothing: sides searched in a tree, and the folded closed form.
TEST(Polygon, AStarAgreesWithItsClosedForm) {
    const ShapeTree star = *parseShape("star(7, 0.45, 0.2)");
    const Grid grid = polygonGrid({{starRing(7, 0.45, 0.2)}}, {.width = 61, .height = 53});
    for (int j = 0; j < 53; ++j)
        for (int i = 0; i < 61; ++i)
            EXPECT_NEAR(grid.at(i, j), distance(star, xAt(grid, i), yAt(grid, j), 0.0), kRounding);
}

TEST(Polygon, RulesDifferWhereRingsOverlap) {
    const auto square = [](double half) {
        return std::vector<glm::dvec2>{{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    };
    const Polygon nested{{square(0.4), square(0.2)}};
    const Grid evenOdd = polygonGrid(nested, {.rule = FillRule::evenOdd, .width = 5, .height = 5});
    const Grid nonzero = polygonGrid(nested, {.rule = FillRule::nonzero, .width = 5, .height = 5});
    EXPECT_NEAR(evenOdd.at(2, 2), 0.2, kRounding);
    EXPECT_NEAR(nonzero.at(2, 2), -0.2, kRounding);
    EXPECT_NEAR(evenOdd.at(0, 0), std::hypot(0.1, 0.1), kRounding);
    // A hole whose sides run the other way is a hole by both rules.
    Polygon hole = nested;
    std::swap(hole.rings[1][1], hole.rings[1][3]);
    EXPECT_NEAR(polygonGrid(hole, {.rule = FillRule::nonzero, .width = 5, .height = 5}).at(2, 2),
                0.2, kRounding);
}

TEST(Polygon, DoesNotDependOnThreads) {
    const Polygon polygon{{starRing(31, 0.45, 0.3)}};
    EXPECT_EQ(polygonGrid(polygon, {}, 1).values, polygonGrid(polygon, {}, 3).values);
}

TEST(Polygon, RefusesWhatHasNoSides) {
    Job job(1);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(polygonDistance({}, {}, job).ok());
    EXPECT_FALSE(polygonDistance({{{{0, 0}}}}, {}, job).ok());
    EXPECT_FALSE(polygonDistance({{{{0, 0}, {1, nan}, {1, 1}}}}, {}, job).ok());
    EXPECT_FALSE(polygonDistance({{starRing(5, 1, 1)}}, {.width = 1000000000}, job).ok());
    EXPECT_FALSE(polygonDistance({{starRing(5, 1, 1)}}, {.minimum = {1, 1}}, job).ok());
}

Raster<unsigned char> randomMask(int width, int height, double share, std::uint64_t seed) {
    Random random(seed);
    Raster<unsigned char> mask({width, height}, 1);
    for (unsigned char& value : mask.values()) value = random.uniform() < share ? 1 : 0;
    mask.at(0, 0) = 0;
    mask.at(1, 0) = 1;
    return mask;
}

// Every pixel against every other.
TEST(ImageDistance, EqualsBruteForce) {
    for (double share : {0.01, 0.5, 0.99}) {
        const Raster<unsigned char> mask = randomMask(37, 23, share, 8);
        Job job(2);
        const Expected<Grid> grid = imageDistance(mask, job);
        ASSERT_TRUE(grid.ok());
        for (int y = 0; y < 23; ++y)
            for (int x = 0; x < 37; ++x) {
                double best = std::numeric_limits<double>::infinity();
                const bool inside = mask.at(x, y) != 0;
                for (int v = 0; v < 23; ++v)
                    for (int u = 0; u < 37; ++u)
                        if ((mask.at(u, v) != 0) != inside)
                            best = std::min(best, std::hypot(u - x, v - y));
                const double expected = (inside ? -1 : 1) * (best - 0.5) / 37;
                EXPECT_NEAR(grid->at(x, 22 - y), expected, kRounding);
            }
    }
}

// An upright edge is met exactly, half a pixel from the centres on both sides.
TEST(ImageDistance, StraightEdgesAreExact) {
    Raster<unsigned char> mask({40, 20}, 1);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 12; ++x) mask.at(x, y) = 255;
    Job job(1);
    const Expected<Grid> grid = imageDistance(mask, job);
    ASSERT_TRUE(grid.ok());
    // The edge is at pixel coordinate 12 of 40, that is -0.2.
    for (int x = 0; x < 40; ++x) EXPECT_NEAR(grid->at(x, 7), xAt(*grid, x) + 0.2, kRounding) << x;
    EXPECT_NEAR(grid->minimum.y, -0.25 + 0.5 / 40, kRounding);
}

TEST(ImageDistance, ADiscIsRightToOnePixel) {
    Raster<unsigned char> mask({100, 100}, 1);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x)
            mask.at(x, y) = std::hypot(x + 0.5 - 50, y + 0.5 - 50) < 30 ? 1 : 0;
    Job job(1);
    const Expected<Grid> grid = imageDistance(mask, job);
    ASSERT_TRUE(grid.ok());
    // The nearest centre of the other kind is up to √2/2 beyond the circle, of which 1/2 is taken
    // off, and on the near side at most 1/2 is taken off too much.
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x)
            EXPECT_NEAR(grid->at(x, y), std::hypot(xAt(*grid, x), yAt(*grid, y)) - 0.3, 0.0072);
}

TEST(ImageDistance, RefusesAPictureWithoutBoundary) {
    Job job(1);
    EXPECT_FALSE(imageDistance(Raster<unsigned char>({8, 8}, 1, 0), job).ok());
    EXPECT_FALSE(imageDistance(Raster<unsigned char>({8, 8}, 1, 1), job).ok());
    EXPECT_FALSE(imageDistance(Raster<unsigned char>(), job).ok());
    EXPECT_FALSE(imageDistance(Raster<unsigned char>({1, 8}, 1, 1), job).ok());
}

using sampling::GridSample;
using sampling::gridValue;
using sampling::sampleGrid;

Grid randomGrid(glm::ivec3 resolution) {
    Random random(21);
    Grid grid;
    grid.resolution = resolution;
    grid.minimum = {-1, 0, 2};
    grid.maximum = {2, 1, resolution.z == 1 ? 2.0 : 3.0};
    grid.values.resize(static_cast<std::size_t>(resolution.x * resolution.y * resolution.z));
    for (double& value : grid.values) value = random.uniform(-1, 1);
    return grid;
}

TEST(GridSampling, MeetsTheNodes) {
    const Grid grid = randomGrid({4, 3, 5});
    for (int z = 0; z < 5; ++z)
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 4; ++x)
                EXPECT_NEAR(gridValue(grid, Outside::border, -1.0 + x, y / 2.0, 2 + z / 4.0),
                            grid.at(x, y, z), kRounding);
}

// Trilinear interpolation reproduces a + bx + cy + dz + exy + … + hxyz, and its gradient.
TEST(GridSampling, ReproducesTrilinearFunctions) {
    const auto f = [](double x, double y, double z) {
        return 1 + 2 * x - y + 0.5 * z + x * y - 3 * y * z + x * z + 2 * x * y * z;
    };
    Grid grid = randomGrid({4, 3, 5});
    for (int z = 0; z < 5; ++z)
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 4; ++x) grid.at(x, y, z) = f(-1.0 + x, y / 2.0, 2 + z / 4.0);
    Random random(2);
    for (int i = 0; i < 300; ++i) {
        const double x = random.uniform(-1, 2), y = random.uniform(0, 1), z = random.uniform(2, 3);
        const GridSample<double> s = sampleGrid(grid, Outside::distance, x, y, z);
        // Values up to 40, slopes multiplied by up to 4 nodes.
        EXPECT_NEAR(s.value, f(x, y, z), 1e-12);
        EXPECT_NEAR(s.dx, 2 + y + z + 2 * y * z, 1e-12);
        EXPECT_NEAR(s.dy, -1 + x - 3 * z + 2 * x * z, 1e-12);
        EXPECT_NEAR(s.dz, 0.5 - 3 * y + x + 2 * x * y, 1e-12);
    }
}

TEST(GridSampling, ValueAndGradientAgree) {
    for (const glm::ivec3 resolution : {glm::ivec3(4, 3, 5), glm::ivec3(6, 4, 1)}) {
        const Grid grid = randomGrid(resolution);
        Random random(6);
        for (int i = 0; i < 500; ++i) {
            const double p[3] = {random.uniform(-2, 3), random.uniform(-1, 2),
                                 random.uniform(1, 4)};
            for (const Outside outside : {Outside::border, Outside::distance}) {
                const auto at = [&](int axis, double step) {
                    double q[3] = {p[0], p[1], p[2]};
                    q[axis] += step;
                    return gridValue(grid, outside, q[0], q[1], q[2]);
                };
                const GridSample<double> s = sampleGrid(grid, outside, p[0], p[1], p[2]);
                EXPECT_EQ(s.value, at(0, 0));
                const double gradient[3] = {s.dx, s.dy, s.dz};
                for (int axis = 0; axis < 3; ++axis) {
                    const double step = 1e-7;
                    const double slope = (at(axis, step) - at(axis, -step)) / (2 * step);
                    // Rounding 1e-16/1e-7; the curvature outside, where no face is crossed (one in
                    // 10⁵ points may), is of order 1.
                    EXPECT_NEAR(gradient[axis], slope, 1e-6);
                }
            }
        }
    }
}

// Lanes take the same operations as scalars, so no tolerance is owed; duals carry the gradient.
TEST(GridSampling, LanesAndDualsAgreeWithScalars) {
    for (const glm::ivec3 resolution : {glm::ivec3(4, 3, 5), glm::ivec3(6, 4, 1)}) {
        const Grid grid = randomGrid(resolution);
        Random random(7);
        for (const Outside outside : {Outside::border, Outside::distance})
            for (int i = 0; i < 100; ++i) {
                Lanes<double> x, y, z;
                for (int k = 0; k < kLaneCount<Lanes<double>>; ++k) {
                    setLane(x, k, random.uniform(-2, 3));
                    setLane(y, k, random.uniform(-1, 2));
                    setLane(z, k, random.uniform(1, 4));
                }
                const auto all = sampleGrid(grid, outside, x, y, z);
                for (int k = 0; k < kLaneCount<Lanes<double>>; ++k) {
                    const double p[3] = {lane(x, k), lane(y, k), lane(z, k)};
                    const auto one = sampleGrid(grid, outside, p[0], p[1], p[2]);
                    EXPECT_EQ(one.value, lane(all.value, k));
                    EXPECT_EQ(one.dx, lane(all.dx, k));
                    const Dual<double> dual =
                        gridValue(grid, outside, Dual<double>(p[0], 0.0), Dual<double>(p[1], 1.0),
                                  Dual<double>(p[2], 0.0));
                    EXPECT_EQ(dual.value, one.value);
                    EXPECT_EQ(dual.slope, one.dy);
                }
            }
    }
}

TEST(GridSampling, OutsideIsTheBorderOrTheDistanceToIt) {
    const Grid grid = randomGrid({4, 3, 5});
    EXPECT_EQ(gridValue(grid, Outside::border, -4.0, 5.0, 2.0), grid.at(0, 2, 0));
    EXPECT_EQ(gridValue(grid, Outside::distance, -4.0, 5.0, 2.0), grid.at(0, 2, 0) + 5);
    const Grid plane = randomGrid({4, 3, 1});
    EXPECT_EQ(gridValue(plane, Outside::distance, 2.0, 1.0, 77.0), plane.at(3, 2));
    EXPECT_NEAR(gridValue(grid, Outside::border, 0.3F, 0.4F, 2.6F),
                gridValue(grid, Outside::border, 0.3, 0.4, 2.6), 1e-5);  // float's digits
}

TEST(GridSampling, OddNumbersStayInBounds) {
    const Grid grid = randomGrid({4, 3, 5});
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(gridValue(grid, Outside::border, infinity, -infinity, 1e308), grid.at(3, 0, 4));
    EXPECT_EQ(gridValue(grid, Outside::border, nan, nan, nan), grid.at(0, 0, 0));
    EXPECT_EQ(gridValue(grid, Outside::distance, infinity, 0.0, 2.0), infinity);
}

}  // namespace
}  // namespace versorium
