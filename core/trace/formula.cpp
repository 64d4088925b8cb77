// SPDX-License-Identifier: MIT
// What the names in a formula mean: where it lives, its parameters and their defaults.
#include "trace/formula.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "trace/formula_reading.h"
#include "trace/formula_terms.h"
#include "trace/index.h"

namespace versorium {
namespace formulas {
namespace {

class Meaning {
  public:
    Meaning(ParsedFormula& parsed, Formula& formula, const FormulaShape* shape)
        : parsed_(parsed), formula_(formula), shape_(shape) {}
    FormulaFault fault;

    bool find() {
        return findSpace() && findShape() && resolveAll() && declare() && noDoubt() &&
               findDefaults();
    }
    const std::vector<Expression>& components() const { return components_; }

  private:
    bool fail(std::size_t position, std::string message) {
        fault = {position, std::move(message)};
        return false;
    }
    // Where a name stands first.
    std::optional<std::size_t> placeOf(const std::string& name) const {
        for (const Statement& statement : parsed_.statements)
            for (const Term& term : statement.expression.terms)
                if (term.kind == TermKind::name && parsed_.names[at(term.index)] == name)
                    return term.position;
        return std::nullopt;
    }
    bool speaksOf(const std::string& name) const { return placeOf(name).has_value(); }
    bool findSpace() {
        auto& all = parsed_.statements;
        if (all.size() == 2) {
            formula_.space = FormulaSpace::plane;
            for (Statement& one : all)
                if (one.head == "z" || one.head == "q")
                    return fail(one.position, "two components are those of the plane: x' and y'");
            if (all[0].head.empty() != all[1].head.empty())
                return fail(all[all[0].head.empty() ? 0 : 1].position,
                            "x' = … and y' = … are expected, both or neither");
            if (!all[0].head.empty() && all[0].head == all[1].head)
                return fail(all[1].position,
                            std::string(all[0].head == "x" ? "y" : "x") + "' = … is expected here");
            for (const char* name : {"z", "q"})
                if (const std::optional<std::size_t> where = placeOf(name))
                    return fail(*where,
                                "a comma parts the two formulas of the plane, which are of x "
                                "and y, not of " +
                                    std::string(name));
            if (all[0].head.empty() && !speaksOf("x") && !speaksOf("y"))
                return fail(all[1].position,
                            "a comma parts the two formulas of the plane, which are of x and y");
            if (all[0].head == "y") std::swap(all[0], all[1]);
            return true;
        }
        std::string head = all[0].head;
        if (head == "y") return fail(all[0].position, "y' needs an x' beside it: x' = …, y' = …");
        for (const char* name : {"z", "q", "x"})
            if (head.empty() && speaksOf(name)) head = name;
        for (const char* name : {"Z", "Q", "X"})
            if (head.empty() && speaksOf(name))
                return fail(*placeOf(name),
                            "capital letters are names of their own: did you mean " +
                                std::string(1, char(name[0] - 'A' + 'a')) + "?");
        for (const FormulaSpace space :
             {FormulaSpace::complex, FormulaSpace::line, FormulaSpace::quaternion})
            for (const std::string& name :
                 head.empty() ? parsed_.names : std::vector<std::string>())
                if (std::string doubt = doubtAbout(name, space, parsed_.names); !doubt.empty())
                    return fail(placeOf(name).value_or(0), std::move(doubt));
        if (head.empty())
            return fail(0,
                        "a formula speaks of z (complex), q (quaternion) or x (real), such as "
                        "z^2 + c; the plane is x' = …, y' = …");
        formula_.space = head == "z"   ? FormulaSpace::complex
                         : head == "q" ? FormulaSpace::quaternion
                                       : FormulaSpace::line;
        if (head == "x" && speaksOf("y") && all[0].head.empty() == false)
            return fail(parsed_.characters, "y' = … is expected, since x' speaks of y");
        return true;
    }

    static bool isShape(const Term& term) {
        return term.kind == TermKind::call && term.index == static_cast<int>(Function::shape);
    }
    // Takes a shape(…) off its formula; its parameters are the first ones.
    bool findShape() {
        for (Statement& statement : parsed_.statements) {
            auto& terms = statement.expression.terms;
            for (const Term& term : terms) {
                if (!isShape(term)) continue;
                if (isReal())
                    return fail(term.position,
                                "shape(…) stands around a formula of z or q, such as "
                                "shape(z^2 + c): real formulas have no direction");
                if (&term != &terms.back())
                    return fail(term.position,
                                "shape(…) stands around the whole formula, once: the modulus is "
                                "that of the shape, and nothing else changes it");
                if (!shape_) return fail(term.position, "there is no shape here");
                formula_.shape = true;
            }
            if (formula_.shape) terms.pop_back();
        }
        if (!formula_.shape) return true;
        const bool complex = formula_.space == FormulaSpace::complex;
        for (const FormulaParameter& own : complex ? shape_->complex : shape_->quaternion) {
            formula_.parameters.push_back(own);
            positions_.push_back(0);
            exponent_.push_back(false);
        }
        own_ = formula_.parameters.size();
        return true;
    }

    bool isReal() const {
        return formula_.space == FormulaSpace::line || formula_.space == FormulaSpace::plane;
    }
    bool isReserved(const std::string& name) const {
        if (name == "pi" || name == "e" || name == "i") return true;
        if (formula_.space == FormulaSpace::quaternion && (name == "j" || name == "k")) return true;
        return std::any_of(kFunctions.begin(), kFunctions.end(),
                           [&](const FunctionInfo& info) { return name == info.name; }) ||
               name == "and" || name == "or" || name == "not" || name == "in";
    }
    int variableOf(const std::string& name) const {
        switch (formula_.space) {
            case FormulaSpace::complex:
                return name == "z" ? 0 : -1;
            case FormulaSpace::quaternion:
                return name == "q" ? 0 : -1;
            case FormulaSpace::line:
                return name == "x" ? 0 : -1;
            default:
                return name == "x" ? 0 : name == "y" ? 1 : -1;
        }
    }
    // Names become variables, constants, and numbers of parameters.
    bool resolve(Expression& expression, bool constantsOnly) {
        for (Term& term : expression.terms) {
            if (isShape(term)) return fail(term.position, "a default is made of numbers alone");
            if (term.kind != TermKind::name) continue;
            const std::string& name = parsed_.names[at(term.index)];
            if (name == "pi" || name == "e") {
                term.kind = TermKind::number;
                term.number = name == "pi" ? kPi : kE;
            } else if (isReserved(name)) {
                if (isReal())
                    return fail(term.position,
                                "the formula is one of real numbers: there is no \"i\" in it");
                term.kind = TermKind::unit;
                term.index = name == "i" ? 1 : name == "j" ? 2 : 3;
            } else if (constantsOnly) {
                return fail(term.position,
                            "a default is made of numbers alone, not of \"" + name + "\"");
            } else if (variableOf(name) >= 0) {
                term.kind = TermKind::variable;
                term.index = variableOf(name);
            } else {
                const auto known = std::find_if(
                    formula_.parameters.begin(), formula_.parameters.end(),
                    [&](const FormulaParameter& parameter) { return parameter.name == name; });
                term.index = static_cast<int>(known - formula_.parameters.begin());
                if (at(term.index) < own_)
                    return fail(term.position, "\"" + name +
                                                   "\" is a number of shape(…) itself: give "
                                                   "yours another name");
                if (known == formula_.parameters.end()) {
                    formula_.parameters.push_back({.name = name});
                    positions_.push_back(term.position);
                    exponent_.push_back(false);
                }
            }
        }
        return true;
    }
    bool resolveAll() {
        for (Statement& statement : parsed_.statements) {
            if (!resolve(statement.expression, false)) return false;
            const auto& terms = statement.expression.terms;
            for (const Term& term : terms)
                if (term.kind == TermKind::power && terms[at(term.b)].kind == TermKind::name)
                    exponent_[at(terms[at(term.b)].index)] = true;
            components_.push_back(statement.expression);
        }
        if (formula_.space == FormulaSpace::line && formula_.parameters.empty())
            return fail(parsed_.characters,
                        "a formula of the real line needs a parameter to be drawn against, such as "
                        "r in r*x*(1 - x)");
        return true;
    }
    bool declare() {
        const FormulaKind own = isReal()                                  ? FormulaKind::real
                                : formula_.space == FormulaSpace::complex ? FormulaKind::complex
                                                                          : FormulaKind::quaternion;
        for (std::size_t k = own_; k < formula_.parameters.size(); ++k)
            formula_.parameters[k].kind = exponent_[k] ? FormulaKind::real : own;
        std::set<std::string> seen;
        for (Declaration& declaration : parsed_.declarations) {
            const auto known = std::find_if(
                formula_.parameters.begin(), formula_.parameters.end(),
                [&](const FormulaParameter& one) { return one.name == declaration.name; });
            if (known == formula_.parameters.end())
                return fail(declaration.position,
                            isReserved(declaration.name)
                                ? "\"" + declaration.name + "\" has a meaning of its own"
                                : "the formula has no parameter \"" + declaration.name + "\"");
            if (!seen.insert(declaration.name).second)
                return fail(declaration.position, "\"" + declaration.name + "\" is declared twice");
            const FormulaKind kind = declaration.kind.value_or(known->kind);
            if (kind != known->kind && at(int(known - formula_.parameters.begin())) < own_)
                return fail(declaration.position,
                            "\"" + declaration.name + "\" is " +
                                (known->kind == FormulaKind::real    ? "a real number"
                                 : known->kind == FormulaKind::whole ? "a whole number"
                                                                     : "a point") +
                                " of shape(…)");
            const bool fits = kind == FormulaKind::real || kind == FormulaKind::whole ||
                              kind == own ||
                              (kind == FormulaKind::complex && own == FormulaKind::quaternion);
            if (!fits)
                return fail(declaration.position, "a formula of this kind has no " +
                                                      std::string(kindName(kind)) + " parameters");
            known->kind = kind;
        }
        int numbers = 0;
        for (std::size_t k = 0; k < formula_.parameters.size(); ++k) {
            numbers += widthOf(formula_.parameters[k].kind);
            if (numbers > kFormulaNumbers)
                return fail(positions_[k], "the parameters are more than " +
                                               std::to_string(kFormulaNumbers) +
                                               " numbers together");
        }
        return true;
    }
    // Names that can be read in two ways are declared, or refused.
    bool noDoubt() {
        std::vector<std::string> names;
        for (const FormulaParameter& parameter : formula_.parameters)
            names.push_back(parameter.name);
        for (std::size_t k = own_; k < names.size(); ++k) {
            if (std::any_of(parsed_.declarations.begin(), parsed_.declarations.end(),
                            [&](const Declaration& one) { return one.name == names[k]; }))
                continue;
            std::string doubt = doubtAbout(names[k], formula_.space, names);
            if (!doubt.empty()) return fail(positions_[k], std::move(doubt));
        }
        return true;
    }
    bool findDefaults() {
        for (std::size_t k = own_; k < formula_.parameters.size(); ++k)
            standard(formula_.parameters[k], exponent_[k]);
        for (Declaration& declaration : parsed_.declarations) {
            FormulaParameter& parameter = *std::find_if(
                formula_.parameters.begin(), formula_.parameters.end(),
                [&](const FormulaParameter& one) { return one.name == declaration.name; });
            if (declaration.ranged)
                parameter.low = declaration.low, parameter.high = declaration.high;
            if (!declaration.value) continue;
            if (!resolve(*declaration.value, true)) return false;
            if (!constantOf(*declaration.value, formula_.space, parameter.kind, parameter.value,
                            fault))
                return false;
            if (parameter.kind == FormulaKind::whole &&
                std::floor(parameter.value[0]) != parameter.value[0])
                return fail(declaration.value->terms[0].position, "a whole number is expected");
        }
        return true;
    }
    static void standard(FormulaParameter& parameter, bool exponent) {
        const bool added = parameter.name == "c";
        if (parameter.kind == FormulaKind::complex) {
            // The rabbit's for c, since many families add it.
            parameter.value = {added ? -0.122561 : 1, added ? 0.744862 : 0, 0, 0};
            parameter.low = -2, parameter.high = 2;
        } else if (parameter.kind == FormulaKind::quaternion) {
            parameter.value = {added ? 0.285 : 1, added ? 0.485 : 0, 0, 0};
            parameter.low = -2, parameter.high = 2;
        } else {
            parameter.value = {exponent ? 2.0 : 1.0, 0, 0, 0};
            if (exponent) parameter.low = -8, parameter.high = 8;
        }
    }

    ParsedFormula& parsed_;
    Formula& formula_;
    const FormulaShape* shape_;
    std::size_t own_ = 0;  // parameters of shape(…)
    std::vector<Expression> components_;
    std::vector<std::size_t> positions_;
    std::vector<bool> exponent_;
};

}  // namespace
// A number's text as the expression that it is.
bool readNumber(std::string_view text, FormulaSpace space, FormulaKind kind,
                std::array<double, 4>& value, FormulaFault& fault) {
    ParsedFormula parsed;
    if (!parseText(text, parsed, fault)) return false;
    if (parsed.statements.size() != 1 || !parsed.declarations.empty() ||
        !parsed.statements[0].head.empty()) {
        fault = {0, "one number is expected"};
        return false;
    }
    Expression& expression = parsed.statements[0].expression;
    for (Term& term : expression.terms) {
        if (term.kind != TermKind::name) continue;
        const std::string& name = parsed.names[at(term.index)];
        const std::size_t unit =
            name.size() == 1 ? std::string_view("ijk").find(name[0]) : std::string_view::npos;
        if (name == "pi" || name == "e") {
            term.kind = TermKind::number;
            term.number = name == "pi" ? kPi : kE;
        } else if (widthOf(kind) == 4 ? unit < 3 : widthOf(kind) == 2 && unit == 0) {
            term.kind = TermKind::unit;
            term.index = static_cast<int>(unit) + 1;
        } else {
            fault = {term.position, "a number is expected, not \"" + name + "\""};
            return false;
        }
    }
    return constantOf(expression, space, kind, value, fault);
}

}  // namespace formulas

Expected<std::array<double, 4>> parseFormulaNumber(std::string_view text, FormulaKind kind) {
    const FormulaSpace space = kind == FormulaKind::quaternion ? FormulaSpace::quaternion
                               : kind == FormulaKind::complex  ? FormulaSpace::complex
                                                               : FormulaSpace::line;
    std::array<double, 4> value{};
    FormulaFault fault;
    if (!formulas::readNumber(text, space, kind, value, fault))
        return Status::usage("character " + std::to_string(fault.position + 1) + ": " +
                             fault.message);
    return value;
}

int widthOf(FormulaKind kind) {
    return kind == FormulaKind::complex ? 2 : kind == FormulaKind::quaternion ? 4 : 1;
}

int dimensionOf(FormulaSpace space) {
    return space == FormulaSpace::line ? 1 : space == FormulaSpace::quaternion ? 4 : 2;
}

Expected<Formula> parseFormula(std::string_view text, FormulaFault* fault,
                               const FormulaShape* shape) {
    Formula formula;
    formulas::ParsedFormula parsed;
    FormulaFault found;
    const auto refused = [&]() -> Expected<Formula> {
        if (fault) *fault = found;
        return Status::usage("character " + std::to_string(found.position + 1) + ": " +
                             found.message);
    };
    if (!formulas::parseText(text, parsed, found)) return refused();
    formulas::Meaning meaning(parsed, formula, shape);
    if (!meaning.find()) return found = meaning.fault, refused();
    if (!formulas::recordFormula(meaning.components(), formula, found)) return refused();
    const auto& parts = meaning.components();
    formula.body = formulas::printExpression(parts[0], formula);
    if (formula.shape) formula.body = "shape(" + formula.body + ")";
    if (parts.size() == 2)
        formula.body =
            "x' = " + formula.body + ", y' = " + formulas::printExpression(parts[1], formula);
    else if (!parsed.statements[0].head.empty())
        formula.body = parsed.statements[0].head + "' = " + formula.body;
    formula.shown = formulas::showFormula(parts, formula);
    formula.text = formula.body + formulas::printDeclarations(parsed.declarations, formula);
    return formula;
}

}  // namespace versorium
