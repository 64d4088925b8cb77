// SPDX-License-Identifier: MIT
// From terms to a tape.
#include <algorithm>
#include <cmath>

#include "trace/formula_recorder.h"
#include "trace/program.h"

namespace versorium::formulas {

bool recordFormula(const std::vector<Expression>& components, Formula& formula,
                   FormulaFault& fault) {
    Tape tape;
    tape.stateSize = dimensionOf(formula.space);
    Recorder recorder(formula.space, formula.parameters, tape, fault);
    for (const Expression& expression : components) {
        const std::vector<Value> values = recorder.record(expression);
        if (recorder.failed()) return false;
        if (values.back().type == Value::Type::truth) {
            fault = {expression.terms.back().position,
                     "the formula's value is a comparison; if(…, a, b) makes a number of it"};
            return false;
        }
        const Value value = recorder.promoted(values.back());
        const int parts = components.size() == 2 ? 1 : tape.stateSize;
        for (int k = 0; k < parts; ++k) tape.outputs.push_back(value.part[k].on(&tape));
    }
    if (static_cast<int>(tape.nodes.size()) > kFormulaNodes) {
        fault = {0, "the formula takes more than " + std::to_string(kFormulaNodes) +
                        " operations; make it shorter"};
        return false;
    }
    formula.tape = simplified(tape);
    formula.components = std::make_shared<const std::vector<Expression>>(components);
    if (formula.shape) {
        // Neither a polynomial's growth nor its critical points are left.
        formula.movesCritical.assign(at(tape.parameterSize), true);
        return true;
    }
    if (formula.space == FormulaSpace::complex) findCritical(components[0], formula);
    return true;
}

bool constantOf(const Expression& expression, FormulaSpace space, FormulaKind kind,
                std::array<double, 4>& value, FormulaFault& fault) {
    Tape tape;
    // Room for the value: a program's outputs are its state.
    const FormulaSpace own = kind == FormulaKind::complex && space == FormulaSpace::quaternion
                                 ? FormulaSpace::complex
                                 : space;
    Recorder recorder(own, {}, tape, fault);
    const std::vector<Value> values = recorder.record(expression);
    if (recorder.failed()) return false;
    const int width = widthOf(kind);
    if (values.back().type == Value::Type::truth ||
        (values.back().type == Value::Type::algebra && width == 1)) {
        fault = {expression.terms.back().position, "the default must be a real number"};
        return false;
    }
    const Value result = width > 1 ? recorder.promoted(values.back()) : values.back();
    for (int k = 0; k < width; ++k) tape.outputs.push_back(result.part[k].on(&tape));
    const Tape made = simplified(tape);
    value = {};
    for (int k = 0; k < width; ++k) {
        const Node& node = made.nodes[at(made.outputs[at(k)])];
        if (node.op != Op::constant || !(std::abs(node.constant) <= kFormulaLargest)) {
            fault = {expression.terms[0].position,
                     "the default must be a finite number of moderate size"};
            return false;
        }
        value[at(k)] = node.constant;
    }
    return true;
}

}  // namespace versorium::formulas
