// SPDX-License-Identifier: MIT
#include "dynamics/manifolds.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "geometry/clip.h"
#include "math/elementary.h"

namespace versorium {
namespace {

constexpr double kSeed = 1e-6;  // length of the first segment, in heights of the window
constexpr double kFar = 1e4;    // heights of the window: what is further out counts as infinity
constexpr double kMostAhead = 1.0 / 8;  // of the curve's parameter, between two points
constexpr double kLeastAhead = 1e-9;
constexpr int kMostImages = 400;  // fundamental segments
constexpr double kIdle = 3;       // of them without a point in the window end a branch
constexpr int kInverseSteps = 30;

// The part of a segment inside the window; false when there is none. An end that lies inside keeps
// its bits.
bool clip(const Window& w, PlanePoint& a, PlanePoint& b) {
    const auto part = clipSegment(a, b, {w.left, w.bottom}, {w.right, w.top});
    if (!part) return false;
    const PlanePoint start = a;
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    if (part->to < 1) b = {start[0] + part->to * dx, start[1] + part->to * dy};
    if (part->from > 0) a = {start[0] + part->from * dx, start[1] + part->from * dy};
    return true;
}

// A direction in which the matrix stretches by `value`.
PlanePoint eigenvector(const double* j, double value) {
    const PlanePoint one{j[1], value - j[0]}, other{value - j[3], j[2]};
    const double a = distance(one, {0, 0}), b = distance(other, {0, 0});
    if (a == 0 && b == 0) return {1, 0};
    const PlanePoint& v = a >= b ? one : other;
    const double size = std::max(a, b);
    return {v[0] / size, v[1] / size};
}

// One branch as a curve t -> G^k(q ± ε Λ^u v), t = k + u, where G is the map (or its inverse) taken
// as often as brings the branch back to itself, and Λ is how far G stretches along v.
struct Branch {
    PlanePoint origin, direction;  // v, with its side as sign
    double stretch;
    int steps;  // of the map in G
    PlanePoint seed(double u, double size) const {
        const double factor = size * exp(u * log(stretch));
        return {origin[0] + factor * direction[0], origin[1] + factor * direction[1]};
    }
};

class Forward {
  public:
    Forward(const System& system, const Branch& branch, double seed, double far)
        : system_(system), branch_(branch), seed_(seed), far_(far) {}

    // False where the curve is far out.
    bool at(int k, double u, PlanePoint& point) {
        point = branch_.seed(u, seed_);
        for (int i = 0; i < k * branch_.steps; ++i) {
            system_.step(point.data());
            if (!(std::abs(point[0]) + std::abs(point[1]) < far_)) return false;
        }
        return true;
    }

  private:
    const System& system_;
    const Branch& branch_;
    double seed_, far_;
};

class Backward {
  public:
    // `before[i]` is the cycle's point that the map takes to the one that the i-th inverse step
    // starts next to.
    Backward(const System& system, const Branch& branch, double seed, double far,
             std::vector<PlanePoint> before)
        : system_(system), branch_(branch), seed_(seed), far_(far), before_(std::move(before)) {}

    bool at(int k, double u, PlanePoint& point) {
        // The neighbouring point's preimages are the guesses; with every fundamental segment there
        // are `steps` more of them.
        for (; images_ < k; ++images_)
            for (int i = branch_.steps; i-- > 0;)
                guesses_.push_front(before_[static_cast<std::size_t>(i) % before_.size()]);
        for (; images_ > k; --images_)
            for (int i = 0; i < branch_.steps && !guesses_.empty(); ++i) guesses_.pop_front();
        point = branch_.seed(u, seed_);
        const auto steps = static_cast<std::size_t>(k * branch_.steps);
        for (std::size_t i = 0; i < steps; ++i) {
            const PlanePoint target = point;
            const bool guessed = i < guesses_.size() && preimage(target, guesses_[i], point);
            if (!guessed && !preimage(target, target, point) &&
                !preimage(target, PlanePoint{0, 0}, point))
                return false;
            if (!(std::abs(point[0]) + std::abs(point[1]) < far_)) return false;
            if (i < guesses_.size())
                guesses_[i] = point;
            else if (i == guesses_.size())
                guesses_.push_back(point);
        }
        return true;
    }

  private:
    bool preimage(const PlanePoint& target, PlanePoint guess, PlanePoint& found) const {
        for (int i = 0; i < kInverseSteps; ++i) {
            double j[4];
            PlanePoint image = guess;
            system_.stepWithJacobian(image.data(), j);
            const double x = image[0] - target[0], y = image[1] - target[1];
            const double determinant = j[0] * j[3] - j[1] * j[2];
            const PlanePoint step{(j[1] * y - j[3] * x) / determinant,
                                  (j[2] * x - j[0] * y) / determinant};
            const double size = std::abs(step[0]) + std::abs(step[1]);
            if (x == 0 && y == 0) return found = guess, true;
            if (!std::isfinite(size)) return false;
            guess = {guess[0] + step[0], guess[1] + step[1]};
            if (size <= 1e-13 * (1e-3 + std::abs(guess[0]) + std::abs(guess[1])))
                return found = guess, true;
        }
        return false;
    }

    const System& system_;
    const Branch& branch_;
    double seed_, far_;
    std::vector<PlanePoint> before_;
    std::deque<PlanePoint> guesses_;
    int images_ = 0;
};

class Grower {
  public:
    Grower(const Window& window, const ManifoldOptions& options, Job& job, Manifold& manifold)
        : window_(window),
          near_(window.grown(0.02)),
          options_(options),
          job_(job),
          manifold_(manifold),
          spacing_(options.spacing * window.height()) {}

    // Points of the branch, one after the other, each at most `spacing` from the one before.
    template <class Curve>
    void grow(Curve curve, const PlanePoint& origin) {
        double t = 0, ahead = kMostAhead, length = 0, lastSeen = 0, segment = 0;
        bool started = false;
        PlanePoint last, previous = origin;
        bool lastFinite = curve.at(0, 0, last);
        add(origin, last);
        while (t < kMostImages && length < options_.length * window_.height()) {
            if (job_.cancelled()) return;
            if (points_ >= options_.mostPoints || ++evaluations_ > 40LL * options_.mostPoints) {
                manifold_.cut = true;
                return;
            }
            const double next = t + ahead;
            const int k = static_cast<int>(next);
            PlanePoint point;
            const bool finite = curve.at(k, next - k, point);
            const double gap = finite && lastFinite ? distance(last, point) : HUGE_VAL;
            const bool seen = (finite && lastFinite)
                                  ? touches(last, point)
                                  : (finite && inside(point)) || (lastFinite && inside(last));
            if (seen && ahead > kLeastAhead &&
                (gap > spacing_ || (gap > 0.02 * spacing_ && turns(previous, last, point)))) {
                ahead *= 0.5;
                continue;
            }
            if (seen && finite && lastFinite && gap <= 8 * spacing_) {
                length += add(last, point);
                lastSeen = next;
            } else {
                end();
            }
            started = started || !finite || distance(point, origin) > 10 * spacing_;
            // A branch that comes to an attracting cycle moves no more.
            segment = gap < HUGE_VAL ? segment + gap : spacing_;
            if (k > static_cast<int>(t)) {
                if (started && segment < 1e-3 * spacing_) break;
                segment = 0;
            }
            if (started && next - lastSeen > kIdle) break;
            previous = lastFinite ? last : point;
            t = next, last = point, lastFinite = finite;
            if (!seen || gap < 0.6 * spacing_) ahead = std::min(1.6 * ahead, kMostAhead);
        }
        end();
    }

  private:
    bool inside(const PlanePoint& p) const { return near_.contains(p[0], p[1]); }
    bool touches(PlanePoint a, PlanePoint b) const { return clip(near_, a, b); }

    // Whether the curve bends so sharply that a fold may hide between the points.
    static bool turns(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
        const PlanePoint u{b[0] - a[0], b[1] - a[1]}, v{c[0] - b[0], c[1] - b[1]};
        return u[0] * v[0] + u[1] * v[1] < 0.9 * distance(u, {0, 0}) * distance(v, {0, 0});
    }
    // Returns the length that is in the window.
    double add(PlanePoint a, PlanePoint b) {
        const PlanePoint end = b;
        if (!clip(window_, a, b)) return this->end(), 0.0;
        if (line_.empty() || line_.back() != a) {
            this->end();
            line_.push_back(a);
        }
        line_.push_back(b);
        ++points_;
        if (b != end) this->end();
        return distance(a, b);
    }
    void end() {
        if (line_.size() > 1) manifold_.curves.push_back(std::move(line_));
        line_.clear();
    }

    const Window window_, near_;
    const ManifoldOptions& options_;
    Job& job_;
    Manifold& manifold_;
    double spacing_;
    Polyline line_;
    int points_ = 0;
    long long evaluations_ = 0;
};

// Why the map has no inverse near the window; empty where nothing speaks against one.
std::string whyNoInverse(const System& system, const Window& window) {
    constexpr int kAcross = 32;
    const Window around = window.grown(0.5);
    bool negative = false, positive = false;
    for (int j = 0; j <= kAcross; ++j)
        for (int i = 0; i <= kAcross; ++i) {
            const PlanePoint at{around.left + around.width() * i / kAcross,
                                around.bottom + around.height() * j / kAcross};
            const double determinant = system.determinant(at.data());
            negative = negative || determinant < 0;
            positive = positive || determinant > 0;
            if (determinant == 0) negative = positive = true;
        }
    return negative && positive
               ? "The map folds the plane (det J = 0 on a curve), so it has no inverse and its "
                 "stable sets are not single curves."
               : "";
}

}  // namespace

Expected<SaddleManifolds> manifoldsOf(const System& system, const PeriodicCycle& saddle,
                                      const Window& window, const ManifoldOptions& options,
                                      Job& job) {
    if (system.dimension() != 2 || saddle.kind != CycleKind::saddle)
        return Status::usage(
            "only a saddle of a map of the plane has a stable and an unstable "
            "manifold that are curves");
    if (Status status = checkWindow(window, 2); !status.ok()) return status;
    if (!(options.spacing >= 1e-5 && options.spacing <= 0.1) ||
        !(options.length > 0 && options.length <= 1e6) || options.mostPoints < 2)
        return Status::usage("the manifold's spacing must be 1e-5 to 0.1, its length above 0");
    SaddleManifolds result;
    result.whyNoStable = whyNoInverse(system, window);
    if (result.whyNoStable.empty()) result.stable.emplace();
    const double size = kSeed * window.height(), far = kFar * window.height();
    const int period = saddle.period;
    Grower unstable(window, options, job, result.unstable);
    Manifold none;
    Grower stable(window, options, job, result.stable ? *result.stable : none);
    for (int i = 0; i < period; ++i) {
        const PlanePoint& origin = saddle.points[static_cast<std::size_t>(i)];
        double j[4];
        PlanePoint image = origin;
        system.iterateWithJacobian(period, image.data(), j);
        for (const bool forward : {true, false}) {
            if (!forward && !result.stable) continue;
            const double value = saddle.eigenvalues[forward ? 0 : 1].real();
            const double stretch = forward ? std::abs(value) : 1 / std::abs(value);
            const PlanePoint v = eigenvector(j, value);
            // A negative eigenvalue changes sides: twice round the cycle brings a branch back.
            const int rounds = value < 0 ? 2 : 1;
            for (const double side : {1.0, -1.0}) {
                const Branch branch{origin,
                                    {side * v[0], side * v[1]},
                                    rounds == 2 ? stretch * stretch : stretch,
                                    rounds * period};
                if (forward) {
                    unstable.grow(Forward(system, branch, size, far), origin);
                    continue;
                }
                std::vector<PlanePoint> before;
                for (int k = 1; k <= period; ++k)
                    before.push_back(
                        saddle
                            .points[static_cast<std::size_t>((i - k % period + period) % period)]);
                stable.grow(Backward(system, branch, size, far, std::move(before)), origin);
            }
        }
        if (job.cancelled()) return Status::cancelled();
    }
    return result;
}

}  // namespace versorium
