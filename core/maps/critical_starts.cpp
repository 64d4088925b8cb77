// SPDX-License-Identifier: MIT
#include "maps/critical_starts.h"

#include <algorithm>
#include <cmath>

#include "maps/formula_map.h"
#include "math/elementary.h"

namespace versorium {
namespace {

using C = Complex<double>;

constexpr int kMostSolvedRoots = 64;
constexpr int kMostRounds = 100;
constexpr double kTwoPi = 6.28318530717958647692;

struct Factor {
    C root;
    double exponent;
};

double size(const C& z) { return std::sqrt(squaredNorm(z)); }

// Factors at the same place are one.
void append(const Environment<double>& environment, int list, double scale,
            std::vector<Factor>& all) {
    if (!environment.lists[list]) return;
    for (int i = 0; i < environment.listSize(list); ++i) {
        const C root{environment.listItem(list, i, 0), environment.listItem(list, i, 1)};
        const double exponent = scale * environment.listItem(list, i, 4);
        const auto known = std::find_if(all.begin(), all.end(), [&](const Factor& other) {
            return squaredNorm(other.root - root) == 0;
        });
        if (known == all.end())
            all.push_back({root, exponent});
        else
            known->exponent += exponent;
    }
}

// Points on a circle around the factors, turned so that no symmetry holds them.
std::vector<C> circle(const std::vector<Factor>& factors, int count) {
    C centre{0, 0};
    for (const Factor& factor : factors)
        centre = centre + (1.0 / static_cast<double>(factors.size())) * factor.root;
    double radius = 0.1;
    for (const Factor& factor : factors)
        radius = std::max(radius, 1.2 * size(factor.root - centre));
    std::vector<C> all;
    for (int k = 0; k < count; ++k) {
        const double angle = 0.4 + kTwoPi * k / count;
        all.push_back(centre + C{radius * cos(angle), radius * sin(angle)});
    }
    return all;
}

template <class LogDerivative>
std::vector<C> aberth(std::vector<C> z, LogDerivative logDerivative) {
    for (int round = 0; round < kMostRounds; ++round) {
        double moved = 0;
        for (std::size_t i = 0; i < z.size(); ++i) {
            C slope = logDerivative(z[i]);
            for (std::size_t j = 0; j < z.size(); ++j)
                if (j != i) slope = slope - inverse(z[i] - z[j]);
            const C step = inverse(slope);
            // Nothing is left to do where h = 0, and nothing can be done where charges balance.
            if (!(squaredNorm(step) < 1e12)) continue;
            z[i] = z[i] - step;
            moved = std::max(moved, size(step) / (1 + size(z[i])));
        }
        if (moved < 1e-12) break;
    }
    return z;
}

std::vector<C> newtonStarts(const C& relaxation, const std::vector<Factor>& factors) {
    const auto simple = [&](const Factor& factor) {
        const double m = factor.exponent;
        return squaredNorm(C{m * m, 0} - m * relaxation) < 1e-24 * m * m;
    };
    const auto known = std::count_if(factors.begin(), factors.end(), simple);
    const int degree = static_cast<int>(2 * factors.size()) - 2 - static_cast<int>(known);
    return aberth(circle(factors, std::max(0, degree)), [&](const C& z) {
        C sum{0, 0}, first{0, 0}, second{0, 0}, products{0, 0};
        for (const Factor& factor : factors) {
            const C term = inverse(z - factor.root);
            const C weighted = factor.exponent * term;
            sum = sum + weighted;
            first = first - weighted * term;
            second = second + 2.0 * (weighted * term * term);
            products = products + (simple(factor) ? 1.0 : 2.0) * term;
        }
        const C function = sum * sum + relaxation * first;
        const C derivative = 2.0 * (sum * first) + relaxation * second;
        return derivative / function + products;
    });
}

std::vector<C> rationalStarts(const std::vector<Factor>& factors) {
    const int degree = static_cast<int>(factors.size()) - 1;
    return aberth(circle(factors, degree), [&](const C& z) {
        C sum{0, 0}, first{0, 0}, products{0, 0};
        for (const Factor& factor : factors) {
            const C term = inverse(z - factor.root);
            sum = sum + factor.exponent * term;
            first = first - factor.exponent * (term * term);
            products = products + term;
        }
        return first / sum + products;
    });
}

// The zeros of a polynomial, its coefficients from the constant one on.
std::vector<C> polynomialStarts(std::vector<C> k) {
    while (!k.empty() && !(squaredNorm(k.back()) > 0)) k.pop_back();
    if (k.size() < 2) return {};
    // Cauchy's bound, halved: the zeros lie within, or not far from it.
    double radius = 0;
    for (std::size_t i = 0; i + 1 < k.size(); ++i)
        radius = std::max(radius, size(k[i]) / size(k.back()));
    if (radius == 0) return {C{0, 0}};
    const C centre{0.013 * radius, -0.007 * radius};
    std::vector<C> z;
    for (std::size_t i = 0; i + 1 < k.size(); ++i) {
        const double angle =
            0.4 + kTwoPi * static_cast<double>(i) / static_cast<double>(k.size() - 1);
        z.push_back(centre + C{0.5 * (1 + radius) * cos(angle), 0.5 * (1 + radius) * sin(angle)});
    }
    return aberth(std::move(z), [&](const C& at) {
        C value = k.back(), slope{0, 0};
        for (std::size_t i = k.size() - 1; i-- > 0;) {
            slope = slope * at + value;
            value = value * at + k[i];
        }
        // Nothing is left to do on a zero: a step of 0.
        return squaredNorm(value) > 0 ? slope / value : C{1e300, 0};
    });
}

}  // namespace

std::vector<Complex<double>> criticalStarts(const MapKernels& map, const double* parameters,
                                            const Environment<double>& environment) {
    if (map.formula) return polynomialStarts(map.formula->slope(parameters));
    std::vector<Factor> factors;
    std::vector<C> all;
    const RootForm form = map.info.rootForm;
    if (form == RootForm::newton) {
        append(environment, 0, 1, factors);
        if (factors.empty() || factors.size() > kMostSolvedRoots) return {};
        all = newtonStarts({parameters[0], parameters[1]}, factors);
    } else if (form == RootForm::product) {
        append(environment, 0, parameters[1], factors);
        append(environment, 1, -parameters[2], factors);
        std::erase_if(factors, [](const Factor& factor) { return factor.exponent == 0; });
        if (factors.empty() || factors.size() > kMostSolvedRoots) return {};
        all = rationalStarts(factors);
    }
    // Simple roots are critical points of Newton's map as well.
    if (form == RootForm::newton)
        for (const Factor& factor : factors) all.push_back(factor.root);
    return all;
}

}  // namespace versorium
