// SPDX-License-Identifier: MIT
#pragma once
// The step of a typed formula, as a map of the kernels: it runs the program that the environment
// names (trace/program.h) over whatever numbers the kernel has. One for each dimension serves all
// formulas of that dimension.

#include "maps/apply.h"
#include "trace/program.h"

namespace versorium {

inline constexpr int kFormulaParameters = 32;  // numbers in all parameters together

template <int D, class R>
struct FormulaState {
    using Real = R;
    static constexpr int kDimension = D;
    R part[D];
};
template <int D, class R>
R squaredNorm(const FormulaState<D, R>& z) {
    R norm = z.part[0] * z.part[0];
    for (int k = 1; k < D; ++k) norm = norm + z.part[k] * z.part[k];
    return norm;
}
template <class M, int D, class R>
FormulaState<D, R> select(const M& mask, const FormulaState<D, R>& yes,
                          const FormulaState<D, R>& no) {
    FormulaState<D, R> result;
    for (int k = 0; k < D; ++k) result.part[k] = select(mask, yes.part[k], no.part[k]);
    return result;
}
template <int D, class R>
struct Layout<FormulaState<D, R>> {
    static constexpr int kWidth = D;
    static FormulaState<D, R> load(const R* from) {
        FormulaState<D, R> state;
        for (int k = 0; k < D; ++k) state.part[k] = from[k];
        return state;
    }
    static void store(const FormulaState<D, R>& value, R* to) {
        for (int k = 0; k < D; ++k) to[k] = value.part[k];
    }
};

// The parameters where they lie, and what to do with them.
template <class R>
struct FormulaArguments {
    const R* parameters;
    const TapeCode* program;
    FieldLookup<R> bound;
};
template <class R>
struct Layout<FormulaArguments<R>> {
    static constexpr int kWidth = kFormulaParameters;
    static FormulaArguments<R> take(const R*& parameters, const Environment<R>& environment) {
        return {parameters, environment.program, environment};
    }
};

// Numbers side by side as single registers, which programs run over.
template <class R>
struct RegistersOf {
    using Register = R;
    static constexpr int kCount = 1;
};
template <class X>
struct RegistersOf<Pair<X>> {
    using Register = typename RegistersOf<X>::Register;
    static constexpr int kCount = 2 * RegistersOf<X>::kCount;
};

template <int D>
struct FormulaStep {
    // Many registers for each instruction, so that choosing it costs little.
    static constexpr int kLanes = VERSORIUM_LANE_BYTES >= 32 ? 64 : 32;

    template <class R>
    static FormulaState<D, R> step(const FormulaState<D, R>& z, const FormulaArguments<R>& p) {
        if constexpr (RegistersOf<R>::kCount == 1) {
            FormulaState<D, R> next = z;
            runOnce(*p.program, next.part, p.parameters, p.bound);
            return next;
        } else {
            File<R> file(z, p);
            file.run();
            return file.state();
        }
    }

    // Steps with the test after each of them, as the escape kernel asks for
    // (maps/kernels/escape.h).
    template <bool Final, class R>
    static auto runBlock(FormulaState<D, R>& z, const FormulaArguments<R>& p, int steps,
                         const R& radius) {
        File<R> file(z, p);
        const auto inside = file.runInside(steps, radius, squaredNorm(z) <= radius);
        z = file.state();
        return inside;
    }

  private:
    template <class R>
    class File {
        using Register = typename RegistersOf<R>::Register;
        using T = ScalarOf<Register>;
        static constexpr int kW = RegistersOf<R>::kCount;

      public:
        File(const FormulaState<D, R>& z, const FormulaArguments<R>& p) : program_(*p.program) {
            bound_.field = p.bound.field;
            int next = 0;
            for (int k = 0; k < D; ++k) put(z.part[k], next++);
            for (int k = 0; k < program_.parameterSize; ++k) put(p.parameters[k], next++);
            for (int k = 0; k < program_.constantCount; ++k, ++next)
                for (int w = 0; w < kW; ++w)
                    file_[next][w] = Register(static_cast<T>(program_.constants[k]));
        }
        void run() { execute<kW>(program_, file_, bound_); }
        template <class Mask>
        auto runInside(int steps, const R& radius, const Mask& start) {
            Register inside[kW], bound[kW];
            split(select(start, R(T(1)), R(T(0))), inside);
            split(radius, bound);
            for (int i = 0; i < steps; ++i) {
                execute<kW>(program_, file_, bound_);
                for (int w = 0; w < kW; ++w) {
                    Register norm = file_[0][w] * file_[0][w];
                    for (int k = 1; k < D; ++k) norm = norm + file_[k][w] * file_[k][w];
                    inside[w] = select(norm <= bound[w], inside[w], Register(T(0)));
                }
            }
            R joined;
            loadLanes(joined, reinterpret_cast<const T*>(&inside[0]));
            return joined != R(T(0));
        }
        FormulaState<D, R> state() const {
            FormulaState<D, R> z;
            for (int k = 0; k < D; ++k)
                loadLanes(z.part[k], reinterpret_cast<const T*>(&file_[k][0]));
            return z;
        }

      private:
        // Lanes are copied as bytes, in their order.
        static void split(const R& value, Register* to) {
            storeLanes(value, reinterpret_cast<T*>(to));
        }
        void put(const R& value, int at) { split(value, file_[at]); }

        const TapeCode& program_;
        FieldLookup<Register> bound_;  // of a shape(…)
        Register file_[kMostRegisters][kW];
    };
};

}  // namespace versorium
