// SPDX-License-Identifier: MIT
#pragma once
// A binary tree of axis-aligned boxes over items that have boxes of their own: nearest items are
// found by visiting the nearer box first and leaving out every box that is further away than what
// was found already. Items are split at the median of their boxes' centres along the longest side;
// ties are settled by index, so the tree is the same everywhere.

#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

namespace versorium {

struct BoundingBox {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void include(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void include(const BoundingBox& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    // Square of the distance to the box, 0 inside.
    double squaredDistance(const glm::dvec3& point) const {
        const glm::dvec3 outside = glm::max(glm::max(low - point, point - high), glm::dvec3(0.0));
        return glm::dot(outside, outside);
    }
};

class BoundingTree {
  public:
    struct Node {
        BoundingBox box;
        // The node holds the items order()[first] … order()[first + count - 1].
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        // Inner nodes: the left child is the next node, the right child this one; 0 in leaves.
        std::uint32_t right = 0;
    };
    static constexpr int kDepth = 64;  // more than halving 2^32 items needs

    BoundingTree() = default;
    explicit BoundingTree(std::span<const BoundingBox> boxes, std::uint32_t leafSize = 4);

    bool empty() const { return nodes_.empty(); }
    // Every node stands before its children.
    const std::vector<Node>& nodes() const { return nodes_; }
    const std::vector<std::uint32_t>& order() const { return order_; }

    // The least of `bound` and squaredDistanceOf(i, best) over the places i in order(). The
    // callback may return anything above `best` for an item that cannot be nearer than that.
    template <class SquaredDistance>
    double nearest(const glm::dvec3& point, double bound, SquaredDistance squaredDistanceOf) const {
        if (nodes_.empty()) return bound;
        struct Pending {
            std::uint32_t node;
            double squared;
        };
        Pending stack[kDepth];
        int size = 0;
        stack[size++] = {0, nodes_[0].box.squaredDistance(point)};
        while (size > 0) {
            const Pending top = stack[--size];
            if (top.squared > bound) continue;
            const Node& node = nodes_[top.node];
            if (node.right == 0) {
                for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                    const double squared = squaredDistanceOf(i, bound);
                    if (squared < bound) bound = squared;
                }
                continue;
            }
            Pending near{top.node + 1, nodes_[top.node + 1].box.squaredDistance(point)};
            Pending far{node.right, nodes_[node.right].box.squaredDistance(point)};
            if (far.squared < near.squared) std::swap(near, far);
            if (far.squared <= bound) stack[size++] = far;
            if (near.squared <= bound) stack[size++] = near;
        }
        return bound;
    }

  private:
    void build(std::span<const BoundingBox> boxes, std::uint32_t first, std::uint32_t count,
               std::uint32_t leafSize);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

}  // namespace versorium
