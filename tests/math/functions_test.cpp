// SPDX-License-Identifier: MIT
#include "math/functions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace versorium {
namespace {

using Exact = std::complex<long double>;

// tan = sin cos / (cos² + sinh²) + i sinh cosh / (cos² + sinh²), in long double.
Exact tangent(long double x, long double y) {
    const long double c = std::cos(x), s = std::sinh(y), below = c * c + s * s;
    return {std::sin(x) * c / below, s * std::cosh(y) / below};
}

double distance(const Complex<double>& value, const Exact& exact) {
    return static_cast<double>(std::abs(Exact(value.re, value.im) - exact) / std::abs(exact));
}

TEST(ComplexFunctions, TanAndTanhAreExactNearTheirPoles) {
    for (double away : {0.0, 1e-1, 1e-4, 1e-8, 1e-12, 1e-15})
        for (double turn : {0.0, 0.7, 1.5, 2.9, 4.0, 5.5}) {
            const double x = 1.5707963267948966 + away * std::cos(turn);
            const double y = away * std::sin(turn);
            const Exact exact = tangent(x, y);
            // A few roundings of sin, cos and sinh, each within 3 units in the last place.
            EXPECT_LT(distance(functions::tan(Complex<double>{x, y}), exact), 1e-14)
                << x << " " << y;
            // tanh(iz) = i tan(z).
            const Complex<double> turned = functions::tanh(Complex<double>{-y, x});
            EXPECT_LT(distance({turned.im, -turned.re}, exact), 1e-14) << x << " " << y;
        }
    EXPECT_NEAR(functions::tan(Complex<double>{1.5707963, 0}).re * 2.679489661923e-8, 1, 1e-8);
}

TEST(ComplexFunctions, TanGoesToIFarFromTheRealLine) {
    for (double y : {1.0, 20.0, 170.0, 400.0, 1e10}) {
        const Complex<double> up = functions::tan(Complex<double>{0.3, y});
        const Complex<double> down = functions::tan(Complex<double>{0.3, -y});
        EXPECT_NEAR(up.im, 1, 2.1 * std::exp(-2 * y) + 1e-15) << y;
        EXPECT_NEAR(down.im, -up.im, 1e-15) << y;
        EXPECT_TRUE(std::isfinite(up.re)) << y;
    }
}

}  // namespace
}  // namespace versorium
