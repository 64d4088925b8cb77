// SPDX-License-Identifier: MIT
// Diagrams of families whose attractors are known.
#include "dynamics/bifurcation_diagram.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/programs.h"

namespace versorium {
namespace {

OrbitProgram logistic() {
    OrbitProgram program = programOf("logistic", {}, {{"r"}}, 100, 16);
    program.critical = 0;
    return program;
}
BifurcationDiagram diagramOf(const OrbitProgram& program, const DiagramOptions& options,
                             Size size) {
    Job job(2);
    BifurcationDiagram diagram(size);
    const Status status = fillDiagram(program, options, 0, size.width, job, diagram);
    EXPECT_TRUE(status.ok()) << status.message();
    return diagram;
}
std::vector<int> darkRows(const BifurcationDiagram& diagram, int column, double least) {
    std::vector<int> rows;
    for (int y = 0; y < diagram.visits.height(); ++y)
        if (diagram.visits.at(column, y) > least) rows.push_back(y);
    return rows;
}

TEST(BifurcationDiagram, OfTheLogisticFamilyShowsItsCycles) {
    const DiagramOptions options{.left = 2.4, .right = 4.1, .low = 0, .high = 1, .points = 600};
    const Size size{340, 400};
    const BifurcationDiagram diagram = diagramOf(logistic(), options, size);
    const auto columnOf = [&](double r) { return static_cast<int>((r - 2.4) / 1.7 * 340); };
    const auto parameter = [&](int column) { return 2.4 + (column + 0.5) / 340 * 1.7; };
    EXPECT_EQ(diagram.periods[static_cast<std::size_t>(columnOf(2.7))], 1);
    EXPECT_EQ(diagram.periods[static_cast<std::size_t>(columnOf(3.2))], 2);
    EXPECT_EQ(diagram.periods[static_cast<std::size_t>(columnOf(3.5))], 4);
    EXPECT_EQ(diagram.periods[static_cast<std::size_t>(columnOf(3.835))], 3);
    EXPECT_EQ(diagram.periods[static_cast<std::size_t>(columnOf(4.05))], -1);
    // One branch at 1 - 1/r.
    const int one = columnOf(2.7);
    for (int row : darkRows(diagram, one, 1))
        EXPECT_NEAR(1 - (row + 0.5) / 400, 1 - 1 / parameter(one), 1.5 / 400);
    // Two branches at (r + 1 ± √((r - 3)(r + 1))) / 2r.
    const int two = columnOf(3.3);
    const double r = parameter(two), root = std::sqrt((r - 3) * (r + 1));
    for (int row : darkRows(diagram, two, 1)) {
        const double x = 1 - (row + 0.5) / 400;
        EXPECT_LT(std::min(std::abs(x - (r + 1 + root) / (2 * r)),
                           std::abs(x - (r + 1 - root) / (2 * r))),
                  1.5 / 400);
    }
    // Every visit of a bounded orbit is somewhere in the column, and none of an escaping one.
    for (int column : {one, two, columnOf(3.5), columnOf(3.9)}) {
        double sum = 0;
        for (int y = 0; y < 400; ++y) sum += diagram.visits.at(column, y);
        EXPECT_NEAR(sum, 600, 0.01);  // in single precision
    }
    EXPECT_TRUE(darkRows(diagram, columnOf(4.05), 0).empty());
    // Curves are darker than the chaos at r = 4.
    const Raster<float> ink = inkOf(diagram, options);
    EXPECT_GT(ink.at(one, darkRows(diagram, one, 100).front()), 0.99F);
    double mean = 0;
    for (int y = 100; y < 300; ++y) mean += ink.at(columnOf(3.995), y) / 200;
    EXPECT_GT(mean, 0.2);
    EXPECT_LT(mean, 0.8);
}

TEST(BifurcationDiagram, DoesNotDependOnHowItIsFilled) {
    const DiagramOptions options{.left = 3.4, .right = 4, .transient = 300, .points = 100};
    const BifurcationDiagram whole = diagramOf(logistic(), options, {101, 60});
    BifurcationDiagram parts({101, 60});
    Job job(1);
    for (int first : {70, 0, 33})
        ASSERT_TRUE(fillDiagram(logistic(), options, first,
                                first == 70  ? 31
                                : first == 0 ? 33
                                             : 37,
                                job, parts)
                        .ok());
    EXPECT_EQ(whole.visits.values(), parts.visits.values());
    EXPECT_EQ(whole.periods, parts.periods);
}

// Hénon against its second parameter, in the plane: b = 0 is the quadratic family x² - 1.4 … .
TEST(BifurcationDiagram, OfHenonAtZeroIsTheQuadraticFamily) {
    const OrbitProgram henon = programOf(
        "planar", {{"g.b1", 0}, {"g.b2", 0}, {"g.d", 1}, {"h.a1", 0}, {"h.c1", 0}, {"h.d", 0}},
        {{"g.a2"}}, 100, 100);
    const DiagramOptions options{
        .left = -1.3, .right = -0.2, .low = -1.5, .high = 1.5, .points = 400};
    const BifurcationDiagram diagram = diagramOf(henon, options, {110, 100});
    // x -> 1 - a x²: periods 1, 2 and 4 begin at a = -1/4, 3/4 and 5/4.
    EXPECT_EQ(diagram.periods[static_cast<std::size_t>((1.3 - 0.5) * 100)], 1);
    EXPECT_EQ(diagram.periods[static_cast<std::size_t>((1.3 - 1.0) * 100)], 2);
    EXPECT_EQ(diagram.periods[static_cast<std::size_t>((1.3 - 1.28) * 100)], 4);
}

TEST(BifurcationDiagram, RefusesWhatMakesNoSense) {
    Job job(1);
    BifurcationDiagram diagram({10, 10});
    const auto kind = [&](const OrbitProgram& program, const DiagramOptions& options, int first,
                          int count) {
        return fillDiagram(program, options, first, count, job, diagram).kind();
    };
    EXPECT_EQ(kind(logistic(), {.left = 4, .right = 3}, 0, 10), ErrorKind::usage);
    EXPECT_EQ(kind(logistic(), {.component = 1}, 0, 10), ErrorKind::usage);
    EXPECT_EQ(kind(logistic(), {.points = 0}, 0, 10), ErrorKind::usage);
    EXPECT_EQ(kind(logistic(), {}, 5, 10), ErrorKind::usage);
    EXPECT_EQ(kind(programOf("logistic", {}, {{"x"}, {"r"}}, 1, 1), {}, 0, 10), ErrorKind::usage);
    job.cancel();
    EXPECT_EQ(kind(logistic(), {}, 0, 10), ErrorKind::cancelled);
}

}  // namespace
}  // namespace versorium
