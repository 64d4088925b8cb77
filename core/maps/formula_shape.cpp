// SPDX-License-Identifier: MIT
#include "maps/formula_shape.h"

#include <algorithm>

#include "maps/shape_modulus.h"
#include "trace/program.h"

namespace versorium {
namespace {

constexpr auto kComplexOwn = shape_modulus::ownParameters<false>();
constexpr auto kQuaternionOwn = shape_modulus::ownParameters<true>();

FormulaKind kindOf(ParameterKind kind) {
    switch (kind) {
        case ParameterKind::complex:
            return FormulaKind::complex;
        case ParameterKind::quaternion:
            return FormulaKind::quaternion;
        case ParameterKind::whole:
            return FormulaKind::whole;
        default:
            return FormulaKind::real;
    }
}

std::vector<FormulaParameter> parametersOf(std::span<const ParameterInfo> own) {
    std::vector<FormulaParameter> all;
    for (const ParameterInfo& info : own)
        all.push_back({.name = std::string(info.name),
                       .kind = kindOf(info.kind),
                       .value = info.value,
                       .low = info.low,
                       .high = info.high});
    return all;
}

// What `from` makes of another state, on another tape with the same parameters.
std::vector<Expr> inlined(const Tape& from, const std::vector<Expr>& state,
                          const std::vector<Expr>& parameters, Tape* tape) {
    std::vector<int> place;
    for (Node node : from.nodes) {
        const auto index = static_cast<std::size_t>(node.index);
        if (node.op == Op::state) {
            place.push_back(state[index].on(tape));
        } else if (node.op == Op::parameter) {
            place.push_back(parameters[index].on(tape));
        } else {
            for (int* operand : {&node.a, &node.b, &node.c, &node.d, &node.e})
                if (*operand >= 0) *operand = place[static_cast<std::size_t>(*operand)];
            place.push_back(tape->add(node));
        }
    }
    std::vector<Expr> outputs;
    for (int output : from.outputs)
        outputs.emplace_back(tape, place[static_cast<std::size_t>(output)]);
    return outputs;
}

template <template <class> class Z>
Tape record(const Formula& formula) {
    using State = Z<Expr>;
    using Controls = shape_modulus::Controls<Expr, State>;
    Tape tape;
    tape.stateSize = State::kDimension;
    tape.parameterSize = formula.tape.parameterSize;
    std::vector<Expr> state, parameters;
    for (int k = 0; k < tape.stateSize; ++k)
        state.emplace_back(&tape, tape.add({.op = Op::state, .index = k}));
    for (int k = 0; k < tape.parameterSize; ++k)
        parameters.emplace_back(&tape, tape.add({.op = Op::parameter, .index = k}));
    Environment<Expr> environment;
    environment.tape = &tape;
    const State next = shape_modulus::stepAround(
        Layout<State>::load(state.data()), Layout<Controls>::load(parameters.data()),
        Field<Expr>(environment), [&](const State& x) {
            std::vector<Expr> moved(state.size());
            Layout<State>::store(x, moved.data());
            return Layout<State>::load(inlined(formula.tape, moved, parameters, &tape).data());
        });
    Layout<State>::store(next, state.data());
    for (const Expr& part : state) tape.outputs.push_back(part.on(&tape));
    return simplified(tape);
}

}  // namespace

std::span<const ParameterInfo> shapeParameters(FormulaSpace space) {
    if (space == FormulaSpace::complex) return kComplexOwn;
    return kQuaternionOwn;
}

const FormulaShape& formulaShape() {
    static const FormulaShape kShape{parametersOf(kComplexOwn), parametersOf(kQuaternionOwn)};
    return kShape;
}

Tape shapeTape(const Formula& formula) {
    return formula.space == FormulaSpace::complex ? record<Complex>(formula)
                                                  : record<Quaternion>(formula);
}

}  // namespace versorium
