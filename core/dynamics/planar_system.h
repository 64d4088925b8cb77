// SPDX-License-Identifier: MIT
#pragma once
// The planar quartic as algebra (A eqs 5-7): its text with the zero terms left out, the complex
// polynomial that it is where the Cauchy-Riemann equations hold, and det J as a polynomial.
// Coefficients are the 30 numbers of PlanarCoefficients (maps/planar.h): g.a1 … g.xy3, h.a1 …
// h.xy3.

#include <array>
#include <complex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "maps/catalogue.h"

namespace versorium {

inline constexpr std::size_t kPlanarNumbers = 30;
using PlanarNumbers = std::array<double, kPlanarNumbers>;

// k₀ + k₁ z + … + k₄ z⁴.
struct ComplexPolynomial {
    std::array<std::complex<double>, 5> k{};
    int degree() const;  // of what is not 0; 0 for a constant
    friend bool operator==(const ComplexPolynomial&, const ComplexPolynomial&) = default;
};

// The polynomial whose real and imaginary parts are g and h; nothing where the Cauchy-Riemann
// equations gₓ = h_y, g_y = -hₓ do not hold for all x and y, to 1e-12 of the largest coefficient of
// the same degree.
std::optional<ComplexPolynomial> complexPolynomialOf(std::span<const double> numbers);
// g - ih in the place of g + ih: what maps such as the tricorn's conj(z)² + c are conjugates of.
PlanarNumbers conjugateOf(std::span<const double> numbers);
PlanarNumbers planarNumbersOf(const ComplexPolynomial& polynomial);

// The largest degree of a term that is not 0, in both components.
int planarDegree(std::span<const double> numbers);

// The zeros of its derivative, each once, by their real, then imaginary parts; none for degree 1,
// and none for a constant, whose derivative vanishes everywhere.
std::vector<std::complex<double>> criticalPointsOf(const ComplexPolynomial& polynomial);

// Of the k-th of the 30: "b₁ᵍ", "dʰ"; the optional terms x³y and xy³ are "e₁ᵍ" and "e₂ᵍ".
std::string planarCoefficientName(std::size_t k);
// Such as "x² − y² − 0.75" (component 0 is g, 1 is h); "0" for no terms. Where `names` has a text
// for a coefficient, that stands in the place of its number: those on the axes of a picture.
std::string planarText(std::span<const double> numbers, int component,
                       std::span<const std::string> names = {});
// Such as "z³ + (0.3 − 0.1i)z + 0.5".
std::string complexText(const ComplexPolynomial& polynomial);

// det J = gₓ h_y - g_y hₓ as a polynomial: [i][j] is the coefficient of xⁱ yʲ.
using PlanarDeterminant = std::array<std::array<double, 7>, 7>;
PlanarDeterminant determinantOf(std::span<const double> numbers);
double valueOf(const PlanarDeterminant& determinant, double x, double y);

}  // namespace versorium
