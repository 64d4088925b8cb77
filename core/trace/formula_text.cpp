// SPDX-License-Identifier: MIT
// The normal form of formulas.
#include <cmath>

#include "base/json.h"
#include "trace/formula_terms.h"
#include "trace/index.h"

namespace versorium::formulas {
namespace {

// How tightly a term holds together.
enum Level { kOr = 1, kAnd, kNot, kComparison, kSum, kProduct, kSign, kPower, kAtom };

struct Printed {
    std::string text;
    int level = kAtom;
};

std::string bracketed(const Printed& printed, int least) {
    return printed.level < least ? "(" + printed.text + ")" : printed.text;
}

// The digits of a whole exponent, written high; empty for others.
std::string raised(const Term& term, const std::string& text) {
    if (term.kind != TermKind::number && term.kind != TermKind::negate) return {};
    constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string high;
    for (char c : text) {
        if (c == '-' && high.empty())
            high = "⁻";
        else if (c >= '0' && c <= '9')
            high += kDigits[c - '0'];
        else
            return {};
    }
    return high;
}

// What is written otherwise in a book than in a line that is typed.
Printed showTerm(const Term& term, const std::vector<Term>& terms, const std::vector<Printed>& all,
                 Printed typed) {
    switch (term.kind) {
        case TermKind::number:
            return term.number == kPi ? Printed{"π"} : typed;
        case TermKind::multiply:
            return {bracketed(all[at(term.a)], kProduct) + "·" + bracketed(all[at(term.b)], kSign),
                    kProduct};
        case TermKind::power:
            if (const std::string high = raised(terms[at(term.b)], all[at(term.b)].text);
                !high.empty())
                return {bracketed(all[at(term.a)], kAtom) + high, kPower};
            return typed;
        default:
            return typed;
    }
}

Printed printTerm(const Term& term, const std::vector<Printed>& all, const Formula& formula) {
    const auto left = [&](int least) { return bracketed(all[at(term.a)], least); };
    const auto right = [&](int least) { return bracketed(all[at(term.b)], least); };
    const auto binary = [&](const char* sign, int level, int leftLeast, int rightLeast) {
        return Printed{left(leftLeast) + sign + right(rightLeast), level};
    };
    const FormulaSpace space = formula.space;
    switch (term.kind) {
        case TermKind::number:
            if (term.number == kPi) return {"pi"};
            if (term.number == kE) return {"e"};
            return {formatNumber(term.number)};
        case TermKind::unit:
            return {std::string(1, "1ijk"[term.index])};
        case TermKind::variable:
            return {space == FormulaSpace::complex      ? "z"
                    : space == FormulaSpace::quaternion ? "q"
                    : term.index == 0                   ? "x"
                                                        : "y"};
        case TermKind::name:
            return {formula.parameters[at(term.index)].name};
        case TermKind::component: {
            constexpr const char* kComplex[] = {".re", ".im", ".y", ".z"};
            constexpr const char* kQuaternion[] = {".w", ".x", ".y", ".z"};
            const bool number =
                all[at(term.a)].text.find_first_not_of("0123456789.") == std::string::npos;
            return {(number ? "(" + all[at(term.a)].text + ")" : left(kAtom)) +
                    (space == FormulaSpace::quaternion ? kQuaternion : kComplex)[term.index]};
        }
        case TermKind::add:
            return binary(" + ", kSum, kSum, kProduct);
        case TermKind::subtract:
            return binary(" - ", kSum, kSum, kProduct);
        case TermKind::multiply:
            return binary("*", kProduct, kProduct, kSign);
        case TermKind::divide:
            return binary("/", kProduct, kProduct, kSign);
        case TermKind::negate:
            return {"-" + left(kSign), kSign};
        case TermKind::power:
            return binary("^", kPower, kAtom, kSign);
        case TermKind::less:
            return binary(" < ", kComparison, kSum, kSum);
        case TermKind::lessEqual:
            return binary(" <= ", kComparison, kSum, kSum);
        case TermKind::greater:
            return binary(" > ", kComparison, kSum, kSum);
        case TermKind::greaterEqual:
            return binary(" >= ", kComparison, kSum, kSum);
        case TermKind::equal:
            return binary(" == ", kComparison, kSum, kSum);
        case TermKind::notEqual:
            return binary(" != ", kComparison, kSum, kSum);
        case TermKind::conjunction:
            return binary(" and ", kAnd, kAnd, kNot);
        case TermKind::disjunction:
            return binary(" or ", kOr, kOr, kAnd);
        case TermKind::negation:
            return {"not " + left(kNot), kNot};
        default: {
            std::string text;
            for (const FunctionInfo& info : kFunctions)
                if (text.empty() && static_cast<int>(info.function) == term.index)
                    text = std::string(info.name) + "(";
            text += all[at(term.a)].text;
            for (int operand : {term.b, term.c})
                if (operand >= 0) text += ", " + all[at(operand)].text;
            return {text + ")"};
        }
    }
}

// "-0.1 + 0.7*i", and so that it reads back as the same numbers.
std::string printValue(const FormulaParameter& parameter) {
    constexpr const char* kUnits[] = {"", "*i", "*j", "*k"};
    std::string text = formatNumber(parameter.value[0]);
    for (int k = 1; k < widthOf(parameter.kind); ++k) {
        const double part = parameter.value[at(k)];
        if (part == 0 && !std::signbit(part)) continue;
        text += std::string(std::signbit(part) ? " - " : " + ") + formatNumber(std::abs(part)) +
                kUnits[k];
    }
    return text;
}

}  // namespace

std::string_view kindName(FormulaKind kind) {
    constexpr std::string_view kNames[] = {"real", "whole", "complex", "quaternion"};
    return kNames[static_cast<int>(kind)];
}

std::string printExpression(const Expression& expression, const Formula& formula) {
    std::vector<Printed> all;
    for (const Term& term : expression.terms) all.push_back(printTerm(term, all, formula));
    return all.back().text;
}

std::string showFormula(const std::vector<Expression>& components, const Formula& formula) {
    std::string shown;
    for (std::size_t k = 0; k < components.size(); ++k) {
        std::vector<Printed> all;
        for (const Term& term : components[k].terms)
            all.push_back(showTerm(term, components[k].terms, all, printTerm(term, all, formula)));
        if (components.size() == 2) shown += k == 0 ? "x′ = " : ", y′ = ";
        shown += formula.shape ? "shape(" + all.back().text + ")" : all.back().text;
    }
    return shown;
}

std::string printDeclarations(const std::vector<Declaration>& declarations,
                              const Formula& formula) {
    std::string text;
    for (const FormulaParameter& parameter : formula.parameters)
        for (const Declaration& declared : declarations) {
            if (declared.name != parameter.name) continue;
            text += "; " + parameter.name;
            if (declared.kind) text += ": " + std::string(kindName(parameter.kind));
            if (declared.value) text += " = " + printValue(parameter);
            if (declared.ranged)
                text += " in [" + formatNumber(parameter.low) + ", " +
                        formatNumber(parameter.high) + "]";
        }
    return text;
}

}  // namespace versorium::formulas
