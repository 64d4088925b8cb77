// SPDX-License-Identifier: MIT
#include "shape/outline.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/json.h"
#include "shape/grid_sampling.h"
#include "shape/polygon.h"

namespace versorium {
namespace {

constexpr std::string_view kWord = "polygon(";
constexpr double kFree = 0.25;          // around the outline, of its size
constexpr double kParts = 20000;        // of its size: what a printed coordinate is rounded to
constexpr double kFlat = 1e-9;          // of its length: the least width of an outline
constexpr std::size_t kText = 1 << 18;  // characters
// Of shapes that a modulus of about 1 on their boundary suits.
constexpr double kLeastSize = 0.9, kMostSize = 4, kUsualSize = 1.8;

struct Extent {
    glm::dvec2 low{1e300}, high{-1e300};
    double size() const { return std::max(high.x - low.x, high.y - low.y); }
};
Extent extentOf(const std::vector<glm::dvec2>& corners) {
    Extent extent;
    for (const glm::dvec2& corner : corners) {
        extent.low = glm::min(extent.low, corner);
        extent.high = glm::max(extent.high, corner);
    }
    return extent;
}

double distanceToLine(const glm::dvec2& point, const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 along = to - from, there = point - from;
    const double square = glm::dot(along, along);
    const double part = square > 0 ? std::clamp(glm::dot(there, along) / square, 0.0, 1.0) : 0;
    return glm::length(there - part * along);
}

bool liesOnALine(const std::vector<glm::dvec2>& corners) {
    std::size_t far = 0;
    for (std::size_t k = 1; k < corners.size(); ++k)
        if (glm::distance(corners[k], corners[0]) > glm::distance(corners[far], corners[0]))
            far = k;
    const glm::dvec2 along = corners[far] - corners[0];
    const double square = glm::dot(along, along);
    return std::none_of(corners.begin(), corners.end(), [&](const glm::dvec2& corner) {
        const glm::dvec2 there = corner - corners[0];
        return std::abs(along.x * there.y - along.y * there.x) > kFlat * square;
    });
}

}  // namespace

bool isOutline(std::string_view text) {
    const std::size_t first = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    return text.substr(first).starts_with(kWord.substr(0, kWord.size() - 1));
}

Expected<std::vector<glm::dvec2>> parseOutline(std::string_view text) {
    const auto fault = [](const std::string& what) {
        return Status::data("polygon(x1, y1, x2, y2, …): " + what);
    };
    if (text.size() > kText) return fault("the text is too long");
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
        return fault("a bracket is missing");
    if (text.find_first_not_of(" \t\r\n", close + 1) != std::string_view::npos)
        return fault("nothing may follow the bracket: an outline stands alone");
    const Expected<Json> list =
        parseJson("[" + std::string(text.substr(open + 1, close - open - 1)) + "]");
    if (!list) return fault("numbers with commas between them are expected");
    std::vector<double> numbers;
    for (const Json& item : *list) {
        const double number = item.is_number() ? item.get<double>() : NAN;
        if (!(std::abs(number) <= kLargestOutline))
            return fault("item " + std::to_string(numbers.size() + 1) +
                         " is no number of at most " + formatNumber(kLargestOutline));
        numbers.push_back(number);
    }
    if (numbers.size() % 2 != 0) return fault("x and y of every corner are expected");
    if (numbers.size() < 6 || numbers.size() > 2 * kMostOutlineCorners)
        return fault("3 to " + std::to_string(kMostOutlineCorners) + " corners are expected, not " +
                     std::to_string(numbers.size() / 2));
    std::vector<glm::dvec2> corners;
    for (std::size_t k = 0; k < numbers.size(); k += 2)
        corners.emplace_back(numbers[k], numbers[k + 1]);
    if (liesOnALine(corners)) return fault("the corners lie on one line and enclose nothing");
    return corners;
}

std::string printOutline(const std::vector<glm::dvec2>& corners) {
    // A power of ten, so that rounded numbers are short.
    const double size = std::max(extentOf(corners).size(), 1e-9);
    double unit = 1;
    while (unit > size / kParts) unit /= 10;
    while (unit * 10 <= size / kParts) unit *= 10;
    std::string text(kWord);
    const char* separator = "";
    for (const glm::dvec2& corner : corners)
        for (double value : {corner.x, corner.y}) {
            text += separator + formatNumber(std::round(value / unit) * unit, 8);
            separator = ", ";
        }
    return text + ")";
}

std::vector<glm::dvec2> simplifyOutline(const std::vector<glm::dvec2>& corners, double tolerance) {
    if (corners.size() < 3) return corners;
    std::vector<bool> stays(corners.size(), false);
    stays.front() = stays.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, corners.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        std::size_t far = first;
        double most = tolerance;
        for (std::size_t k = first + 1; k < last; ++k) {
            const double away = distanceToLine(corners[k], corners[first], corners[last]);
            if (away > most) most = away, far = k;
        }
        if (far == first) continue;
        stays[far] = true;
        open.emplace_back(first, far);
        open.emplace_back(far, last);
    }
    std::vector<glm::dvec2> fewer;
    for (std::size_t k = 0; k < corners.size(); ++k)
        if (stays[k]) fewer.push_back(corners[k]);
    return fewer;
}

Expected<std::vector<glm::dvec2>> aroundOrigin(std::vector<glm::dvec2> corners, Job& job) {
    constexpr int kNodes = 96;
    const Expected<Grid> grid = outlineDistance(corners, kNodes, job);
    if (!grid) return grid.status();
    const double here = sampling::gridValue(*grid, Outside::distance, 0.0, 0.0, 0.0);
    const auto least = std::min_element(grid->values.begin(), grid->values.end());
    const auto at = static_cast<int>(least - grid->values.begin());
    const double cell = (grid->maximum.x - grid->minimum.x) / (grid->resolution.x - 1);
    const glm::dvec2 deepest(grid->minimum.x + cell * (at % grid->resolution.x),
                             grid->minimum.y + cell * (at / grid->resolution.x));
    // Half as deep as may be is well inside.
    const glm::dvec2 by = here < 0.5 * *least ? glm::dvec2(0) : deepest;
    const double size = extentOf(corners).size();
    const double scale = size < kLeastSize || size > kMostSize ? kUsualSize / size : 1;
    for (glm::dvec2& corner : corners) corner = scale * (corner - by);
    return corners;
}

Expected<Grid> outlineDistance(const std::vector<glm::dvec2>& corners, int nodes, Job& job) {
    const Extent extent = extentOf(corners);
    const glm::dvec2 low = extent.low - kFree * extent.size();
    const glm::dvec2 high = extent.high + kFree * extent.size();
    const double cell = std::max(high.x - low.x, high.y - low.y) / (nodes - 1);
    PolygonDistanceOptions options{.rule = FillRule::nonzero, .minimum = low, .maximum = high};
    // Cells are squares, as nearly as whole numbers of them allow.
    options.width = static_cast<int>(std::lround((high.x - low.x) / cell)) + 1;
    options.height = static_cast<int>(std::lround((high.y - low.y) / cell)) + 1;
    Expected<Grid> grid = polygonDistance({{corners}}, options, job);
    if (!grid) return grid.status();
    if (std::none_of(grid->values.begin(), grid->values.end(), [](double v) { return v < 0; }))
        return Status::data(
            "polygon(…): the outline is so thin that no node of its grid lies inside; draw it "
            "wider, or raise shape.resolution");
    return grid;
}

}  // namespace versorium
