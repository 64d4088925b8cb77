// SPDX-License-Identifier: MIT
#pragma once
// Orbits and their fields by the definitions of core/fields/field_names.h, in long double, with the
// maps of oracle.h; and how far rounding may move them, measured on the oracle itself.

#include <optional>

#include "oracle/oracle.h"

namespace oracle {

// What an orbit follows from, as an affine function of the coordinates of a slice.
struct Case {
    const Step* step = nullptr;
    const Bound* bound = nullptr;
    std::vector<std::string> names;  // of the parameters
    Vector start, parameters;        // at coordinates 0
    std::vector<Vector> axes;        // of start.size() + parameters.size() numbers
    int iterations = 8;
    Real radius = 2;
    Real degree = 2;

    Vector startAt(const Vector& u) const {
        Vector z = start;
        for (std::size_t k = 0; k < axes.size(); ++k)
            for (std::size_t i = 0; i < z.size(); ++i) z[i] += u[k] * axes[k][i];
        return z;
    }
    Numbers parametersAt(const Vector& u) const {
        Numbers p;
        for (std::size_t i = 0; i < names.size(); ++i) {
            p[names[i]] = parameters[i];
            for (std::size_t k = 0; k < axes.size(); ++k)
                p[names[i]] += u[k] * axes[k][start.size() + i];
        }
        return p;
    }
};

inline bool outside(const Vector& z, Real radius) { return !(length(z) <= radius); }

// z_0 … up to the first iterate that is outside, or to z_N.
inline std::vector<Vector> orbit(const Case& c, const Vector& u) {
    const Numbers p = c.parametersAt(u);
    std::vector<Vector> all{c.startAt(u)};
    for (int n = 0; n < c.iterations && !outside(all.back(), c.radius); ++n)
        all.push_back((*c.step)(all.back(), p, *c.bound));
    return all;
}

// How much z_n moves, for each n, when every z_k before it and the parameters are moved by one unit
// of relative size: rounding errors of size eps in each step move it by about eps times that.
inline std::vector<Real> amplification(const Case& c, const Vector& u,
                                       const std::vector<Vector>& all) {
    const Real delta = 1e-9L;
    const Numbers p = c.parametersAt(u);
    std::vector<Real> moved(all.size(), 0);
    const auto follow = [&](std::size_t n, Vector z, const Numbers& numbers) {
        for (;; ++n) {
            const Real away = length(plus(z, all[n], -1)) / delta;
            moved[n] += std::isnan(away) ? std::numeric_limits<Real>::infinity() : away;
            if (n + 1 == all.size()) return;
            z = (*c.step)(z, numbers, *c.bound);
        }
    };
    for (std::size_t n = 0; n < all.size(); ++n)
        for (std::size_t k = 0; k < c.start.size(); ++k) {
            Vector z = all[n];
            z[k] += delta * (1 + std::abs(z[k]));
            follow(n, z, p);
        }
    for (const auto& [name, value] : p) {
        // Words such as `drop` are not rounded.
        if (name == "drop" || name == "as_printed") continue;
        Numbers other = p;
        other[name] += delta * std::fmax(Real(0.1), std::abs(value));
        follow(0, all[0], other);
    }
    return moved;
}

struct Fields {
    bool escaped = false;
    int step = 0;
    Real smooth = 0, squaredNorm = 0, logModulus = 0, trap = 0, distance = 0;
    std::optional<int> attraction;  // none where the orbit escapes
    std::optional<Real> lyapunov;   // none where it escapes, or where the derivative is lost
    Real imageModulus = 0, argument = 0;
    Vector versor;
};

// Least distance to a point; lines and circles lie in the first two components.
struct Trap {
    enum class Kind { point, line, circle } kind = Kind::point;
    Vector point;
    Real radius = 1, angle = 0;
};
inline Real trapDistance(const Trap& trap, const Vector& z) {
    const Real x = z[0] - trap.point[0];
    const Real y = z.size() > 1 && trap.point.size() > 1 ? z[1] - trap.point[1]
                   : z.size() > 1                        ? z[1]
                                                         : 0;
    if (trap.kind == Trap::Kind::circle) return std::abs(std::sqrt(x * x + y * y) - trap.radius);
    if (trap.kind == Trap::Kind::line)  // |(x, y) × (cos, sin)|
        return std::abs(x * std::sin(trap.angle) - y * std::cos(trap.angle));
    Vector away;
    for (std::size_t k = 0; k < z.size() && k < trap.point.size(); ++k)
        away.push_back(z[k] - trap.point[k]);
    return length(away);
}

// z_n for a given n, escaped or not.
inline Vector iterate(const Case& c, const Vector& u, std::size_t n) {
    const Numbers p = c.parametersAt(u);
    Vector z = c.startAt(u);
    for (std::size_t i = 0; i < n; ++i) z = (*c.step)(z, p, *c.bound);
    return z;
}

// ½ |z| ln|z| / |∇|z|| at escape, ∇ by central differences along the axes of the slice.
inline Real distanceEstimate(const Case& c, const Vector& u, std::size_t n) {
    const Real h = 1e-7L;
    Real square = 0;
    for (std::size_t k = 0; k < c.axes.size(); ++k) {
        Vector more = u, less = u;
        more[k] += h, less[k] -= h;
        const Real slope = (length(iterate(c, more, n)) - length(iterate(c, less, n))) / (2 * h);
        square += slope * slope;
    }
    const Real size = length(iterate(c, u, n));
    return size * std::log(size) / (2 * std::sqrt(square));
}

inline Fields fieldsOf(const Case& c, const Vector& u, const std::vector<Vector>& all,
                       const Trap& trap) {
    Fields f;
    const Vector& last = all.back();
    f.escaped = outside(last, c.radius);
    f.step = f.escaped ? static_cast<int>(all.size()) - 1 : c.iterations;
    const Real size = length(last);
    f.squaredNorm = size * size;
    f.logModulus = std::log(size);
    f.smooth = f.step;
    if (f.escaped) {
        const Real nu = 1 - std::log(std::log(size) / std::log(c.radius)) / std::log(c.degree);
        f.smooth = f.step + std::fmin(Real(1), std::fmax(Real(0), nu));
    }
    f.trap = trapDistance(trap, all[0]);
    for (const Vector& z : all) f.trap = std::fmin(f.trap, trapDistance(trap, z));
    if (!f.escaped) {
        f.attraction = c.iterations;
        for (std::size_t n = all.size() - 1; n >= 1; --n) {
            const Real change =
                length(all[n]) * length(all[n]) - length(all[n - 1]) * length(all[n - 1]);
            if (change * change < 0.0005L) f.attraction = static_cast<int>(n);
        }
    }
    const Vector image = iterate(c, u, 1);
    f.imageModulus = length(image);
    f.argument = std::atan2(image.size() > 1 ? image[1] : 0, image[0]);
    f.versor = image;
    for (Real& part : f.versor) part /= f.imageModulus;
    return f;
}

// ln|∂z_N/∂(first component of z_0)| / N.
inline Real lyapunovOf(const Case& c, const Vector& u) {
    const Real h = 1e-7L;
    const Numbers p = c.parametersAt(u);
    Vector more = c.startAt(u), less = more;
    more[0] += h, less[0] -= h;
    for (int n = 0; n < c.iterations; ++n)
        more = (*c.step)(more, p, *c.bound), less = (*c.step)(less, p, *c.bound);
    return std::log(length(plus(more, less, -1)) / (2 * h)) / c.iterations;
}

}  // namespace oracle
