// SPDX-License-Identifier: MIT
#pragma once
// The signed distance of a triangle mesh at any point. The distance is exact, by a tree of boxes.
// The sign comes from the generalized winding number (Jacobson, Kavan, Sorkine-Hornung 2013): the
// solid angle of the surface divided by 4π, which is a whole number for a closed mesh and stays
// near one when the mesh has small holes; inside is where it exceeds ½. Far parts of the surface
// are summed up by their first three moments (Barill, Dickson, Schmidt, Levin, Jacobson 2018).

#include <array>
#include <cstddef>
#include <vector>

#include "base/status.h"
#include "geometry/bounding_tree.h"
#include "geometry/mesh.h"
#include "geometry/triangle.h"

namespace versorium {

class MeshField {
  public:
    // Triangles without area are dropped. A mesh that encloses a negative volume has its inside
    // out and is turned. Refused: no triangle left, a vertex that is not finite or further than
    // 10⁶ from 0, an index that no vertex has.
    static Expected<MeshField> make(const Mesh& mesh);

    // Distance to the surface, ≥ 0. A point's distance to one triangle, as a bound, may be given as
    // `squaredBound` to make the search shorter; `nearest` is the place of the nearest triangle and
    // stays as it was when none is below the bound.
    double distance(const glm::dvec3& point) const;
    double squaredDistance(const glm::dvec3& point, double squaredBound,
                           std::size_t& nearest) const;
    const std::vector<Triangle>& triangles() const { return triangles_; }  // in the tree's order

    // Differs from the winding number by less than kWindingError for surfaces that do not fold
    // back on themselves many times.
    double windingNumber(const glm::dvec3& point) const;
    static constexpr double kWindingError = 0.01;

    // A radius around a point within which the winding number stays on the same side of ½, given
    // the point's distance to the surface and its winding number; 0 when nothing can be said.
    double signRadius(const glm::dvec3& point, double distance, double winding) const;

    bool closed() const { return boundaryLength_ == 0; }
    std::size_t droppedTriangles() const { return dropped_; }
    bool turned() const { return turned_; }

  private:
    // Moments of the triangles of a node, for points that see it under a small angle: with v the
    // place from the centre and n the normal, ∫ n, ∫ v n and ½ ∫ v v n over the area, each in the
    // form in which it meets the direction d.
    struct Cluster {
        glm::dvec3 centre{};             // weighted by area
        double squaredRadius = 0;        // nearer points than this need the node's parts
        glm::dvec3 dipole{};             // n·d
        double trace = 0;                // v·n
        glm::dvec3 diagonal{}, mixed{};  // (v·d)(n·d): xx, yy, zz; xy, xz, yz
        glm::dvec3 vector{};             // (|v|² n·d + 2 (v·n)(v·d)) / 2
        std::array<double, 10>
            cubic{};  // (v·d)² (n·d) / 2: xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz
    };
    struct Segment {
        glm::dvec3 start, side;
        double inverseSquare;
    };

    MeshField() = default;
    void gatherTriangles(const Mesh& mesh);
    void gatherBoundary(const Mesh& mesh);
    void gatherClusters();
    static Cluster clusterOf(std::span<const Triangle> triangles);
    static void addMoments(const Triangle& triangle, Cluster& cluster);
    static double clusterAngle(const Cluster& cluster, const glm::dvec3& d, double squared);

    BoundingTree tree_;
    std::vector<Triangle> triangles_;
    std::vector<Cluster> clusters_;  // one for each node of the tree
    BoundingTree boundaryTree_;
    std::vector<Segment> boundary_;
    double boundaryLength_ = 0;
    std::size_t dropped_ = 0;
    bool turned_ = false;
};

// For each vertex the first index, in an order by place, that has the same place.
std::vector<std::uint32_t> weldedIndices(const Mesh& mesh);

}  // namespace versorium
