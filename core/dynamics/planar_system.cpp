// SPDX-License-Identifier: MIT
#include "dynamics/planar_system.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/json.h"
#include "maps/planar.h"
#include "math/complex.h"

namespace versorium {
namespace {

constexpr double kRounding = 1e-12;
constexpr std::size_t kEach = 15;

// The term of each coefficient, in the order of planar::Coefficient: powers of x and y.
struct Power {
    int x, y;
};
constexpr std::array<Power, kEach> kTerms = {{{1, 0},
                                              {2, 0},
                                              {3, 0},
                                              {4, 0},
                                              {0, 1},
                                              {0, 2},
                                              {0, 3},
                                              {0, 4},
                                              {1, 1},
                                              {2, 1},
                                              {1, 2},
                                              {2, 2},
                                              {0, 0},
                                              {3, 1},
                                              {1, 3}}};
// Texts run from the highest degree to the constant; within a degree from x to y.
constexpr std::array<planar::Coefficient, kEach> kOrder = {
    planar::a4, planar::x3y, planar::c4, planar::xy3, planar::b4,
    planar::a3, planar::c2,  planar::c3, planar::b3,  planar::a2,
    planar::c1, planar::b2,  planar::a1, planar::b1,  planar::d};

const char* superscript(int power) {
    constexpr const char* kDigits[] = {"", "", "\u00b2", "\u00b3", "\u2074"};
    return kDigits[power];
}

std::string monomial(const Power& power) {
    std::string text;
    if (power.x > 0) text += std::string("x") + superscript(power.x);
    if (power.y > 0) text += std::string("y") + superscript(power.y);
    return text;
}

std::string numberText(double value) { return formatNumber(value, 6); }

// Joins terms with their signs; `text` has none.
void append(std::string& sum, bool negative, const std::string& text) {
    if (sum.empty())
        sum = (negative ? "\u2212" : "") + text;
    else
        sum += (negative ? " \u2212 " : " + ") + text;
}

// kz ⁿ = k (x + iy)ⁿ split into coefficients of g and h.
void addPower(int n, double p, double q, PlanarNumbers& numbers) {
    double* g = numbers.data();
    double* h = numbers.data() + kEach;
    using namespace planar;
    switch (n) {
        case 0:
            g[d] += p, h[d] += q;
            break;
        case 1:
            g[a1] += p, g[b1] -= q;
            h[a1] += q, h[b1] += p;
            break;
        case 2:
            g[a2] += p, g[b2] -= p, g[c1] -= 2 * q;
            h[a2] += q, h[b2] -= q, h[c1] += 2 * p;
            break;
        case 3:
            g[a3] += p, g[c3] -= 3 * p, g[c2] -= 3 * q, g[b3] += q;
            h[a3] += q, h[c3] -= 3 * q, h[c2] += 3 * p, h[b3] -= p;
            break;
        default:
            g[a4] += p, g[c4] -= 6 * p, g[b4] += p, g[x3y] -= 4 * q, g[xy3] += 4 * q;
            h[a4] += q, h[c4] -= 6 * q, h[b4] += q, h[x3y] += 4 * p, h[xy3] -= 4 * p;
    }
}

using Polynomial = std::array<std::array<double, 5>, 5>;

Polynomial polynomialOf(const double* component) {
    Polynomial result{};
    for (std::size_t k = 0; k < kEach; ++k)
        result[static_cast<std::size_t>(kTerms[k].x)][static_cast<std::size_t>(kTerms[k].y)] =
            component[k];
    return result;
}
// ∂/∂x or ∂/∂y.
Polynomial derivative(const Polynomial& of, bool byX) {
    Polynomial result{};
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t j = 0; j < 5; ++j) {
            if (byX && i > 0) result[i - 1][j] = static_cast<double>(i) * of[i][j];
            if (!byX && j > 0) result[i][j - 1] = static_cast<double>(j) * of[i][j];
        }
    return result;
}

}  // namespace

std::string planarCoefficientName(std::size_t k) {
    assert(k < kPlanarNumbers);
    constexpr const char* kNames[kEach] = {"a\u2081", "a\u2082", "a\u2083", "a\u2084", "b\u2081",
                                           "b\u2082", "b\u2083", "b\u2084", "c\u2081", "c\u2082",
                                           "c\u2083", "c\u2084", "d",       "e\u2081", "e\u2082"};
    return std::string(kNames[k % kEach]) + (k < kEach ? "\u1d4d" : "\u02b0");
}

int ComplexPolynomial::degree() const {
    int n = 4;
    while (n > 0 && k[static_cast<std::size_t>(n)] == std::complex<double>(0, 0)) --n;
    return n;
}

PlanarNumbers planarNumbersOf(const ComplexPolynomial& polynomial) {
    PlanarNumbers numbers{};
    for (std::size_t n = 0; n < polynomial.k.size(); ++n)
        addPower(static_cast<int>(n), polynomial.k[n].real(), polynomial.k[n].imag(), numbers);
    return numbers;
}

PlanarNumbers conjugateOf(std::span<const double> numbers) {
    assert(numbers.size() == kPlanarNumbers);
    PlanarNumbers result{};
    for (std::size_t k = 0; k < kPlanarNumbers; ++k)
        result[k] = k < kEach ? numbers[k] : -numbers[k];
    return result;
}

std::optional<ComplexPolynomial> complexPolynomialOf(std::span<const double> numbers) {
    assert(numbers.size() == kPlanarNumbers);
    const double* g = numbers.data();
    const double* h = numbers.data() + kEach;
    using namespace planar;
    ComplexPolynomial result;
    result.k = {{{g[d], h[d]}, {g[a1], h[a1]}, {g[a2], h[a2]}, {g[a3], h[a3]}, {g[a4], h[a4]}}};
    const PlanarNumbers back = planarNumbersOf(result);
    std::array<double, 5> largest{};
    const auto degreeAt = [](std::size_t k) {
        const Power& term = kTerms[k % kEach];
        return static_cast<std::size_t>(term.x + term.y);
    };
    for (std::size_t k = 0; k < kPlanarNumbers; ++k)
        largest[degreeAt(k)] = std::max(largest[degreeAt(k)], std::abs(numbers[k]));
    for (std::size_t k = 0; k < kPlanarNumbers; ++k)
        if (!(std::abs(back[k] - numbers[k]) <= kRounding * largest[degreeAt(k)]))
            return std::nullopt;
    return result;
}

int planarDegree(std::span<const double> numbers) {
    int largest = 0;
    for (std::size_t k = 0; k < kPlanarNumbers; ++k)
        if (numbers[k] != 0) largest = std::max(largest, kTerms[k % kEach].x + kTerms[k % kEach].y);
    return largest;
}

std::vector<std::complex<double>> criticalPointsOf(const ComplexPolynomial& polynomial) {
    using C = Complex<double>;
    std::vector<C> slope;  // coefficients of the derivative
    for (std::size_t n = 1; n < polynomial.k.size(); ++n)
        slope.push_back(static_cast<double>(n) * C{polynomial.k[n].real(), polynomial.k[n].imag()});
    while (!slope.empty() && squaredNorm(slope.back()) == 0) slope.pop_back();
    if (slope.size() < 2) return {};
    const std::size_t degree = slope.size() - 1;
    // Durand and Kerner: all zeros at once, from a circle that holds them (Cauchy's bound).
    double bound = 0;
    for (std::size_t n = 0; n < degree; ++n)
        bound = std::max(bound, std::sqrt(squaredNorm(slope[n] / slope[degree])));
    const auto value = [&](const C& z) {
        C sum = slope[degree];
        for (std::size_t n = degree; n-- > 0;) sum = sum * z + slope[n];
        return sum / slope[degree];
    };
    std::vector<C> z;
    for (std::size_t n = 0; n < degree; ++n) {
        const double angle =
            0.4 + 6.28318530717958647692 * static_cast<double>(n) / static_cast<double>(degree);
        z.push_back({(1 + bound) * cos(angle), (1 + bound) * sin(angle)});
    }
    for (int round = 0; round < 500; ++round) {
        double moved = 0;
        for (std::size_t i = 0; i < degree; ++i) {
            C step = value(z[i]);
            for (std::size_t k = 0; k < degree; ++k)
                if (k != i) step = step / (z[i] - z[k]);
            if (!(squaredNorm(step) < 1e300)) continue;
            z[i] = z[i] - step;
            moved = std::max(moved, squaredNorm(step));
        }
        if (moved < 1e-32 * (1 + bound) * (1 + bound)) break;
    }
    // A zero of order m is told apart from its copies to about rounding^(1/m); their mean is exact.
    const double same = 3e-5 * (1 + bound);
    std::vector<std::complex<double>> distinct;
    std::vector<char> used(degree, 0);
    for (std::size_t i = 0; i < degree; ++i) {
        if (used[i]) continue;
        C sum{0, 0};
        double count = 0;
        for (std::size_t k = i; k < degree; ++k)
            if (!used[k] && squaredNorm(z[k] - z[i]) < same * same)
                used[k] = 1, sum = sum + z[k], ++count;
        // What rounding leaves of a 0.
        const auto clean = [&](double part) {
            return std::abs(part) < 1e-15 * (1 + bound) ? 0.0 : part;
        };
        distinct.emplace_back(clean(sum.re / count), clean(sum.im / count));
    }
    std::sort(distinct.begin(), distinct.end(), [](const auto& a, const auto& b) {
        const auto cell = [](double x) { return std::floor(x * 1e8 + 0.5); };
        return cell(a.real()) != cell(b.real()) ? a.real() < b.real() : a.imag() < b.imag();
    });
    return distinct;
}

std::string planarText(std::span<const double> numbers, int component,
                       std::span<const std::string> names) {
    assert(numbers.size() == kPlanarNumbers && (names.empty() || names.size() == kPlanarNumbers));
    std::string sum;
    for (planar::Coefficient coefficient : kOrder) {
        const std::size_t at = kEach * static_cast<std::size_t>(component) + coefficient;
        const std::string term = monomial(kTerms[coefficient]);
        if (!names.empty() && !names[at].empty()) {
            append(sum, false, names[at] + (term.empty() ? "" : " " + term));
            continue;
        }
        const double value = numbers[at];
        if (value == 0) continue;
        const std::string size = numberText(std::abs(value));
        append(sum, value < 0, term.empty() ? size : size == "1" ? term : size + term);
    }
    return sum.empty() ? "0" : sum;
}

std::string complexText(const ComplexPolynomial& polynomial) {
    std::string sum;
    for (int n = 4; n >= 0; --n) {
        const std::complex<double> k = polynomial.k[static_cast<std::size_t>(n)];
        if (n == 0) {
            // The constant ends the sum, so that it needs no brackets.
            const std::string imaginary = numberText(std::abs(k.imag()));
            if (k.real() != 0) append(sum, k.real() < 0, numberText(std::abs(k.real())));
            if (k.imag() != 0) append(sum, k.imag() < 0, (imaginary == "1" ? "" : imaginary) + "i");
            break;
        }
        const std::string term = std::string("z") + superscript(n);
        if (k.real() != 0 && k.imag() != 0) {
            const std::string imaginary = numberText(std::abs(k.imag()));
            const std::string both = numberText(std::abs(k.real())) +
                                     ((k.imag() < 0) == (k.real() < 0) ? " + " : " \u2212 ") +
                                     (imaginary == "1" ? "" : imaginary) + "i";
            append(sum, k.real() < 0, "(" + both + ")" + term);
        } else if (k.real() != 0 || k.imag() != 0) {
            const bool real = k.real() != 0;
            const double value = real ? k.real() : k.imag();
            const std::string size = numberText(std::abs(value));
            append(sum, value < 0, (size == "1" ? "" : size) + (real ? "" : "i") + term);
        }
    }
    return sum.empty() ? "0" : sum;
}

PlanarDeterminant determinantOf(std::span<const double> numbers) {
    assert(numbers.size() == kPlanarNumbers);
    const Polynomial g = polynomialOf(numbers.data()), h = polynomialOf(numbers.data() + kEach);
    const Polynomial gx = derivative(g, true), gy = derivative(g, false);
    const Polynomial hx = derivative(h, true), hy = derivative(h, false);
    PlanarDeterminant result{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k)
                for (std::size_t l = 0; l < 4; ++l)
                    result[i + k][j + l] += gx[i][j] * hy[k][l] - gy[i][j] * hx[k][l];
    return result;
}

double valueOf(const PlanarDeterminant& determinant, double x, double y) {
    double sum = 0;
    for (std::size_t i = 7; i-- > 0;) {
        double inner = 0;
        for (std::size_t j = 7; j-- > 0;) inner = inner * y + determinant[i][j];
        sum = sum * x + inner;
    }
    return sum;
}

}  // namespace versorium
