// SPDX-License-Identifier: MIT
// Truths about planar systems and their bifurcation sets, over whole pictures.
#include <gtest/gtest.h>

#include <cmath>

#include "colour/rules.h"
#include "fields/programs.h"

namespace versorium {
namespace {

// Fields at the centres of the pixels of a rectangle, row after row from the top.
std::vector<std::vector<double>> picture(const OrbitProgram& program, double left, double right,
                                         double bottom, double top, int width, int height,
                                         std::vector<FieldName> fields) {
    std::vector<std::vector<double>> all(fields.size());
    for (int row = 0; row < height; ++row) {
        std::vector<double> u, v;
        for (int column = 0; column < width; ++column) {
            u.push_back(left + (right - left) * (column + 0.5) / width);
            v.push_back(top - (top - bottom) * (row + 0.5) / height);
        }
        const double* coordinates[3] = {u.data(), v.data(), nullptr};
        const auto values = evaluateFields(program, width, coordinates, fields);
        for (std::size_t k = 0; k < fields.size(); ++k)
            all[k].insert(all[k].end(), values[k].begin(), values[k].end());
    }
    return all;
}

OrbitProgram planarMandelbrot(int iterations) {
    return programOf("planar", {}, {{"g.d"}, {"h.d"}}, iterations, 2);
}
OrbitProgram henon(int iterations) {
    return programOf("planar",
                     {{"g.a2", -1.4},
                      {"g.b1", 1},
                      {"g.b2", 0},
                      {"g.d", 1},
                      {"h.a1", 0.3},
                      {"h.c1", 0},
                      {"h.d", 0}},
                     {{"p.x"}, {"p.y"}}, iterations, 100);
}

// A eq 7: the same set, but for the order of the operations, which chaos makes visible at the
// boundary.
TEST(PlanarQuadratic, BifurcationSetIsTheMandelbrotSet) {
    const int width = 480, height = 400, iterations = 500;
    const auto planar = picture(planarMandelbrot(iterations), -2.2, 0.7, -1.2, 1.2, width, height,
                                {FieldName::membership, FieldName::escapeStep});
    const auto complex =
        picture(programOf("quadratic", {}, {{"c.re"}, {"c.im"}}, iterations, 2), -2.2, 0.7, -1.2,
                1.2, width, height, {FieldName::membership, FieldName::escapeStep});
    int members = 0, steps = 0;
    for (std::size_t i = 0; i < planar[0].size(); ++i) {
        members += planar[0][i] != complex[0][i];
        steps += planar[1][i] != complex[1][i];
    }
    EXPECT_LE(members, width * height / 1000);
    EXPECT_LE(steps, width * height / 1000);
}

// 1.50659 (counted by several authors on grids of up to 10¹² points). What N steps do not tell from
// the set has an area of about 3.7/N. A grid of cells of area h² is off by the halves of the cells
// at the boundary, whose signs are independent: h² √n, and three times that is not exceeded.
TEST(PlanarQuadratic, BifurcationSetHasTheAreaOfTheMandelbrotSet) {
    const int iterations = 10000, width = 1500, height = 690;
    const double h = 2.5 / width;  // 690 h = 1.15
    // The upper half: the set is symmetric.
    const auto members = picture(planarMandelbrot(iterations), -2, 0.5, 0, height * h, width,
                                 height, {FieldName::membership})[0];
    int count = 0, boundary = 0;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const auto at = static_cast<std::size_t>(row * width + column);
            count += members[at] == 1;
            boundary += column > 0 && members[at] != members[at - 1];
            boundary += row > 0 && members[at] != members[at - static_cast<std::size_t>(width)];
        }
    const double grid = 2 * h * h * 3 * std::sqrt(boundary);
    EXPECT_LT(grid, 0.002);
    EXPECT_NEAR(2 * count * h * h, 1.5066, 3.7 / iterations + grid);
}

// The attracted region, against the formula as it stands in textbooks.
TEST(Henon, AttractedRegionIsThatOfAPlainLoop) {
    const int size = 300, iterations = 200;
    const auto members =
        picture(henon(iterations), -2.5, 2.5, -2.5, 2.5, size, size, {FieldName::membership})[0];
    int different = 0, inside = 0;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            double x = -2.5 + 5.0 * (column + 0.5) / size, y = 2.5 - 5.0 * (row + 0.5) / size;
            bool bounded = true;
            for (int n = 0; n < iterations && bounded; ++n) {
                const double next = 1 - 1.4 * x * x + y;
                y = 0.3 * x;
                x = next;
                bounded = x * x + y * y <= 100 * 100;
            }
            inside += bounded;
            different += bounded != (members[static_cast<std::size_t>(row * size + column)] == 1);
        }
    EXPECT_GT(inside, size * size / 10);
    EXPECT_LT(inside, size * size * 9 / 10);
    // One pixel in a thousand: boundary points whose orbits rounding decides.
    EXPECT_LE(different, size * size / 1000);
}

// A eq 15 as printed takes a power of a negative number where n + β/‖p_n‖ exceeds N.
TEST(Gradient, AsPrintedIsUndefinedWhereOursIsNot) {
    const int size = 120, iterations = 12;
    const double squared = 16, exponent = 0.7;
    OrbitProgram program =
        programOf("planar", {{"g.d", -0.7269}, {"h.d", 0.1889}}, {{"p.x"}, {"p.y"}}, iterations, 4);
    const auto fields =
        picture(program, -1.6, 1.6, -1.6, 1.6, size, size,
                {FieldName::membership, FieldName::escapeStep, FieldName::squaredNorm});
    Gradient gradient;
    gradient.start = {0.9, 0.8, 0.6, 1};
    gradient.finish = {0, 0, 0, 1};
    gradient.exponent = exponent;
    int undefined = 0, escaped = 0;
    for (std::size_t i = 0; i < fields[0].size(); ++i) {
        if (fields[0][i] == 1) continue;
        ++escaped;
        const double n = fields[1][i], norm = fields[2][i];
        const double printed =
            std::pow(gradient.start.r -
                         (n + squared / norm) / iterations * (gradient.start.r - gradient.finish.r),
                     exponent);
        undefined += std::isnan(printed);
        const Colour ours = smoothedColour(gradient, n, norm, squared, iterations);
        ASSERT_TRUE(ours.r >= 0 && ours.r <= 1 && ours.g >= 0 && ours.g <= 1 && ours.b >= 0 &&
                    ours.b <= 1);
        // Where the printed one is defined they agree: up to the conversion to linear light.
        if (!std::isnan(printed)) {
            EXPECT_NEAR(displayFromColour(ours).r, printed, 1e-6);
        }
    }
    EXPECT_GT(escaped, 1000);
    EXPECT_GT(undefined, 10);
}

}  // namespace
}  // namespace versorium
