// SPDX-License-Identifier: MIT
#include "trace/formula_growth.h"

#include <cmath>
#include <limits>

#include "trace/formula_terms.h"
#include "trace/index.h"

namespace versorium {
namespace formulas {
namespace {

constexpr double kZero = -std::numeric_limits<double>::infinity();  // the growth of 0
constexpr double kMostPower = 256;

double valueOf(double x) { return x; }
double valueOf(const Dual<double>& x) { return x.value; }

// The leading term a z^g of an expression; `exact` where a is known and the term is analytic.
template <class R>
struct Lead {
    bool known = false;
    double growth = 0;
    bool exact = false;
    Complex<R> factor{R(0.0), R(0.0)};

    bool isZero() const { return known && growth == kZero; }
    bool isNumber() const { return known && exact && (growth == 0 || isZero()); }
};

template <class R>
class Leading {
  public:
    Leading(const Formula& formula, const R* parameters, const std::vector<bool>& varies)
        : formula_(formula), varies_(varies) {
        std::size_t first = 0;
        for (const FormulaParameter& parameter : formula.parameters) {
            const auto width = static_cast<std::size_t>(widthOf(parameter.kind));
            Lead<R> lead = number(parameters[first], width > 1 ? parameters[first + 1] : R(0.0));
            for (std::size_t k = 0; k < width; ++k) {
                if (first + k < varies.size() && varies[first + k]) lead = some(0);
                if (k >= 2 && valueOf(parameters[first + k]) != 0) lead = some(0);
            }
            parameters_.push_back(lead);
            first += width;
        }
    }

    Lead<R> of(const Expression& expression) {
        std::vector<Lead<R>> all;
        for (const Term& term : expression.terms) all.push_back(leadOf(term, all));
        return all.back();
    }

  private:
    static Lead<R> unknown() { return {}; }
    static Lead<R> some(double growth) { return {true, growth, false, {}}; }
    static Lead<R> number(const R& re, const R& im) {
        const bool zero = valueOf(re) == 0 && valueOf(im) == 0;
        return {true, zero ? kZero : 0, true, {re, im}};
    }

    Lead<R> leadOf(const Term& term, const std::vector<Lead<R>>& all) const {
        const auto operand = [&](int index) { return index >= 0 ? all[at(index)] : unknown(); };
        const Lead<R> a = operand(term.a), b = operand(term.b);
        switch (term.kind) {
            case TermKind::number:
                return number(R(term.number), R(0.0));
            case TermKind::unit:
                return term.index == 1 ? number(R(0.0), R(1.0)) : some(0);
            case TermKind::variable:
                return {true, 1, formula_.space == FormulaSpace::complex, {R(1.0), R(0.0)}};
            case TermKind::name:
                return parameters_[at(term.index)];
            case TermKind::component:
                return a.known ? some(a.growth) : unknown();
            case TermKind::negate:
                return {a.known, a.growth, a.exact, -a.factor};
            case TermKind::add:
                return sum(a, b);
            case TermKind::subtract:
                return sum(a, {b.known, b.growth, b.exact, -b.factor});
            case TermKind::multiply:
                if (!a.known || !b.known) return unknown();
                return {true, a.growth + b.growth, a.exact && b.exact, a.factor * b.factor};
            case TermKind::divide:
                if (!a.known || !b.known || b.isZero()) return unknown();
                return {true, a.growth - b.growth, a.exact && b.exact, a.factor / b.factor};
            case TermKind::power:
                return power(a, b);
            case TermKind::call:
                return call(static_cast<Function>(term.index), a, b, operand(term.c));
            default:
                return some(0);  // true or false
        }
    }

    static Lead<R> sum(const Lead<R>& a, const Lead<R>& b) {
        if (!a.known || !b.known) return unknown();
        if (a.growth != b.growth) return a.growth > b.growth ? a : b;
        if (!a.exact || !b.exact) return some(a.growth);
        const Complex<R> factor = a.factor + b.factor;
        const bool gone = valueOf(factor.re) == 0 && valueOf(factor.im) == 0;
        // What is left of leading terms that cancel is not known, unless nothing is.
        if (gone && !a.isNumber()) return unknown();
        return {true, gone ? kZero : a.growth, true, factor};
    }

    static Lead<R> power(const Lead<R>& base, const Lead<R>& exponent) {
        if (!base.known || !exponent.isNumber() || valueOf(exponent.factor.im) != 0)
            return unknown();
        const double e = valueOf(exponent.factor.re);
        if (e == 0) return number(R(1.0), R(0.0));
        if (base.isZero()) return e > 0 ? base : unknown();
        if (!base.exact || std::floor(e) != e || !(std::abs(e) <= kMostPower))
            return some(e * base.growth);
        Complex<R> factor{R(1.0), R(0.0)};
        for (int k = 0; k < static_cast<int>(std::abs(e)); ++k) factor = factor * base.factor;
        return {true, e * base.growth, true, e > 0 ? factor : inverse(factor)};
    }

    static Lead<R> call(Function function, const Lead<R>& a, const Lead<R>& b, const Lead<R>& c) {
        switch (function) {
            case Function::conj:
            case Function::abs:
            case Function::re:
            case Function::im:
            case Function::floor:
                return a.known ? some(a.growth) : unknown();
            case Function::norm:
                return a.known ? some(2 * a.growth) : unknown();
            case Function::sqrt:
                return a.known ? some(a.growth / 2) : unknown();
            case Function::arg:
            case Function::atan2:
                return some(0);
            case Function::min:
            case Function::max:
                return a.known && b.known ? some(std::max(a.growth, b.growth)) : unknown();
            case Function::choose:
                return b.known && c.known ? some(std::max(b.growth, c.growth)) : unknown();
            case Function::log:
                return a.known ? some(0) : unknown();
            default:
                break;
        }
        // Bounded where their argument is.
        if (!a.known || a.growth > 0) return unknown();
        if (a.growth < 0 &&
            (function == Function::exp || function == Function::cos || function == Function::cosh))
            return number(R(1.0), R(0.0));
        return some(0);
    }

    const Formula& formula_;
    const std::vector<bool>& varies_;
    std::vector<Lead<R>> parameters_;
};

template <class R>
std::optional<Complex<R>> limitOf(const Formula& formula, const R* parameters) {
    if (formula.space != FormulaSpace::complex || formula.shape) return std::nullopt;
    const Lead<R> lead = Leading<R>(formula, parameters, {}).of(formula.components->front());
    if (!lead.known || !lead.exact || lead.growth > 0) return std::nullopt;
    return lead.growth < 0 ? Complex<R>{R(0.0), R(0.0)} : lead.factor;
}

}  // namespace
}  // namespace formulas

std::optional<double> growthOf(const Formula& formula, const double* parameters,
                               const std::vector<bool>& varies) {
    if (formula.shape) return std::nullopt;
    formulas::Leading<double> leading(formula, parameters, varies);
    double largest = formulas::kZero;
    for (const formulas::Expression& expression : *formula.components) {
        const auto lead = leading.of(expression);
        if (!lead.known) return std::nullopt;
        largest = std::max(largest, lead.growth);
    }
    return largest;
}

std::optional<Complex<double>> valueAtInfinity(const Formula& formula, const double* parameters) {
    return formulas::limitOf(formula, parameters);
}

std::optional<Complex<Dual<double>>> valueAtInfinity(const Formula& formula,
                                                     const Dual<double>* parameters) {
    return formulas::limitOf(formula, parameters);
}

}  // namespace versorium
