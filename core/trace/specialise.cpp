// SPDX-License-Identifier: MIT
#include "trace/specialise.h"

#include <cassert>

#include "trace/index.h"

namespace versorium {
namespace {

constexpr int kZero = -2;  // in place of a node: the number 0

class Specialiser {
  public:
    Specialiser(const Tape& tape, const std::vector<char>& zero) : from_(tape), zero_(zero) {}

    Tape run() {
        for (std::size_t i = 0; i < from_.nodes.size(); ++i) reduced_.push_back(reduce(i));
        markLive();
        to_.stateSize = from_.stateSize;
        to_.parameterSize = from_.parameterSize;
        copies_.assign(from_.nodes.size(), -1);
        for (std::size_t i = 0; i < from_.nodes.size(); ++i) copy(i);
        for (int output : from_.outputs) to_.outputs.push_back(operand(output));
        return std::move(to_);
    }

  private:
    // What a node has become: itself, an earlier node, or 0.
    int resolved(int node) const { return node < 0 ? node : reduced_[at(node)]; }

    int reduce(std::size_t i) {
        const Node& node = from_.nodes[i];
        const int self = static_cast<int>(i);
        const int a = resolved(node.a), b = resolved(node.b);
        switch (node.op) {
            case Op::parameter:
                return at(node.index) < zero_.size() && zero_[at(node.index)] ? kZero : self;
            case Op::multiply:
                return a == kZero || b == kZero ? kZero : self;
            case Op::add:
                return a == kZero ? b : b == kZero ? a : self;
            case Op::subtract:
                return b == kZero ? a : self;
            case Op::negate:
                return a == kZero ? kZero : self;
            default:
                return self;
        }
    }

    void markLive() {
        live_.assign(from_.nodes.size(), 0);
        for (int output : from_.outputs) need(output);
        // Loops stay as they are, with all that steers them.
        for (std::size_t i = from_.nodes.size(); i-- > 0;) {
            const Node& node = from_.nodes[i];
            if (node.op == Op::loopBegin || node.op == Op::loopVariable || node.op == Op::loopEnd)
                live_[i] = 1;
            if (node.op == Op::loopEnd)
                for (const Tape::Update& update : from_.updates[at(node.index)]) need(update.next);
            if (!live_[i]) continue;
            for (int operand : {node.a, node.b, node.c, node.d, node.e}) need(operand);
        }
    }
    void need(int node) {
        if (const int now = resolved(node); now >= 0) live_[at(now)] = 1;
    }

    // The copy of an operand, as it stands in the new tape.
    int operand(int node) {
        const int now = resolved(node);
        if (now == kZero) return to_.add({.op = Op::constant, .constant = 0});
        return now < 0 ? now : copies_[at(now)];
    }

    void copy(std::size_t i) {
        if (!live_[i] || (reduced_[i] != static_cast<int>(i))) return;
        Node node = from_.nodes[i];
        if (node.op == Op::loopBegin) return to_.beginLoop(node.index);
        if (node.op == Op::loopEnd) {
            std::vector<Tape::Update> updates;
            for (const Tape::Update& update : from_.updates[at(node.index)])
                updates.push_back({copies_[at(update.variable)], operand(update.next)});
            return to_.endLoop(std::move(updates));
        }
        // 0 - b, of which nothing but the sign is left.
        if (node.op == Op::subtract && resolved(node.a) == kZero)
            node = {.op = Op::negate, .a = node.b};
        for (int* part : {&node.a, &node.b, &node.c, &node.d, &node.e}) *part = operand(*part);
        copies_[i] = to_.add(node);
    }

    const Tape& from_;
    const std::vector<char>& zero_;
    std::vector<int> reduced_, copies_;
    std::vector<char> live_;
    Tape to_;
};

}  // namespace

Tape specialise(const Tape& tape, const std::vector<char>& zero) {
    return Specialiser(tape, zero).run();
}

}  // namespace versorium
