// SPDX-License-Identifier: MIT
#pragma once
// Expr: a number that records what is done to it on a Tape. An Expr without a tape is a constant
// and joins the tape of whatever it meets. Truth: what comparisons of Expr give.

#include <cassert>

#include "math/power.h"
#include "trace/tape.h"

namespace versorium {

class Expr {
  public:
    Expr() = default;
    Expr(double constant) : constant_(constant) {}
    Expr(Tape* tape, int node) : tape_(tape), node_(node) {}

    Tape* tape() const { return tape_; }
    // The number of this value's node on the given tape.
    int on(Tape* tape) const;
    bool isConstant() const { return tape_ == nullptr; }
    double constant() const { return constant_; }

  private:
    Tape* tape_ = nullptr;
    int node_ = -1;
    double constant_ = 0;
};

class Truth {
  public:
    Truth(Tape* tape, int node) : tape_(tape), node_(node) {}
    Tape* tape() const { return tape_; }
    int node() const { return node_; }

    friend Truth operator&(Truth a, Truth b) { return join(Op::conjunction, a, b); }
    friend Truth operator|(Truth a, Truth b) { return join(Op::disjunction, a, b); }
    friend Truth operator!(Truth a) {
        return {a.tape_, a.tape_->add({.op = Op::negation, .a = a.node_})};
    }

  private:
    static Truth join(Op op, Truth a, Truth b) {
        return {a.tape_, a.tape_->add({.op = op, .a = a.node_, .b = b.node_})};
    }
    Tape* tape_;
    int node_;
};

namespace recording {

inline Tape* commonTape(const Expr& a, const Expr& b) { return a.tape() ? a.tape() : b.tape(); }

inline Expr unary(Op op, const Expr& a) {
    // A constant alone has no tape to stand on: maps apply functions to what varies.
    assert(a.tape());
    return {a.tape(), a.tape()->add({.op = op, .a = a.on(a.tape())})};
}
inline int binaryNode(Op op, Tape* tape, const Expr& a, const Expr& b) {
    const int left = a.on(tape);
    const int right = b.on(tape);
    return tape->add({.op = op, .a = left, .b = right});
}
inline Expr binary(Op op, const Expr& a, const Expr& b) {
    Tape* tape = commonTape(a, b);
    return {tape, binaryNode(op, tape, a, b)};
}
inline Truth compare(Op op, const Expr& a, const Expr& b) {
    Tape* tape = commonTape(a, b);
    assert(tape);
    return {tape, binaryNode(op, tape, a, b)};
}

}  // namespace recording

// Two constants make a constant, computed as the scalar form would.
inline Expr operator+(const Expr& a, const Expr& b) {
    if (a.isConstant() && b.isConstant()) return a.constant() + b.constant();
    return recording::binary(Op::add, a, b);
}
inline Expr operator-(const Expr& a, const Expr& b) {
    if (a.isConstant() && b.isConstant()) return a.constant() - b.constant();
    return recording::binary(Op::subtract, a, b);
}
inline Expr operator*(const Expr& a, const Expr& b) {
    if (a.isConstant() && b.isConstant()) return a.constant() * b.constant();
    return recording::binary(Op::multiply, a, b);
}
inline Expr operator/(const Expr& a, const Expr& b) {
    if (a.isConstant() && b.isConstant()) return a.constant() / b.constant();
    return recording::binary(Op::divide, a, b);
}
inline Expr operator-(const Expr& a) {
    if (a.isConstant()) return -a.constant();
    return recording::unary(Op::negate, a);
}
inline Truth operator<(const Expr& a, const Expr& b) { return recording::compare(Op::less, a, b); }
inline Truth operator<=(const Expr& a, const Expr& b) {
    return recording::compare(Op::lessEqual, a, b);
}
inline Truth operator>(const Expr& a, const Expr& b) { return b < a; }
inline Truth operator>=(const Expr& a, const Expr& b) { return b <= a; }
inline Truth operator==(const Expr& a, const Expr& b) {
    return recording::compare(Op::equal, a, b);
}
inline Truth operator!=(const Expr& a, const Expr& b) {
    return recording::compare(Op::notEqual, a, b);
}

inline Expr select(const Truth& mask, const Expr& yes, const Expr& no) {
    Tape* tape = mask.tape();
    const int first = yes.on(tape);
    const int second = no.on(tape);
    return {tape, tape->add({.op = Op::select, .a = mask.node(), .b = first, .c = second})};
}
inline Truth isNan(const Expr& a) { return a != a; }
inline Expr abs(const Expr& a) { return recording::unary(Op::absolute, a); }
inline Expr sqrt(const Expr& a) { return recording::unary(Op::squareRoot, a); }
inline Expr floor(const Expr& a) { return recording::unary(Op::floor, a); }
inline Expr exp(const Expr& a) { return recording::unary(Op::exponential, a); }
inline Expr log(const Expr& a) { return recording::unary(Op::logarithm, a); }
inline Expr sin(const Expr& a) { return recording::unary(Op::sine, a); }
inline Expr cos(const Expr& a) { return recording::unary(Op::cosine, a); }
inline Expr min(const Expr& a, const Expr& b) { return recording::binary(Op::minimum, a, b); }
inline Expr max(const Expr& a, const Expr& b) { return recording::binary(Op::maximum, a, b); }
inline Expr atan2(const Expr& y, const Expr& x) { return recording::binary(Op::angle, y, x); }
inline Expr pow(const Expr& x, const Expr& y) { return recording::binary(Op::power, x, y); }

inline Complex<Expr> power(const Complex<Expr>& z, const Expr& e) {
    Tape* tape = z.re.tape() ? z.re.tape() : recording::commonTape(z.im, e);
    const Node node{
        .op = Op::complexPower, .a = z.re.on(tape), .b = z.im.on(tape), .e = e.on(tape)};
    Node second = node;
    second.index = 1;
    return {{tape, tape->add(node)}, {tape, tape->add(second)}};
}
inline Quaternion<Expr> power(const Quaternion<Expr>& q, const Expr& e) {
    Tape* tape = q.w.tape();
    assert(tape);
    Node node{.op = Op::quaternionPower,
              .a = q.w.on(tape),
              .b = q.x.on(tape),
              .c = q.y.on(tape),
              .d = q.z.on(tape),
              .e = e.on(tape)};
    Expr parts[4];
    for (int k = 0; k < 4; ++k) {
        node.index = k;
        parts[k] = {tape, tape->add(node)};
    }
    return {parts[0], parts[1], parts[2], parts[3]};
}

}  // namespace versorium
