// SPDX-License-Identifier: MIT
#pragma once
// From terms to the nodes of a tape: every operation is done by the numbers of core/math over Expr,
// so that a typed formula leaves what a built-in map leaves. It holds one rule for each function
// over each of the three algebras, which are read side by side.

#include <cmath>

#include "math/functions.h"
#include "trace/expr.h"
#include "trace/formula_terms.h"
#include "trace/index.h"

namespace versorium::formulas {

struct Value {
    enum class Type { real, algebra, truth } type = Type::real;
    bool nonNegative = false;
    Expr part[4] = {};
    int truth = -1;  // the node
};

inline bool isZero(const Expr& a) { return a.isConstant() && a.constant() == 0; }
inline bool isOne(const Expr& a) { return a.isConstant() && a.constant() == 1; }

// Sums and products without the zeros and ones of i, j, k and written-out numbers.
inline Expr plus(const Expr& a, const Expr& b) { return isZero(b) ? a : isZero(a) ? b : a + b; }
inline Expr minus(const Expr& a, const Expr& b) { return isZero(b) ? a : isZero(a) ? -b : a - b; }
inline Expr times(const Expr& a, const Expr& b) {
    if (isZero(a) || isZero(b)) return 0.0;
    if (isOne(a) || isOne(b)) return isOne(a) ? b : a;
    return a * b;
}

class Recorder {
  public:
    Recorder(FormulaSpace space, const std::vector<FormulaParameter>& parameters, Tape& tape,
             FormulaFault& fault)
        : space_(space), tape_(tape), fault_(fault) {
        dimension_ = space == FormulaSpace::complex ? 2 : space == FormulaSpace::quaternion ? 4 : 1;
        for (int k = 0; k < tape.stateSize; ++k)
            state_.push_back({&tape, tape.add({.op = Op::state, .index = k})});
        int index = 0;
        for (const FormulaParameter& parameter : parameters) {
            Value value;
            const int width = widthOf(parameter.kind);
            for (int k = 0; k < 4; ++k) value.part[k] = 0.0;
            for (int k = 0; k < width; ++k)
                value.part[k] = {&tape, tape.add({.op = Op::parameter, .index = index++})};
            if (width > 1) value.type = Value::Type::algebra;
            parameters_.push_back(value);
            whole_.push_back(parameter.kind == FormulaKind::whole);
        }
        tape.parameterSize = index;
    }

    bool failed() const { return failed_; }
    bool full() const { return static_cast<int>(tape_.nodes.size()) > kFormulaNodes; }

    // All terms; the last value is the expression's.
    std::vector<Value> record(const Expression& expression) {
        std::vector<Value> values;
        for (const Term& term : expression.terms) {
            values.push_back(failed_ ? Value{} : apply(expression, term, values));
            if (!failed_ && full())
                fail(term.position, "the formula takes more than " + std::to_string(kFormulaNodes) +
                                        " operations up to here; make it shorter");
        }
        return values;
    }

    Value apply(const Expression& expression, const Term& term, const std::vector<Value>& values) {
        const auto operand = [&](int index) -> Value {
            const Value& value = values[at(index)];
            if (value.type == Value::Type::truth)
                fail(expression.terms[at(index)].position,
                     "a number is expected here, not a comparison");
            return value;
        };
        switch (term.kind) {
            case TermKind::number:
                return real(term.number, term.number >= 0);
            case TermKind::unit: {
                Value unit = algebra();
                unit.part[term.index] = 1.0;
                return unit;
            }
            case TermKind::variable:
                return variable(term.index);
            case TermKind::name:
                return parameters_[at(term.index)];
            case TermKind::component:
                return component(term, operand(term.a));
            case TermKind::add:
                return add(operand(term.a), operand(term.b));
            case TermKind::subtract:
                return subtract(operand(term.a), operand(term.b));
            case TermKind::multiply:
                return multiply(operand(term.a), operand(term.b));
            case TermKind::divide:
                return divide(operand(term.a), operand(term.b));
            case TermKind::negate:
                return negate(operand(term.a));
            case TermKind::power:
                return raise(expression, term, operand(term.a), operand(term.b));
            case TermKind::call:
                return call(expression, term, values);
            default:
                return logic(expression, term, values);
        }
    }

    Value real(const Expr& value, bool nonNegative = false) const {
        Value result;
        result.part[0] = value;
        result.nonNegative = nonNegative;
        return result;
    }
    Value algebra() const {
        Value value;
        value.type = Value::Type::algebra;
        for (Expr& part : value.part) part = 0.0;
        return value;
    }
    // A real number as a complex number or a quaternion.
    Value promoted(const Value& value) const {
        if (value.type == Value::Type::algebra || dimension_ == 1) return value;
        Value result = algebra();
        result.part[0] = value.part[0];
        return result;
    }

    Value add(const Value& a, const Value& b) const {
        if (isReal(a) && isReal(b))
            return real(a.part[0] + b.part[0], a.nonNegative && b.nonNegative);
        return eachPart(promoted(a), promoted(b), plus);
    }
    Value subtract(const Value& a, const Value& b) const {
        if (isReal(a) && isReal(b)) return real(a.part[0] - b.part[0]);
        return eachPart(promoted(a), promoted(b), minus);
    }
    Value negate(const Value& a) const {
        Value result = a;
        result.nonNegative = false;
        for (int k = 0; k < width(a); ++k) result.part[k] = -a.part[k];
        return result;
    }
    Value multiply(const Value& a, const Value& b) const {
        if (isReal(a) && isReal(b))
            return real(a.part[0] * b.part[0], a.nonNegative && b.nonNegative);
        if (isReal(a) || isReal(b)) {
            const Expr& scale = isReal(a) ? a.part[0] : b.part[0];
            Value result = isReal(a) ? b : a;
            for (int k = 0; k < dimension_; ++k) result.part[k] = times(scale, result.part[k]);
            return result;
        }
        const Expr *p = a.part, *q = b.part;
        Value result = algebra();
        if (dimension_ == 2) {
            result.part[0] = minus(times(p[0], q[0]), times(p[1], q[1]));
            result.part[1] = plus(times(p[0], q[1]), times(p[1], q[0]));
            return result;
        }
        const auto row = [&](int i, int j, int k, int l, int sj, int sk, int sl) {
            const auto step = [](const Expr& sum, const Expr& term, int sign) {
                return sign > 0 ? plus(sum, term) : minus(sum, term);
            };
            Expr sum = times(p[0], q[i]);
            sum = step(sum, times(p[1], q[j]), sj);
            sum = step(sum, times(p[2], q[k]), sk);
            return step(sum, times(p[3], q[l]), sl);
        };
        result.part[0] = row(0, 1, 2, 3, -1, -1, -1);
        result.part[1] = row(1, 0, 3, 2, 1, 1, -1);
        result.part[2] = row(2, 3, 0, 1, -1, 1, 1);
        result.part[3] = row(3, 2, 1, 0, 1, -1, 1);
        return result;
    }
    Value divide(const Value& a, const Value& b) const {
        if (isReal(b)) {
            Value result = a;
            result.nonNegative = a.nonNegative && b.nonNegative;
            for (int k = 0; k < width(a); ++k) result.part[k] = a.part[k] / b.part[0];
            return result;
        }
        return multiply(a, inverted(b));
    }
    Value raised(const Value& base, int exponent) const {
        Value result = promotedOne(base), power = base;
        bool untouched = true;
        for (int left = std::abs(exponent); left > 0; left >>= 1) {
            if (left & 1) {
                result = untouched ? power : multiply(result, power);
                untouched = false;
            }
            if (left > 1) power = squared(power);
        }
        if (exponent < 0)
            result = isReal(result) ? real(Expr(1.0) / result.part[0]) : inverted(result);
        result.nonNegative = isReal(base) && (exponent % 2 == 0 || base.nonNegative);
        return result;
    }
    bool isConstantZero(const Value& a) const {
        for (int k = 0; k < width(a); ++k)
            if (!isZero(a.part[k])) return false;
        return true;
    }

  private:
    static bool isReal(const Value& a) { return a.type == Value::Type::real; }
    int width(const Value& a) const { return isReal(a) ? 1 : dimension_; }
    void fail(std::size_t position, std::string message) {
        if (!failed_) fault_ = {position, std::move(message)};
        failed_ = true;
    }
    const char* kindOfNumber() const {
        return dimension_ == 2 ? "a complex number" : "a quaternion";
    }

    template <class Operation>
    Value eachPart(const Value& a, const Value& b, Operation operation) const {
        Value result = algebra();
        for (int k = 0; k < dimension_; ++k) result.part[k] = operation(a.part[k], b.part[k]);
        return result;
    }
    Complex<Expr> complexOf(const Value& a) const { return {a.part[0], a.part[1]}; }
    Quaternion<Expr> quaternionOf(const Value& a) const {
        return {a.part[0], a.part[1], a.part[2], a.part[3]};
    }
    Value valueOf(const Complex<Expr>& z) const {
        Value value = algebra();
        value.part[0] = z.re, value.part[1] = z.im;
        return value;
    }
    Value valueOf(const Quaternion<Expr>& q) const {
        Value value = algebra();
        value.part[0] = q.w, value.part[1] = q.x, value.part[2] = q.y, value.part[3] = q.z;
        return value;
    }
    bool hasConstantPart(const Value& a) const {
        for (int k = 0; k < width(a); ++k)
            if (a.part[k].isConstant()) return true;
        return false;
    }
    Value squared(const Value& a) const {
        if (isReal(a)) return multiply(a, a);
        if (hasConstantPart(a)) return multiply(a, a);
        return dimension_ == 2 ? valueOf(square(complexOf(a))) : valueOf(square(quaternionOf(a)));
    }
    Value inverted(const Value& a) const {
        return dimension_ == 2 ? valueOf(inverse(complexOf(a))) : valueOf(inverse(quaternionOf(a)));
    }
    Value promotedOne(const Value& like) const {
        return isReal(like) ? real(1.0, true) : promoted(real(1.0));
    }

    // Functions stand on a tape, constants do not yet; they are computed when it is simplified.
    Expr onTape(const Expr& a) const { return {&tape_, a.on(&tape_)}; }
    Value onTape(Value a) const {
        for (int k = 0; k < width(a); ++k) a.part[k] = onTape(a.part[k]);
        return a;
    }

    Value variable(int index) const {
        if (dimension_ == 1) return real(state_[at(index)]);
        Value value = algebra();
        for (int k = 0; k < dimension_; ++k) value.part[k] = state_[at(k)];
        return value;
    }
    Value component(const Term& term, const Value& a) {
        const Value whole = promoted(a);
        if (dimension_ == 1 || term.index >= dimension_) {
            fail(term.position, dimension_ == 1
                                    ? "real numbers have no components"
                                    : "complex numbers have the components .re and .im");
            return {};
        }
        return real(whole.part[term.index]);
    }

    Value raise(const Expression& expression, const Term& term, const Value& base,
                const Value& exponent) {
        const Expr& e = exponent.part[0];
        if (isReal(exponent) && e.isConstant() && std::floor(e.constant()) == e.constant() &&
            std::abs(e.constant()) <= kLargestWholePower)
            return raised(base, static_cast<int>(e.constant()));
        const Term& written = expression.terms[at(term.b)];
        const bool whole = written.kind == TermKind::name && whole_[at(written.index)];
        if (isReal(exponent)) {
            if (dimension_ == 1 && whole)
                return real(power(Complex<Expr>{onTape(base.part[0]), onTape(0.0)}, onTape(e)).re);
            if (isReal(base) && (dimension_ == 1 || base.nonNegative))
                return real(pow(onTape(base.part[0]), onTape(e)), base.nonNegative);
            const Value own = onTape(promoted(base));
            return dimension_ == 2 ? valueOf(power(complexOf(own), onTape(e)))
                                   : valueOf(power(quaternionOf(own), onTape(e)));
        }
        if (dimension_ == 4) {
            fail(written.position,
                 "the exponent of a quaternion formula is a real number; write exp(w*log(q)) in "
                 "the order that you mean");
            return {};
        }
        return valueOf(functions::complexExponent(complexOf(onTape(promoted(base))),
                                                  complexOf(onTape(exponent))));
    }

    // f as a function of a real number, a complex number or a quaternion.
    template <class Apply>
    Value elementary(const Value& a, Apply apply, bool staysReal) const {
        if (isReal(a) && (staysReal || dimension_ == 1)) return real(apply(onTape(a.part[0])));
        const Value own = onTape(promoted(a));
        if (dimension_ == 2) return valueOf(apply(complexOf(own)));
        return valueOf(functions::alongAxis(quaternionOf(own), apply));
    }

    Expr normOf(const Value& a) const {
        if (isReal(a)) return a.part[0] * a.part[0];
        return dimension_ == 2 ? squaredNorm(complexOf(a)) : squaredNorm(quaternionOf(a));
    }
    Value argumentOf(const Value& a) const {
        const Value own = onTape(promoted(a));
        if (dimension_ == 4)
            return real(atan2(sqrt(own.part[1] * own.part[1] + own.part[2] * own.part[2] +
                                   own.part[3] * own.part[3]),
                              own.part[0]));
        if (dimension_ == 1) return real(atan2(onTape(0.0), own.part[0]));
        return real(atan2(functions::fromAbove(own.part[1]), own.part[0]));
    }

    Value call(const Expression& expression, const Term& term, const std::vector<Value>& values) {
        const auto function = static_cast<Function>(term.index);
        if (function == Function::choose) return choose(expression, term, values);
        const Value& a = values[at(term.a)];
        for (int index : {term.a, term.b})
            if (index >= 0 && values[at(index)].type == Value::Type::truth) {
                fail(expression.terms[at(index)].position,
                     "a number is expected here, not a comparison");
                return {};
            }
        if (function == Function::min || function == Function::max || function == Function::atan2 ||
            function == Function::floor) {
            for (int index : {term.a, term.b})
                if (index >= 0 && !isReal(values[at(index)])) {
                    fail(expression.terms[at(index)].position,
                         std::string("a real number is expected here, not ") + kindOfNumber() +
                             "; re(…) and abs(…) give one");
                    return {};
                }
            const Expr x = onTape(a.part[0]);
            if (function == Function::floor) return real(floor(x), a.nonNegative);
            const Value& b = values[at(term.b)];
            const Expr y = onTape(b.part[0]);
            if (function == Function::atan2) return real(atan2(x, y));
            return function == Function::min ? real(min(x, y), a.nonNegative && b.nonNegative)
                                             : real(max(x, y), a.nonNegative || b.nonNegative);
        }
        return callOfOne(function, a);
    }

    Value callOfOne(Function function, const Value& a) const {
        switch (function) {
            case Function::exp: {
                Value value = elementary(
                    a,
                    [](const auto& x) {
                        using functions::exp;
                        return exp(x);
                    },
                    true);
                value.nonNegative = isReal(value);
                return value;
            }
            case Function::log:
                return elementary(
                    a,
                    [](const auto& x) {
                        using functions::log;
                        return log(x);
                    },
                    a.nonNegative);
            case Function::sqrt: {
                Value value = elementary(
                    a,
                    [](const auto& x) {
                        using functions::sqrt;
                        return sqrt(x);
                    },
                    a.nonNegative);
                value.nonNegative = isReal(value);
                return value;
            }
            case Function::sin:
                return elementary(
                    a,
                    [](const auto& x) {
                        using functions::sin;
                        return sin(x);
                    },
                    true);
            case Function::cos:
                return elementary(
                    a,
                    [](const auto& x) {
                        using functions::cos;
                        return cos(x);
                    },
                    true);
            case Function::tan:
                return elementary(
                    a, [](const auto& x) { return functions::tan(x); }, true);
            case Function::sinh:
                return elementary(
                    a, [](const auto& x) { return functions::sinh(x); }, true);
            case Function::cosh:
                return elementary(
                    a, [](const auto& x) { return functions::cosh(x); }, true);
            case Function::tanh:
                return elementary(
                    a, [](const auto& x) { return functions::tanh(x); }, true);
            case Function::asin:
                return elementary(
                    a, [](const auto& x) { return functions::asin(x); }, false);
            case Function::acos:
                return elementary(
                    a, [](const auto& x) { return functions::acos(x); }, false);
            case Function::atan:
                return elementary(
                    a, [](const auto& x) { return functions::atan(x); }, true);
            case Function::asinh:
                return elementary(
                    a, [](const auto& x) { return functions::asinh(x); }, true);
            case Function::acosh:
                return elementary(
                    a, [](const auto& x) { return functions::acosh(x); }, false);
            case Function::atanh:
                return elementary(
                    a, [](const auto& x) { return functions::atanh(x); }, false);
            case Function::abs:
                if (isReal(a)) return real(abs(onTape(a.part[0])), true);
                return real(sqrt(normOf(onTape(a))), true);
            case Function::norm:
                return real(normOf(a), true);
            case Function::arg:
                return argumentOf(a);
            case Function::re:
                return real(a.part[0], isReal(a) && a.nonNegative);
            case Function::im: {
                if (dimension_ < 4) return real(isReal(a) ? Expr(0.0) : a.part[1], isReal(a));
                Value vector = promoted(a);
                vector.part[0] = 0.0;
                return vector;
            }
            default: {  // conj
                Value value = a;
                for (int k = 1; k < width(a); ++k) value.part[k] = -a.part[k];
                return value;
            }
        }
    }

    Truth truthOf(const Value& value) const { return {&tape_, value.truth}; }
    Value valueOf(const Truth& truth) const {
        Value value;
        value.type = Value::Type::truth;
        value.truth = truth.node();
        return value;
    }
    bool wantsTruth(const Expression& expression, int index, const std::vector<Value>& values) {
        if (values[at(index)].type == Value::Type::truth) return true;
        fail(expression.terms[at(index)].position,
             "a comparison such as abs(z) < 1 is expected here, not a number");
        return false;
    }

    Value choose(const Expression& expression, const Term& term, const std::vector<Value>& values) {
        if (!wantsTruth(expression, term.a, values)) return {};
        Value yes = values[at(term.b)], no = values[at(term.c)];
        for (int index : {term.b, term.c})
            if (values[at(index)].type == Value::Type::truth) {
                fail(expression.terms[at(index)].position,
                     "a number is expected here, not a comparison");
                return {};
            }
        const bool nonNegative = yes.nonNegative && no.nonNegative;
        if (!isReal(yes) || !isReal(no)) yes = promoted(yes), no = promoted(no);
        Value result = yes;
        for (int k = 0; k < width(yes); ++k)
            result.part[k] = select(truthOf(values[at(term.a)]), yes.part[k], no.part[k]);
        result.nonNegative = nonNegative;
        return result;
    }

    Value logic(const Expression& expression, const Term& term, const std::vector<Value>& values) {
        const Value& a = values[at(term.a)];
        if (term.kind == TermKind::negation)
            return wantsTruth(expression, term.a, values) ? valueOf(!truthOf(a)) : Value{};
        const Value& b = values[at(term.b)];
        if (term.kind == TermKind::conjunction || term.kind == TermKind::disjunction) {
            if (!wantsTruth(expression, term.a, values) || !wantsTruth(expression, term.b, values))
                return {};
            return valueOf(term.kind == TermKind::conjunction ? truthOf(a) & truthOf(b)
                                                              : truthOf(a) | truthOf(b));
        }
        for (int index : {term.a, term.b})
            if (!isReal(values[at(index)])) {
                fail(expression.terms[at(index)].position,
                     values[at(index)].type == Value::Type::truth
                         ? "comparisons cannot be compared; join them with \"and\""
                         : std::string("only real numbers can be compared, and this is ") +
                               kindOfNumber() + "; re(…) and abs(…) give one");
                return {};
            }
        const Expr x = onTape(a.part[0]), y = onTape(b.part[0]);
        switch (term.kind) {
            case TermKind::less:
                return valueOf(x < y);
            case TermKind::lessEqual:
                return valueOf(x <= y);
            case TermKind::greater:
                return valueOf(x > y);
            case TermKind::greaterEqual:
                return valueOf(x >= y);
            case TermKind::equal:
                return valueOf(x == y);
            default:
                return valueOf(x != y);
        }
    }

    FormulaSpace space_;
    Tape& tape_;
    FormulaFault& fault_;
    bool failed_ = false;
    int dimension_ = 1;
    std::vector<Expr> state_;
    std::vector<Value> parameters_;
    std::vector<bool> whole_;
};

// Which parameters the critical points of a complex formula may follow, and the derivative where it
// is a polynomial.
void findCritical(const Expression& expression, Formula& formula);

}  // namespace versorium::formulas
