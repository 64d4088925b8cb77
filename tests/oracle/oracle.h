// SPDX-License-Identifier: MIT
#pragma once
// The independent oracle: every map of the catalogue once more, as a textbook would write it, in
// long double and without a line of the project's code. Powers are taken in polar form, products
// factor by factor and not normalised, spherical coordinates by their angles: where core takes a
// short cut, the oracle takes the long way. (On WebAssembly the long double functions of the C
// library are no better than double; tolerances leave room for that.)

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace oracle {

using Real = long double;
using Vector = std::vector<Real>;
// Parameters by the names that users type: "c.re", "alpha", "g.b1".
using Numbers = std::map<std::string, Real>;

struct Root {
    Real q[4];
    Real power;
};
struct Bound {
    std::vector<Root> lists[2];
    std::function<Real(Real, Real, Real)> distance;
};

using Step = std::function<Vector(const Vector& z, const Numbers& p, const Bound& bound)>;

inline Real length(const Vector& v) {
    Real sum = 0;
    for (Real part : v) sum += part * part;
    return std::sqrt(sum);
}
inline Vector plus(const Vector& a, const Vector& b, Real scale = 1) {
    Vector c = a;
    for (std::size_t k = 0; k < c.size(); ++k) c[k] += scale * b[k];
    return c;
}

// ---- complex numbers and quaternions as lists of 2 and 4 numbers -------------------------------

// Over four components Hamilton's table, over two the complex rule.
inline Vector times(const Vector& a, const Vector& b) {
    if (a.size() == 2) return {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]};
    return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
            a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}
inline Vector reciprocal(const Vector& a) {
    Vector b = a;
    Real norm = 0;
    for (Real part : a) norm += part * part;
    for (std::size_t k = 0; k < b.size(); ++k) b[k] *= (k == 0 ? 1 : -1) / norm;
    return b;
}
// |q|^e (cos eθ + v̂ sin eθ), θ = atan2(|v|, w); over ℂ the angle carries the sign of the
// imaginary part.
inline Vector toPower(const Vector& q, Real e) {
    Vector v(q.begin() + 1, q.end());
    const Real vector = length(v), modulus = std::pow(length(q), e);
    const Real angle = e * std::atan2(vector, q[0]);
    Vector result{modulus * std::cos(angle)};
    for (Real part : v)
        result.push_back(vector == 0 ? 0 : modulus * std::sin(angle) * part / vector);
    return result;
}

inline Vector number(const Numbers& p, const std::string& name, std::size_t width) {
    if (width == 2) return {p.at(name + ".re"), p.at(name + ".im")};
    if (width == 3) return {p.at(name + ".x"), p.at(name + ".y"), p.at(name + ".z")};
    return {p.at(name + ".w"), p.at(name + ".x"), p.at(name + ".y"), p.at(name + ".z")};
}
inline Vector minusRoot(const Vector& q, const Root& root) {
    Vector difference = q;
    for (std::size_t k = 0; k < q.size(); ++k) difference[k] -= root.q[k];
    return difference;
}
inline Vector product(const Vector& q, const std::vector<Root>& roots, Real scale) {
    Vector all(q.size(), 0);
    all[0] = 1;
    for (const Root& root : roots)
        all = times(all, toPower(minusRoot(q, root), root.power * scale));
    return all;
}

// ---- the maps
// ------------------------------------------------------------------------------------

// Σ aₖxᵏ + Σ bₖyᵏ + c₁xy + c₂x²y + c₃xy² + c₄x²y² + d + x3y x³y + xy3 xy³, term by term.
inline Real planarComponent(const Numbers& p, const std::string& name, Real x, Real y) {
    const auto k = [&](const char* coefficient) { return p.at(name + "." + coefficient); };
    return k("a1") * x + k("a2") * x * x + k("a3") * x * x * x + k("a4") * x * x * x * x +
           k("b1") * y + k("b2") * y * y + k("b3") * y * y * y + k("b4") * y * y * y * y +
           k("c1") * x * y + k("c2") * x * x * y + k("c3") * x * y * y + k("c4") * x * x * y * y +
           k("d") + k("x3y") * x * x * x * y + k("xy3") * x * y * y * y;
}

// White and Nylander's power in spherical coordinates with the z-axis as pole.
inline Vector bulbPower(const Vector& v, Real n) {
    const Real rho = std::sqrt(v[0] * v[0] + v[1] * v[1]);
    const Real theta = std::atan2(rho, v[2]), phi = rho == 0 ? 0 : std::atan2(v[1], v[0]);
    const Real r = std::pow(length(v), n);
    return {r * std::sin(n * theta) * std::cos(n * phi),
            r * std::sin(n * theta) * std::sin(n * phi), r * std::cos(n * theta)};
}

// z - a / Σ mᵢ/(z - rᵢ); a root stays where it is.
inline Vector newton(const Vector& z, const Numbers& p, const Bound& bound) {
    Vector sum{0, 0};
    for (const Root& root : bound.lists[0]) {
        const Vector difference = minusRoot(z, root);
        if (length(difference) == 0) return z;
        sum = plus(sum, reciprocal(difference), root.power);
    }
    return plus(z, times(number(p, "relaxation", 2), reciprocal(sum)), -1);
}

// R(q) = e^C Π (q - tᵢ)^(τTᵢ) (Π (q - bᵢ)^(βBᵢ))⁻¹.
inline Vector rational(const Vector& q, const Numbers& p, const Bound& bound) {
    const Vector top = product(q, bound.lists[0], p.at("tau"));
    const Vector bottom = product(q, bound.lists[1], p.at("exponent_beta"));
    Vector all = times(top, reciprocal(bottom));
    for (Real& part : all) part *= std::exp(p.at("log_scale"));
    return all;
}
inline Vector interleaved(const Vector& q, const Numbers& p, const Bound& bound) {
    Vector all = product(q, bound.lists[0], p.at("tau"));
    for (Real& part : all) part *= std::exp(p.at("log_scale"));
    return all;
}

// S(q) = e^C (Σ (q - tᵢ)^(τTᵢ) + Σ (q - bᵢ)^(-βBᵢ)).
inline Vector rootSum(const Vector& q, const Numbers& p, const Bound& bound) {
    Vector all(q.size(), 0);
    for (const Root& root : bound.lists[0])
        all = plus(all, toPower(minusRoot(q, root), root.power * p.at("tau")));
    for (const Root& root : bound.lists[1])
        all = plus(all, toPower(minusRoot(q, root), -root.power * p.at("exponent_beta")));
    for (Real& part : all) part *= std::exp(p.at("log_scale"));
    return all;
}

inline bool hasDirection(const Vector& v) {
    const Real size = length(v);
    return size > 0 && size <= std::numeric_limits<Real>::max();
}

// e^{α(φ(x) - β)} p(x)/|p(x)|, x = q - shift, around any complex or quaternion map p.
inline Step shapeModulus(const Step& inner) {
    return [inner](const Vector& q, const Numbers& p, const Bound& bound) {
        const Vector x = plus(q, number(p, "shift", q.size()), -1);
        Vector place;
        for (std::size_t k = 0; k < x.size(); ++k)
            if (x.size() == 2 || static_cast<Real>(k) != p.at("drop")) place.push_back(x[k]);
        if (place.size() == 2) place.push_back(0);
        const Real phi = bound.distance(place[0], place[1], place[2]);
        const Real offset = p.at("as_printed") != 0 ? -p.at("beta") : p.at("beta");
        Real exponent = p.at("alpha") * (phi - offset);
        if (exponent > 300) exponent = 300;
        if (exponent < -300) exponent = -300;
        Vector direction = inner(x, p, bound);
        if (!hasDirection(direction)) direction = q;
        if (!hasDirection(direction)) direction.assign(q.size(), 0), direction[0] = 1;
        const Real scale = std::exp(exponent) / length(direction);
        for (Real& part : direction) part *= scale;
        return direction;
    };
}

// By the names of the catalogue. A map that is missing here fails a test.
inline const std::map<std::string, Step>& steps() {
    static const std::map<std::string, Step> kSteps = [] {
        std::map<std::string, Step> all;
        all["logistic"] = [](const Vector& x, const Numbers& p, const Bound&) {
            return Vector{p.at("r") * x[0] * (1 - x[0])};
        };
        all["real-quadratic"] = [](const Vector& x, const Numbers& p, const Bound&) {
            return Vector{x[0] * x[0] + p.at("c")};
        };
        const Step square = [](const Vector& z, const Numbers& p, const Bound&) {
            return plus(times(z, z), number(p, "c", z.size()));
        };
        all["quadratic"] = all["quaternion-quadratic"] = square;
        all["power"] = [](const Vector& z, const Numbers& p, const Bound&) {
            return plus(toPower(z, p.at("power")), number(p, "c", 2));
        };
        all["cubic"] = [](const Vector& z, const Numbers& p, const Bound&) {
            const Vector linear = times(number(p, "a", 2), z);
            return plus(plus(times(times(z, z), z), linear), number(p, "b", 2));
        };
        all["newton"] = newton;
        all["burning-ship"] = [](const Vector& z, const Numbers& p, const Bound&) {
            const Vector folded{std::abs(z[0]), std::abs(z[1])};
            return plus(times(folded, folded), number(p, "c", 2));
        };
        all["planar"] = [](const Vector& z, const Numbers& p, const Bound&) {
            return Vector{planarComponent(p, "g", z[0], z[1]), planarComponent(p, "h", z[0], z[1])};
        };
        all["quaternion-cubic"] = [](const Vector& q, const Numbers& p, const Bound&) {
            return plus(times(q, times(q, q)), number(p, "c", 4));
        };
        // Two complex numbers a + b j with j² = -1 and everything commuting.
        all["bicomplex-quadratic"] = [](const Vector& q, const Numbers& p, const Bound&) {
            const Vector a{q[0], q[1]}, b{q[2], q[3]};
            const Vector first = plus(times(a, a), times(b, b), -1), second = times(a, b);
            return plus(Vector{first[0], first[1], 2 * second[0], 2 * second[1]},
                        number(p, "c", 4));
        };
        all["mandelbulb"] = [](const Vector& v, const Numbers& p, const Bound&) {
            return plus(bulbPower(v, p.at("power")), number(p, "c", 3));
        };
        all["complex-rational"] = all["quaternion-rational"] = rational;
        all["quaternion-interleaved"] = interleaved;
        all["complex-root-sum"] = all["quaternion-root-sum"] = rootSum;
        all["shape-modulus"] = shapeModulus(rational);
        for (const char* inner :
             {"complex-rational", "quadratic", "power", "cubic", "newton", "quaternion-quadratic",
              "quaternion-cubic", "quaternion-interleaved", "complex-root-sum",
              "quaternion-root-sum"})
            all[std::string("shape-modulus-") + inner] = shapeModulus(all[inner]);
        return all;
    }();
    return kSteps;
}

// ---- shapes
// --------------------------------------------------------------------------------------

inline Real sphere(Real x, Real y, Real z, Real radius) { return length({x, y, z}) - radius; }

// The nearest point of a solid box is the point with every coordinate cut to the box; from within,
// the nearest face counts.
inline Real box(Real x, Real y, Real z, Real hx, Real hy, Real hz) {
    const Real p[3] = {x, y, z}, half[3] = {hx, hy, hz};
    Vector away;
    Real face = std::numeric_limits<Real>::infinity();
    for (int k = 0; k < 3; ++k) {
        const Real cut = p[k] < -half[k] ? -half[k] : p[k] > half[k] ? half[k] : p[k];
        away.push_back(p[k] - cut);
        face = std::fmin(face, half[k] - std::abs(p[k]));
    }
    return face > 0 ? -face : length(away);
}

// Trilinear interpolation as a sum over all nodes, each with its hat function.
struct GridTable {
    int nodes[3];
    Real minimum[3], maximum[3];
    std::vector<double> values;  // x fastest
};
inline Real trilinear(const GridTable& grid, const Real* point, bool addDistance) {
    Real u[3], beyond[3];
    for (int k = 0; k < 3; ++k) {
        const Real low = grid.minimum[k], high = grid.maximum[k];
        const Real cut = point[k] < low ? low : point[k] > high ? high : point[k];
        beyond[k] = grid.nodes[k] < 2 ? 0 : point[k] - cut;
        u[k] = grid.nodes[k] < 2 ? 0 : (cut - low) / (high - low) * (grid.nodes[k] - 1);
    }
    const auto hat = [](Real t) { return std::fmax(Real(0), 1 - std::abs(t)); };
    Real sum = 0;
    std::size_t at = 0;
    for (int k = 0; k < grid.nodes[2]; ++k)
        for (int j = 0; j < grid.nodes[1]; ++j)
            for (int i = 0; i < grid.nodes[0]; ++i)
                sum += grid.values[at++] * hat(u[0] - i) * hat(u[1] - j) * hat(u[2] - k);
    return addDistance ? sum + length({beyond[0], beyond[1], beyond[2]}) : sum;
}

}  // namespace oracle
