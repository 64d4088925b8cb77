// SPDX-License-Identifier: MIT
#include "shape/tree.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/json.h"
#include "math/elementary.h"
#include "shape/shape_words.h"

namespace versorium {

struct ShapeTree::Node {
    ShapeKind kind{};
    std::vector<double> numbers;
    std::vector<double> derived;
    std::vector<ShapeTree> children;
    int depth = 1;
    int count = 1;
};

namespace {

// A star's sector is reached by reflections in lines through 0 at multiples m·π/n: first m = ⌈n/2⌉,
// then half of that, until m = 1. Derived: cos and sin of each line, then of the sector's end π/n.
std::vector<double> starNumbers(double points) {
    std::vector<double> derived;
    const double width = std::numbers::pi / points;
    int sectors = static_cast<int>(points);
    while (sectors > 1) {
        sectors = (sectors + 1) / 2;
        derived.push_back(cos(width * sectors));
        derived.push_back(sin(width * sectors));
    }
    derived.push_back(cos(width));
    derived.push_back(sin(width));
    return derived;
}

// The cusp (x, y > 0) where the circles of a crescent meet.
std::vector<double> crescentNumbers(double large, double small, double offset) {
    const double x = (large * large - small * small + offset * offset) / (2 * offset);
    return {x, sqrt(max(large * large - x * x, 0.0))};
}

std::vector<double> derive(ShapeKind kind, const std::vector<double>& numbers) {
    switch (kind) {
        case ShapeKind::star:
            return starNumbers(numbers[0]);
        case ShapeKind::crescent:
            return crescentNumbers(numbers[0], numbers[1], numbers[2]);
        case ShapeKind::halfSpace: {
            const double length =
                sqrt(numbers[0] * numbers[0] + numbers[1] * numbers[1] + numbers[2] * numbers[2]);
            return {numbers[0] / length, numbers[1] / length, numbers[2] / length};
        }
        case ShapeKind::rotate:
            return {cos(numbers[0]), sin(numbers[0])};
        default:
            return {};
    }
}

Status refuse(const ShapeWord& word, const std::string& what) {
    return Status::data(std::string(word.name) + ": " + what);
}

// What the ranges of the single numbers do not say.
Status checkTogether(const ShapeWord& word, const std::vector<double>& n) {
    switch (word.kind) {
        case ShapeKind::star:
            if (n[0] != std::floor(n[0]) || n[0] < 2 || n[0] > kStarPoints)
                return refuse(word, "the number of points must be whole, 2 to " +
                                        std::to_string(kStarPoints));
            return {};
        case ShapeKind::crescent:
            if (!(n[2] > std::abs(n[0] - n[1]) && n[2] < n[0] + n[1]))
                return refuse(word, "the circles do not cross; the offset must lie between " +
                                        formatNumber(std::abs(n[0] - n[1])) + " and " +
                                        formatNumber(n[0] + n[1]));
            return {};
        case ShapeKind::halfSpace:
            if (!(std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]) >= kShapeSmallest))
                return refuse(word, "the normal (nx, ny, nz) must not be zero");
            return {};
        default:
            return {};
    }
}

Status checkNumbers(const ShapeWord& word, const std::vector<double>& numbers) {
    const auto count = static_cast<int>(numbers.size());
    if (count < word.leastNumbers || count > word.mostNumbers)
        return refuse(word, std::to_string(count) + " numbers were given; it is " + word.usage);
    for (int i = 0; i < count; ++i) {
        const double number = numbers[static_cast<std::size_t>(i)];
        if (!(std::abs(number) <= kShapeLargest))
            return refuse(word, formatNumber(number) + " is out of range: -1e+06 to 1e+06");
        if (((word.positive >> i) & 1) != 0 && !(number >= kShapeSmallest))
            return refuse(word, formatNumber(number) + " must be positive, at least 1e-06");
    }
    return checkTogether(word, numbers);
}

}  // namespace

Expected<ShapeTree> ShapeTree::make(ShapeKind kind, std::vector<double> numbers,
                                    std::vector<ShapeTree> children) {
    const ShapeWord& word = shapeWord(kind);
    const auto count = static_cast<int>(children.size());
    if (count < word.leastChildren || (word.mostChildren >= 0 && count > word.mostChildren))
        return refuse(word, std::to_string(count) + " shapes were given; it is " + word.usage);
    if (const Status status = checkNumbers(word, numbers); !status.ok()) return status;
    auto node = std::make_shared<Node>();
    for (const ShapeTree& child : children) {
        node->depth = std::max(node->depth, child.depth() + 1);
        node->count += child.nodeCount();
        if (node->depth > kShapeDepth || node->count > kShapeNodes)
            return refuse(word, "a shape has at most " + std::to_string(kShapeNodes) +
                                    " parts, nested " + std::to_string(kShapeDepth) + " deep");
    }
    node->kind = kind;
    node->derived = derive(kind, numbers);
    node->numbers = std::move(numbers);
    node->children = std::move(children);
    return ShapeTree(std::move(node));
}

ShapeKind ShapeTree::kind() const { return node_->kind; }
const std::vector<double>& ShapeTree::numbers() const { return node_->numbers; }
const std::vector<ShapeTree>& ShapeTree::children() const { return node_->children; }
const std::vector<double>& ShapeTree::derived() const { return node_->derived; }
int ShapeTree::depth() const { return node_->depth; }
int ShapeTree::nodeCount() const { return node_->count; }

bool operator==(const ShapeTree& a, const ShapeTree& b) {
    return a.node_ == b.node_ ||
           (a.kind() == b.kind() && a.numbers() == b.numbers() && a.children() == b.children());
}

ShapeExactness exactness(const ShapeTree& shape) {
    ShapeExactness result{true, true};
    for (const ShapeTree& child : shape.children()) {
        const ShapeExactness part = exactness(child);
        result.outside = result.outside && part.outside;
        result.inside = result.inside && part.inside;
    }
    switch (shape.kind()) {
        case ShapeKind::smoothUnion:
            return {false, false};
        case ShapeKind::unionOf:
            return {result.outside, result.inside && shape.children().size() == 1};
        case ShapeKind::intersection:
            return {result.outside && shape.children().size() == 1, result.inside};
        case ShapeKind::difference:
            return {false, exactness(shape.children()[0]).inside &&
                               exactness(shape.children()[1]).outside};
        default:
            return result;
    }
}

}  // namespace versorium
