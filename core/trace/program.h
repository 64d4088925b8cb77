// SPDX-License-Identifier: MIT
#pragma once
// A tape made ready to be run many times: a list of instructions over a file of registers. Nodes
// that nothing needs are gone, registers are used again, the outputs land in the registers of the
// state, and pairs of operations that follow each other are one instruction. Every rounding is that
// of the tape, so it gives the same bits as trace/interpret.h and as the recorded code itself.
//
// The registers are the state, the parameters, the constants, then room for what is computed.

#include <cstdint>
#include <vector>

#include "base/status.h"
#include "math/power.h"
#include "trace/tape.h"

namespace versorium {

enum class Code : std::uint8_t {
    move,
    add,
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
    angle,
    power,
    less,
    lessEqual,
    equal,
    notEqual,
    conjunction,
    disjunction,
    negation,
    select,
    complexPower,     // (a + bi)^e into out[0], out[1]
    quaternionPower,  // (a + bi + cj + dk)^e into out[0] … out[3]
    // Two operations in one, each rounded by itself.
    multiplyAdd,       // a b + c
    multiplySubtract,  // a b - c
    subtractProduct,   // c - a b
    sumAdd,            // (a + b) + c
    productsAdd,       // a b + c d
    productsSubtract,  // a b - c d
    // Looks into what is bound, at (a, b, c).
    distance,
    alphaAt,  // from the base d
    betaAt,
};

struct Instruction {
    Code code = Code::move;
    std::uint8_t out[4] = {};
    std::uint8_t a = 0, b = 0, c = 0, d = 0, e = 0;
};

// What a kernel sees of a program: plain memory that the program owns.
struct TapeCode {
    const Instruction* instructions = nullptr;
    int size = 0;
    const double* constants = nullptr;
    int constantCount = 0;
    int stateSize = 0, parameterSize = 0;
    int registers = 0;  // at most kMostRegisters
};

inline constexpr int kMostRegisters = 128;

class TapeProgram {
  public:
    TapeProgram() = default;
    // A tape without lists. ErrorKind::usage where it needs too many registers.
    static Expected<TapeProgram> make(const Tape& tape);

    TapeCode code() const;

  private:
    std::vector<Instruction> instructions_;
    std::vector<double> constants_;
    int stateSize_ = 0, parameterSize_ = 0, registers_ = 0;
};

// The same tape without nodes that nothing needs, and with the value in the place of what is
// computed from constants alone. States and parameters all stay.
Tape simplified(const Tape& tape);

inline namespace VERSORIUM_TARGET {

// Runs a program once on registers of W numbers each. `bound` gives what it looks into, as that of
// trace/interpret.h does.
template <int W, class R, class Bound = NothingBound>
void execute(const TapeCode& tape, R (*file)[W], const Bound& bound = {}) {
    // Those of single numbers stand outside of the instruction set's namespace.
    using versorium::select, versorium::sqrt, versorium::abs, versorium::min, versorium::max,
        versorium::floor, versorium::exp, versorium::log, versorium::sin, versorium::cos,
        versorium::atan2, versorium::pow;
    const auto truth = [](const auto& mask) { return select(mask, R(1.0), R(0.0)); };
    const Instruction* end = tape.instructions + tape.size;
    for (const Instruction* at = tape.instructions; at != end; ++at) {
        const R *a = file[at->a], *b = file[at->b], *c = file[at->c], *d = file[at->d];
        R* out = file[at->out[0]];
        const auto each = [&](const auto& function) {
            for (int w = 0; w < W; ++w) out[w] = function(w);
        };
        switch (at->code) {
            case Code::move:
                each([&](int w) { return a[w]; });
                break;
            case Code::add:
                each([&](int w) { return a[w] + b[w]; });
                break;
            case Code::subtract:
                each([&](int w) { return a[w] - b[w]; });
                break;
            case Code::multiply:
                each([&](int w) { return a[w] * b[w]; });
                break;
            case Code::divide:
                each([&](int w) { return a[w] / b[w]; });
                break;
            case Code::negate:
                each([&](int w) { return -a[w]; });
                break;
            case Code::squareRoot:
                each([&](int w) { return sqrt(a[w]); });
                break;
            case Code::absolute:
                each([&](int w) { return abs(a[w]); });
                break;
            case Code::minimum:
                each([&](int w) { return min(a[w], b[w]); });
                break;
            case Code::maximum:
                each([&](int w) { return max(a[w], b[w]); });
                break;
            case Code::floor:
                each([&](int w) { return floor(a[w]); });
                break;
            case Code::exponential:
                each([&](int w) { return exp(a[w]); });
                break;
            case Code::logarithm:
                each([&](int w) { return log(a[w]); });
                break;
            case Code::sine:
                each([&](int w) { return sin(a[w]); });
                break;
            case Code::cosine:
                each([&](int w) { return cos(a[w]); });
                break;
            case Code::angle:
                each([&](int w) { return atan2(a[w], b[w]); });
                break;
            case Code::power:
                each([&](int w) { return pow(a[w], b[w]); });
                break;
            case Code::less:
                each([&](int w) { return truth(a[w] < b[w]); });
                break;
            case Code::lessEqual:
                each([&](int w) { return truth(a[w] <= b[w]); });
                break;
            case Code::equal:
                each([&](int w) { return truth(a[w] == b[w]); });
                break;
            case Code::notEqual:
                each([&](int w) { return truth(a[w] != b[w]); });
                break;
            case Code::conjunction:
                each([&](int w) { return truth((a[w] != R(0.0)) & (b[w] != R(0.0))); });
                break;
            case Code::disjunction:
                each([&](int w) { return truth((a[w] != R(0.0)) | (b[w] != R(0.0))); });
                break;
            case Code::negation:
                each([&](int w) { return truth(a[w] == R(0.0)); });
                break;
            case Code::select:
                each([&](int w) { return select(a[w] != R(0.0), b[w], c[w]); });
                break;
            case Code::complexPower: {
                const R* e = file[at->e];
                for (int w = 0; w < W; ++w) {
                    const Complex<R> z = power(Complex<R>{a[w], b[w]}, e[w]);
                    file[at->out[0]][w] = z.re;
                    file[at->out[1]][w] = z.im;
                }
                break;
            }
            case Code::quaternionPower: {
                const R* e = file[at->e];
                for (int w = 0; w < W; ++w) {
                    const Quaternion<R> q = power(Quaternion<R>{a[w], b[w], c[w], d[w]}, e[w]);
                    file[at->out[0]][w] = q.w;
                    file[at->out[1]][w] = q.x;
                    file[at->out[2]][w] = q.y;
                    file[at->out[3]][w] = q.z;
                }
                break;
            }
            case Code::multiplyAdd:
                each([&](int w) { return a[w] * b[w] + c[w]; });
                break;
            case Code::multiplySubtract:
                each([&](int w) { return a[w] * b[w] - c[w]; });
                break;
            case Code::subtractProduct:
                each([&](int w) { return c[w] - a[w] * b[w]; });
                break;
            case Code::sumAdd:
                each([&](int w) { return (a[w] + b[w]) + c[w]; });
                break;
            case Code::productsAdd:
                each([&](int w) { return a[w] * b[w] + c[w] * d[w]; });
                break;
            case Code::productsSubtract:
                each([&](int w) { return a[w] * b[w] - c[w] * d[w]; });
                break;
            case Code::distance:
                each([&](int w) { return bound.distance(a[w], b[w], c[w]); });
                break;
            case Code::alphaAt:
                each([&](int w) { return bound.alphaAt(a[w], b[w], c[w], d[w]); });
                break;
            case Code::betaAt:
                each([&](int w) { return bound.betaAt(a[w], b[w], c[w], d[w]); });
                break;
        }
    }
}

// One step on single numbers, in place.
template <class R, class Bound = NothingBound>
void runOnce(const TapeCode& tape, R* state, const R* parameters, const Bound& bound = {}) {
    R file[kMostRegisters][1];
    int next = 0;
    for (int k = 0; k < tape.stateSize; ++k) file[next++][0] = state[k];
    for (int k = 0; k < tape.parameterSize; ++k) file[next++][0] = parameters[k];
    for (int k = 0; k < tape.constantCount; ++k)
        file[next++][0] = R(static_cast<ScalarOf<R>>(tape.constants[k]));
    execute<1>(tape, file, bound);
    for (int k = 0; k < tape.stateSize; ++k) state[k] = file[k][0];
}

}  // namespace VERSORIUM_TARGET
}  // namespace versorium
