// SPDX-License-Identifier: MIT
#include "shape/mesh_report.h"

#include <gtest/gtest.h>

#include "geometry/triangulate.h"
#include "jobs/job.h"
#include "shape/mesh_distance.h"
#include "shape/test_meshes.h"

namespace versorium {
namespace {

TEST(MeshReport, ASphereIsSound) {
    EXPECT_TRUE(reportOf(icosphere(2)).sound());
    EXPECT_TRUE(warningsOf(reportOf(icosphere(2))).empty());
}

TEST(MeshReport, EachFaultIsCounted) {
    Mesh open = icosphere(1);
    open.triangles.pop_back();
    EXPECT_EQ(reportOf(open), (MeshReport{.openSides = 3}));

    Mesh turned = icosphere(1);
    std::swap(turned.triangles[5][0], turned.triangles[5][1]);
    EXPECT_EQ(reportOf(turned), (MeshReport{.turnedSides = 3}));

    Mesh doubled = icosphere(1);
    doubled.triangles.push_back(doubled.triangles[7]);
    const MeshReport report = reportOf(doubled);
    EXPECT_EQ(report.doubledTriangles, 1u);
    EXPECT_EQ(report.openSides, 3u);  // three sheets meet there

    Mesh empty = icosphere(1);
    const std::uint32_t corner = empty.triangles[0][0];
    empty.triangles.push_back({corner, corner, corner});
    EXPECT_EQ(reportOf(empty), (MeshReport{.emptyTriangles = 1}));

    Mesh inside = icosphere(1);
    for (auto& triangle : inside.triangles) std::swap(triangle[0], triangle[1]);
    EXPECT_EQ(reportOf(inside), (MeshReport{.turned = true}));

    for (const Mesh& mesh : {open, turned, doubled, empty, inside})
        EXPECT_FALSE(warningsOf(reportOf(mesh)).empty());
}

TEST(MeshReport, CornersAtOnePlaceAreOne) {
    const Mesh whole = icosphere(1);
    Mesh loose;
    for (const auto& triangle : whole.triangles) {
        const auto first = static_cast<std::uint32_t>(loose.vertices.size());
        for (const std::uint32_t corner : triangle)
            loose.vertices.push_back(whole.vertices[corner]);
        loose.triangles.push_back({first, first + 1, first + 2});
    }
    EXPECT_TRUE(reportOf(loose).sound());
}

Mesh boxMesh() {
    Mesh mesh;
    for (int k = 0; k < 8; ++k) mesh.vertices.emplace_back(k & 1, k >> 1 & 1, k >> 2);
    const std::uint32_t sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& side : sides) appendPolygon(side, mesh);
    return mesh;
}

TEST(MeshReport, OnlyDoubtfulMeshesHaveUncertainNodes) {
    Job job(1);
    Mesh mesh = icosphere(2);
    EXPECT_EQ(meshDistance(mesh, {.resolution = 24}, job)->uncertainNodes, 0u);
    // A box whose sides run through nodes of the grid.
    EXPECT_EQ(meshDistance(boxMesh(), {.resolution = 33, .padding = 4}, job)->uncertainNodes, 0u);
    // A third of the faces turned.
    for (std::size_t i = 0; i < mesh.triangles.size() / 3; ++i)
        std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
    EXPECT_GT(meshDistance(mesh, {.resolution = 24}, job)->uncertainNodes, 0u);
}

}  // namespace
}  // namespace versorium
