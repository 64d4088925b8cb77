// SPDX-License-Identifier: MIT
#pragma once
// A map that a user types, read into the very tape that a built-in map leaves.
//
//   z^2 + c                                a complex formula: it speaks of z
//   x' = 1 - a*x^2 + y, y' = b*x           the plane: two real formulas (also "1 - a*x^2 + y, b*x")
//   q^2 + c                                quaternions: it speaks of q and not of z
//   r*x*(1 - x)                            the real line: it speaks of x alone
//   z^3 - a*z + c; a: real = 0.5 in [0, 4]; c = -0.1 + 0.7i
//
// A head (z' =, q' =, x' =, z ->, f(z) = or z_{n+1} =) decides where a formula lives, else the
// first of z, q, x that stands in it; z_n is z. All other names are parameters, in the order in
// which they stand: complex in a complex formula, real in one of the line or the plane, quaternions
// in a quaternion formula. A name that stands alone as an exponent is real. Declarations after a
// semicolon say otherwise: name: kind = default in [low, high], each part optional, with the kinds
// real, whole, complex and quaternion. A name that could be a product (cz, iz, z2) or another name
// in capitals (Z, I) is refused unless it is declared, and so is a decimal comma.
//
// Operators, loosest first: c ? a : b, or (||), and (&&), not (!), comparisons of real numbers,
// + -, * /, the sign, ^ (from the right; -z^2 is -(z^2)). A number may stand directly before a name
// or a bracket, 2z = 2*z, but not after / or ^, where it could mean two things. Postfix: z.re,
// z.im, q.w … q.z. · and × are *, ² and ³ are ^2 and ^3, π is pi. Constants: pi, e, i, and j, k of
// quaternions.
//
// Functions: exp log sqrt sin cos tan sinh cosh tanh asin acos atan asinh acosh atanh on their
// principal branches (math/functions.h), abs (the modulus), norm (its square), arg, re, im, conj;
// of real numbers floor, min, max, atan2; if(condition, a, b). In a complex formula, sqrt, log, the
// inverse functions and fractional powers of a real number are complex. A whole exponent up to ±256
// that is written out is done by repeated squaring, as built-in maps do; a real exponent is a power
// on the principal branch (math/power.h), a complex one e^(w log z).
//
// shape(p) around a whole formula of z or q is the shape modulus with the direction of p
// (maps/shape_modulus.h): p is taken at z - shift, and the parameters of the shape modulus (alpha,
// beta, as_printed, shift, and drop of quaternions) come before those of p.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "math/complex.h"
#include "trace/tape.h"

namespace versorium {

namespace formulas {
struct Expression;  // trace/formula_terms.h
}

inline constexpr std::size_t kFormulaCharacters = 1000;
inline constexpr int kFormulaDepth = 64;          // of brackets, signs and exponents in each other
inline constexpr int kFormulaNodes = 4000;        // of its tape
inline constexpr int kFormulaNumbers = 32;        // of all parameters together
inline constexpr double kFormulaLargest = 1e100;  // of a number that is written out

enum class FormulaSpace { line, complex, plane, quaternion };
enum class FormulaKind { real, whole, complex, quaternion };

int widthOf(FormulaKind kind);
int dimensionOf(FormulaSpace space);

struct FormulaParameter {
    std::string name;
    FormulaKind kind = FormulaKind::real;
    std::array<double, 4> value{};  // default
    double low = -4, high = 4;      // range of a slider
};

// What was wrong, and at which character (from 0; the text's length at its end).
struct FormulaFault {
    std::size_t position = 0;
    std::string message;
};

struct Formula {
    FormulaSpace space = FormulaSpace::complex;
    std::string text;  // in its normal form, which reads back as the same formula
    std::string body;  // the same without the declarations
    // As a book has it, z² + 2·i·z: how the text was understood.
    std::string shown;
    std::vector<FormulaParameter> parameters;
    Tape tape;  // parameters component by component
    // Whether it is shape(p). The tape is then that of p, with all parameters.
    bool shape = false;

    // One expression, or the two of the plane (trace/formula_growth.h reads them).
    std::shared_ptr<const std::vector<formulas::Expression>> components;
    // Of complex formulas: whether critical points may move with a number of the parameters. A sum
    // with and a product by what does not depend on z leave them where they are.
    std::vector<bool> movesCritical;
    // Of a polynomial in z: its degree, else 0, and a tape that takes the parameters to the
    // coefficients of its derivative, constant first: re, im, re, im, …
    int degree = 0;
    Tape slope;
    // Whether z -> f(z) has the form z^degree + (what does not depend on z).
    bool unicritical = false;
};

// The parameters that shape(…) brings along. Maps know them: FormulaMap::make hands them over.
struct FormulaShape {
    std::vector<FormulaParameter> complex, quaternion;
};

// ErrorKind::usage with the character (counted from 1) in the message; `fault` says it for a caret.
// Without `shape` there is no shape(…).
Expected<Formula> parseFormula(std::string_view text, FormulaFault* fault = nullptr,
                               const FormulaShape* shape = nullptr);

// A number of this kind as formulas write it, without names: -0.8 + 0.156i, sqrt(2)/2, 16/9.
Expected<std::array<double, 4>> parseFormulaNumber(std::string_view text, FormulaKind kind);

// The message on one line, then the text, then a ^ below the character.
std::string withCaret(std::string_view text, const FormulaFault& fault);

// The one judge of whether a text that is no known name is meant as a formula: it reads as one, or
// it has what names of maps and files lack, such as an operator, a bracket or a blank.
bool looksLikeFormula(std::string_view text);

}  // namespace versorium
