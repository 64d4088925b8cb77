// SPDX-License-Identifier: MIT
#pragma once
// The escape kernel for maps whose steps are long (kStepwise): every orbit is looked at after every
// step, and the last active ones take the places of those that left. Nothing is walked twice. The
// result is that of the plain loop.
//
// A map may tell log |f(z)| without f(z) (`logModulus`). Where only the steps are wanted, that
// decides who leaves next before anything else is computed, and nothing at all is computed for the
// last step, but for the few whose modulus is as good as the radius.

#include "maps/kernels/escape.h"

namespace versorium {
inline namespace VERSORIUM_TARGET {

template <class M, class R>
struct StepwiseKernel : EscapeKernel<M, R> {
    using Base = EscapeKernel<M, R>;
    using T = typename Base::T;
    using State = typename Base::State;
    using Base::active, Base::batch, Base::hole, Base::holes, Base::kPlain, Base::kWidth;

    static constexpr bool kKnowsModulus = requires { &M::template logModulus<R>; };
    // It and the norm of the image differ by rounding.
    static constexpr double kMargin = sizeof(T) == 8 ? 1e-9 : 1e-4;

    using Base::Base;

    void run() {
        for (int i = 0; i < batch.count; ++i) batch.steps[i] = kPlain;
        this->begin(kPlain);
        if (active.size == 0) return;
        leaveNow();
        const bool ahead = batch.shortcuts && !batch.needLast && !batch.needEscaped;
        int n0 = 0, nextReference = 64;
        bool compare = false;
        for (int n = 1; n <= batch.iterations && active.size > 0; ++n) {
            if constexpr (kKnowsModulus) {
                if (ahead) {
                    lookAhead(n, compare);
                    if (active.size == 0) break;
                    step<true>(n, compare, n0);
                } else {
                    step<false>(n, compare, n0);
                }
            } else {
                step<false>(n, compare, n0);
            }
            if (batch.shortcuts && n >= nextReference) {
                for (int k = 0; k < Base::kD; ++k)
                    for (int i = 0; i < active.size; ++i)
                        this->reference[k][i] = active.state[k][i];
                n0 = n;
                nextReference = 2 * n;
                compare = true;
            }
        }
        for (int i = 0; i < active.size; ++i)
            this->finish(active.index[i], batch.iterations + 1, active.state, i);
    }

  private:
    template <class Function>
    void forEachRegister(Function function) {
        R parameters[Base::kP > 0 ? Base::kP : 1];
        this->loadUniform(parameters);
        Environment<R> environment = this->environmentOf();
        holes = 0;
        for (int first = 0; first < active.size; first += kWidth) {
            this->loadStreams(active, first, parameters, environment);
            const R* from = parameters;
            const auto arguments = ArgumentList<ArgumentsOf<M, R>>::take(from, environment);
            function(first, this->loadState(active, first), arguments);
        }
    }
    // Ends the orbits of a register whose mask is set.
    template <class Mask>
    void end(const Mask& mask, int first, std::int32_t steps) {
        Base::forEachLane(mask, first, [&](int i) {
            if (i >= active.size) return;
            this->finish(active.index[i], steps, active.state, i);
            hole[holes++] = i;
        });
    }
    // The moduli that were looked up move along with their orbits.
    void close(bool compare) {
        for (int h = holes - 1, last = active.size - 1; h >= 0; --h, --last)
            moduli()[hole[h]] = moduli()[last];
        this->fillHoles(compare);
        if (active.size > 0) this->pad(active);
    }

    // A row of scratch that this kernel has no other use for.
    T* moduli() { return this->leaving.state[0]; }

    // Orbits that start outside.
    void leaveNow() {
        const R radius(batch.squaredRadius);
        forEachRegister([&](int first, const State& z, const auto&) {
            end(!(squaredNorm(z) <= radius), first, 0);
        });
        close(false);
    }

    // Step n, unless the modulus tells what it comes to.
    void lookAhead(int n, bool compare) {
        const T radius = log(batch.squaredRadius), trap = log(batch.squaredCapture);
        const R beyond(radius * T(0.5) + T(kMargin)), within(radius * T(0.5) - T(kMargin));
        const R trapped(trap * T(0.5) - T(kMargin));
        const bool last = n == batch.iterations;
        forEachRegister([&](int first, const State& z, const auto& arguments) {
            const R logarithm = std::apply(
                [&](const auto&... as) { return M::template logModulus<R>(z, as...); }, arguments);
            storeLanes(logarithm, moduli() + first);
            const auto escapes = logarithm > beyond;
            const auto stays = last ? logarithm < within : logarithm < trapped;
            Base::forEachLane(escapes | stays, first, [&](int i) {
                if (i >= active.size) return;
                batch.steps[active.index[i]] = lane(escapes, i - first) ? n : batch.iterations + 1;
                hole[holes++] = i;
            });
        });
        close(compare);
    }

    template <bool Known>
    State stepFrom(const State& z, int first, const auto& arguments) {
        if constexpr (Known) {
            R logarithm;
            loadLanes(logarithm, moduli() + first);
            return std::apply(
                [&](const auto&... as) {
                    return M::template withLogModulus<R>(z, logarithm, as...);
                },
                arguments);
        } else {
            return stepWith<M, R>(z, arguments);
        }
    }

    template <bool Known>
    void step(int n, bool compare, int n0) {
        const R radius(batch.squaredRadius);
        forEachRegister([&](int first, const State& before, const auto& arguments) {
            const State z = stepFrom<Known>(before, first, arguments);
            this->storeState(z, active.state, first);
            const auto inside = squaredNorm(z) <= radius;
            if (batch.previous) {
                T norms[kWidth];
                storeLanes(squaredNorm(before), norms);
                Base::forEachLane(!inside, first, [&](int i) {
                    if (i < active.size) batch.previous[active.index[i]] = norms[i - first];
                });
            }
            end(!inside, first, n);
            if (compare) this->retireRepeating(z, inside, first, n, n - n0);
        });
        close(compare);
    }
};

}  // namespace VERSORIUM_TARGET
}  // namespace versorium
