// SPDX-License-Identifier: MIT
// Manifolds of saddles: invariant, through the saddle, and where known, the curve itself.
#include "dynamics/manifolds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/programs.h"

namespace versorium {
namespace {

OrbitProgram planar(std::vector<std::pair<std::string, double>> values) {
    std::vector<std::pair<std::string, double>> all = {
        {"g.a2", 0}, {"g.b2", 0}, {"g.d", 0}, {"h.c1", 0}, {"h.d", 0}};
    all.insert(all.end(), values.begin(), values.end());
    return programOf("planar", all, {}, 100, 100);
}
OrbitProgram henon(double a, double b) {
    return planar({{"g.d", 1}, {"g.a2", -a}, {"g.b1", 1}, {"h.a1", b}});
}

PeriodicCycle saddleOf(const System& system, int period, int index, const Window& window = {}) {
    Job job(1);
    const auto found = findCycles(system, window, {.maxPeriod = period}, job);
    EXPECT_TRUE(found.ok());
    for (const PeriodicCycle& cycle : found->cycles)
        if (cycle.period == period && cycle.kind == CycleKind::saddle && index-- == 0) return cycle;
    ADD_FAILURE() << "there is no such saddle";
    return {};
}
SaddleManifolds manifolds(const System& system, const PeriodicCycle& saddle, const Window& window,
                          const ManifoldOptions& options = {}) {
    Job job(1);
    auto made = manifoldsOf(system, saddle, window, options, job);
    EXPECT_TRUE(made.ok()) << made.status().message();
    return made.ok() ? *made : SaddleManifolds{};
}
double toSegment(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
    const double x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
    double t = square > 0 ? ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / square : 0;
    t = std::min(1.0, std::max(0.0, t));
    return std::hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y);
}
double toCurves(const PlanePoint& p, const std::vector<Polyline>& curves) {
    double least = HUGE_VAL;
    for (const Polyline& line : curves)
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            least = std::min(least, toSegment(p, line[i], line[i + 1]));
    return least;
}
std::size_t pointsOf(const Manifold& manifold) {
    std::size_t count = 0;
    for (const Polyline& line : manifold.curves) count += line.size();
    return count;
}

// (x/2, 2y - c x²) has the stable manifold y = c x²/(2 - ¼) and the unstable one x = 0.
TEST(Manifolds, OfAMapInClosedForm) {
    const double c = 1.75;
    const System system(planar({{"g.a1", 0.5}, {"h.b1", 2}, {"h.a2", -c}}));
    const Window window{-1, 1, -1, 1};
    const SaddleManifolds both = manifolds(system, saddleOf(system, 1, 0), window);
    for (const Polyline& line : both.unstable.curves)
        for (const PlanePoint& p : line) EXPECT_NEAR(p[0], 0, 1e-9);
    ASSERT_TRUE(both.stable.has_value());
    double left = 0, right = 0, top = 0;
    // The seed lies on the tangent, off the curve by (2e-6)² · c/1.75, which the inverse shrinks;
    // the ends are cut where a chord of length 2/500 leaves the window.
    for (const Polyline& line : both.stable->curves)
        for (const PlanePoint& p : line) {
            EXPECT_NEAR(p[1], c * p[0] * p[0] / 1.75, p[1] < 1 && std::abs(p[0]) < 1 ? 1e-9 : 1e-4);
            left = std::min(left, p[0]), right = std::max(right, p[0]);
            top = std::max(top, p[1]);
        }
    // They reach the borders of the window.
    EXPECT_NEAR(left, -1, 1e-4);
    EXPECT_NEAR(right, 1, 1e-4);
    double low = 1, high = -1;
    for (const Polyline& line : both.unstable.curves)
        for (const PlanePoint& p : line) low = std::min(low, p[1]), high = std::max(high, p[1]);
    EXPECT_EQ(low, -1);
    EXPECT_EQ(high, 1);
}

// Images of points of either manifold lie on it again; a polygon with a side of 1/500 is off a
// curve of curvature κ by κ/8 of its square.
TEST(Manifolds, OfHenonsMapAreInvariant) {
    const System system(henon(1.4, 0.3));
    const Window window{-2, 2, -2, 2};
    const PeriodicCycle saddle = saddleOf(system, 1, 1);
    ASSERT_NEAR(saddle.points[0][0], 0.631354, 1e-6);
    ManifoldOptions options;
    options.length = 12;
    const SaddleManifolds both = manifolds(system, saddle, window, options);
    ASSERT_TRUE(both.stable.has_value());
    EXPECT_GT(pointsOf(both.unstable), 2000u);
    EXPECT_GT(pointsOf(*both.stable), 1000u);
    EXPECT_LT(toCurves(saddle.points[0], both.unstable.curves), 1e-9);
    EXPECT_LT(toCurves(saddle.points[0], both.stable->curves), 1e-9);
    // Forward images of the stable manifold come nearer to the saddle, so they are on the part that
    // has been drawn; the unstable manifold is asked about its first part.
    const double tolerance = 4.0 / 500 * 0.1;
    int checked = 0;
    for (const Polyline& line : both.stable->curves)
        for (std::size_t i = 0; i < line.size(); i += 40) {
            PlanePoint image = line[i];
            system.step(image.data());
            if (!window.contains(image[0], image[1])) continue;
            EXPECT_LT(toCurves(image, both.stable->curves), tolerance);
            ++checked;
        }
    EXPECT_GT(checked, 20);
    SaddleManifolds longer =
        manifolds(system, saddle, window, {.length = 40, .mostPoints = 300000});
    EXPECT_FALSE(longer.unstable.cut);
    checked = 0;
    for (const Polyline& line : both.unstable.curves)
        for (std::size_t i = 0; i < line.size(); i += 60) {
            PlanePoint image = line[i];
            system.step(image.data());
            EXPECT_LT(toCurves(image, longer.unstable.curves), tolerance);
            ++checked;
        }
    EXPECT_GT(checked, 40);
    // The attractor is the closure of the unstable manifold: a long orbit keeps close to it.
    PlanePoint at{0.1, 0.1};
    for (int n = 0; n < 1000; ++n) system.step(at.data());
    for (int n = 0; n < 200; ++n) {
        system.step(at.data());
        EXPECT_LT(toCurves(at, longer.unstable.curves), 0.01);
    }
    // Points of the stable manifold come to the saddle.
    for (const Polyline& line : both.stable->curves) {
        PlanePoint p = line[line.size() / 2];
        double least = HUGE_VAL;
        for (int n = 0; n < 60 && std::abs(p[0]) < 1e3; ++n) {
            system.step(p.data());
            least =
                std::min(least, std::hypot(p[0] - saddle.points[0][0], p[1] - saddle.points[0][1]));
        }
        EXPECT_LT(least, 0.02);
    }
}

TEST(Manifolds, OfACycleGoThroughAllItsPoints) {
    const System system(henon(1.4, 0.3));
    const PeriodicCycle saddle = saddleOf(system, 2, 0);
    const SaddleManifolds both = manifolds(system, saddle, {}, {.length = 3});
    for (const PlanePoint& p : saddle.points) {
        EXPECT_LT(toCurves(p, both.unstable.curves), 1e-9);
        EXPECT_LT(toCurves(p, both.stable->curves), 1e-9);
    }
}

TEST(Manifolds, AreBoundedAndClipped) {
    const System system(henon(1.4, 0.3));
    const Window window{-1, 1, -0.3, 0.3};
    const SaddleManifolds both =
        manifolds(system, saddleOf(system, 1, 1), window, {.length = 1000, .mostPoints = 500});
    EXPECT_TRUE(both.unstable.cut);
    EXPECT_LT(pointsOf(both.unstable), 1500u);
    for (const Manifold* manifold : {&both.unstable, &*both.stable})
        for (const Polyline& line : manifold->curves)
            for (const PlanePoint& p : line) EXPECT_TRUE(window.grown(1e-12).contains(p[0], p[1]));
}

// A folding map has no inverse; a cycle that is no saddle has no manifolds that are curves.
TEST(Manifolds, SayWhyThereAreNone) {
    const System fold(planar({{"g.a2", 1}, {"g.a1", 2}, {"h.b1", 0.5}}));
    const SaddleManifolds both = manifolds(fold, saddleOf(fold, 1, 0), {-2, 2, -2, 2});
    EXPECT_FALSE(both.stable.has_value());
    EXPECT_NE(both.whyNoStable.find("det J"), std::string::npos);
    EXPECT_FALSE(both.unstable.curves.empty());
    Job job(1);
    PeriodicCycle attracting;
    attracting.kind = CycleKind::attracting;
    EXPECT_EQ(manifoldsOf(fold, attracting, {}, {}, job).status().kind(), ErrorKind::usage);
}

}  // namespace
}  // namespace versorium
