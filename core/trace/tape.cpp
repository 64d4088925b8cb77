// SPDX-License-Identifier: MIT
#include "trace/tape.h"

#include <cassert>

#include "base/json.h"
#include "trace/expr.h"

namespace versorium {
namespace {

bool sameNode(const Node& a, const Node& b) {
    // NaN and the sign of zero are told apart by their bits.
    return a.op == b.op && a.index == b.index && a.a == b.a && a.b == b.b && a.c == b.c &&
           a.d == b.d && a.e == b.e &&
           __builtin_bit_cast(std::uint64_t, a.constant) ==
               __builtin_bit_cast(std::uint64_t, b.constant);
}

constexpr const char* kNames[] = {"constant",
                                  "state",
                                  "parameter",
                                  "add",
                                  "subtract",
                                  "multiply",
                                  "divide",
                                  "negate",
                                  "sqrt",
                                  "abs",
                                  "min",
                                  "max",
                                  "floor",
                                  "exp",
                                  "log",
                                  "sin",
                                  "cos",
                                  "atan2",
                                  "pow",
                                  "less",
                                  "lessEqual",
                                  "equal",
                                  "notEqual",
                                  "and",
                                  "or",
                                  "not",
                                  "select",
                                  "complexPower",
                                  "quaternionPower",
                                  "distance",
                                  "alphaAt",
                                  "betaAt",
                                  "loopBegin",
                                  "loopVariable",
                                  "listItem",
                                  "loopEnd"};

}  // namespace

int Tape::add(const Node& node) {
    if (node.op != Op::loopVariable)
        for (int candidate : reusable_)
            if (sameNode(nodes[static_cast<std::size_t>(candidate)], node)) return candidate;
    nodes.push_back(node);
    const int number = static_cast<int>(nodes.size()) - 1;
    reusable_.push_back(number);
    return number;
}

void Tape::beginLoop(int list) {
    nodes.push_back({.op = Op::loopBegin, .index = list});
    scopes_.push_back(reusable_.size());
}

void Tape::endLoop(std::vector<Update> update) {
    assert(!scopes_.empty());
    // The loop variables stay in use after the loop; what was computed inside does not.
    nodes.push_back({.op = Op::loopEnd, .index = static_cast<int>(updates.size())});
    updates.push_back(std::move(update));
    reusable_.resize(scopes_.back());
    scopes_.pop_back();
}

int Expr::on(Tape* tape) const {
    assert(tape);
    return tape_ ? node_ : tape->add({.op = Op::constant, .constant = constant_});
}

std::string describe(const Tape& tape) {
    std::string text;
    for (std::size_t i = 0; i < tape.nodes.size(); ++i) {
        const Node& node = tape.nodes[i];
        text += std::to_string(i) + " " + kNames[static_cast<int>(node.op)];
        if (node.op == Op::constant) text += " " + formatNumber(node.constant);
        text += " [" + std::to_string(node.index) + "]";
        for (int operand : {node.a, node.b, node.c, node.d, node.e})
            if (operand >= 0) text += " " + std::to_string(operand);
        text += "\n";
    }
    for (int output : tape.outputs) text += "output " + std::to_string(output) + "\n";
    return text;
}

}  // namespace versorium
