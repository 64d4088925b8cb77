// SPDX-License-Identifier: MIT
#include "shape/mesh_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

namespace versorium {
namespace {

constexpr double kLargest = 1e6;
constexpr double kLeastSquaredArea = 1e-280;  // of the doubled area; below, normals lose digits
constexpr double kFarRadii = 2.5;             // radii from which on a cluster's moments are used

using Edge = std::array<std::uint32_t, 2>;

Status checkMesh(const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(mesh.vertices[i][axis]) <= kLargest))
                return Status::data("vertex " + std::to_string(i + 1) +
                                    " of the mesh is not finite or further than 1e6 from 0");
    for (const auto& triangle : mesh.triangles)
        for (std::uint32_t corner : triangle)
            if (corner >= mesh.vertices.size())
                return Status::data("the mesh has a triangle with a corner " +
                                    std::to_string(corner) + ", but only " +
                                    std::to_string(mesh.vertices.size()) + " vertices");
    return {};
}

bool lexicographic(const glm::dvec3& a, const glm::dvec3& b) {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
}

// Six times the volume enclosed, seen from a vertex, so that a mesh far from 0 loses no digits.
double signedVolume(const Mesh& mesh) {
    double volume = 0;
    const glm::dvec3 origin = mesh.vertices[mesh.triangles[0][0]];
    for (const auto& triangle : mesh.triangles)
        volume += glm::dot(
            mesh.vertices[triangle[0]] - origin,
            glm::cross(mesh.vertices[triangle[1]] - origin, mesh.vertices[triangle[2]] - origin));
    return volume;
}

}  // namespace

std::vector<std::uint32_t> weldedIndices(const Mesh& mesh) {
    std::vector<std::uint32_t> order(mesh.vertices.size()), welded(mesh.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (mesh.vertices[a] != mesh.vertices[b])
            return lexicographic(mesh.vertices[a], mesh.vertices[b]);
        return a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && mesh.vertices[order[i]] == mesh.vertices[order[i - 1]];
        welded[order[i]] = same ? welded[order[i - 1]] : order[i];
    }
    return welded;
}

Expected<MeshField> MeshField::make(const Mesh& mesh) {
    if (mesh.triangles.empty())
        return Status::data("the mesh has no triangles; a surface of triangles is needed");
    if (const Status status = checkMesh(mesh); !status.ok()) return status;
    MeshField field;
    field.turned_ = signedVolume(mesh) < 0;
    field.gatherTriangles(mesh);
    if (field.triangles_.empty())
        return Status::data("none of the mesh's " + std::to_string(mesh.triangles.size()) +
                            " triangles has an area");
    field.gatherBoundary(mesh);
    field.gatherClusters();
    return field;
}

void MeshField::gatherTriangles(const Mesh& mesh) {
    std::vector<Triangle> kept;
    std::vector<BoundingBox> boxes;
    for (const auto& triangle : mesh.triangles) {
        const glm::dvec3 a = mesh.vertices[triangle[0]];
        const glm::dvec3 b = mesh.vertices[triangle[turned_ ? 2 : 1]];
        const glm::dvec3 c = mesh.vertices[triangle[turned_ ? 1 : 2]];
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        if (!(glm::dot(normal, normal) > kLeastSquaredArea)) continue;
        BoundingBox box;
        for (const glm::dvec3& corner : {a, b, c}) box.include(corner);
        kept.emplace_back(a, b, c);
        boxes.push_back(box);
    }
    dropped_ = mesh.triangles.size() - kept.size();
    tree_ = BoundingTree(boxes);
    triangles_.reserve(kept.size());
    for (std::uint32_t item : tree_.order()) triangles_.push_back(kept[item]);
}

// The boundary of the surface as a chain: sides that are not met as often in one direction as in
// the other. Triangles without area belong to it, as they may close gaps between others.
void MeshField::gatherBoundary(const Mesh& mesh) {
    const std::vector<std::uint32_t> welded = weldedIndices(mesh);
    std::vector<std::pair<Edge, int>> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (const auto& triangle : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = welded[triangle[i]], b = welded[triangle[(i + 1) % 3]];
            if (a != b) sides.push_back({{std::min(a, b), std::max(a, b)}, a < b ? 1 : -1});
        }
    std::sort(sides.begin(), sides.end());
    std::vector<BoundingBox> boxes;
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < sides.size();) {
        const Edge edge = sides[i].first;
        int net = 0;
        for (; i < sides.size() && sides[i].first == edge; ++i) net += sides[i].second;
        if (net == 0) continue;
        const glm::dvec3 start = mesh.vertices[edge[0]], side = mesh.vertices[edge[1]] - start;
        const double squared = glm::dot(side, side);
        boundaryLength_ += std::abs(net) * sqrt(squared);
        segments.push_back({start, side, squared > 0 ? 1 / squared : 0.0});
        boxes.emplace_back();
        boxes.back().include(start);
        boxes.back().include(mesh.vertices[edge[1]]);
    }
    boundaryTree_ = BoundingTree(boxes);
    for (std::uint32_t item : boundaryTree_.order()) boundary_.push_back(segments[item]);
}

void MeshField::gatherClusters() {
    for (const BoundingTree::Node& node : tree_.nodes())
        clusters_.push_back(clusterOf(std::span(triangles_).subspan(node.first, node.count)));
}

MeshField::Cluster MeshField::clusterOf(std::span<const Triangle> triangles) {
    Cluster cluster;
    double area = 0;
    for (const Triangle& triangle : triangles) {
        area += triangle.area();
        cluster.centre += triangle.area() * triangle.centroid();
    }
    cluster.centre /= area;
    for (const Triangle& triangle : triangles) {
        addMoments(triangle, cluster);
        for (const glm::dvec3& corner : triangle.corners()) {
            const glm::dvec3 apart = corner - cluster.centre;
            cluster.squaredRadius =
                std::max(cluster.squaredRadius, kFarRadii * kFarRadii * glm::dot(apart, apart));
        }
    }
    return cluster;
}

void MeshField::addMoments(const Triangle& triangle, Cluster& cluster) {
    const glm::dvec3 n = triangle.normal() * triangle.area();
    const glm::dvec3 v = triangle.centroid() - cluster.centre;
    cluster.dipole += n;
    cluster.trace += glm::dot(v, n);
    cluster.diagonal += v * n;
    cluster.mixed +=
        glm::dvec3(v.x * n.y + v.y * n.x, v.x * n.z + v.z * n.x, v.y * n.z + v.z * n.y);
    // The mean of v v over a triangle is that of its centroid plus 1/12 Σ of its corners' about it.
    glm::dvec3 square = v * v, product(v.x * v.y, v.x * v.z, v.y * v.z);
    for (const glm::dvec3& corner : triangle.corners()) {
        const glm::dvec3 c = corner - triangle.centroid();
        square += c * c / 12.0;
        product += glm::dvec3(c.x * c.y, c.x * c.z, c.y * c.z) / 12.0;
    }
    const double xx = square.x, yy = square.y, zz = square.z;
    const double xy = product.x, xz = product.y, yz = product.z;
    const glm::dvec3 applied(xx * n.x + xy * n.y + xz * n.z, xy * n.x + yy * n.y + yz * n.z,
                             xz * n.x + yz * n.y + zz * n.z);
    cluster.vector += 0.5 * ((xx + yy + zz) * n + 2.0 * applied);
    const double entries[10] = {
        xx * n.x,
        xx * n.y + 2 * xy * n.x,
        xx * n.z + 2 * xz * n.x,
        yy * n.x + 2 * xy * n.y,
        2 * (xy * n.z + xz * n.y + yz * n.x),
        zz * n.x + 2 * xz * n.z,
        yy * n.y,
        yy * n.z + 2 * yz * n.y,
        zz * n.y + 2 * yz * n.z,
        zz * n.z,
    };
    for (std::size_t i = 0; i < 10; ++i) cluster.cubic[i] += 0.5 * entries[i];
}

double MeshField::distance(const glm::dvec3& point) const {
    std::size_t nearest = 0;
    return sqrt(squaredDistance(point, std::numeric_limits<double>::infinity(), nearest));
}

double MeshField::squaredDistance(const glm::dvec3& point, double squaredBound,
                                  std::size_t& nearest) const {
    return tree_.nearest(point, squaredBound, [&](std::uint32_t item, double best) {
        const double squared = triangles_[item].squaredDistance(point, best);
        if (squared < best) nearest = item;
        return squared;
    });
}

// ∫ n·(d + v)/|d + v|³ by Taylor's formula about v = 0, where d leads from the point to the centre:
//   n·d/r³ + [v·n/r³ - 3 (v·d)(n·d)/r⁵] + ½ [15 (v·d)² (n·d)/r⁷ - 3 (|v|² n·d + 2 (v·n)(v·d))/r⁵].
double MeshField::clusterAngle(const Cluster& cluster, const glm::dvec3& d, double squared) {
    const double inverse = 1 / squared;
    const double inverseCube = inverse / sqrt(squared);
    const glm::dvec3 square = d * d;
    const double quadratic = glm::dot(cluster.diagonal, square) + cluster.mixed.x * d.x * d.y +
                             cluster.mixed.y * d.x * d.z + cluster.mixed.z * d.y * d.z;
    const std::array<double, 10>& c = cluster.cubic;
    const double cubic = d.x * (c[0] * square.x + c[1] * d.x * d.y + c[2] * d.x * d.z +
                                c[3] * square.y + c[4] * d.y * d.z + c[5] * square.z) +
                         d.y * (c[6] * square.y + c[7] * d.y * d.z + c[8] * square.z) +
                         c[9] * d.z * square.z;
    const double fifth = quadratic + glm::dot(cluster.vector, d);
    return inverseCube * (glm::dot(cluster.dipole, d) + cluster.trace - 3 * inverse * fifth +
                          15 * inverse * inverse * cubic);
}

double MeshField::windingNumber(const glm::dvec3& point) const {
    const std::vector<BoundingTree::Node>& nodes = tree_.nodes();
    std::uint32_t stack[BoundingTree::kDepth];
    int size = 0;
    stack[size++] = 0;
    double angle = 0;
    while (size > 0) {
        const std::uint32_t n = stack[--size];
        const Cluster& cluster = clusters_[n];
        const glm::dvec3 towards = cluster.centre - point;
        const double squared = glm::dot(towards, towards);
        if (squared > cluster.squaredRadius) {
            angle += clusterAngle(cluster, towards, squared);
        } else if (nodes[n].right == 0) {
            for (std::uint32_t i = nodes[n].first; i < nodes[n].first + nodes[n].count; ++i)
                angle += triangles_[i].solidAngle(point);
        } else {
            stack[size++] = nodes[n].right;
            stack[size++] = n + 1;
        }
    }
    return angle / (4 * std::numbers::pi);
}

// Off the surface the winding number is smooth, and its gradient is the law of Biot and Savart for
// a current along the boundary: |∇w| ≤ 1/(4π) ∮ |dl| / r². Within half the distance b to a boundary
// of length L that is at most L / (π b²). A closed mesh has none: w only changes at the surface.
double MeshField::signRadius(const glm::dvec3& point, double distance, double winding) const {
    const double margin = std::abs(winding - 0.5) - 2 * kWindingError;
    if (!(margin > 0)) return 0;
    if (closed()) return distance;
    const double squared = boundaryTree_.nearest(
        point, std::numeric_limits<double>::infinity(), [&](std::uint32_t item, double) {
            const Segment& segment = boundary_[item];
            return squaredDistanceToSegment(point, segment.start, segment.side,
                                            segment.inverseSquare);
        });
    return std::min(
        {distance, sqrt(squared) / 2, std::numbers::pi * margin * squared / boundaryLength_});
}

}  // namespace versorium
