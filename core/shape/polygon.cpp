// SPDX-License-Identifier: MIT
#include "shape/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "geometry/bounding_tree.h"
#include "geometry/triangle.h"

namespace versorium {
namespace {

constexpr double kLargestNumber = 1e6;

struct Side {
    glm::dvec3 start, span;
    double inverseSquare = 0;
};

bool usable(const glm::dvec2& point) {
    return std::abs(point.x) <= kLargestNumber && std::abs(point.y) <= kLargestNumber;
}

Status checkOptions(const PolygonDistanceOptions& options) {
    if (options.width < 2 || options.height < 2 || options.width > kPolygonNodes ||
        options.height > kPolygonNodes)
        return Status::usage("a grid of " + std::to_string(options.width) + " × " +
                             std::to_string(options.height) + " nodes is out of range: 2 to " +
                             std::to_string(kPolygonNodes) + " on a side");
    if (!usable(options.minimum) || !usable(options.maximum) ||
        !(options.minimum.x < options.maximum.x) || !(options.minimum.y < options.maximum.y))
        return Status::usage("the box of the grid must have its minimum below its maximum");
    return {};
}

Expected<std::vector<Side>> gatherSides(const Polygon& polygon) {
    std::vector<Side> sides;
    for (std::size_t r = 0; r < polygon.rings.size(); ++r) {
        const std::vector<glm::dvec2>& ring = polygon.rings[r];
        if (sides.size() + ring.size() > kPolygonSides)
            return Status::data("the polygon has more than " + std::to_string(kPolygonSides) +
                                " sides");
        for (std::size_t i = 0; i < ring.size(); ++i) {
            if (!usable(ring[i]))
                return Status::data("corner " + std::to_string(i + 1) + " of ring " +
                                    std::to_string(r + 1) +
                                    " of the polygon is not finite or further than 1e6 from 0");
            const glm::dvec2 next = ring[(i + 1) % ring.size()];
            if (next == ring[i]) continue;
            const glm::dvec3 span(next - ring[i], 0.0);
            const double squared = glm::dot(span, span);
            sides.push_back({glm::dvec3(ring[i], 0.0), span, squared > 0 ? 1 / squared : 0.0});
        }
    }
    if (sides.empty())
        return Status::data("the polygon has no sides; a ring of at least three corners is needed");
    return sides;
}

// Where a row crosses the sides, from left to right, and in which direction. A side holds its lower
// end and not its upper one, so that a corner on the row counts once.
struct Crossing {
    double x;
    int direction;
    friend bool operator<(const Crossing& a, const Crossing& b) { return a.x < b.x; }
};

std::vector<Crossing> crossingsAt(double y, const std::vector<Side>& sides) {
    std::vector<Crossing> crossings;
    for (const Side& side : sides) {
        const double from = side.start.y, to = side.start.y + side.span.y;
        const bool up = from <= y && y < to, down = to <= y && y < from;
        if (!up && !down) continue;
        const double x = side.start.x + (y - from) / side.span.y * side.span.x;
        crossings.push_back({x, up ? 1 : -1});
    }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
}

}  // namespace

Expected<Grid> polygonDistance(const Polygon& polygon, const PolygonDistanceOptions& options,
                               Job& job) {
    if (const Status status = checkOptions(options); !status.ok()) return status;
    const Expected<std::vector<Side>> sides = gatherSides(polygon);
    if (!sides) return sides.status();
    std::vector<BoundingBox> boxes(sides->size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        boxes[i].include((*sides)[i].start);
        boxes[i].include((*sides)[i].start + (*sides)[i].span);
    }
    const BoundingTree tree(boxes);
    const auto squaredDistanceTo = [&](std::uint32_t place, const glm::dvec3& point) {
        const Side& side = (*sides)[tree.order()[place]];
        return squaredDistanceToSegment(point, side.start, side.span, side.inverseSquare);
    };

    Grid grid;
    grid.resolution = {options.width, options.height, 1};
    grid.minimum = glm::dvec3(options.minimum, 0.0);
    grid.maximum = glm::dvec3(options.maximum, 0.0);
    grid.values.resize(static_cast<std::size_t>(options.width) *
                       static_cast<std::size_t>(options.height));
    const glm::dvec3 span = grid.maximum - grid.minimum;
    const bool done = job.parallelFor(static_cast<std::size_t>(options.height), [&](std::size_t r) {
        const int row = static_cast<int>(r);
        const double y = grid.minimum.y + span.y * (row / (options.height - 1.0));
        const std::vector<Crossing> crossings = crossingsAt(y, *sides);
        std::size_t passed = 0;
        int winding = 0;
        std::uint32_t nearest = 0;
        for (int i = 0; i < options.width; ++i) {
            const glm::dvec3 point(grid.minimum.x + span.x * (i / (options.width - 1.0)), y, 0);
            while (passed < crossings.size() && crossings[passed].x <= point.x)
                winding += crossings[passed++].direction;
            // The side nearest to the last node bounds the search.
            const double squared = tree.nearest(
                point, squaredDistanceTo(nearest, point), [&](std::uint32_t place, double best) {
                    const double found = squaredDistanceTo(place, point);
                    if (found < best) nearest = place;
                    return found;
                });
            const bool odd = passed % 2 == 1;
            const bool inside = options.rule == FillRule::evenOdd ? odd : winding != 0;
            grid.at(i, row) = inside && squared > 0 ? -sqrt(squared) : sqrt(squared);
        }
    });
    if (!done) return Status::cancelled();
    return grid;
}

}  // namespace versorium
