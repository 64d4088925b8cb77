// SPDX-License-Identifier: MIT
#include "geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace versorium {
namespace {

using Corners = std::span<const std::uint32_t>;

// Work that may be spent on one list, in looks at a corner or a cell: enough for every list of
// 100 000 corners that was tried and does not cross itself, and some two seconds at most.
constexpr std::size_t kLooks = std::size_t{1} << 28;

// Twice the vector area.
glm::dvec3 newellNormal(Corners corners, const Mesh& mesh) {
    glm::dvec3 normal(0.0);
    const glm::dvec3 origin = mesh.vertices[corners[0]];
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        normal +=
            glm::cross(mesh.vertices[corners[i]] - origin, mesh.vertices[corners[i + 1]] - origin);
    return normal;
}

// Whether every triangle of the fan about the first corner faces the polygon's way.
bool isFan(Corners corners, const Mesh& mesh, const glm::dvec3& normal) {
    const glm::dvec3 origin = mesh.vertices[corners[0]];
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::dvec3 area =
            glm::cross(mesh.vertices[corners[i]] - origin, mesh.vertices[corners[i + 1]] - origin);
        if (!(glm::dot(area, normal) > 0)) return false;
    }
    return true;
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The corners that may lie in an ear: those where the polygon does not turn left, by place.
class CornerGrid {
  public:
    CornerGrid(const std::vector<glm::dvec2>& places, const std::vector<std::uint32_t>& members)
        : places_(places) {
        low_ = high_ = places[0];
        for (const glm::dvec2& place : places)
            for (int k = 0; k < 2; ++k) {
                low_[k] = std::min(low_[k], place[k]);
                high_[k] = std::max(high_[k], place[k]);
            }
        const glm::dvec2 size = high_ - low_;
        const double area = size.x * size.y;
        const double side =
            area > 0 ? std::sqrt(area / static_cast<double>(members.size() + 1)) : 0;
        for (int k = 0; k < 2; ++k)
            count_[k] = side > 0 ? static_cast<int>(std::clamp(size[k] / side, 1.0, 4096.0)) : 1;
        cells_.resize(static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]));
        for (const std::uint32_t member : members) cells_[cellOf(places[member])].push_back(member);
    }

    void remove(std::uint32_t member) {
        std::vector<std::uint32_t>& cell = cells_[cellOf(places_[member])];
        const auto found = std::find(cell.begin(), cell.end(), member);
        if (found == cell.end()) return;
        *found = cell.back();
        cell.pop_back();
    }

    // Calls `blocks(member)` for those in the box until it is true; counts what was looked at.
    template <class Blocks>
    bool any(const glm::dvec2& low, const glm::dvec2& high, std::size_t& looks, Blocks blocks) {
        const int left = along(low, 0), right = along(high, 0), top = along(high, 1);
        for (int y = along(low, 1); y <= top; ++y)
            for (int x = left; x <= right; ++x) {
                ++looks;
                for (const std::uint32_t member : cells_[cellAt(x, y)]) {
                    ++looks;
                    const glm::dvec2& place = places_[member];
                    if (place.x >= low.x && place.x <= high.x && place.y >= low.y &&
                        place.y <= high.y && blocks(member))
                        return true;
                }
            }
        return false;
    }

  private:
    int along(const glm::dvec2& place, int axis) const {
        const double size = high_[axis] - low_[axis];
        const double share = size > 0 ? (place[axis] - low_[axis]) / size : 0;
        return static_cast<int>(
            std::clamp(share * count_[axis], 0.0, static_cast<double>(count_[axis] - 1)));
    }
    std::size_t cellAt(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(count_[0]) +
               static_cast<std::size_t>(x);
    }
    std::size_t cellOf(const glm::dvec2& place) const {
        return cellAt(along(place, 0), along(place, 1));
    }

    const std::vector<glm::dvec2>& places_;
    glm::dvec2 low_{}, high_{};
    int count_[2] = {1, 1};
    std::vector<std::vector<std::uint32_t>> cells_;
};

// What a corner must be to be cut off. When none is that, the next is tried: only lists that touch
// or cross themselves come so far.
enum class Ear { empty, nearlyEmpty, convex, any };

class EarClipper {
  public:
    EarClipper(Corners corners, const Mesh& mesh, const glm::dvec3& normal)
        : corners_(corners.begin(), corners.end()), places_(placesOf(corners, mesh, normal)) {
        const std::size_t count = corners.size();
        next_.resize(count);
        before_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            next_[i] = static_cast<std::uint32_t>((i + 1) % count);
            before_[i] = static_cast<std::uint32_t>((i + count - 1) % count);
        }
        hollow_.resize(count);
        std::vector<std::uint32_t> members;
        for (std::uint32_t i = 0; i < count; ++i) {
            hollow_[i] = !(turnAt(i) > 0);
            if (hollow_[i]) members.push_back(i);
        }
        grid_.emplace_back(places_, members);
    }

    void run(Mesh& mesh) {
        std::size_t left = corners_.size(), failed = 0;
        std::uint32_t at = 0;
        Ear wanted = Ear::empty;
        while (left > 3) {
            if (looks_ > kLooks) wanted = Ear::any;
            if (isEar(at, wanted)) {
                at = cut(at, mesh);
                --left;
                failed = 0;
                wanted = Ear::empty;
                continue;
            }
            at = next_[at];
            ++looks_;
            if (++failed < left) continue;
            failed = 0;
            wanted = static_cast<Ear>(static_cast<int>(wanted) + 1);
        }
        mesh.triangles.push_back({corners_[before_[at]], corners_[at], corners_[next_[at]]});
    }

  private:
    // Without the coordinate along which the normal is longest, so that the polygon turns left.
    static std::vector<glm::dvec2> placesOf(Corners corners, const Mesh& mesh,
                                            const glm::dvec3& normal) {
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
        const int u = normal[axis] > 0 ? (axis + 1) % 3 : (axis + 2) % 3;
        const int v = 3 - axis - u;
        std::vector<glm::dvec2> places;
        places.reserve(corners.size());
        for (const std::uint32_t corner : corners)
            places.emplace_back(mesh.vertices[corner][u], mesh.vertices[corner][v]);
        return places;
    }

    double turnAt(std::uint32_t i) const {
        return turn(places_[before_[i]], places_[i], places_[next_[i]]);
    }

    bool isEar(std::uint32_t i, Ear wanted) {
        if (wanted == Ear::any) return true;
        if (!(turnAt(i) > 0)) return false;
        if (wanted == Ear::convex) return true;
        const std::uint32_t ends[3] = {before_[i], i, next_[i]};
        const glm::dvec2 &a = places_[ends[0]], &b = places_[i], &c = places_[ends[2]];
        const glm::dvec2 low(std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}));
        const glm::dvec2 high(std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}));
        return !grid_[0].any(low, high, looks_, [&](std::uint32_t member) {
            return member != ends[0] && member != i && member != ends[2] &&
                   blocks(member, a, b, c, wanted);
        });
    }

    bool blocks(std::uint32_t member, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                Ear wanted) const {
        const glm::dvec2& p = places_[member];
        const double ab = turn(a, b, p), bc = turn(b, c, p), ca = turn(c, a, p);
        if (wanted == Ear::nearlyEmpty) return ab > 0 && bc > 0 && ca > 0;
        if (!(ab >= 0 && bc >= 0 && ca >= 0)) return false;
        // A corner of the ear that the list passes again lies in its way only where it leads in.
        if (p == a) return leadsBetween(member, b, c);
        if (p == b) return leadsBetween(member, c, a);
        if (p == c) return leadsBetween(member, a, b);
        return true;
    }
    // Whether a side at the member leaves between the directions to `from` and to `to`.
    bool leadsBetween(std::uint32_t member, const glm::dvec2& from, const glm::dvec2& to) const {
        const glm::dvec2& p = places_[member];
        for (const std::uint32_t other : {before_[member], next_[member]})
            if (turn(p, from, places_[other]) > 0 && turn(p, places_[other], to) > 0) return true;
        return false;
    }

    // Gives where to go on: two corners further, so that ears do not make a fan of slivers.
    std::uint32_t cut(std::uint32_t i, Mesh& mesh) {
        const std::uint32_t before = before_[i], next = next_[i];
        mesh.triangles.push_back({corners_[before], corners_[i], corners_[next]});
        next_[before] = next;
        before_[next] = before;
        if (hollow_[i]) grid_[0].remove(i);
        for (const std::uint32_t k : {before, next})
            if (hollow_[k] && turnAt(k) > 0) {
                hollow_[k] = false;
                grid_[0].remove(k);
            }
        return next_[next];
    }

    std::vector<std::uint32_t> corners_;
    std::vector<glm::dvec2> places_;
    std::vector<std::uint32_t> next_, before_;
    std::vector<char> hollow_;
    std::vector<CornerGrid> grid_;  // one, made when all corners are known
    std::size_t looks_ = 0;
};

}  // namespace

void appendPolygon(std::span<const std::uint32_t> given, Mesh& mesh) {
    std::vector<std::uint32_t> corners;
    corners.reserve(given.size());
    for (const std::uint32_t corner : given)
        if (corners.empty() || corner != corners.back()) corners.push_back(corner);
    while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    if (corners.size() < 3) return;
    const glm::dvec3 normal = newellNormal(corners, mesh);
    const bool flat = !(glm::dot(normal, normal) > 0);
    if (corners.size() > 3 && !flat && !isFan(corners, mesh, normal)) {
        EarClipper(corners, mesh, normal).run(mesh);
        return;
    }
    for (std::size_t i = 2; i < corners.size(); ++i)
        mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

}  // namespace versorium
