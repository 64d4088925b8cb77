// SPDX-License-Identifier: MIT
#pragma once
// Runs a tape over any number type with the very functions that the recorded code would have
// called, hence with the same bits. Truth values are kept as 0 and 1.

#include <vector>

#include "math/power.h"
#include "trace/tape.h"

namespace versorium {

// Environment: `int listSize(int list)`, `R listItem(int list, int item, int component)`,
// `R distance(R x, R y, R z)` and `R alphaAt(R x, R y, R z, R base)`, `betaAt`, which give what is
// bound to the map.
template <class R, class Environment>
void interpret(const Tape& tape, const R* state, const R* parameters,
               const Environment& environment, R* outputs) {
    std::vector<R> value(tape.nodes.size(), R(0.0));
    const auto at = [&](int node) -> R& { return value[static_cast<std::size_t>(node)]; };
    const auto truth = [](const auto& mask) { return select(mask, R(1.0), R(0.0)); };
    const auto isTrue = [&](int node) { return at(node) != R(0.0); };

    struct Loop {
        int begin, item;
    };
    std::vector<Loop> loops;
    const int size = static_cast<int>(tape.nodes.size());
    for (int i = 0; i < size; ++i) {
        const Node& n = tape.nodes[static_cast<std::size_t>(i)];
        switch (n.op) {
            case Op::constant:
                at(i) = R(n.constant);
                break;
            case Op::state:
                at(i) = state[n.index];
                break;
            case Op::parameter:
                at(i) = parameters[n.index];
                break;
            case Op::add:
                at(i) = at(n.a) + at(n.b);
                break;
            case Op::subtract:
                at(i) = at(n.a) - at(n.b);
                break;
            case Op::multiply:
                at(i) = at(n.a) * at(n.b);
                break;
            case Op::divide:
                at(i) = at(n.a) / at(n.b);
                break;
            case Op::negate:
                at(i) = -at(n.a);
                break;
            case Op::squareRoot:
                at(i) = sqrt(at(n.a));
                break;
            case Op::absolute:
                at(i) = abs(at(n.a));
                break;
            case Op::minimum:
                at(i) = min(at(n.a), at(n.b));
                break;
            case Op::maximum:
                at(i) = max(at(n.a), at(n.b));
                break;
            case Op::floor:
                at(i) = floor(at(n.a));
                break;
            case Op::exponential:
                at(i) = exp(at(n.a));
                break;
            case Op::logarithm:
                at(i) = log(at(n.a));
                break;
            case Op::sine:
                at(i) = sin(at(n.a));
                break;
            case Op::cosine:
                at(i) = cos(at(n.a));
                break;
            case Op::angle:
                at(i) = atan2(at(n.a), at(n.b));
                break;
            case Op::power:
                at(i) = pow(at(n.a), at(n.b));
                break;
            case Op::less:
                at(i) = truth(at(n.a) < at(n.b));
                break;
            case Op::lessEqual:
                at(i) = truth(at(n.a) <= at(n.b));
                break;
            case Op::equal:
                at(i) = truth(at(n.a) == at(n.b));
                break;
            case Op::notEqual:
                at(i) = truth(at(n.a) != at(n.b));
                break;
            case Op::conjunction:
                at(i) = truth(isTrue(n.a) & isTrue(n.b));
                break;
            case Op::disjunction:
                at(i) = truth(isTrue(n.a) | isTrue(n.b));
                break;
            case Op::negation:
                at(i) = truth(at(n.a) == R(0.0));
                break;
            case Op::select:
                at(i) = select(isTrue(n.a), at(n.b), at(n.c));
                break;
            case Op::complexPower: {
                const Complex<R> z = power(Complex<R>{at(n.a), at(n.b)}, at(n.e));
                at(i) = n.index == 0 ? z.re : z.im;
                break;
            }
            case Op::quaternionPower: {
                const Quaternion<R> q =
                    power(Quaternion<R>{at(n.a), at(n.b), at(n.c), at(n.d)}, at(n.e));
                at(i) = n.index == 0 ? q.w : n.index == 1 ? q.x : n.index == 2 ? q.y : q.z;
                break;
            }
            case Op::distance:
                at(i) = environment.distance(at(n.a), at(n.b), at(n.c));
                break;
            case Op::alphaAt:
                at(i) = environment.alphaAt(at(n.a), at(n.b), at(n.c), at(n.d));
                break;
            case Op::betaAt:
                at(i) = environment.betaAt(at(n.a), at(n.b), at(n.c), at(n.d));
                break;
            case Op::loopVariable:
                // Later rounds keep the value that loopEnd gave.
                if (loops.back().item == 0) at(i) = at(n.a);
                break;
            case Op::listItem:
                at(i) = loops.back().item <
                                environment.listSize(
                                    tape.nodes[static_cast<std::size_t>(loops.back().begin)].index)
                            ? environment.listItem(
                                  tape.nodes[static_cast<std::size_t>(loops.back().begin)].index,
                                  loops.back().item, n.index)
                            : R(0.0);
                break;
            case Op::loopBegin:
                loops.push_back({i, 0});
                break;
            case Op::loopEnd: {
                const auto& updates = tape.updates[static_cast<std::size_t>(n.index)];
                Loop& loop = loops.back();
                const int items =
                    environment.listSize(tape.nodes[static_cast<std::size_t>(loop.begin)].index);
                // An empty list runs the body once without effect: its variables keep their start.
                if (items > 0) {
                    std::vector<R> next;
                    for (const Tape::Update& update : updates) next.push_back(at(update.next));
                    for (std::size_t k = 0; k < updates.size(); ++k)
                        at(updates[k].variable) = next[k];
                }
                if (++loop.item < items)
                    i = loop.begin;
                else
                    loops.pop_back();
                break;
            }
        }
    }
    for (std::size_t k = 0; k < tape.outputs.size(); ++k) outputs[k] = at(tape.outputs[k]);
}

}  // namespace versorium
