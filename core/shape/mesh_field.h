// SPDX-License-Identifier: MIT
#pragma once
// The signed distance of a triangle mesh at any point. The distance is exact, by a tree of boxes.
// The sign comes from the generalized winding number (Jacobson, Kavan, Sorkine-Hornung 2013): the
// solid angle of the surface divided by 4π, which is a whole number for a closed mesh and stays
// near one when the mesh has small holes; inside is where it exceeds ½. Far parts of the surface
// are summed up by their first two moments (Barill, Dickson, Schmidt, Levin, Jacobson 2018).

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
    // The winding number as the plain sum over all triangles.
    double windingNumberBySum(const glm::dvec3& point) const;
    static constexpr double kWindingError = 0.02;

    // A radius around a point within which the winding number stays on the same side of ½, given
    // the point's distance to the surface and its winding number; 0 when nothing can be said.
    double signRadius(const glm::dvec3& point, double distance, double winding) const;

    bool closed() const { return boundaryLength_ == 0; }
    double boundaryLength() const { return boundaryLength_; }
    std::size_t droppedTriangles() const { return dropped_; }
    bool turned() const { return turned_; }

  private:
    // Moments of the triangles of a node, for points that see it under a small angle.
    struct Cluster {
        glm::dvec3 centre{};       // weighted by area
        double squaredRadius = 0;  // times kFar²: nearer points need the node's parts
        glm::dvec3 dipole{};       // Σ area · normal
        glm::dvec3 diagonal{};  // of the symmetric part of Σ area · (centroid - centre) normalᵀ
        glm::dvec3 mixed{};     // its xy, xz, yz entries, doubled
    };
    struct Segment {
        glm::dvec3 start, side;
        double inverseSquare;
    };

    MeshField() = default;
    void gatherTriangles(const Mesh& mesh);
    void gatherBoundary(const Mesh& mesh);
    void gatherClusters();
    double clusterAngle(const Cluster& cluster, const glm::dvec3& towards, double squared) const;

    BoundingTree tree_;
    std::vector<Triangle> triangles_;
    std::vector<Cluster> clusters_;  // one for each node of the tree
    BoundingTree boundaryTree_;
    std::vector<Segment> boundary_;
    double boundaryLength_ = 0;
    std::size_t dropped_ = 0;
    bool turned_ = false;
};

}  // namespace versorium
