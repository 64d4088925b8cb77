// SPDX-License-Identifier: MIT
#include "shape/mesh_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/random.h"
#include "shape/mesh_field.h"
#include "shape/test_meshes.h"

namespace versorium {
namespace {

// Another way to the distance from a point to a triangle: the projection by barycentric
// coordinates, else the nearest of densely bracketed points on the sides (golden section is not
// needed: the distance to a line's point is quadratic in its parameter).
double plainDistance(const Mesh& mesh, const glm::dvec3& p) {
    const auto length = [](const glm::dvec3& v) { return std::sqrt(glm::dot(v, v)); };
    double best = std::numeric_limits<double>::infinity();
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 corner[3] = {mesh.vertices[t[0]], mesh.vertices[t[1]],
                                      mesh.vertices[t[2]]};
        const glm::dvec3 e = corner[1] - corner[0], f = corner[2] - corner[0], d = p - corner[0];
        const double ee = glm::dot(e, e), ef = glm::dot(e, f), ff = glm::dot(f, f);
        const double de = glm::dot(d, e), df = glm::dot(d, f), det = ee * ff - ef * ef;
        const double u = (de * ff - df * ef) / det, v = (df * ee - de * ef) / det;
        if (u >= 0 && v >= 0 && u + v <= 1) best = std::min(best, length(d - u * e - v * f));
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 a = corner[i], side = corner[(i + 1) % 3] - a;
            double s = glm::dot(p - a, side) / glm::dot(side, side);
            s = s < 0 ? 0 : s > 1 ? 1 : s;
            best = std::min(best, length(p - a - s * side));
        }
    }
    return best;
}

MeshField fieldOf(const Mesh& mesh) {
    Expected<MeshField> field = MeshField::make(mesh);
    EXPECT_TRUE(field.ok()) << field.status().message();
    return std::move(*field);
}

glm::dvec3 randomPoint(Random& random, double size) {
    const double x = random.uniform(-size, size), y = random.uniform(-size, size);
    return {x, y, random.uniform(-size, size)};
}

// A bumpy sphere: no symmetry that could hide a mistake.
Mesh bumpyMesh() {
    Mesh mesh = icosphere(3);
    for (glm::dvec3& v : mesh.vertices)
        v *= 1 + 0.3 * std::sin(3 * v.x + 1) * std::sin(4 * v.y) + 0.2 * std::sin(5 * v.z);
    return mesh;
}

// The winding number as the plain sum over all triangles.
double windingNumberBySum(const MeshField& field, const glm::dvec3& point) {
    double angle = 0;
    for (const Triangle& triangle : field.triangles()) angle += triangle.solidAngle(point);
    return angle / (4 * std::numbers::pi);
}

TEST(MeshField, DistanceEqualsBruteForce) {
    for (const Mesh& mesh : {bumpyMesh(), torusMesh(1, 0.3, 31, 17)}) {
        const MeshField field = fieldOf(mesh);
        Random random(1);
        for (int i = 0; i < 400; ++i) {
            const glm::dvec3 p = randomPoint(random, 1.6);
            // Both are right to a few roundings of coordinates of order 1.
            EXPECT_NEAR(field.distance(p), plainDistance(mesh, p), 1e-14);
        }
    }
}

TEST(MeshField, DistanceToThinTrianglesKeepsItsDigits) {
    // A needle of width 1e-9 along x: distances are those of a segment, to that width.
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0.3, 1e-9, 0}};
    mesh.triangles = {{0, 1, 2}};
    const MeshField field = fieldOf(mesh);
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = randomPoint(random, 2);
        const double t = std::clamp(p.x, 0.0, 1.0);
        EXPECT_NEAR(field.distance(p), std::hypot(p.x - t, p.y, p.z), 2e-9);
    }
}

TEST(MeshField, WindingNumberOfAClosedMeshIsWhole) {
    const MeshField field = fieldOf(bumpyMesh());
    EXPECT_TRUE(field.closed());
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 p = randomPoint(random, 1.6);
        const double sum = windingNumberBySum(field, p);
        // The sum of 1280 angles, each right to a few roundings, over 4π.
        EXPECT_NEAR(sum, std::round(sum), 1e-12);
        EXPECT_LE(std::abs(field.windingNumber(p) - sum), MeshField::kWindingError);
    }
    EXPECT_NEAR(windingNumberBySum(field, {0, 0, 0}), 1, 1e-12);
}

TEST(MeshField, WindingNumberOfOneTriangleIsItsShareOfTheSphere) {
    // An octant is seen from the origin under 4π/8; its face looks away from it.
    Mesh mesh;
    mesh.vertices = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}};
    EXPECT_NEAR(windingNumberBySum(fieldOf(mesh), {0, 0, 0}), 0.125, 1e-15);
}

// The radius within which a sign is spread is a proof: no point in it has the other sign.
TEST(MeshField, SignsAreOnlySpreadWhereTheyHold) {
    Mesh holed = bumpyMesh();
    // Two holes, one of a single triangle and one of a few dozen.
    holed.triangles.erase(holed.triangles.begin() + 700);
    holed.triangles.erase(holed.triangles.begin() + 100, holed.triangles.begin() + 130);
    for (const Mesh& mesh : {bumpyMesh(), holed}) {
        const MeshField field = fieldOf(mesh);
        Random random(4);
        int spread = 0;
        for (int i = 0; i < 400; ++i) {
            const glm::dvec3 p = randomPoint(random, 1.6);
            const double winding = field.windingNumber(p);
            const double radius = field.signRadius(p, field.distance(p), winding);
            spread += radius > 0.05;
            for (int k = 0; k < 10; ++k) {
                glm::dvec3 apart = randomPoint(random, 1);
                apart *= radius * random.uniform() / std::sqrt(glm::dot(apart, apart));
                EXPECT_EQ(windingNumberBySum(field, p + apart) > 0.5, winding > 0.5);
            }
        }
        EXPECT_GT(spread, 100);  // and it is worth its name
    }
}

MeshDistance gridOf(const Mesh& mesh, int resolution, int threads = 1) {
    Job job(threads);
    Expected<MeshDistance> result = meshDistance(mesh, {.resolution = resolution}, job);
    EXPECT_TRUE(result.ok()) << result.status().message();
    return std::move(*result);
}

glm::dvec3 nodeOf(const Grid& grid, int x, int y, int z) {
    return grid.minimum +
           (grid.maximum - grid.minimum) * (glm::dvec3(x, y, z) / glm::dvec3(grid.resolution - 1));
}

// A polyhedron with its corners on a smooth surface is within the sagitta of its sides, and a
// distance cannot be further off than the surface.
TEST(MeshDistance, ApproachesTheClosedForms) {
    const auto check = [](const Mesh& mesh, auto exact, double sagitta) {
        const MeshDistance made = gridOf(mesh, 33);
        EXPECT_TRUE(made.closed);
        EXPECT_FALSE(made.turned);
        for (int z = 0; z < 33; ++z)
            for (int y = 0; y < 33; ++y)
                for (int x = 0; x < 33; ++x) {
                    const glm::dvec3 p = nodeOf(made.grid, x, y, z) / made.scale + made.centre;
                    const double value = made.grid.at(x, y, z) / made.scale;
                    EXPECT_NEAR(value, exact(p), sagitta + 1e-12);
                }
    };
    // Icosphere of level 3: edges are at most 0.164 long (63.43°/8, stretched by at most 1.18), a
    // triangle's circumradius 0.095, the sagitta 0.095²/2.
    check(
        icosphere(3), [](const glm::dvec3& p) { return std::sqrt(glm::dot(p, p)) - 1; }, 0.0046);
    // Torus: the chords' sagittas R(1 - cos π/n) around and r(1 - cos π/m) across, added.
    check(
        torusMesh(1, 0.4, 96, 48),
        [](const glm::dvec3& p) { return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4; },
        1.4 * (1 - std::cos(M_PI / 96)) + 0.4 * (1 - std::cos(M_PI / 48)));
}

TEST(MeshDistance, EqualsTheFieldAtEveryNode) {
    Mesh mesh = bumpyMesh();
    mesh.triangles.erase(mesh.triangles.begin() + 300, mesh.triangles.begin() + 310);
    const MeshDistance made = gridOf(mesh, 25);
    EXPECT_FALSE(made.closed);
    for (glm::dvec3& v : mesh.vertices) v = (v - made.centre) * made.scale;
    const MeshField field = fieldOf(mesh);
    for (int z = 0; z < 25; ++z)
        for (int y = 0; y < 25; ++y)
            for (int x = 0; x < 25; ++x) {
                const glm::dvec3 p = nodeOf(made.grid, x, y, z);
                const double sign = field.windingNumber(p) > 0.5 ? -1 : 1;
                // The search starts elsewhere, but ends with the same triangle.
                EXPECT_EQ(made.grid.at(x, y, z), sign * field.distance(p));
            }
}

// Without a few of its triangles a sphere still has an inside: away from the hole all is as before.
TEST(MeshDistance, SmallHolesDoNotMatter) {
    const Mesh whole = icosphere(3);
    Mesh holed = whole;
    const auto atTop = [&](const std::array<std::uint32_t, 3>& t) {
        return whole.vertices[t[0]].z > 0.95 && whole.vertices[t[1]].z > 0.95;
    };
    holed.triangles.erase(std::remove_if(holed.triangles.begin(), holed.triangles.end(), atTop),
                          holed.triangles.end());
    ASSERT_LT(holed.triangles.size(), whole.triangles.size());
    const MeshDistance a = gridOf(whole, 25), b = gridOf(holed, 25);
    EXPECT_TRUE(a.closed);
    EXPECT_FALSE(b.closed);
    for (int z = 0; z < 25; ++z)
        for (int y = 0; y < 25; ++y)
            for (int x = 0; x < 25; ++x) {
                const glm::dvec3 p = nodeOf(b.grid, x, y, z) / b.scale + b.centre;
                // The hole's radius is 0.36; from 0.5 beyond its rim the hole is seen under less
                // than half of what would turn a sign.
                const glm::dvec3 fromHole = p - glm::dvec3(0, 0, 1);
                if (std::sqrt(glm::dot(fromHole, fromHole)) < 0.86) continue;
                // Between the sphere and its polyhedron (see above) nothing is claimed.
                const double radius = std::sqrt(glm::dot(p, p));
                if (std::abs(radius - 1) < 0.0046) continue;
                EXPECT_EQ(b.grid.at(x, y, z) < 0, radius < 1);
            }
}

TEST(MeshDistance, DoesNotDependOnThreads) {
    const Mesh mesh = bumpyMesh();
    const Grid one = gridOf(mesh, 40, 1).grid;
    for (int threads : {2, 5}) EXPECT_EQ(gridOf(mesh, 40, threads).grid.values, one.values);
}

TEST(MeshDistance, FillsTheBoxWithItsPadding) {
    Mesh mesh = torusMesh(3, 1, 24, 12);
    for (glm::dvec3& v : mesh.vertices) v += glm::dvec3(100, -50, 7);
    const MeshDistance made = gridOf(mesh, 41);
    EXPECT_EQ(made.grid.minimum, glm::dvec3(-0.5));
    EXPECT_EQ(made.grid.maximum, glm::dvec3(0.5));
    // The longest side, 8, spans 40 - 2·2 of 40 cells; coordinates near 100 round at 1e-14.
    EXPECT_NEAR(made.scale, 0.9 / 8, 1e-14);
    EXPECT_NEAR(made.centre.x, 100, 1e-13);
    EXPECT_NEAR(made.grid.at(38, 20, 20), 0, 1e-13);
    EXPECT_NEAR(made.grid.at(40, 20, 20), 0.05, 1e-13);
}

TEST(MeshDistance, AMeshWithItsInsideOutIsTurned) {
    Mesh mesh = icosphere(2);
    const Grid before = gridOf(mesh, 17).grid;
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    const MeshDistance after = gridOf(mesh, 17);
    EXPECT_TRUE(after.turned);
    EXPECT_LT(after.grid.at(8, 8, 8), 0);
    for (std::size_t i = 0; i < before.values.size(); ++i)
        EXPECT_NEAR(after.grid.values[i], before.values[i], 1e-14);  // corners in another order
}

TEST(MeshDistance, DegenerateTrianglesAreDropped) {
    Mesh mesh = icosphere(2);
    const Grid before = gridOf(mesh, 17).grid;
    mesh.vertices.push_back((mesh.vertices[0] + mesh.vertices[1]) / 2.0);
    mesh.triangles.insert(mesh.triangles.begin(), {3, 3, 5});
    mesh.triangles.push_back({7, 7, 7});
    const MeshDistance after = gridOf(mesh, 17);
    EXPECT_EQ(after.droppedTriangles, 2u);
    EXPECT_TRUE(after.closed);
    EXPECT_EQ(after.grid.values, before.values);
}

std::string faultOf(const Mesh& mesh, const MeshDistanceOptions& options = {.resolution = 9}) {
    Job job(1);
    const Expected<MeshDistance> made = meshDistance(mesh, options, job);
    return made.ok() ? "" : made.status().message();
}

TEST(MeshDistance, RefusesWhatHasNoDistance) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(faultOf({}), "the mesh has no triangles; a surface of triangles is needed");
    Mesh flat;
    flat.vertices = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    flat.triangles = {{0, 1, 2}};
    EXPECT_EQ(faultOf(flat), "none of the mesh's 1 triangles has an area");
    Mesh point = flat;
    point.vertices = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    EXPECT_NE(faultOf(point), "");
    for (double bad : {nan, infinity, -infinity}) {
        Mesh mesh = icosphere(0);
        mesh.vertices[3].y = bad;
        EXPECT_EQ(faultOf(mesh), "vertex 4 of the mesh is not finite");
    }
    Mesh index = icosphere(0);
    index.triangles[2][1] = 12;
    EXPECT_NE(faultOf(index).find("a corner 12, but only 12 vertices"), std::string::npos);
    Mesh vast = icosphere(0);
    for (glm::dvec3& v : vast.vertices) v *= 1.5e308;  // its size overflows
    EXPECT_NE(faultOf(vast), "");
    for (int resolution : {-1, 0, 1, 1025, 1000000000})
        EXPECT_NE(faultOf(icosphere(0), {.resolution = resolution}), "") << resolution;
    for (double padding : {-1.0, 4.0, 1e300, nan, infinity})
        EXPECT_NE(faultOf(icosphere(0), {.resolution = 9, .padding = padding}), "") << padding;
}

TEST(MeshDistance, HugeAndTinyMeshesAreScaled) {
    for (double size : {1e-150, 1e-3, 1e150}) {
        Mesh mesh = icosphere(1);
        for (glm::dvec3& v : mesh.vertices) v *= size;
        const MeshDistance made = gridOf(mesh, 9);
        EXPECT_LT(made.grid.at(4, 4, 4), 0) << size;
        EXPECT_GT(made.grid.at(0, 0, 0), 0) << size;
    }
}

TEST(MeshDistance, CanBeCancelled) {
    Job job(2);
    job.cancel();
    const Expected<MeshDistance> made = meshDistance(icosphere(2), {.resolution = 50}, job);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.status().kind(), ErrorKind::cancelled);
}

}  // namespace
}  // namespace versorium
