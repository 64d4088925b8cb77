// SPDX-License-Identifier: MIT
// What the critical points of a formula follow from.
#include "trace/formula_recorder.h"
#include "trace/program.h"

namespace versorium::formulas {
namespace {

constexpr int kMostDegree = 32;

std::vector<char> freeTerms(const Expression& expression) {
    std::vector<char> free;
    for (const Term& term : expression.terms) {
        bool own = term.kind != TermKind::variable;
        for (int operand : {term.a, term.b, term.c})
            if (operand >= 0) own = own && free[at(operand)];
        free.push_back(own);
    }
    return free;
}

// The addends of a sum, or the factors of a product, that are not free of z.
void gather(const Expression& expression, const std::vector<char>& free, int root, bool sum,
            std::vector<int>& parts) {
    std::vector<int> open{root};
    while (!open.empty()) {
        const int index = open.back();
        open.pop_back();
        const Term& term = expression.terms[at(index)];
        if (free[at(index)]) continue;
        if (term.kind == TermKind::negate) {
            open.push_back(term.a);
        } else if (sum ? term.kind == TermKind::add || term.kind == TermKind::subtract
                       : term.kind == TermKind::multiply) {
            open.push_back(term.a);
            open.push_back(term.b);
        } else if (!sum && term.kind == TermKind::divide && free[at(term.b)]) {
            open.push_back(term.a);
        } else {
            parts.push_back(index);
        }
    }
}

// Marks the parameters that the critical points may follow: those of what is left when addends and
// factors without z are taken away.
std::vector<bool> followed(const Expression& expression, std::size_t parameters) {
    const std::vector<char> free = freeTerms(expression);
    std::vector<int> parts{static_cast<int>(expression.terms.size()) - 1};
    for (bool sum = true, changed = true; parts.size() == 1 && changed; sum = !sum) {
        std::vector<int> next;
        gather(expression, free, parts[0], sum, next);
        // Neither a sum nor a product takes it further: one try of each.
        changed = next != parts || sum;
        parts = next;
    }
    std::vector<bool> result(parameters, false);
    std::vector<int> open = parts;
    while (!open.empty()) {
        const Term& term = expression.terms[at(open.back())];
        open.pop_back();
        if (term.kind == TermKind::name) result[at(term.index)] = true;
        for (int operand : {term.a, term.b, term.c})
            if (operand >= 0) open.push_back(operand);
    }
    return result;
}

// The coefficients of a polynomial in z, or nothing.
class Polynomial {
  public:
    Polynomial(Recorder& recorder, const Expression& expression)
        : recorder_(recorder), expression_(expression) {}

    std::optional<std::vector<Value>> coefficients() {
        const std::vector<char> free = freeTerms(expression_);
        std::vector<Value> plain;
        std::vector<std::optional<std::vector<Value>>> all;
        for (std::size_t i = 0; i < expression_.terms.size(); ++i) {
            const Term& term = expression_.terms[i];
            plain.push_back(free[i] ? recorder_.apply(expression_, term, plain) : Value{});
            if (free[i])
                all.push_back(std::vector<Value>{plain.back()});
            else
                all.push_back(combine(term, all, free));
        }
        return all.back();
    }

  private:
    using Coefficients = std::vector<Value>;

    std::optional<Coefficients> combine(const Term& term,
                                        const std::vector<std::optional<Coefficients>>& all,
                                        const std::vector<char>& free) {
        if (term.kind == TermKind::variable)
            return Coefficients{recorder_.real(0.0), recorder_.real(1.0)};
        for (int operand : {term.a, term.b, term.c})
            if (operand >= 0 && !all[at(operand)]) return std::nullopt;
        switch (term.kind) {
            case TermKind::negate: {
                Coefficients result = *all[at(term.a)];
                for (Value& value : result) value = recorder_.negate(value);
                return result;
            }
            case TermKind::add:
            case TermKind::subtract:
                return sum(*all[at(term.a)], *all[at(term.b)], term.kind == TermKind::add);
            case TermKind::multiply:
                return product(*all[at(term.a)], *all[at(term.b)]);
            case TermKind::divide: {
                if (!free[at(term.b)]) return std::nullopt;
                Coefficients result = *all[at(term.a)];
                for (Value& value : result) value = recorder_.divide(value, (*all[at(term.b)])[0]);
                return result;
            }
            case TermKind::power:
                return power(*all[at(term.a)], *all[at(term.b)], free[at(term.b)]);
            default:
                return std::nullopt;
        }
    }
    Coefficients sum(const Coefficients& a, const Coefficients& b, bool plus) {
        Coefficients result;
        for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
            const Value left = k < a.size() ? a[k] : recorder_.real(0.0);
            const Value right = k < b.size() ? b[k] : recorder_.real(0.0);
            result.push_back(plus ? recorder_.add(left, right) : recorder_.subtract(left, right));
        }
        return result;
    }
    std::optional<Coefficients> product(const Coefficients& a, const Coefficients& b) {
        if (a.size() + b.size() - 2 > kMostDegree) return std::nullopt;
        // Multiplied out, a formula may be much longer than it was.
        Coefficients result(a.size() + b.size() - 1, recorder_.real(0.0));
        for (std::size_t i = 0; i < a.size(); ++i)
            for (std::size_t j = 0; j < b.size(); ++j) {
                if (recorder_.full()) return std::nullopt;
                if (recorder_.isConstantZero(a[i]) || recorder_.isConstantZero(b[j])) continue;
                const Value term = recorder_.multiply(a[i], b[j]);
                result[i + j] = recorder_.isConstantZero(result[i + j])
                                    ? term
                                    : recorder_.add(result[i + j], term);
            }
        return result;
    }
    std::optional<Coefficients> power(const Coefficients& base, const Coefficients& exponent,
                                      bool free) {
        if (!free || exponent[0].type != Value::Type::real || !exponent[0].part[0].isConstant())
            return std::nullopt;
        const double e = exponent[0].part[0].constant();
        if (!(e >= 0 && e <= kMostDegree) || std::floor(e) != e) return std::nullopt;
        std::optional<Coefficients> result = Coefficients{recorder_.real(1.0)};
        for (int k = 0; k < static_cast<int>(e) && result; ++k) result = product(*result, base);
        return result;
    }

    Recorder& recorder_;
    const Expression& expression_;
};

}  // namespace

void findCritical(const Expression& expression, Formula& formula) {
    std::vector<bool> names = followed(expression, formula.parameters.size());
    for (std::size_t k = 0; k < names.size(); ++k)
        for (int i = 0; i < widthOf(formula.parameters[k].kind); ++i)
            formula.movesCritical.push_back(names[k]);
    Tape tape;
    tape.stateSize = 0;
    FormulaFault unused;
    Recorder recorder(formula.space, formula.parameters, tape, unused);
    const auto coefficients = Polynomial(recorder, expression).coefficients();
    if (!coefficients || coefficients->size() < 2) return;
    std::vector<Value> all = *coefficients;
    while (all.size() > 1 && recorder.isConstantZero(all.back())) all.pop_back();
    if (all.size() < 2 || static_cast<int>(tape.nodes.size()) > kFormulaNodes) return;
    formula.degree = static_cast<int>(all.size()) - 1;
    const Value& top = all.back();
    formula.unicritical =
        top.type == Value::Type::real && top.part[0].isConstant() && top.part[0].constant() == 1;
    for (std::size_t k = 1; k + 1 < all.size(); ++k)
        formula.unicritical = formula.unicritical && recorder.isConstantZero(all[k]);
    for (std::size_t k = 1; k < all.size(); ++k) {
        const Value value =
            recorder.promoted(recorder.multiply(recorder.real(static_cast<double>(k)), all[k]));
        for (int part = 0; part < 2; ++part) tape.outputs.push_back(value.part[part].on(&tape));
    }
    tape.stateSize = static_cast<int>(tape.outputs.size());
    formula.slope = simplified(tape);
}

}  // namespace versorium::formulas
