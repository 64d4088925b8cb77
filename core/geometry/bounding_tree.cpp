// SPDX-License-Identifier: MIT
#include "geometry/bounding_tree.h"

#include <algorithm>
#include <numeric>

namespace versorium {

BoundingTree::BoundingTree(std::span<const BoundingBox> boxes, std::uint32_t leafSize) {
    order_.resize(boxes.size());
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes.empty())
        build(boxes, 0, static_cast<std::uint32_t>(boxes.size()), std::max(leafSize, 1u));
}

void BoundingTree::build(std::span<const BoundingBox> boxes, std::uint32_t first,
                         std::uint32_t count, std::uint32_t leafSize) {
    const std::size_t self = nodes_.size();
    Node node;
    node.first = first;
    node.count = count;
    for (std::uint32_t i = first; i < first + count; ++i) node.box.include(boxes[order_[i]]);
    nodes_.push_back(node);
    if (count <= leafSize) return;

    const glm::dvec3 size = node.box.high - node.box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = count / 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double left = boxes[a].low[axis] + boxes[a].high[axis];
        const double right = boxes[b].low[axis] + boxes[b].high[axis];
        return left < right || (left == right && a < b);
    });
    // nth_element leaves the halves in an order of the library's choosing.
    std::sort(begin, begin + half);
    std::sort(begin + half, begin + count);
    build(boxes, first, half, leafSize);
    nodes_[self].right = static_cast<std::uint32_t>(nodes_.size());
    build(boxes, first + half, count - half, leafSize);
}

}  // namespace versorium
