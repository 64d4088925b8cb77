// SPDX-License-Identifier: MIT
#pragma once
// The tape: what a map does, as a list of elementary operations in the order in which they are
// done. It is recorded by running the map's own definition on `Expr` (trace/expr.h), printed as
// GLSL (trace/glsl.h) and interpreted over any number type (trace/interpret.h).
//
// Elementary functions and powers are single nodes. A fold over a list of roots is one loop between
// loopBegin and loopEnd, whatever the list's length. A look-up of a distance field is one node.

#include <cstdint>
#include <string>
#include <vector>

namespace versorium {

enum class Op : std::uint8_t {
    constant,   // constant
    state,      // component `index` of the state
    parameter,  // component `index` of the parameters
    add,        // a + b, and so on
    subtract,
    multiply,
    divide,
    negate,
    squareRoot,
    absolute,
    minimum,
    maximum,
    floor,
    exponential,
    logarithm,
    sine,
    cosine,
    angle,  // atan2(a, b)
    power,  // a^b, a >= 0
    less,   // truth values from here …
    lessEqual,
    equal,
    notEqual,
    conjunction,
    disjunction,
    negation,         // … to here
    select,           // a ? b : c
    complexPower,     // component `index` of (a + bi)^e
    quaternionPower,  // component `index` of (a + bi + cj + dk)^e
    distance,         // the bound distance field at (a, b, c)
    alphaAt,          // what α of a shape modulus is there, d being its base (shape/modulation.h)
    betaAt,           // the same of β
    loopBegin,        // over list `index`
    loopVariable,     // starts as a; loopEnd gives it its next value
    listItem,         // component `index` of the current root: 0 … 3, and 4 for its power
    loopEnd,          // closes the innermost loop
};

inline bool isTruth(Op op) { return op >= Op::less && op <= Op::negation; }

struct Node {
    Op op;
    int index = 0;
    int a = -1, b = -1, c = -1, d = -1, e = -1;
    double constant = 0;
    friend bool operator==(const Node&, const Node&) = default;
};

struct Tape {
    std::vector<Node> nodes;
    // For each loopEnd, in the order of the nodes: pairs (loop variable, node of its next value).
    struct Update {
        int variable, next;
    };
    std::vector<std::vector<Update>> updates;
    std::vector<int> outputs;
    int stateSize = 0;
    int parameterSize = 0;

    // The node's number; a node that stands in the current scope already is not added again.
    int add(const Node& node);
    void beginLoop(int list);
    void endLoop(std::vector<Update> updates);

  private:
    // Nodes before this one must not be reused: they stand in a loop that is closed.
    std::vector<int> reusable_;
    std::vector<std::size_t> scopes_;
};

// What a tape without lists and fields is run in.
struct NothingBound {
    int listSize(int) const { return 0; }
    double listItem(int, int, int) const { return 0; }
    template <class R>
    R distance(const R&, const R&, const R&) const {
        return R(0.0);
    }
    template <class R>
    R alphaAt(const R&, const R&, const R&, const R& base) const {
        return base;
    }
    template <class R>
    R betaAt(const R&, const R&, const R&, const R& base) const {
        return base;
    }
};

// One line per node, for people and for tests.
std::string describe(const Tape& tape);

}  // namespace versorium
