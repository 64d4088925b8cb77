// SPDX-License-Identifier: MIT
// What the shape modulus f = r̂ d, r̂ = e^{α(φ - β)}, makes true whatever d is (S section 3).
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "fields/ensemble.h"
#include "render/cpu/cpu_renderer.h"
#include "render/shape_profile.h"

namespace versorium {
namespace {

Scene shapeScene(const char* map, const char* shape, double alpha, double beta) {
    Scene scene = sceneOf(*findMap(map));
    scene.shape.source = shape;
    scene.parameters["alpha"] = {alpha};
    scene.parameters["beta"] = {beta};
    return scene;
}

std::vector<double> at(const Scene& scene, const std::vector<std::vector<double>>& points,
                       FieldName field) {
    CpuRenderer renderer;
    Job job(1);
    std::vector<std::vector<double>> rows;
    const Status status = renderer.measureAt(scene, points, {field}, {}, job, rows);
    EXPECT_TRUE(status.ok()) << status.message();
    std::vector<double> values;
    for (const auto& row : rows) values.push_back(row[0]);
    return values;
}

std::vector<std::vector<double>> randomPoints(int count, int dimension, double reach) {
    Random random(11);
    std::vector<std::vector<double>> points;
    for (int i = 0; i < count; ++i) {
        points.emplace_back();
        for (int k = 0; k < dimension; ++k) points.back().push_back(random.uniform(-reach, reach));
    }
    return points;
}

struct Case {
    const char *map, *shape;
    int dimension;
};
constexpr Case kCases[] = {
    {"shape-modulus-complex-rational", "star(5, 1.2, 0.6)", 2},
    {"shape-modulus", "union(sphere(0.6), translate(0.4, 0.2, 0, box(0.3, 0.2, 0.4)))", 3},
};

TEST(ShapeModulusTruths, TheModulusIsThatOfTheDistance) {
    for (const Case& one : kCases) {
        const ShapeTree shape = *parseShape(one.shape);
        const Scene scene = shapeScene(one.map, one.shape, 6, 0.05);
        const auto points = randomPoints(300, one.dimension, 1.5);
        const auto modulus = at(scene, points, FieldName::imageModulus);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double z = one.dimension == 3 ? points[i][2] : 0;
            const double expected =
                std::exp(6 * (distance(shape, points[i][0], points[i][1], z) - 0.05));
            // One exponential, one root and one quotient.
            EXPECT_NEAR(modulus[i], expected, 1e-13 * expected) << one.map;
        }
    }
}

// The orbit's own points: log|f_n| follows from φ at the point before.
TEST(ShapeModulusTruths, EveryLogModulusFollowsFromThePointBefore) {
    for (const Case& one : kCases) {
        const ShapeTree shape = *parseShape(one.shape);
        Scene scene = shapeScene(one.map, one.shape, 6, 0.05);
        CpuRenderer renderer;
        Job job(1);
        int steps = 0;
        for (const auto& point : randomPoints(100, one.dimension, 0.9)) {
            for (std::size_t k = 0; k < point.size(); ++k) scene.start[k] = point[k];
            OrbitProgram program = *renderer.binder().bind(scene, job);
            for (std::size_t k = 0; k < scene.start.size(); ++k)
                program.slice.origin[k] = scene.start[k];
            for (auto& axis : program.slice.axes) std::fill(axis.begin(), axis.end(), 0.0);
            const double origin[3] = {};
            const auto orbit = orbitOf(program, origin, 6);
            for (std::size_t n = 1; n < orbit.size(); ++n) {
                double square = 0;
                for (double part : orbit[n]) square += part * part;
                const auto& before = orbit[n - 1];
                const double phi =
                    distance(shape, before[0], before[1], before.size() > 2 ? before[2] : 0.0);
                EXPECT_NEAR(0.5 * std::log(square), 6 * (phi - 0.05), 1e-12);
                ++steps;
            }
        }
        EXPECT_GT(steps, 200);
    }
}

TEST(ShapeModulusTruths, WhereTheModulusIsBelowRGrowsWithBeta) {
    const auto points = randomPoints(500, 2, 2);
    std::vector<double> before;
    for (double beta : {-0.2, -0.1, 0.0, 0.1, 0.3}) {
        const auto modulus =
            at(shapeScene("shape-modulus-complex-rational", "star(5, 1.2, 0.6)", 6, beta), points,
               FieldName::imageModulus);
        // Less everywhere: every set {r̂ <= r} only gains points.
        for (std::size_t i = 0; i < before.size(); ++i) EXPECT_LT(modulus[i], before[i]);
        before = modulus;
    }
}

// φ(0) < β: for steep α the modulus of points inside is nearly 0, and they are carried to 0's
// neighbourhood, which is inside.
TEST(ShapeModulusTruths, SteepSolidSetsTendToTheShape) {
    const char* star = "star(5, 0.45, 0.2)";
    const ShapeTree shape = *parseShape(star);
    const auto points = randomPoints(3000, 2, 0.6);
    double before = 1;
    for (double alpha : {25.0, 100.0, 400.0, 3200.0}) {
        const auto solid = at(shapeScene("shape-modulus-complex-rational", star, alpha, 0.02),
                              points, FieldName::solid);
        double wrong = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
            wrong += (solid[i] != 0) != (distance(shape, points[i][0], points[i][1], 0.0) < 0.02);
        wrong /= static_cast<double>(points.size());
        EXPECT_LE(wrong, before + 0.002) << alpha;
        before = wrong;
    }
    // Points within log(20)/3200 of the surface may still go either way.
    EXPECT_LT(before, 0.01);
}

// d(x) = x/|x| keeps every ray, on which f is r -> e^{α(φ(r u) - β)}.
TEST(ShapeModulusTruths, WithTheIdentityAsDirectionTheRadialMapDecides) {
    for (const Case& one : kCases) {
        const ShapeTree shape = *parseShape(one.shape);
        Scene scene = shapeScene(one.map, one.shape, 6, 0.05);
        scene.lists["roots"] = {{{{0, 0, 0, 0}, 1}}, 1};
        scene.iterations = 12;
        const auto points = randomPoints(800, one.dimension, one.dimension == 3 ? 0.7 : 1.4);
        const auto member = at(scene, points, FieldName::membership);
        int inside = 0, differ = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            double u[3] = {points[i][0], points[i][1], one.dimension == 3 ? points[i][2] : 0};
            double r = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
            for (double& part : u) part /= r;
            bool stays = true;
            for (int n = 0; n < scene.iterations && stays; ++n) {
                r = std::exp(6 * (distance(shape, r * u[0], r * u[1], r * u[2]) - 0.05));
                stays = r <= 20;
            }
            inside += stays;
            differ += stays != (member[i] != 0);
        }
        // Only points within rounding of a repelling radius could differ.
        EXPECT_EQ(differ, 0) << one.map;
        EXPECT_GT(inside, 50);
        EXPECT_LT(inside, 750);
    }
}

// Below the radius of certain capture every d keeps the orbit, beyond that of certain escape none.
TEST(ShapeModulusTruths, CertainRadiiHoldForEveryDirection) {
    Scene scene = shapeScene("shape-modulus-complex-rational", "star(5, 1.2, 0.6)", 8, 0);
    scene.iterations = 200;
    scene.ensemble.count = 20;
    scene.ensemble.roots.emplace();
    Binder binder;
    Job job(1);
    const Expected<RadialProfile> profile = shapeProfile(binder, scene, 0, 513, job);
    ASSERT_TRUE(profile.ok());
    EXPECT_GT(profile->capture, 0.3);
    EXPECT_LT(profile->escape, 1.4);
    std::vector<std::vector<double>> captured, escaping;
    for (int k = 0; k < 100; ++k) {
        const double angle = 2 * M_PI * k / 100;
        captured.push_back({profile->capture * std::cos(angle) * 0.999999,
                            profile->capture * std::sin(angle) * 0.999999});
        escaping.push_back({profile->escape * std::cos(angle) * 1.000001,
                            profile->escape * std::sin(angle) * 1.000001});
    }
    for (double mean : at(scene, captured, FieldName::meanMembership)) EXPECT_EQ(mean, 1);
    for (double mean : at(scene, escaping, FieldName::meanMembership)) EXPECT_EQ(mean, 0);
    EXPECT_EQ(shapeProfile(binder, sceneOf(*findMap("quadratic")), 0, 65, job).status().kind(),
              ErrorKind::usage);
}

}  // namespace
}  // namespace versorium
