// SPDX-License-Identifier: MIT
#include "geometry/triangulate.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

#include "base/random.h"

namespace versorium {
namespace {

using Plane = std::vector<std::array<double, 2>>;

struct CutPolygon {
    Mesh mesh;
    std::vector<std::uint32_t> corners;
    double polygonArea = 0;
    glm::dvec3 normal{0};
};

// Laid into the plane z = x / 2 - y / 3.
CutPolygon cutOf(const Plane& polygon, const std::vector<std::uint32_t>& corners) {
    CutPolygon result;
    for (const auto& [x, y] : polygon) result.mesh.vertices.emplace_back(x, y, x / 2 - y / 3);
    result.corners = corners;
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += glm::cross(result.mesh.vertices[corners[i]],
                          result.mesh.vertices[corners[(i + 1) % corners.size()]]) /
               2.0;
    result.polygonArea = glm::length(sum);
    result.normal = sum / result.polygonArea;
    appendPolygon(corners, result.mesh);
    return result;
}

CutPolygon cutOf(const Plane& polygon) {
    std::vector<std::uint32_t> corners(polygon.size());
    std::iota(corners.begin(), corners.end(), 0u);
    return cutOf(polygon, corners);
}

// Triangles that all face the polygon's way and have its area together do not overlap; and their
// sides are those of the polygon, and inner ones in pairs.
void expectCut(const CutPolygon& cut, const char* what) {
    ASSERT_EQ(cut.mesh.triangles.size(), cut.corners.size() - 2) << what;
    double signedArea = 0, area = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    const auto add = [&](std::uint32_t a, std::uint32_t b, int by) {
        sides[{std::min(a, b), std::max(a, b)}] += a < b ? by : -by;
    };
    for (const auto& t : cut.mesh.triangles) {
        const glm::dvec3 a = cut.mesh.vertices[t[0]];
        const double part =
            glm::dot(glm::cross(cut.mesh.vertices[t[1]] - a, cut.mesh.vertices[t[2]] - a),
                     cut.normal) /
            2;
        signedArea += part;
        area += std::abs(part);
        for (std::size_t k = 0; k < 3; ++k) add(t[k], t[(k + 1) % 3], 1);
    }
    for (std::size_t i = 0; i < cut.corners.size(); ++i)
        add(cut.corners[i], cut.corners[(i + 1) % cut.corners.size()], -1);
    // Rounding of the sums of some 20 000 areas.
    EXPECT_NEAR(signedArea, cut.polygonArea, 1e-9 * cut.polygonArea) << what;
    EXPECT_NEAR(area, cut.polygonArea, 1e-9 * cut.polygonArea) << what;
    for (const auto& side : sides) ASSERT_EQ(side.second, 0) << what;
}

Plane turned(const Plane& polygon, std::size_t by) {
    Plane result;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        result.push_back(polygon[(i + by) % polygon.size()]);
    return result;
}

TEST(Triangulate, ConcavePolygonsKeepTheirArea) {
    const std::pair<const char*, Plane> shapes[] = {
        {"C", {{4, 0}, {4, 1}, {1, 1}, {1, 3}, {4, 3}, {4, 4}, {0, 4}, {0, 0}}},
        {"arrow", {{0, 0}, {2, 1}, {0, 2}, {1, 1}}},
        {"L with corners on its sides",
         {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}}},
        {"cross",
         {{1, 0},
          {2, 0},
          {2, 1},
          {3, 1},
          {3, 2},
          {2, 2},
          {2, 3},
          {1, 3},
          {1, 2},
          {0, 2},
          {0, 1},
          {1, 1}}},
        {"zigzag",
         {{0, 0}, {1, 2}, {2, 0}, {3, 2}, {4, 0}, {4, 1}, {3, 3}, {2, 1}, {1, 3}, {0, 1}}},
    };
    for (const auto& [what, polygon] : shapes)
        for (std::size_t by = 0; by < polygon.size(); ++by) {
            const Plane from = turned(polygon, by);
            expectCut(cutOf(from), what);
            expectCut(cutOf(Plane(from.rbegin(), from.rend())), what);
        }
}

TEST(Triangulate, ConvexPolygonsAreFans) {
    Mesh mesh;
    for (int k = 0; k < 4; ++k) mesh.vertices.emplace_back(k == 1 || k == 2, k >= 2, 0);
    const std::uint32_t square[] = {0, 1, 2, 3};
    appendPolygon(square, mesh);
    const std::vector<std::array<std::uint32_t, 3>> fan{{0, 1, 2}, {0, 2, 3}};
    EXPECT_EQ(mesh.triangles, fan);
}

TEST(Triangulate, AHoleIsPartOfTheListByABridge) {
    // A square with a square hole, and with two holes that share the outer end of their bridges.
    const Plane places{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {1, 1}, {1, 2},
                       {2, 2}, {2, 1}, {4, 1}, {4, 2}, {5, 2}, {5, 1}};
    const std::vector<std::vector<std::uint32_t>> lists{
        {0, 1, 2, 3, 0, 4, 5, 6, 7, 4},
        {0, 1, 2, 3, 0, 4, 5, 6, 7, 4, 0, 8, 9, 10, 11, 8},
        // The second hole hangs on the first one.
        {0, 1, 2, 3, 0, 4, 5, 6, 7, 8, 9, 10, 11, 8, 7, 4},
        // A hole that touches the outside in a corner, and one that touches a side.
        {0, 1, 2, 3, 0, 5, 6, 7},
    };
    for (const auto& list : lists)
        for (std::size_t by = 0; by < list.size(); ++by) {
            std::vector<std::uint32_t> from(list);
            std::rotate(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(by), from.end());
            expectCut(cutOf(places, from), "hole");
        }
}

TEST(Triangulate, RandomStarsOfEverySizeKeepTheirArea) {
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const std::size_t count = 4 + random.below(200);
        Plane star;
        for (std::size_t k = 0; k < count; ++k) {
            const double angle =
                6.283185307179586 * static_cast<double>(k) / static_cast<double>(count);
            const double radius = 0.05 + random.uniform();
            star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
        expectCut(cutOf(star), "star");
    }
}

Plane comb(std::size_t teeth, double slant) {
    Plane shape;
    for (std::size_t k = 0; k < teeth; ++k) {
        const double x = static_cast<double>(k);
        shape.push_back({x + 0.25, 0});
        shape.push_back({x + 0.5 + slant, 1000});
    }
    shape.push_back({static_cast<double>(teeth), 0});
    shape.push_back({static_cast<double>(teeth), -1});
    shape.push_back({0, -1});
    return shape;
}

Plane spiral(std::size_t count) {
    Plane shape;
    for (const double width : {0.0, 0.5})
        for (std::size_t k = 0; k < count; ++k) {
            const double at = static_cast<double>(width > 0 ? count - 1 - k : k);
            const double angle = 30 * 6.283185307179586 * at / static_cast<double>(count);
            const double radius = 1 + angle / 6.283185307179586 + width;
            shape.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
    return shape;
}

TEST(Triangulate, ListsOfTwentyThousandCorners) {
    Plane gear;
    for (int k = 0; k < 20000; ++k) {
        const double angle = 6.283185307179586 * k / 20000, radius = k % 2 == 0 ? 1 : 0.9;
        gear.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const auto start = std::chrono::steady_clock::now();
    expectCut(cutOf(gear), "gear");
    expectCut(cutOf(spiral(10000)), "spiral");
    expectCut(cutOf(comb(10000, 0)), "comb");
    expectCut(cutOf(comb(10000, 5000)), "slanting comb");
    // A second or so; a fan and a look at all corners for each took a minute.
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(Triangulate, ListsThatCrossThemselvesEnd) {
    Random random(9);
    for (const std::size_t count : {5, 20, 300, 20000}) {
        Plane places;
        for (std::size_t k = 0; k < count; ++k)
            places.push_back({random.uniform(), random.uniform()});
        EXPECT_EQ(cutOf(places).mesh.triangles.size(), count - 2);
        // The same few corners again and again, and all on a line.
        std::vector<std::uint32_t> again;
        for (std::size_t k = 0; k < count; ++k)
            again.push_back(
                static_cast<std::uint32_t>(k % 2 == 0 ? 0 : random.below(count - 1) + 1));
        EXPECT_LE(cutOf(places, again).mesh.triangles.size(), count - 2);
        for (auto& place : places) place[1] = place[0];
        EXPECT_EQ(cutOf(places).mesh.triangles.size(), count - 2);
    }
}

TEST(Triangulate, CornersThatRepeatCountOnce) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::uint32_t twice[] = {0, 0, 1, 1, 1, 2, 0};
    appendPolygon(twice, mesh);
    EXPECT_EQ(mesh.triangles.size(), 1u);
    const std::uint32_t none[] = {0, 0, 1, 1};
    appendPolygon(none, mesh);
    appendPolygon({}, mesh);
    EXPECT_EQ(mesh.triangles.size(), 1u);
}

}  // namespace
}  // namespace versorium
