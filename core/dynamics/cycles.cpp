// SPDX-License-Identifier: MIT
#include "dynamics/cycles.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace versorium {
namespace {

constexpr int kNewtonSteps = 60;
constexpr double kConverged = 1e-13;  // of a Newton step, relative
constexpr double kSame = 1e-7;        // points nearer than this, relative, are one
// At a bifurcation the equation has a multiple root, which double precision tells apart from its
// neighbours only so far.
constexpr double kSameAtBifurcation = 1e-4;
constexpr double kBifurcation = 1e-7;  // of det(J - 1)
constexpr double kNeutral = 1e-7;

double scaleOf(const PlanePoint& p) { return 1 + std::abs(p[0]) + std::abs(p[1]); }
double sumOfDistances(const PlanePoint& a, const PlanePoint& b) {
    return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]);
}

// fⁿ(x), and its Jacobian as a 2 by 2 matrix (on the line with nothing but 0 in y).
PlanePoint iterate(const System& system, int n, PlanePoint at, double* jacobian) {
    double j[4] = {};
    system.iterateWithJacobian(n, at.data(), j);
    if (system.dimension() == 1) {
        jacobian[0] = j[0];
        jacobian[1] = jacobian[2] = jacobian[3] = 0;
    } else {
        std::copy(j, j + 4, jacobian);
    }
    return at;
}

// One Newton step for fⁿ(x) = x from `at`; false where it is not defined.
bool newtonStep(const System& system, int n, const PlanePoint& at, PlanePoint& step) {
    double j[4];
    const PlanePoint image = iterate(system, n, at, j);
    const double x = image[0] - at[0], y = image[1] - at[1];
    const double a = j[0] - 1, b = j[1], c = j[2], d = j[3] - 1;
    const double determinant = a * d - b * c;
    step = {(b * y - d * x) / determinant, (c * x - a * y) / determinant};
    if (x == 0 && y == 0) step = {0, 0};
    return std::isfinite(step[0]) && std::isfinite(step[1]);
}

bool solve(const System& system, int n, PlanePoint start, double reach, PlanePoint& found) {
    PlanePoint at = start;
    double last = HUGE_VAL;
    for (int i = 0; i < kNewtonSteps; ++i) {
        PlanePoint step;
        if (!newtonStep(system, n, at, step)) return false;
        double size = std::abs(step[0]) + std::abs(step[1]);
        // A step that leaves the neighbourhood says only in which direction to go.
        const double share = size > reach ? reach / size : 1;
        at = {at[0] + share * step[0], at[1] + share * step[1]};
        if (std::abs(at[0]) + std::abs(at[1]) > 1e6) return false;
        last = size;
        if (size <= kConverged * scaleOf(at)) break;
    }
    // A multiple root is come to by halves, down to the square root of the rounding.
    found = at;
    return last <= 1e-6 * scaleOf(at);
}

// Whether a root of fⁿ(x) = x is one: at a multiple root steps are noise, and then the value
// counts.
bool isRoot(const System& system, int n, const PlanePoint& at) {
    PlanePoint step;
    if (!newtonStep(system, n, at, step)) return false;
    if (std::abs(step[0]) + std::abs(step[1]) <= 1e-10 * scaleOf(at)) return true;
    double j[4];
    return sumOfDistances(iterate(system, n, at, j), at) <= 1e-13 * scaleOf(at);
}

void setEigenvalues(const System& system, const double* j, PeriodicCycle& cycle) {
    if (system.dimension() == 1) {
        cycle.eigenvalues = {j[0]};
        cycle.multiplier = j[0];
        return;
    }
    const double middle = 0.5 * (j[0] + j[3]), half = 0.5 * (j[0] - j[3]);
    const double discriminant = half * half + j[1] * j[2];
    if (discriminant >= 0) {
        // The larger one first; the other from the product, which loses no digits.
        const double large =
            middle + (middle < 0 ? -std::sqrt(discriminant) : std::sqrt(discriminant));
        const double determinant = j[0] * j[3] - j[1] * j[2];
        cycle.eigenvalues = {large, large == 0 ? 0.0 : determinant / large};
    } else {
        const double imaginary = std::sqrt(-discriminant);
        cycle.eigenvalues = {{middle, imaginary}, {middle, -imaginary}};
    }
    if (system.map().info.algebra != Algebra::complex) return;
    const double tolerance = 1e-9 * (1e-3 + std::abs(j[0]) + std::abs(j[2]));
    if (std::abs(j[3] - j[0]) <= tolerance && std::abs(j[1] + j[2]) <= tolerance)
        cycle.multiplier = std::complex<double>(j[0], j[2]);
}

double squaredModulus(const std::complex<double>& a) {
    return a.real() * a.real() + a.imag() * a.imag();
}

void setKind(PeriodicCycle& cycle) {
    bool inside = false, outside = false, neutral = false;
    for (const auto& value : cycle.eigenvalues) {
        const double modulus = std::sqrt(squaredModulus(value));
        neutral = neutral || std::abs(modulus - 1) <= kNeutral;
        inside = inside || modulus < 1;
        outside = outside || !(modulus < 1);
    }
    cycle.kind = neutral             ? CycleKind::neutral
                 : inside && outside ? CycleKind::saddle
                 : inside            ? CycleKind::attracting
                                     : CycleKind::repelling;
}

// For orders that rounding must not disturb.
bool before(const PlanePoint& a, const PlanePoint& b) {
    const auto cell = [](double value) { return std::floor(value * 1e8 + 0.5); };
    return cell(a[0]) != cell(b[0]) ? a[0] < b[0] : cell(a[1]) < cell(b[1]);
}

class Collector {
  public:
    Collector(const System& system, const Window& window, const CycleOptions& options)
        : system_(system), window_(window.grown(1e-9)), options_(options) {}

    void add(const PlanePoint& point, int period) {
        if (search_.cut || known(point, kSame)) return;
        PeriodicCycle cycle = cycleThrough(system_, point.data(), period);
        double j[4];
        iterate(system_, cycle.period, cycle.points[0], j);
        const double determinant = (j[0] - 1) * (j[3] - 1) - j[1] * j[2];
        if (known(cycle.points[0],
                  std::abs(determinant) < kBifurcation ? kSameAtBifurcation : kSame))
            return;
        const bool seen =
            std::any_of(cycle.points.begin(), cycle.points.end(), [&](const PlanePoint& p) {
                return system_.dimension() == 1 ? p[0] >= window_.left && p[0] <= window_.right
                                                : window_.contains(p[0], p[1]);
            });
        if (!seen) return;
        if (search_.cycles.size() >= static_cast<std::size_t>(options_.mostCycles)) {
            search_.cut = true;
            return;
        }
        for (const PlanePoint& known : cycle.points) byX_.emplace(known[0], known[1]);
        search_.cycles.push_back(std::move(cycle));
    }
    CycleSearch take() {
        std::sort(search_.cycles.begin(), search_.cycles.end(),
                  [](const PeriodicCycle& a, const PeriodicCycle& b) {
                      return a.period != b.period ? a.period < b.period
                                                  : before(a.points[0], b.points[0]);
                  });
        return std::move(search_);
    }

  private:
    bool known(const PlanePoint& point, double tolerance) const {
        const double near = tolerance * scaleOf(point);
        for (auto other = byX_.lower_bound(point[0] - near);
             other != byX_.end() && other->first <= point[0] + near; ++other)
            if (sumOfDistances({other->first, other->second}, point) < near) return true;
        return false;
    }

    const System& system_;
    Window window_;
    const CycleOptions& options_;
    CycleSearch search_;
    std::multimap<double, double> byX_;  // all points of the cycles
};

int startsAcross(const System& system, const CycleOptions& options, int period) {
    if (options.across > 0) return options.across;
    return system.dimension() == 1 ? std::min(200 + 60 * period, kMostStartsAcross)
                                   : std::min(20 + 4 * period, 96);
}

}  // namespace

const char* wordOf(CycleKind kind) {
    switch (kind) {
        case CycleKind::attracting:
            return "attracting";
        case CycleKind::repelling:
            return "repelling";
        case CycleKind::saddle:
            return "saddle";
        default:
            return "neutral";
    }
}

PeriodicCycle cycleThrough(const System& system, const double* point, int period) {
    PeriodicCycle cycle;
    PlanePoint at{point[0], system.dimension() == 1 ? 0.0 : point[1]};
    const PlanePoint start = at;
    cycle.period = period;
    for (int n = 1; n < period; ++n) {
        system.step(at.data());
        if (period % n == 0 && sumOfDistances(at, start) < kSame * scaleOf(start)) {
            cycle.period = n;
            break;
        }
    }
    at = start;
    for (int n = 0; n < cycle.period; ++n) {
        // Rounding grows along a repelling cycle: each point is solved for by itself.
        PlanePoint step;
        if (newtonStep(system, cycle.period, at, step) &&
            std::abs(step[0]) + std::abs(step[1]) < kSame * scaleOf(at))
            at = {at[0] + step[0], at[1] + step[1]};
        cycle.points.push_back(at);
        system.step(at.data());
    }
    std::rotate(cycle.points.begin(),
                std::min_element(cycle.points.begin(), cycle.points.end(), before),
                cycle.points.end());
    double j[4];
    iterate(system, cycle.period, cycle.points[0], j);
    setEigenvalues(system, j, cycle);
    setKind(cycle);
    return cycle;
}

Expected<CycleSearch> findCycles(const System& system, const Window& window,
                                 const CycleOptions& options, Job& job) {
    if (system.dimension() > 2)
        return Status::usage("cycles are sought on the line and in the plane; the map \"" +
                             std::string(system.map().info.name) + "\" has points of " +
                             std::to_string(system.dimension()) + " numbers");
    if (options.maxPeriod < 1 || options.maxPeriod > kMostPeriod)
        return Status::usage("the period must be 1 to " + std::to_string(kMostPeriod));
    if (options.across < 0 || options.across > kMostStartsAcross || options.mostCycles < 1)
        return Status::usage("at most " + std::to_string(kMostStartsAcross) +
                             " starts along each side are possible");
    if (Status status = checkWindow(window, system.dimension()); !status.ok()) return status;

    struct Row {
        int period, row;
        std::vector<PlanePoint> found;
    };
    std::vector<Row> rows;
    for (int period = 1; period <= options.maxPeriod; ++period) {
        const int count = system.dimension() == 1 ? 1 : startsAcross(system, options, period);
        for (int row = 0; row < count; ++row) rows.push_back({period, row, {}});
    }
    const double reach =
        0.5 * std::max(window.width(), system.dimension() == 1 ? 0.0 : window.height());
    const bool finished = job.parallelFor(rows.size(), [&](std::size_t index) {
        Row& row = rows[index];
        const int across = startsAcross(system, options, row.period);
        for (int i = 0; i < across; ++i) {
            if (job.cancelled()) return;
            // A little off the middle of each cell: symmetric maps have no slope on their axes.
            PlanePoint start{window.left + window.width() * (i + 0.5137) / across, 0};
            if (system.dimension() == 2)
                start[1] = window.bottom + window.height() * (row.row + 0.4871) / across;
            PlanePoint found;
            if (!solve(system, row.period, start, reach, found) ||
                !isRoot(system, row.period, found))
                continue;
            const bool known =
                std::any_of(row.found.begin(), row.found.end(), [&](const PlanePoint& other) {
                    return sumOfDistances(other, found) < kSame * scaleOf(found);
                });
            if (!known) row.found.push_back(found);
        }
    });
    if (!finished || job.cancelled()) return Status::cancelled();
    Collector collector(system, window, options);
    for (const Row& row : rows) {
        if (job.cancelled()) return Status::cancelled();
        for (const PlanePoint& point : row.found) collector.add(point, row.period);
    }
    return collector.take();
}

}  // namespace versorium
