// SPDX-License-Identifier: MIT
#include "trace/program.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "trace/expr.h"
#include "trace/index.h"
#include "trace/interpret.h"

namespace versorium {
namespace {

// ---- simplifying -------------------------------------------------------------------------------

bool isInput(Op op) { return op == Op::constant || op == Op::state || op == Op::parameter; }
// What these give is not known before something is bound.
bool looksUp(Op op) { return op == Op::distance || op == Op::alphaAt || op == Op::betaAt; }

// The value of an operation on constants.
double valueOf(Node node, const std::vector<std::optional<double>>& known) {
    Tape tape;
    for (int* operand : {&node.a, &node.b, &node.c, &node.d, &node.e})
        if (*operand >= 0) {
            tape.nodes.push_back({.op = Op::constant, .constant = *known[at(*operand)]});
            *operand = static_cast<int>(tape.nodes.size()) - 1;
        }
    tape.nodes.push_back(node);
    tape.outputs = {static_cast<int>(tape.nodes.size()) - 1};
    double value = 0;
    interpret(tape, &value, &value, NothingBound{}, &value);
    return value;
}

std::vector<char> neededNodes(const std::vector<Node>& nodes, const std::vector<int>& outputs) {
    std::vector<char> needed(nodes.size(), 0);
    for (int output : outputs) needed[at(output)] = 1;
    for (std::size_t i = nodes.size(); i-- > 0;)
        if (needed[i])
            for (int operand : {nodes[i].a, nodes[i].b, nodes[i].c, nodes[i].d, nodes[i].e})
                if (operand >= 0) needed[at(operand)] = 1;
    return needed;
}

// ---- the program -------------------------------------------------------------------------------

// An instruction whose registers may be as many as it likes: the fixed ones come first.
struct Draft {
    Code code = Code::move;
    std::vector<int> out, in;  // a, b, c, d, e
    bool reads(int value) const { return std::find(in.begin(), in.end(), value) != in.end(); }
};

Code codeOf(Op op) {
    switch (op) {
        case Op::add:
            return Code::add;
        case Op::subtract:
            return Code::subtract;
        case Op::multiply:
            return Code::multiply;
        case Op::divide:
            return Code::divide;
        case Op::negate:
            return Code::negate;
        case Op::squareRoot:
            return Code::squareRoot;
        case Op::absolute:
            return Code::absolute;
        case Op::minimum:
            return Code::minimum;
        case Op::maximum:
            return Code::maximum;
        case Op::floor:
            return Code::floor;
        case Op::exponential:
            return Code::exponential;
        case Op::logarithm:
            return Code::logarithm;
        case Op::sine:
            return Code::sine;
        case Op::cosine:
            return Code::cosine;
        case Op::angle:
            return Code::angle;
        case Op::power:
            return Code::power;
        case Op::less:
            return Code::less;
        case Op::lessEqual:
            return Code::lessEqual;
        case Op::equal:
            return Code::equal;
        case Op::notEqual:
            return Code::notEqual;
        case Op::conjunction:
            return Code::conjunction;
        case Op::disjunction:
            return Code::disjunction;
        case Op::negation:
            return Code::negation;
        case Op::select:
            return Code::select;
        case Op::complexPower:
            return Code::complexPower;
        case Op::quaternionPower:
            return Code::quaternionPower;
        case Op::distance:
            return Code::distance;
        case Op::alphaAt:
            return Code::alphaAt;
        case Op::betaAt:
            return Code::betaAt;
        default:
            assert(false && "lists are not for programs");
            return Code::move;
    }
}

class Drafting {
  public:
    explicit Drafting(const Tape& tape)
        : tape_(tape), value_(tape.nodes.size(), -1), uses_(tape.nodes.size(), 0) {
        for (const Node& node : tape.nodes)
            for (int operand : {node.a, node.b, node.c, node.d, node.e})
                if (operand >= 0) ++uses_[at(operand)];
        for (int output : tape.outputs) ++uses_[at(output)];
        placeInputs();
        fuse();
        for (std::size_t i = 0; i < tape.nodes.size(); ++i) draft(static_cast<int>(i));
        finish();
    }

    std::vector<Draft> drafts;
    std::vector<double> constants;
    int fixed() const { return fixed_; }
    int values() const { return next_; }

  private:
    struct Fusion {
        Code code;
        std::vector<int> in;  // nodes
    };

    void placeInputs() {
        next_ = tape_.stateSize + tape_.parameterSize;
        for (std::size_t i = 0; i < tape_.nodes.size(); ++i) {
            const Node& node = tape_.nodes[i];
            if (node.op == Op::state) value_[i] = node.index;
            if (node.op == Op::parameter) value_[i] = tape_.stateSize + node.index;
            if (node.op != Op::constant) continue;
            value_[i] = next_++;
            constants.push_back(node.constant);
        }
        fixed_ = next_;
    }

    // From the last node on, so that what a fusion takes in is not fused by itself.
    void fuse() {
        fused_.resize(tape_.nodes.size());
        absorbed_.assign(tape_.nodes.size(), 0);
        const auto takes = [&](int node, Op op) {
            return tape_.nodes[at(node)].op == op && uses_[at(node)] == 1;
        };
        for (std::size_t i = tape_.nodes.size(); i-- > 0;) {
            const Node& n = tape_.nodes[i];
            if (absorbed_[i] || (n.op != Op::add && n.op != Op::subtract)) continue;
            const bool sum = n.op == Op::add;
            const Node &a = tape_.nodes[at(n.a)], &b = tape_.nodes[at(n.b)];
            const bool left = takes(n.a, Op::multiply), right = takes(n.b, Op::multiply);
            if (left && right)
                fused_[i] = {sum ? Code::productsAdd : Code::productsSubtract,
                             {a.a, a.b, b.a, b.b}};
            else if (left)
                fused_[i] = {sum ? Code::multiplyAdd : Code::multiplySubtract, {a.a, a.b, n.b}};
            else if (right)
                fused_[i] = {sum ? Code::multiplyAdd : Code::subtractProduct, {b.a, b.b, n.a}};
            else if (sum && takes(n.a, Op::add))
                fused_[i] = {Code::sumAdd, {a.a, a.b, n.b}};
            else if (sum && takes(n.b, Op::add))
                fused_[i] = {Code::sumAdd, {b.a, b.b, n.a}};
            else
                continue;
            const bool sumOfSums = fused_[i]->code == Code::sumAdd;
            if (left || (sumOfSums && takes(n.a, Op::add))) absorbed_[at(n.a)] = 1;
            if (right || (sumOfSums && !takes(n.a, Op::add))) absorbed_[at(n.b)] = 1;
        }
    }

    void draft(int i) {
        const Node& n = tape_.nodes[at(i)];
        if (isInput(n.op) || absorbed_[at(i)] || value_[at(i)] >= 0) return;
        Draft made;
        std::vector<int> nodes;
        if (fused_[at(i)]) {
            made.code = fused_[at(i)]->code;
            nodes = fused_[at(i)]->in;
        } else {
            made.code = codeOf(n.op);
            for (int operand : {n.a, n.b, n.c, n.d, n.e})
                if (operand >= 0) nodes.push_back(operand);
        }
        for (int node : nodes) made.in.push_back(value_[at(node)]);
        const int parts = n.op == Op::complexPower ? 2 : n.op == Op::quaternionPower ? 4 : 1;
        for (int k = 0; k < parts; ++k) made.out.push_back(next_++);
        if (parts == 1) {
            value_[at(i)] = made.out[0];
        } else {
            // All components of one power together.
            for (std::size_t j = at(i); j < tape_.nodes.size(); ++j) {
                Node other = tape_.nodes[j];
                const int component = other.index;
                other.index = n.index;
                if (other == n) value_[j] = made.out[at(component)];
            }
        }
        drafts.push_back(std::move(made));
    }

    // The outputs go to the state's registers: the operations that make them come last, each as
    // soon as nobody needs what it overwrites.
    void finish() {
        std::vector<Draft> finals;
        for (std::size_t k = 0; k < tape_.outputs.size(); ++k) {
            const int target = static_cast<int>(k);
            const int value = value_[at(tape_.outputs[k])];
            if (value == target) continue;
            const auto maker = std::find_if(drafts.begin(), drafts.end(), [&](const Draft& d) {
                return d.out.size() == 1 && d.out[0] == value;
            });
            if (maker != drafts.end() && uses_[at(tape_.outputs[k])] == 1) {
                finals.push_back(*maker);
                finals.back().out = {target};
                drafts.erase(maker);
            } else {
                finals.push_back({Code::move, {target}, {value}});
            }
        }
        while (!finals.empty()) {
            const auto free = std::find_if(finals.begin(), finals.end(), [&](const Draft& one) {
                return std::none_of(finals.begin(), finals.end(), [&](const Draft& other) {
                    return &other != &one && other.reads(one.out[0]);
                });
            });
            if (free != finals.end()) {
                drafts.push_back(*free);
                finals.erase(free);
                continue;
            }
            // They wait for each other in a circle: one old component steps aside.
            const int aside = finals.front().out[0];
            drafts.push_back({Code::move, {next_}, {aside}});
            for (Draft& one : finals) std::replace(one.in.begin(), one.in.end(), aside, next_);
            ++next_;
        }
    }

    const Tape& tape_;
    std::vector<int> value_, uses_;
    std::vector<std::optional<Fusion>> fused_;
    std::vector<char> absorbed_;
    int next_ = 0, fixed_ = 0;
};

}  // namespace

Tape simplified(const Tape& tape) {
    assert(tape.updates.empty());
    const std::size_t size = tape.nodes.size();
    std::vector<Node> nodes = tape.nodes;
    std::vector<std::optional<double>> known(size);
    std::vector<int> same(size);  // the node that stands for this one
    for (std::size_t i = 0; i < size; ++i) {
        Node& n = nodes[i];
        same[i] = static_cast<int>(i);
        bool constant = true;
        for (int* operand : {&n.a, &n.b, &n.c, &n.d, &n.e})
            if (*operand >= 0) {
                *operand = same[at(*operand)];
                constant = constant && known[at(*operand)];
            }
        if (looksUp(n.op)) constant = false;
        if (n.op == Op::constant) known[i] = n.constant;
        if (isInput(n.op)) continue;
        if (n.op == Op::select && known[at(n.a)]) {
            same[i] = *known[at(n.a)] != 0 ? n.b : n.c;
            known[i] = known[at(same[i])];
        } else if (constant) {
            known[i] = valueOf(n, known);
            // Truth values stay what they are: a shader has no numbers for them.
            if (!isTruth(n.op)) n = {.op = Op::constant, .constant = *known[i]};
        }
    }
    std::vector<int> outputs;
    for (int output : tape.outputs) outputs.push_back(same[at(output)]);
    const std::vector<char> needed = neededNodes(nodes, outputs);
    Tape result;
    result.stateSize = tape.stateSize;
    result.parameterSize = tape.parameterSize;
    for (int k = 0; k < tape.stateSize; ++k) result.add({.op = Op::state, .index = k});
    for (int k = 0; k < tape.parameterSize; ++k) result.add({.op = Op::parameter, .index = k});
    std::vector<int> place(size, -1);
    for (std::size_t i = 0; i < size; ++i) {
        if (!needed[i]) continue;
        Node node = nodes[i];
        for (int* operand : {&node.a, &node.b, &node.c, &node.d, &node.e})
            if (*operand >= 0) *operand = place[at(*operand)];
        place[i] = result.add(node);
    }
    for (int output : outputs) result.outputs.push_back(place[at(output)]);
    return result;
}

Expected<TapeProgram> TapeProgram::make(const Tape& tape) {
    const Drafting drafting(tape);
    TapeProgram program;
    program.stateSize_ = tape.stateSize;
    program.parameterSize_ = tape.parameterSize;
    program.constants_ = drafting.constants;
    program.registers_ = drafting.fixed();
    const auto tooMany = [] {
        return Status::usage("the formula keeps too many values at once: at most " +
                             std::to_string(kMostRegisters) + " are possible; make it shorter");
    };
    if (program.registers_ > kMostRegisters) return tooMany();
    // A value's register is free again after its last use.
    std::vector<std::size_t> last(at(drafting.values()), 0);
    for (std::size_t i = 0; i < drafting.drafts.size(); ++i)
        for (int value : drafting.drafts[i].in) last[at(value)] = i;
    std::vector<int> place(at(drafting.values()), -1), free;
    for (int k = 0; k < drafting.fixed(); ++k) place[at(k)] = k;
    for (std::size_t i = 0; i < drafting.drafts.size(); ++i) {
        const Draft& draft = drafting.drafts[i];
        Instruction made;
        made.code = draft.code;
        std::uint8_t* operands[] = {&made.a, &made.b, &made.c, &made.d, &made.e};
        // Powers keep their exponent in e.
        const bool power = made.code == Code::complexPower || made.code == Code::quaternionPower;
        for (std::size_t k = 0; k < draft.in.size(); ++k) {
            const std::size_t slot = power && k + 1 == draft.in.size() ? 4 : k;
            *operands[slot] = static_cast<std::uint8_t>(place[at(draft.in[k])]);
        }
        std::vector<int> ended;
        for (int value : draft.in)
            if (value >= drafting.fixed() && last[at(value)] == i &&
                std::find(ended.begin(), ended.end(), value) == ended.end())
                ended.push_back(value);
        for (int value : ended) free.push_back(place[at(value)]);
        std::vector<int> unused;
        for (std::size_t k = 0; k < draft.out.size(); ++k) {
            const int value = draft.out[k];
            if (value >= drafting.fixed()) {
                if (free.empty()) {
                    if (program.registers_ == kMostRegisters) return tooMany();
                    free.push_back(program.registers_++);
                }
                place[at(value)] = free.back();
                free.pop_back();
                if (last[at(value)] <= i) unused.push_back(place[at(value)]);
            }
            made.out[k] = static_cast<std::uint8_t>(place[at(value)]);
        }
        for (int place : unused) free.push_back(place);
        program.instructions_.push_back(made);
    }
    return program;
}

TapeCode TapeProgram::code() const {
    return {instructions_.data(),
            static_cast<int>(instructions_.size()),
            constants_.data(),
            static_cast<int>(constants_.size()),
            stateSize_,
            parameterSize_,
            registers_};
}

}  // namespace versorium
