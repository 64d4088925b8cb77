// SPDX-License-Identifier: MIT
#pragma once
// The escape kernel: it works in passes over all orbits that are still active. A pass runs a block
// of steps without looking, several registers at a time, then tests. Orbits that left during the
// block walk through it again in short blocks, together with others from other passes, and are
// looked at after each step only in the last one; the last active orbits take their places. So
// registers are full almost always. The result is that of the plain loop.

#include "maps/apply.h"
#include "maps/orbit_batch.h"

namespace versorium {
inline namespace VERSORIUM_TARGET {

template <int Registers, class T>
struct BlockOf {
    using type = Pair<typename BlockOf<Registers / 2, T>::type>;
};
template <class T>
struct BlockOf<1, T> {
    using type = Lanes<T>;
};

// Registers in flight: enough to hide latency, few enough to stay in registers.
template <class M, class T>
constexpr int registersOf() {
    if constexpr (requires { M::kLanes; })
        return M::kLanes / Lanes<T>::kCount;
    else if constexpr (requires { M::kRegisters; })
        return M::kRegisters;
    else
        return kDimension<M> <= 2 ? 4 : 2;
}

// The numbers of the parameters; those of typed formulas are known when they run.
template <class M, class T>
int parameterCount(const OrbitBatch<T>& batch) {
    if constexpr (requires { M::kLanes; })
        return batch.program->parameterSize;
    else
        return kParameters<M>;
}

template <class M, class R>
struct EscapeKernel {
    using T = ScalarOf<R>;
    using State = StateOf<M, R>;
    static constexpr int kD = kDimension<M>;
    static constexpr int kP = kParameters<M>;
    static constexpr int kWidth = kLaneCount<R>;
    static constexpr int kStreams = kP + kMostOverrides;
    static constexpr int kShort = 8;

    struct Orbits {
        T* state[kD];
        T* streams[kStreams];
        std::int32_t* index;
        std::int32_t* base;  // iteration at which the state stands; not of active orbits
        int size = 0;
    };

    OrbitBatch<T>& batch;
    Orbits active, leaving, closer;
    T* reference[kD];
    int streamCount = 0;
    int streamParameter[kStreams];  // < kP: a parameter; else override number + kP
    std::int32_t* hole;
    int holes = 0;

    explicit EscapeKernel(OrbitBatch<T>& b) : batch(b) {
        for (int k = 0; k < kP; ++k)
            if (batch.parameters[k].varies) streamParameter[streamCount++] = k;
        for (int k = 0; k < batch.overrideCount; ++k)
            if (batch.overrides[k].stream.varies) streamParameter[streamCount++] = kP + k;
        T* next = batch.scratch;
        const auto take = [&] {
            T* row = next;
            next += batch.capacity;
            return row;
        };
        for (int k = 0; k < kD; ++k) {
            active.state[k] = take();
            leaving.state[k] = take();
            closer.state[k] = take();
            reference[k] = take();
        }
        for (int k = 0; k < streamCount; ++k) {
            active.streams[k] = take();
            leaving.streams[k] = take();
            closer.streams[k] = take();
        }
        active.index = batch.scratchIndex;
        leaving.index = batch.scratchIndex + batch.capacity;
        closer.index = batch.scratchIndex + 2 * batch.capacity;
        hole = batch.scratchIndex + 3 * batch.capacity;
        leaving.base = batch.scratchIndex + 4 * batch.capacity;
        closer.base = batch.scratchIndex + 5 * batch.capacity;
        active.base = nullptr;
        leaving.size = closer.size = 0;
    }

    const T* streamValues(int k) const {
        const int which = streamParameter[k];
        return which < kP ? batch.parameters[which].values
                          : batch.overrides[which - kP].stream.values;
    }

    // Copies the last orbit into the lanes behind it, so that every register is full.
    void pad(Orbits& orbits) {
        const int end = (orbits.size + kWidth - 1) / kWidth * kWidth;
        for (int i = orbits.size; i < end; ++i) {
            for (int k = 0; k < kD; ++k) orbits.state[k][i] = orbits.state[k][orbits.size - 1];
            for (int k = 0; k < streamCount; ++k)
                orbits.streams[k][i] = orbits.streams[k][orbits.size - 1];
        }
    }

    State loadState(const Orbits& orbits, int first) const {
        R parts[kD];
        for (int k = 0; k < kD; ++k) loadLanes(parts[k], orbits.state[k] + first);
        return Layout<State>::load(parts);
    }
    static void storeState(const State& z, T* const* rows, int first) {
        R parts[kD];
        Layout<State>::store(z, parts);
        for (int k = 0; k < kD; ++k) storeLanes(parts[k], rows[k] + first);
    }

    // Parameters and overrides of the orbits from `first` on.
    void loadStreams(const Orbits& orbits, int first, R* parameters,
                     Environment<R>& environment) const {
        for (int k = 0; k < streamCount; ++k) {
            const int which = streamParameter[k];
            R& target = which < kP ? parameters[which] : environment.overrides[which - kP].value;
            loadLanes(target, orbits.streams[k] + first);
        }
    }
    Environment<R> environmentOf() const {
        Environment<R> environment;
        for (int k = 0; k < kMostLists; ++k) environment.lists[k] = batch.lists[k];
        environment.field = batch.field;
        environment.program = batch.program;
        environment.overrideCount = batch.overrideCount;
        for (int k = 0; k < batch.overrideCount; ++k) {
            environment.overrides[k].list = batch.overrides[k].list;
            environment.overrides[k].item = batch.overrides[k].item;
            environment.overrides[k].component = batch.overrides[k].component;
            environment.overrides[k].value = R(*batch.overrides[k].stream.values);
        }
        return environment;
    }
    void loadUniform(R* parameters) const {
        const int count = parameterCount<M>(batch);
        for (int k = 0; k < count; ++k) parameters[k] = R(*batch.parameters[k].values);
    }

    // Takes the orbits whose mark in batch.steps is the given one.
    void begin(std::int32_t mark) {
        active.size = 0;
        for (int i = 0; i < batch.count; ++i) {
            if (batch.steps[i] != mark) continue;
            const int at = active.size++;
            active.index[at] = i;
            for (int k = 0; k < kD; ++k) active.state[k][at] = batch.state[k][i];
            for (int k = 0; k < streamCount; ++k) active.streams[k][at] = streamValues(k)[i];
        }
        if (active.size > 0) pad(active);
    }

    template <class Function>
    void forEachBlock(const Orbits& orbits, Function function) const {
        R parameters[kP > 0 ? kP : 1];
        loadUniform(parameters);
        Environment<R> environment = environmentOf();
        for (int first = 0; first < orbits.size; first += kWidth) {
            loadStreams(orbits, first, parameters, environment);
            const R* from = parameters;
            const auto arguments = ArgumentList<ArgumentsOf<M, R>>::take(from, environment);
            function(first, loadState(orbits, first), arguments);
        }
    }

    // For which orbits may the test after a block stand for the tests within it? Their marks
    // become kFinal. All orbits must be active.
    void markFinal() {
        if constexpr (requires { &M::template outsideIsFinal<R>; }) {
            const R radius(batch.squaredRadius);
            forEachBlock(active, [&](int first, const State& z, const auto& arguments) {
                const auto final = std::apply(
                    [&](const auto&... as) {
                        return M::template outsideIsFinal<R>(radius, z, as...);
                    },
                    arguments);
                forEachLane(final, first, [&](int i) {
                    if (i < active.size) batch.steps[active.index[i]] = kFinal;
                });
            });
        }
    }

    void removeKnownInterior() {
        if constexpr (requires { &M::template knownInterior<R>; }) {
            const R radius(batch.squaredRadius);
            std::int32_t* known = leaving.index;
            forEachBlock(active, [&](int first, const State& z, const auto& arguments) {
                const auto inside = std::apply(
                    [&](const auto&... as) {
                        return M::template knownInterior<R>(radius, z, as...);
                    },
                    arguments);
                for (int i = 0; i < kWidth; ++i) known[first + i] = lane(inside, i) ? 1 : 0;
            });
            int write = 0;
            for (int i = 0; i < active.size; ++i) {
                if (known[i])
                    batch.steps[active.index[i]] = batch.iterations + 1;
                else
                    moveOrbit(active, i, active, write++);
            }
            active.size = write;
            pad(active);
        }
    }

    void move(const Orbits& from, int i, Orbits& to, int at) const {
        to.base[at] = from.base[i];
        moveOrbit(from, i, to, at);
    }
    void moveOrbit(const Orbits& from, int i, Orbits& to, int at) const {
        for (int k = 0; k < kD; ++k) to.state[k][at] = from.state[k][i];
        for (int k = 0; k < streamCount; ++k) to.streams[k][at] = from.streams[k][i];
        to.index[at] = from.index[i];
    }

    void finish(int orbit, std::int32_t steps, const T* const* rows, int at) {
        batch.steps[orbit] = steps;
        for (int k = 0; k < kD; ++k) batch.state[k][orbit] = rows[k][at];
    }

    template <bool Final, class Arguments>
    static auto runBlock(State& z, const Arguments& arguments, int steps, const R& radius) {
        if constexpr (requires { M::kLanes; })
            return M::template runBlock<Final, R>(z, std::get<0>(arguments), steps, radius);
        else
            return runSteps<Final>(z, arguments, steps, radius);
    }
    template <bool Final, class Arguments>
    static auto runSteps(State& z, const Arguments& arguments, int steps, const R& radius) {
        auto inside = squaredNorm(z) <= radius;
        for (int i = 0; i < steps; ++i) {
            z = stepWith<M, R>(z, arguments);
            if constexpr (!Final) inside = inside & (squaredNorm(z) <= radius);
        }
        if constexpr (Final) inside = squaredNorm(z) <= radius;
        return inside;
    }

    // Same bits in all components: the orbit is periodic from here on.
    static auto sameBits(const State& a, const State& b) {
        R x[kD], y[kD];
        Layout<State>::store(a, x);
        Layout<State>::store(b, y);
        const auto zero = toBits(x[0]) - toBits(x[0]);
        auto same = (toBits(x[0]) - toBits(y[0])) == zero;
        for (int k = 1; k < kD; ++k) same = same & ((toBits(x[k]) - toBits(y[k])) == zero);
        return same;
    }

    // Calls function(i) for every lane i whose truth value is set.
    template <class Mask, class Function>
    static void forEachLane(const Mask& mask, int base, Function function) {
        for (std::uint64_t bits = maskBits(mask); bits != 0; bits &= bits - 1)
            function(base + __builtin_ctzll(bits));
    }

    // Runs `steps` steps from iteration n. `compare`: orbits that are back at their reference (of
    // iteration n0) never escape.
    template <bool Final>
    void pass(int n, int steps, bool compare, int n0) {
        const R radius(batch.squaredRadius);
        R parameters[kP > 0 ? kP : 1];
        loadUniform(parameters);
        Environment<R> environment = environmentOf();
        holes = 0;
        for (int first = 0; first < active.size; first += kWidth) {
            loadStreams(active, first, parameters, environment);
            State z = loadState(active, first);
            const R* from = parameters;
            const auto arguments = ArgumentList<ArgumentsOf<M, R>>::take(from, environment);
            const auto inside = runBlock<Final>(z, arguments, steps, radius);
            forEachLane(!inside, first, [&](int i) {
                if (i >= active.size) return;
                leaving.base[leaving.size] = n;
                moveOrbit(active, i, leaving, leaving.size++);
                hole[holes++] = i;
            });
            storeState(z, active.state, first);
            if (compare) retireRepeating(z, inside, first, n + steps, n + steps - n0);
        }
        fillHoles(compare);
        if (active.size > 0) pad(active);
        walk<Final>(4 * kWidth);
    }

    // The last orbits take the places of those that are gone. Holes are in ascending order.
    void fillHoles(bool compare) {
        while (holes > 0) {
            const int at = hole[--holes];
            const int last = --active.size;
            if (at == last) continue;
            moveOrbit(active, last, active, at);
            if (compare)
                for (int k = 0; k < kD; ++k) reference[k][at] = reference[k][last];
        }
    }

    template <class Mask>
    void retireRepeating(const State& z, const Mask& inside, int first, int n, int period) {
        R old[kD];
        for (int k = 0; k < kD; ++k) loadLanes(old[k], reference[k] + first);
        const int before = holes;
        forEachLane(sameBits(z, Layout<State>::load(old)), first, [&](int i) {
            if (i >= active.size || !lane(inside, i - first)) return;
            retire(i, n, period);
            hole[holes++] = i;
        });
        // Merge with the holes that this block's escapes have left.
        for (int i = before; i < holes; ++i)
            for (int j = i; j > 0 && hole[j - 1] > hole[j]; --j) {
                const std::int32_t swapped = hole[j];
                hole[j] = hole[j - 1];
                hole[j - 1] = swapped;
            }
    }

    // A periodic orbit ends where the remainder of its iterations by the period takes it.
    void retire(int at, int n, int period) {
        const int orbit = active.index[at];
        batch.steps[orbit] = batch.iterations + 1;
        if (!batch.needLast) return;
        const int first = at / kWidth * kWidth;
        R parameters[kP > 0 ? kP : 1];
        loadUniform(parameters);
        Environment<R> environment = environmentOf();
        loadStreams(active, first, parameters, environment);
        State z = loadState(active, first);
        for (int rest = (batch.iterations - n) % period; rest > 0; --rest)
            z = applyStep<M, R>(z, parameters, environment);
        R parts[kD];
        Layout<State>::store(z, parts);
        for (int k = 0; k < kD; ++k) batch.state[k][orbit] = lane(parts[k], at - first);
    }

    // Orbits in `leaving` have left within a block that began at their base. They walk on in short
    // blocks together, whenever they came, so that registers stay full: at least `least` of them
    // are needed to go on.
    template <bool Final>
    void walk(int least) {
        while (leaving.size >= least && leaving.size > 0) {
            shortBlock<Final>();
            lookClosely(kWidth);
        }
    }

    // Those that leave within the next kShort steps are to be looked at step by step.
    template <bool Final>
    void shortBlock() {
        pad(leaving);
        const R radius(batch.squaredRadius);
        R parameters[kP > 0 ? kP : 1];
        loadUniform(parameters);
        Environment<R> environment = environmentOf();
        holes = 0;
        for (int first = 0; first < leaving.size; first += kWidth) {
            loadStreams(leaving, first, parameters, environment);
            State z = loadState(leaving, first);
            const R* from = parameters;
            const auto arguments = ArgumentList<ArgumentsOf<M, R>>::take(from, environment);
            const auto inside = runBlock<Final>(z, arguments, kShort, radius);
            forEachLane(!inside, first, [&](int i) {
                if (i >= leaving.size) return;
                move(leaving, i, closer, closer.size++);
                hole[holes++] = i;
            });
            storeState(z, leaving.state, first);
        }
        for (int i = 0; i < leaving.size; ++i) leaving.base[i] += kShort;
        while (holes > 0) {
            const int at = hole[--holes];
            const int last = --leaving.size;
            if (at != last) move(leaving, last, leaving, at);
        }
    }

    // Finds the first step at which each orbit in `closer` is outside, and stops it there: a
    // register's worth at a time while there are at least `least` of them.
    void lookClosely(int least) {
        const R radius(batch.squaredRadius);
        R parameters[kP > 0 ? kP : 1];
        loadUniform(parameters);
        Environment<R> environment = environmentOf();
        while (closer.size >= least && closer.size > 0) {
            const int first = closer.size > kWidth ? closer.size - kWidth : 0;
            pad(closer);
            loadStreams(closer, first, parameters, environment);
            State z = loadState(closer, first);
            const R* from = parameters;
            const auto arguments = ArgumentList<ArgumentsOf<M, R>>::take(from, environment);
            R norm = squaredNorm(z), previous(T(0));
            auto inside = norm <= radius;
            R count(T(0));
            for (int i = 0; i < kShort; ++i) {
                previous = select(inside, norm, previous);
                z = select(inside, stepWith<M, R>(z, arguments), z);
                count = select(inside, count + R(T(1)), count);
                norm = squaredNorm(z);
                inside = inside & (norm <= radius);
            }
            if (batch.previous) {
                T norms[kWidth];
                storeLanes(previous, norms);
                for (int i = 0; first + i < closer.size; ++i)
                    batch.previous[closer.index[first + i]] = norms[i];
            }
            T last[kD][kWidth], counts[kWidth];
            T* lastRows[kD];
            for (int k = 0; k < kD; ++k) lastRows[k] = last[k];
            storeState(z, lastRows, 0);
            storeLanes(count, counts);
            for (int i = 0; first + i < closer.size; ++i)
                finish(closer.index[first + i],
                       closer.base[first + i] + static_cast<int>(counts[i]), lastRows, i);
            closer.size = first;
        }
    }

    // Marks are negative, so that no result is taken for one.
    static constexpr std::int32_t kPlain = -1, kFinal = -2;

    void run() {
        for (int i = 0; i < batch.count; ++i) batch.steps[i] = kPlain;
        begin(kPlain);
        if (active.size == 0) return;
        markFinal();
        runGroup(kFinal, true);
        runGroup(kPlain, false);
    }

    void runGroup(std::int32_t mark, bool outsideIsFinal) {
        begin(mark);
        if (active.size == 0) return;
        if (batch.shortcuts && !batch.needLast) removeKnownInterior();
        int n = 0, block = 0, n0 = 0, nextReference = 64;
        bool compare = false;
        while (active.size > 0) {
            const int steps = block < batch.iterations - n ? block : batch.iterations - n;
            outsideIsFinal ? pass<true>(n, steps, compare, n0) : pass<false>(n, steps, compare, n0);
            n += steps;
            if (n >= batch.iterations) break;
            if (batch.shortcuts && n >= nextReference) {
                for (int k = 0; k < kD; ++k)
                    for (int i = 0; i < active.size; ++i) reference[k][i] = active.state[k][i];
                n0 = n;
                nextReference = 2 * n;
                compare = true;
            }
            block = block == 0 ? 2 : block < 64 ? 2 * block : 64;
        }
        outsideIsFinal ? walk<true>(1) : walk<false>(1);
        lookClosely(1);
        for (int i = 0; i < active.size; ++i)
            finish(active.index[i], batch.iterations + 1, active.state, i);
    }
};

}  // namespace VERSORIUM_TARGET
}  // namespace versorium
