// SPDX-License-Identifier: MIT
#pragma once
// What is bound to a map rather than sliced: lists of roots and a distance field. Any one component
// of a list may still be an axis of a slice; it then comes as an override with a value per lane.

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/roots.h"
#include "maps/layout.h"
#include "shape/field.h"
#include "shape/modulation.h"
#include "trace/expr.h"
#include "trace/program.h"

namespace versorium {

// Roots with their exponents (a list's common scale is multiplied in). For complex maps only w (the
// real part) and x (the imaginary part) count.
using BoundList = std::vector<RootList::Root>;

inline constexpr int kMostLists = 2;
inline constexpr int kMostOverrides = 4;

template <class R>
struct Override {
    int list = 0, item = 0, component = 0;  // component 4 is the power
    R value{};
};

// The bound distance field, with what α and β of a shape modulus are over space.
template <class R>
struct FieldLookup {
    const DistanceField* field = nullptr;

    R distance(const R& x, const R& y, const R& z) const { return field->at(x, y, z); }
    R alphaAt(const R& x, const R& y, const R& z, const R& base) const {
        return field->alpha() ? field->alpha()->at(x, y, z, base) : base;
    }
    R betaAt(const R& x, const R& y, const R& z, const R& base) const {
        return field->beta() ? field->beta()->at(x, y, z, base) : base;
    }
};
// A grid has no second derivatives; no map that looks into a field is asked for them.
template <class R>
struct FieldLookup<Dual<Dual<R>>> : NothingBound {
    const DistanceField* field = nullptr;
};

// Everything that a step sees beside its state and its parameters. Refers to what the caller keeps.
template <class R>
struct Environment : FieldLookup<R> {
    const BoundList* lists[kMostLists] = {};
    Override<R> overrides[kMostOverrides] = {};
    int overrideCount = 0;
    const TapeCode* program = nullptr;  // of a typed formula

    int listSize(int list) const { return static_cast<int>(lists[list]->size()); }
    R listItem(int list, int item, int component) const {
        for (int k = 0; k < overrideCount; ++k)
            if (overrides[k].list == list && overrides[k].item == item &&
                overrides[k].component == component)
                return overrides[k].value;
        const RootList::Root& root = (*lists[list])[static_cast<std::size_t>(item)];
        return R(static_cast<ScalarOf<R>>(
            component == 4 ? root.power : root.q[static_cast<std::size_t>(component)]));
    }
};

// Recording needs only the tape.
template <>
struct Environment<Expr> {
    Tape* tape = nullptr;
    Expr distance(const Expr& x, const Expr& y, const Expr& z) const {
        return {tape,
                tape->add({.op = Op::distance, .a = x.on(tape), .b = y.on(tape), .c = z.on(tape)})};
    }
    Expr alphaAt(const Expr& x, const Expr& y, const Expr& z, const Expr& base) const {
        return modulated(Op::alphaAt, x, y, z, base);
    }
    Expr betaAt(const Expr& x, const Expr& y, const Expr& z, const Expr& base) const {
        return modulated(Op::betaAt, x, y, z, base);
    }

  private:
    Expr modulated(Op op, const Expr& x, const Expr& y, const Expr& z, const Expr& base) const {
        return {
            tape,
            tape->add(
                {.op = op, .a = x.on(tape), .b = y.on(tape), .c = z.on(tape), .d = base.on(tape)})};
    }
};

// One root as a step sees it.
template <class R>
struct Root {
    R w, x, y, z, power;
    Complex<R> complex() const { return {w, x}; }
    Quaternion<R> quaternion() const { return {w, x, y, z}; }
};

// The list that is bound at place `Index`, as an argument of a step.
template <class R, int Index = 0>
class Roots {
  public:
    explicit Roots(const Environment<R>& environment) : environment_(environment) {}

    // body(… body(body(start, first root), second root) …, last root).
    template <class S, class Body>
    S fold(S start, Body body) const {
        const int size = environment_.listSize(Index);
        for (int i = 0; i < size; ++i)
            start =
                body(start, Root<R>{item(i, 0), item(i, 1), item(i, 2), item(i, 3), item(i, 4)});
        return start;
    }

  private:
    R item(int i, int component) const { return environment_.listItem(Index, i, component); }
    const Environment<R>& environment_;
};

// Recorded once as a loop, however long the list will be.
template <int Index>
class Roots<Expr, Index> {
  public:
    explicit Roots(const Environment<Expr>& environment) : tape_(environment.tape) {}

    template <class S, class Body>
    S fold(S start, Body body) const {
        constexpr int kWidth = Layout<S>::kWidth;
        Expr values[kWidth];
        Layout<S>::store(start, values);
        int starts[kWidth], variables[kWidth];
        for (int k = 0; k < kWidth; ++k) starts[k] = values[k].on(tape_);
        tape_->beginLoop(Index);
        for (int k = 0; k < kWidth; ++k) {
            variables[k] = tape_->add({.op = Op::loopVariable, .index = k, .a = starts[k]});
            values[k] = {tape_, variables[k]};
        }
        Expr parts[5];
        for (int k = 0; k < 5; ++k)
            parts[k] = {tape_, tape_->add({.op = Op::listItem, .index = k})};
        const S next = body(Layout<S>::load(values),
                            Root<Expr>{parts[0], parts[1], parts[2], parts[3], parts[4]});
        Expr nextValues[kWidth];
        Layout<S>::store(next, nextValues);
        std::vector<Tape::Update> updates;
        for (int k = 0; k < kWidth; ++k) updates.push_back({variables[k], nextValues[k].on(tape_)});
        tape_->endLoop(std::move(updates));
        return Layout<S>::load(values);
    }

  private:
    Tape* tape_;
};

// The bound distance field as an argument of a step.
template <class R>
class Field {
  public:
    explicit Field(const Environment<R>& environment) : environment_(environment) {}
    R at(const R& x, const R& y, const R& z) const { return environment_.distance(x, y, z); }
    // α and β there, whose values elsewhere are `base`.
    R alphaAt(const R& x, const R& y, const R& z, const R& base) const {
        return environment_.alphaAt(x, y, z, base);
    }
    R betaAt(const R& x, const R& y, const R& z, const R& base) const {
        return environment_.betaAt(x, y, z, base);
    }

  private:
    const Environment<R>& environment_;
};

template <class R, int Index>
struct Layout<Roots<R, Index>> {
    static constexpr int kWidth = 0;
    static Roots<R, Index> bind(const Environment<R>& environment) {
        return Roots<R, Index>(environment);
    }
};
template <class R>
struct Layout<Field<R>> {
    static constexpr int kWidth = 0;
    static Field<R> bind(const Environment<R>& environment) { return Field<R>(environment); }
};

}  // namespace versorium
