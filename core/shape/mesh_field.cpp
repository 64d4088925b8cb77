// SPDX-License-Identifier: MIT
#include "shape/mesh_field.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace versorium {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kLargest = 1e6;
constexpr double kLeastSquaredArea = 1e-280;  // of the doubled area; below, normals lose digits
constexpr double kFar = 2;  // a cluster is far from 2 radii on (Barill et al. 2018, section 3)

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

// For each vertex the first index in an order by place that has the same place.
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
    std::vector<Box> boxes;
    for (const auto& triangle : mesh.triangles) {
        const glm::dvec3 a = mesh.vertices[triangle[0]];
        const glm::dvec3 b = mesh.vertices[triangle[turned_ ? 2 : 1]];
        const glm::dvec3 c = mesh.vertices[triangle[turned_ ? 1 : 2]];
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        if (!(glm::dot(normal, normal) > kLeastSquaredArea)) continue;
        Box box;
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
    std::vector<Box> boxes;
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
    clusters_.resize(tree_.nodes().size());
    for (std::size_t n = 0; n < clusters_.size(); ++n) {
        const BoundingTree::Node& node = tree_.nodes()[n];
        const auto begin = triangles_.begin() + node.first, end = begin + node.count;
        const auto centroid = [](const Triangle& triangle) {
            const auto& corners = triangle.corners();
            return (corners[0] + corners[1] + corners[2]) / 3.0;
        };
        Cluster& cluster = clusters_[n];
        double area = 0;
        for (auto triangle = begin; triangle != end; ++triangle) {
            area += triangle->area();
            cluster.centre += triangle->area() * centroid(*triangle);
            cluster.dipole += triangle->area() * triangle->normal();
        }
        cluster.centre /= area;
        for (auto triangle = begin; triangle != end; ++triangle) {
            const glm::dvec3 arm = triangle->area() * (centroid(*triangle) - cluster.centre);
            const glm::dvec3& normal = triangle->normal();
            cluster.diagonal += arm * normal;
            cluster.mixed +=
                glm::dvec3(arm.x * normal.y + arm.y * normal.x, arm.x * normal.z + arm.z * normal.x,
                           arm.y * normal.z + arm.z * normal.y);
            for (const glm::dvec3& corner : triangle->corners()) {
                const glm::dvec3 apart = corner - cluster.centre;
                cluster.squaredRadius =
                    std::max(cluster.squaredRadius, kFar * kFar * glm::dot(apart, apart));
            }
        }
    }
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

// ∫ n·(x - q)/|x - q|³ over the cluster, by Taylor's formula about its centre; d = centre - q.
double MeshField::clusterAngle(const Cluster& cluster, const glm::dvec3& d, double squared) const {
    const double inverse = 1 / squared;
    const double inverseCube = inverse / sqrt(squared);
    const double trace = cluster.diagonal.x + cluster.diagonal.y + cluster.diagonal.z;
    const double quadratic = glm::dot(cluster.diagonal, d * d) + cluster.mixed.x * d.x * d.y +
                             cluster.mixed.y * d.x * d.z + cluster.mixed.z * d.y * d.z;
    return inverseCube * (glm::dot(cluster.dipole, d) + trace - 3 * inverse * quadratic);
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
    return angle / (4 * kPi);
}

double MeshField::windingNumberBySum(const glm::dvec3& point) const {
    double angle = 0;
    for (const Triangle& triangle : triangles_) angle += triangle.solidAngle(point);
    return angle / (4 * kPi);
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
    return std::min({distance, sqrt(squared) / 2, kPi * margin * squared / boundaryLength_});
}

}  // namespace versorium
