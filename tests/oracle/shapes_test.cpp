// SPDX-License-Identifier: MIT
// Grids and the two simplest solids against the oracle.
#include <gtest/gtest.h>

#include "oracle/cases.h"

namespace versorium {
namespace {

// Values of order 1 after a few dozen operations.
constexpr double kTolerance = 1e-14;

TEST(OracleShapes, TrilinearLookUp) {
    Random random(51);
    for (const glm::ivec3 resolution :
         {glm::ivec3(5, 4, 3), glm::ivec3(2, 2, 2), glm::ivec3(6, 5, 1), glm::ivec3(1, 3, 1)}) {
        Grid grid;
        grid.resolution = resolution;
        grid.minimum = {-0.5, -0.25, 0.125};
        grid.maximum = {0.75, 0.5, resolution.z == 1 ? 0.125 : 1.0};
        grid.values.resize(static_cast<std::size_t>(resolution.x * resolution.y * resolution.z));
        for (double& value : grid.values) value = random.uniform(-1, 1);
        oracle::GridTable table{{resolution.x, resolution.y, resolution.z}, {}, {}, grid.values};
        for (int k = 0; k < 3; ++k)
            table.minimum[k] = grid.minimum[k], table.maximum[k] = grid.maximum[k];
        const auto shared = std::make_shared<const Grid>(grid);
        for (const Outside outside : {Outside::border, Outside::distance}) {
            const DistanceField field(shared, outside);
            for (int i = 0; i < 300; ++i) {
                const double p[3] = {random.uniform(-1, 1.5), random.uniform(-1, 1),
                                     random.uniform(-0.5, 1.5)};
                const oracle::Real q[3] = {p[0], p[1], p[2]};
                EXPECT_NEAR(
                    field.at(p[0], p[1], p[2]),
                    static_cast<double>(oracle::trilinear(table, q, outside == Outside::distance)),
                    kTolerance);
            }
        }
    }
}

TEST(OracleShapes, SphereAndBox) {
    Random random(52);
    const DistanceField ball(*parseShape("sphere(0.4)"));
    const DistanceField block(*parseShape("translate(0.1, -0.2, 0.05, box(0.3, 0.2, 0.1))"));
    const DistanceField disc(*parseShape("disc(0.3)"));
    for (int i = 0; i < 500; ++i) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1),
                     z = random.uniform(-1, 1);
        EXPECT_NEAR(ball.at(x, y, z), static_cast<double>(oracle::sphere(x, y, z, 0.4L)),
                    kTolerance);
        EXPECT_NEAR(
            block.at(x, y, z),
            static_cast<double>(oracle::box(x - 0.1L, y + 0.2L, z - 0.05L, 0.3L, 0.2L, 0.1L)),
            kTolerance);
        EXPECT_NEAR(disc.at(x, y, z), static_cast<double>(oracle::sphere(x, y, 0, 0.3L)),
                    kTolerance);
    }
}

}  // namespace
}  // namespace versorium
