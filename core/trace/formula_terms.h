// SPDX-License-Identifier: MIT
#pragma once
// What the parser of formulas hands to the recorder and to the normal form: terms in the order in
// which they are computed.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trace/formula.h"

namespace versorium::formulas {

// The constants pi and e.
constexpr double kPi = 3.14159265358979323846, kE = 2.71828182845904523536;

enum class TermKind {
    number,
    unit,       // index 1, 2, 3: i, j, k
    variable,   // component `index` of the state, or all of a complex number or quaternion
    name,       // a parameter
    call,       // function `index` of a, b, c
    component,  // `index` of a: 0 re or w, 1 im or x, 2 y, 3 z
    add,
    subtract,
    multiply,
    divide,
    power,
    negate,
    less,
    lessEqual,
    greater,
    greaterEqual,
    equal,
    notEqual,
    conjunction,
    disjunction,
    negation,
};

enum class Function {
    exp,
    log,
    sqrt,
    sin,
    cos,
    tan,
    sinh,
    cosh,
    tanh,
    asin,
    acos,
    atan,
    asinh,
    acosh,
    atanh,
    abs,
    norm,
    arg,
    re,
    im,
    conj,
    floor,
    min,
    max,
    atan2,
    choose,
    shape,  // only around a whole formula, of which the parser takes it off
};

struct FunctionInfo {
    const char* name;
    Function function;
    int arguments;
};
extern const std::vector<FunctionInfo> kFunctions;

struct Term {
    TermKind kind = TermKind::number;
    int a = -1, b = -1, c = -1;
    int index = 0;
    double number = 0;
    std::size_t position = 0;
};

// The last term is the value.
struct Expression {
    std::vector<Term> terms;
};

// What stands behind a formula of one of its names: "; a: complex = 1 + i in [-2, 2]".
struct Declaration {
    std::string name;
    std::size_t position = 0;
    std::optional<FormulaKind> kind;
    std::optional<Expression> value;
    bool ranged = false;
    double low = 0, high = 0;
};

struct Statement {
    std::string head;  // z, q, x, y, or empty
    std::size_t position = 0;
    Expression expression;
};

// A text that is a formula by its form.
struct ParsedFormula {
    std::vector<Statement> statements;  // one or two
    std::vector<Declaration> declarations;
    std::vector<std::string> names;  // in the order in which they stand
    std::size_t characters = 0;
};
// False with the fault where the text is none.
bool parseText(std::string_view text, ParsedFormula& parsed, FormulaFault& fault);

// Records the expressions of a formula on its tape, and finds what its critical points follow from.
// False with the fault where the types do not fit. Needs space and parameters.
bool recordFormula(const std::vector<Expression>& components, Formula& formula,
                   FormulaFault& fault);
// The value of an expression without names, as `kind`; false with the fault.
bool constantOf(const Expression& expression, FormulaSpace space, FormulaKind kind,
                std::array<double, 4>& value, FormulaFault& fault);

// As a declaration names it: "real", "whole", "complex" or "quaternion".
std::string_view kindName(FormulaKind kind);
// The normal form of an expression, with no more brackets than it needs.
std::string printExpression(const Expression& expression, const Formula& formula);
// "z² + 2·i·z", or of the plane "x′ = …, y′ = …", without declarations.
std::string showFormula(const std::vector<Expression>& components, const Formula& formula);
// That of the declarations, in the order of the parameters.
std::string printDeclarations(const std::vector<Declaration>& declarations, const Formula& formula);

}  // namespace versorium::formulas
