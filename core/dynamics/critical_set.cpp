// SPDX-License-Identifier: MIT
#include "dynamics/critical_set.h"

#include <algorithm>
#include <cmath>

#include "dynamics/planar_system.h"
#include "maps/critical.h"

namespace versorium {
namespace {

constexpr int kMostPoints = 64;
constexpr int kBisections = 40;

// Values of det J at the nodes of a grid, and the vertices of its zero set on the grid's edges.
class Squares {
  public:
    Squares(const System& system, const Window& window, int across)
        : system_(system), window_(window) {
        const double cell = std::max(window.width(), window.height()) / across;
        const auto cells = [&](double side) {
            return std::max(2, static_cast<int>(std::ceil(side / cell - 1e-9)));
        };
        columns_ = cells(window.width()) + 1;
        rows_ = cells(window.height()) + 1;
    }

    bool measure(Job& job) {
        values_.assign(count(), 0.0);
        return job.parallelFor(static_cast<std::size_t>(rows_), [&](std::size_t row) {
            for (int i = 0; i < columns_; ++i) {
                const PlanePoint at = node(i, static_cast<int>(row));
                values_[index(i, static_cast<int>(row))] = system_.determinant(at.data());
            }
        });
    }

    std::vector<Polyline> trace() {
        vertexAt_.assign(2 * count(), -1);
        for (int j = 0; j + 1 < rows_; ++j)
            for (int i = 0; i + 1 < columns_; ++i) cell(i, j);
        std::vector<Polyline> lines;
        std::vector<char> used(vertices_.size(), 0);
        // Open lines first, from their ends; what is left is closed.
        for (const bool open : {true, false})
            for (std::size_t start = 0; start < vertices_.size(); ++start)
                if (!used[start] && (!open || links_[start][1] < 0))
                    lines.push_back(follow(start, used));
        return lines;
    }

  private:
    std::size_t count() const {
        return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    }
    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(i);
    }
    PlanePoint node(int i, int j) const {
        return {window_.left + window_.width() * i / (columns_ - 1),
                window_.bottom + window_.height() * j / (rows_ - 1)};
    }
    bool negative(int i, int j) const { return values_[index(i, j)] < 0; }

    // The vertex on the edge from node (i, j) to the right, or upwards.
    int vertex(int i, int j, bool up) {
        int& known = vertexAt_[2 * index(i, j) + (up ? 1 : 0)];
        if (known >= 0) return known;
        PlanePoint a = node(i, j), b = up ? node(i, j + 1) : node(i + 1, j);
        if (!negative(i, j)) std::swap(a, b);
        // a lies on the negative side, b on the other.
        PlanePoint middle = a;
        for (int k = 0; k < kBisections; ++k) {
            middle = {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
            (system_.determinant(middle.data()) < 0 ? a : b) = middle;
        }
        known = static_cast<int>(vertices_.size());
        vertices_.push_back(middle);
        links_.push_back({-1, -1});
        return known;
    }
    void link(int a, int b) {
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
            auto& links = links_[static_cast<std::size_t>(from)];
            (links[0] < 0 ? links[0] : links[1]) = to;
        }
    }
    void cell(int i, int j) {
        const bool corner[4] = {negative(i, j), negative(i + 1, j), negative(i + 1, j + 1),
                                negative(i, j + 1)};
        // Edges in order round the cell: bottom, right, top, left.
        int crossing[4], crossings = 0;
        for (int k = 0; k < 4; ++k) {
            if (corner[k] == corner[(k + 1) % 4]) continue;
            crossing[crossings++] = k == 0   ? vertex(i, j, false)
                                    : k == 1 ? vertex(i + 1, j, true)
                                    : k == 2 ? vertex(i, j + 1, false)
                                             : vertex(i, j, true);
        }
        if (crossings == 2) link(crossing[0], crossing[1]);
        if (crossings != 4) return;
        // Two lines: the middle says which corners are joined.
        const PlanePoint low = node(i, j), high = node(i + 1, j + 1);
        const PlanePoint middle{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
        const bool joined = (system_.determinant(middle.data()) < 0) == corner[0];
        link(crossing[0], crossing[joined ? 1 : 3]);
        link(crossing[2], crossing[joined ? 3 : 1]);
    }
    Polyline follow(std::size_t start, std::vector<char>& used) const {
        Polyline line;
        int at = static_cast<int>(start), from = -1;
        while (at >= 0 && !used[static_cast<std::size_t>(at)]) {
            used[static_cast<std::size_t>(at)] = 1;
            line.push_back(vertices_[static_cast<std::size_t>(at)]);
            const auto& links = links_[static_cast<std::size_t>(at)];
            const int next = links[0] != from ? links[0] : links[1];
            from = at;
            at = next;
        }
        if (at == static_cast<int>(start) && line.size() > 2) line.push_back(line.front());
        return line;
    }

    const System& system_;
    Window window_;
    int columns_ = 0, rows_ = 0;
    std::vector<double> values_;
    std::vector<int> vertexAt_;
    std::vector<PlanePoint> vertices_;
    std::vector<std::array<int, 2>> links_;
};

PlanePoint nearestOn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p) {
    const double x = b[0] - a[0], y = b[1] - a[1];
    const double square = x * x + y * y;
    const double t =
        square > 0 ? std::clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / square, 0.0, 1.0) : 0.0;
    return {a[0] + t * x, a[1] + t * y};
}

// Newton's method along the gradient of det J, which differences give well enough to converge.
PlanePoint ontoZero(const System& system, PlanePoint at, double reach) {
    const PlanePoint start = at;
    const double h = 1e-6 * (1 + std::abs(at[0]) + std::abs(at[1]));
    const auto value = [&](double x, double y) {
        return system.determinant(PlanePoint{x, y}.data());
    };
    for (int i = 0; i < 12; ++i) {
        const double here = value(at[0], at[1]);
        const double x = (value(at[0] + h, at[1]) - value(at[0] - h, at[1])) / (2 * h);
        const double y = (value(at[0], at[1] + h) - value(at[0], at[1] - h)) / (2 * h);
        const double square = x * x + y * y;
        if (here == 0 || !(square > 0)) break;
        at = {at[0] - here * x / square, at[1] - here * y / square};
        if (!(distance(at, start) <= reach)) return start;
    }
    const double before = std::abs(value(start[0], start[1]));
    return std::abs(value(at[0], at[1])) <= before ? at : start;
}

}  // namespace

std::vector<PlanePoint> criticalPointsOf(const System& system) {
    std::vector<PlanePoint> points;
    if (system.map().info.planarCoefficients) {
        auto polynomial = complexPolynomialOf(system.parameters());
        if (!polynomial) polynomial = complexPolynomialOf(conjugateOf(system.parameters()));
        if (polynomial) {
            for (const auto& z : criticalPointsOf(*polynomial))
                points.push_back({z.real(), z.imag()});
            return points;
        }
    }
    for (int k = 0; k < kMostPoints && system.dimension() <= 2; ++k) {
        PlanePoint at{0, 0};
        if (!criticalPoint(system.map(), k, system.parameters().data(), system.environment(),
                           at.data()))
            break;
        const bool known = std::any_of(points.begin(), points.end(), [&](const PlanePoint& other) {
            return distance(other, at) < 1e-7;
        });
        if (!known) points.push_back(at);
    }
    return points;
}

Expected<CriticalSet> criticalSet(const System& system, const Window& window,
                                  const CriticalSetOptions& options, Job& job) {
    if (system.dimension() != 2)
        return Status::usage("the critical set is drawn for maps of the plane; the map \"" +
                             std::string(system.map().info.name) + "\" has points of " +
                             std::to_string(system.dimension()) + " numbers");
    if (options.across < 8 || options.across > 2048)
        return Status::usage("the grid of the critical set has 8 to 2048 cells across");
    if (Status status = checkWindow(window, 2); !status.ok()) return status;
    const double ratio = window.width() / window.height();
    if (!(ratio > 1e-3 && ratio < 1e3))
        return Status::usage("the window is more than a thousand times as long as it is wide");
    Squares squares(system, window, options.across);
    if (!squares.measure(job)) return Status::cancelled();
    CriticalSet set;
    set.curves = squares.trace();
    for (const PlanePoint& at : criticalPointsOf(system)) {
        double j[4];
        PlanePoint image = at;
        system.stepWithJacobian(image.data(), j);
        const double size = std::abs(j[0]) + std::abs(j[1]) + std::abs(j[2]) + std::abs(j[3]);
        if (size < 1e-6 && window.contains(at[0], at[1])) set.points.push_back(at);
    }
    return set;
}

std::optional<PlanePoint> nearestCriticalPoint(const System& system, const CriticalSet& set,
                                               PlanePoint point) {
    std::optional<PlanePoint> best;
    double least = HUGE_VAL, reach = 0;
    bool onCurve = false;
    for (const PlanePoint& isolated : set.points)
        if (const double d = distance(isolated, point); d < least) least = d, best = isolated;
    for (const Polyline& line : set.curves)
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const PlanePoint at = nearestOn(line[i], line[i + 1], point);
            const double d = distance(at, point);
            if (d >= least) continue;
            least = d, best = at, onCurve = true;
            reach = distance(line[i], line[i + 1]);
        }
    if (best && onCurve) best = ontoZero(system, *best, reach);
    return best;
}

}  // namespace versorium
