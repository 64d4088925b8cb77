// SPDX-License-Identifier: MIT
#include "shape/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/json.h"
#include "shape/mesh_field.h"

namespace versorium {
namespace {

constexpr double kOnSurface = 1e-9;  // nearer nodes lie on it but for rounding
constexpr int kBlock = 16;           // nodes along a side of the blocks that threads take

Status checkOptions(const MeshDistanceOptions& options) {
    if (options.resolution < 2 || options.resolution > kMeshDistanceNodes)
        return Status::usage("resolution " + std::to_string(options.resolution) +
                             " is out of range: 2 to " + std::to_string(kMeshDistanceNodes));
    if (options.normalise &&
        !(options.padding >= 0 && 2 * options.padding < options.resolution - 1))
        return Status::usage("a padding of " + formatNumber(options.padding) +
                             " cells leaves no room for the mesh in " +
                             std::to_string(options.resolution - 1) + " cells");
    return {};
}

// Centre and scale that take the mesh into the padded box.
Status placeMesh(const Mesh& mesh, const MeshDistanceOptions& options, MeshDistance& result) {
    if (mesh.triangles.empty() || mesh.vertices.empty())
        return Status::data("the mesh has no triangles; a surface of triangles is needed");
    BoundingBox box;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const glm::dvec3& vertex = mesh.vertices[i];
        if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y) || !std::isfinite(vertex.z))
            return Status::data("vertex " + std::to_string(i + 1) + " of the mesh is not finite");
    }
    // Vertices that no triangle uses do not count.
    for (const auto& triangle : mesh.triangles)
        for (std::uint32_t corner : triangle)
            if (corner < mesh.vertices.size()) box.include(mesh.vertices[corner]);
    const glm::dvec3 size = box.high - box.low;
    const double longest = std::max({size.x, size.y, size.z});
    result.scale = (1 - 2 * options.padding / (options.resolution - 1)) / longest;
    result.centre = box.low + size / 2.0;
    if (!(longest > 0) || !std::isfinite(longest) || !std::isfinite(result.scale))
        return Status::data("the mesh has a size that cannot be scaled: its longest side is " +
                            formatNumber(longest));
    return {};
}

Mesh placedMesh(const Mesh& mesh, const MeshDistance& place) {
    Mesh placed = mesh;
    // What is far outside the box belongs to no triangle; 0 keeps it harmless.
    for (glm::dvec3& vertex : placed.vertices) {
        vertex = (vertex - place.centre) * place.scale;
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(vertex[axis]) <= 1)) vertex = glm::dvec3(0.0);
    }
    return placed;
}

// One block of nodes: first the distances, each started from the triangle that was nearest to its
// neighbour, then the signs, each spread as far as it is certain (MeshField::signRadius).
class BlockSampler {
  public:
    BlockSampler(const MeshField& field, Grid& grid, glm::ivec3 first)
        : field_(field),
          grid_(grid),
          first_(first),
          last_(glm::min(first + kBlock, grid.resolution)) {}

    // Gives how many of its nodes have an uncertain side.
    std::size_t run() {
        sampleDistances();
        std::fill(std::begin(signs_), std::end(signs_), 0);
        // The node furthest from the surface often decides the whole block.
        decide(furthest_);
        forEachNode([&](const glm::ivec3& node) {
            if (signOf(node) == 0) decide(node);
        });
        forEachNode([&](const glm::ivec3& node) {
            double& value = grid_.at(node.x, node.y, node.z);
            if (signOf(node) < 0 && value > 0) value = -value;
        });
        return uncertain_;
    }

  private:
    template <class Body>
    void forEachNode(Body body) {
        for (int z = first_.z; z < last_.z; ++z)
            for (int y = first_.y; y < last_.y; ++y)
                for (int x = first_.x; x < last_.x; ++x) body(glm::ivec3(x, y, z));
    }
    signed char& signOf(const glm::ivec3& node) {
        const glm::ivec3 local = node - first_;
        return signs_[(local.z * kBlock + local.y) * kBlock + local.x];
    }
    glm::dvec3 placeOf(const glm::ivec3& node) const {
        const glm::dvec3 cells(grid_.resolution - 1);
        return grid_.minimum + (grid_.maximum - grid_.minimum) * (glm::dvec3(node) / cells);
    }

    void sampleDistances() {
        std::size_t nearest = 0;
        double greatest = -1;
        for (int z = first_.z; z < last_.z; ++z)
            for (int y = first_.y; y < last_.y; ++y) {
                // Back and forth, so that the next node is always a neighbour.
                const bool forth = ((y - first_.y) & 1) == 0;
                for (int i = first_.x; i < last_.x; ++i) {
                    const glm::ivec3 node(forth ? i : last_.x - 1 - (i - first_.x), y, z);
                    const glm::dvec3 point = placeOf(node);
                    const double start = field_.triangles()[nearest].squaredDistance(
                        point, std::numeric_limits<double>::infinity());
                    const double value = sqrt(field_.squaredDistance(point, start, nearest));
                    grid_.at(node.x, node.y, node.z) = value;
                    if (value > greatest) {
                        greatest = value;
                        furthest_ = node;
                    }
                }
            }
    }

    void decide(const glm::ivec3& node) {
        const glm::dvec3 point = placeOf(node);
        const double winding = field_.windingNumber(point);
        // A node on the surface belongs to neither side.
        const bool off = grid_.at(node.x, node.y, node.z) > kOnSurface;
        uncertain_ += off && winding > 0.25 && winding < 0.75 ? 1 : 0;
        const signed char sign = winding > 0.5 ? -1 : 1;
        signOf(node) = sign;
        // A little less, so that rounding decides nothing.
        const double radius =
            field_.signRadius(point, grid_.at(node.x, node.y, node.z), winding) * (1 - 1e-9);
        const glm::dvec3 cell = (grid_.maximum - grid_.minimum) / glm::dvec3(grid_.resolution - 1);
        if (!(radius > std::min({cell.x, cell.y, cell.z}))) return;
        const glm::ivec3 reach(glm::min(glm::dvec3(kBlock), glm::dvec3(radius) / cell));
        const glm::ivec3 low = glm::max(first_, node - reach);
        const glm::ivec3 high = glm::min(last_, node + reach + 1);
        for (int z = low.z; z < high.z; ++z)
            for (int y = low.y; y < high.y; ++y)
                for (int x = low.x; x < high.x; ++x) {
                    const glm::dvec3 apart = placeOf({x, y, z}) - point;
                    if (glm::dot(apart, apart) < radius * radius) signOf({x, y, z}) = sign;
                }
    }

    const MeshField& field_;
    Grid& grid_;
    glm::ivec3 first_, last_, furthest_{};
    std::size_t uncertain_ = 0;
    signed char signs_[kBlock * kBlock * kBlock];  // 0 while unknown
};

}  // namespace

Expected<MeshDistance> meshDistance(const Mesh& mesh, const MeshDistanceOptions& options,
                                    Job& job) {
    if (const Status status = checkOptions(options); !status.ok()) return status;
    MeshDistance result;
    if (options.normalise)
        if (const Status status = placeMesh(mesh, options, result); !status.ok()) return status;
    const Expected<MeshField> field =
        MeshField::make(options.normalise ? placedMesh(mesh, result) : mesh);
    if (!field) return field.status();
    result.closed = field->closed();
    result.turned = field->turned();
    result.droppedTriangles = field->droppedTriangles();

    Grid& grid = result.grid;
    grid.resolution = glm::ivec3(options.resolution);
    const auto side = static_cast<std::size_t>(options.resolution);
    grid.values.resize(side * side * side);
    const std::size_t blocks = (side + kBlock - 1) / kBlock;
    std::vector<std::size_t> uncertain(blocks * blocks * blocks);
    const bool done = job.parallelFor(blocks * blocks * blocks, [&](std::size_t part) {
        const glm::ivec3 block(static_cast<int>(part % blocks),
                               static_cast<int>(part / blocks % blocks),
                               static_cast<int>(part / blocks / blocks));
        uncertain[part] = BlockSampler(*field, grid, block * kBlock).run();
    });
    if (!done) return Status::cancelled();
    for (const std::size_t nodes : uncertain) result.uncertainNodes += nodes;
    return result;
}

}  // namespace versorium
