// SPDX-License-Identifier: MIT
#pragma once
// The escape kernel: it works in passes over all orbits that are still active. A pass runs a block
// of steps without looking, several registers at a time, then tests. Orbits that left during the
// block are collected and replayed from its beginning with a test after each step, full registers
// again; the others move up, so that no lane is ever idle. The result is that of the plain loop.

#include "maps/apply.h"
#include "maps/orbit_batch.h"

namespace versorium {
inline namespace VERSORIUM_TARGET {

template <int Registers, class T>
struct BlockOf;
template <class T>
struct BlockOf<1, T> {
    using type = Lanes<T>;
};
template <class T>
struct BlockOf<2, T> {
    using type = Pair<Lanes<T>>;
};
template <class T>
struct BlockOf<4, T> {
    using type = Pair<Pair<Lanes<T>>>;
};
template <class T>
struct BlockOf<8, T> {
    using type = Pair<Pair<Pair<Lanes<T>>>>;
};

// Registers in flight: enough to hide latency, few enough to stay in registers.
template <class M>
constexpr int registersOf() {
    if constexpr (requires { M::kRegisters; })
        return M::kRegisters;
    else
        return kDimension<M> <= 2 ? 4 : 2;
}

template <class M, class R>
struct EscapeKernel {
    using T = ScalarOf<R>;
    using State = StateOf<M, R>;
    static constexpr int kD = kDimension<M>;
    static constexpr int kP = kParameters<M>;
    static constexpr int kWidth = kLaneCount<R>;
    static constexpr int kStreams = kP + kMostOverrides;

    struct Orbits {
        T* state[kD];
        T* streams[kStreams];
        std::int32_t* index;
        int size = 0;
    };

    OrbitBatch<T>& batch;
    Orbits active, leaving;
    T* reference[kD];
    int streamCount = 0;
    int streamParameter[kStreams];  // < kP: a parameter; else override number + kP
    bool outsideIsFinal = false;

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
            reference[k] = take();
        }
        for (int k = 0; k < streamCount; ++k) {
            active.streams[k] = take();
            leaving.streams[k] = take();
        }
        active.index = batch.scratchIndex;
        leaving.index = batch.scratchIndex + batch.capacity;
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
        for (int k = 0; k < kP; ++k) parameters[k] = R(*batch.parameters[k].values);
    }

    void begin() {
        for (int i = 0; i < batch.count; ++i) active.index[i] = i;
        for (int k = 0; k < kD; ++k)
            for (int i = 0; i < batch.count; ++i) active.state[k][i] = batch.state[k][i];
        for (int k = 0; k < streamCount; ++k)
            for (int i = 0; i < batch.count; ++i) active.streams[k][i] = streamValues(k)[i];
        active.size = batch.count;
        pad(active);
        decideFinality();
        if (batch.shortcuts && !batch.needLast) removeKnownInterior();
    }

    template <class Function>
    void forEachBlock(const Orbits& orbits, Function function) const {
        R parameters[kP > 0 ? kP : 1];
        loadUniform(parameters);
        Environment<R> environment = environmentOf();
        for (int first = 0; first < orbits.size; first += kWidth) {
            loadStreams(orbits, first, parameters, environment);
            const R* from = parameters;
            const auto arguments =
                ArgumentList<ArgumentsOf<M, R>>::take(from, environment);
            function(first, loadState(orbits, first), arguments);
        }
    }

    // May the test after a block stand for the tests within it?
    void decideFinality() {
        if constexpr (requires { &M::template outsideIsFinal<R>; }) {
            const R radius(batch.squaredRadius);
            bool all = true;
            forEachBlock(active, [&](int, const State& z, const auto& arguments) {
                const auto final = std::apply(
                    [&](const auto&... as) { return M::template outsideIsFinal<R>(radius, z, as...); },
                    arguments);
                if (any(!final)) all = false;
            });
            outsideIsFinal = all;
        }
    }

    void removeKnownInterior() {
        if constexpr (requires { &M::template knownInterior<R>; }) {
            const R radius(batch.squaredRadius);
            std::int32_t* known = leaving.index;
            forEachBlock(active, [&](int first, const State& z, const auto& arguments) {
                const auto inside = std::apply(
                    [&](const auto&... as) { return M::template knownInterior<R>(radius, z, as...); },
                    arguments);
                for (int i = 0; i < kWidth; ++i) known[first + i] = lane(inside, i) ? 1 : 0;
            });
            int write = 0;
            for (int i = 0; i < active.size; ++i) {
                if (known[i])
                    batch.steps[active.index[i]] = batch.iterations + 1;
                else
                    move(active, i, active, write++);
            }
            active.size = write;
            pad(active);
        }
    }

    void move(const Orbits& from, int i, Orbits& to, int at) const {
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

    // Runs `steps` steps from iteration n. `compare`: orbits that are back at their reference (of
    // iteration n0) never escape.
    template <bool Final>
    void pass(int n, int steps, bool compare, int n0) {
        const R radius(batch.squaredRadius);
        R parameters[kP > 0 ? kP : 1];
        loadUniform(parameters);
        Environment<R> environment = environmentOf();
        T fresh[kD][kWidth];
        T* freshRows[kD];
        for (int k = 0; k < kD; ++k) freshRows[k] = fresh[k];
        int write = 0;
        leaving.size = 0;
        for (int first = 0; first < active.size; first += kWidth) {
            loadStreams(active, first, parameters, environment);
            State z = loadState(active, first);
            const R* from = parameters;
            const auto arguments = ArgumentList<ArgumentsOf<M, R>>::take(from, environment);
            const auto inside = runBlock<Final>(z, arguments, steps, radius);
            bool repeats = false;
            R old[kD];
            if (compare) {
                for (int k = 0; k < kD; ++k) loadLanes(old[k], reference[k] + first);
                repeats = any(sameBits(z, Layout<State>::load(old)));
            }
            const int valid = active.size - first < kWidth ? active.size - first : kWidth;
            if (!repeats && !any(!inside)) {
                moveBlock(first, write, compare);
                storeState(z, active.state, write);
                write += valid;
                continue;
            }
            storeState(z, freshRows, 0);
            for (int i = 0; i < valid; ++i) {
                if (!lane(inside, i)) {
                    move(active, first + i, leaving, leaving.size++);
                    continue;
                }
                if (repeats && returned(fresh, i, first)) {
                    retire(active.index[first + i], n + steps, n + steps - n0, first, i, freshRows);
                    continue;
                }
                move(active, first + i, active, write);
                for (int k = 0; k < kD; ++k) {
                    active.state[k][write] = fresh[k][i];
                    if (compare) reference[k][write] = reference[k][first + i];
                }
                ++write;
            }
        }
        active.size = write;
        if (write > 0) pad(active);
        if (leaving.size > 0) replay(n, steps);
    }

    // Streams, indices and references of a whole register move up; the state is stored anew.
    void moveBlock(int first, int write, bool compare) {
        if (write == first) return;
        for (int i = 0; i < kWidth; ++i) active.index[write + i] = active.index[first + i];
        R row;
        for (int k = 0; k < streamCount; ++k) {
            loadLanes(row, active.streams[k] + first);
            storeLanes(row, active.streams[k] + write);
        }
        if (!compare) return;
        for (int k = 0; k < kD; ++k) {
            loadLanes(row, reference[k] + first);
            storeLanes(row, reference[k] + write);
        }
    }

    bool returned(const T (&fresh)[kD][kWidth], int i, int first) const {
        for (int k = 0; k < kD; ++k)
            if (std::memcmp(&fresh[k][i], &reference[k][first + i], sizeof(T)) != 0) return false;
        return true;
    }

    // A periodic orbit ends where the remainder of its iterations by the period takes it.
    void retire(int orbit, int n, int period, int first, int i, T* const* rows) {
        if (batch.needLast) {
            int rest = (batch.iterations - n) % period;
            R parameters[kP > 0 ? kP : 1];
            loadUniform(parameters);
            Environment<R> environment = environmentOf();
            loadStreams(active, first, parameters, environment);
            R parts[kD];
            for (int k = 0; k < kD; ++k) loadLanes(parts[k], rows[k]);
            State z = Layout<State>::load(parts);
            for (; rest > 0; --rest) z = applyStep<M, R>(z, parameters, environment);
            T last[kD][kWidth];
            T* lastRows[kD];
            for (int k = 0; k < kD; ++k) lastRows[k] = last[k];
            storeState(z, lastRows, 0);
            finish(orbit, batch.iterations + 1, lastRows, i);
        } else {
            batch.steps[orbit] = batch.iterations + 1;
        }
    }

    // All orbits in `leaving` escape within `steps` steps from iteration n: finds the first.
    void replay(int n, int steps) {
        pad(leaving);
        const R radius(batch.squaredRadius);
        R parameters[kP > 0 ? kP : 1];
        loadUniform(parameters);
        Environment<R> environment = environmentOf();
        for (int first = 0; first < leaving.size; first += kWidth) {
            loadStreams(leaving, first, parameters, environment);
            State z = loadState(leaving, first);
            auto inside = squaredNorm(z) <= radius;
            R count(T(0));
            for (int i = 0; i < steps && any(inside); ++i) {
                z = select(inside, applyStep<M, R>(z, parameters, environment), z);
                count = select(inside, count + R(T(1)), count);
                inside = inside & (squaredNorm(z) <= radius);
            }
            storeState(z, leaving.state, first);
            const int valid = leaving.size - first < kWidth ? leaving.size - first : kWidth;
            for (int i = 0; i < valid; ++i)
                finish(leaving.index[first + i], n + static_cast<int>(lane(count, i)),
                       leaving.state, first + i);
        }
    }

    void run() {
        begin();
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
            block = block == 0 ? 2 : block < 32 ? 2 * block : 32;
        }
        for (int i = 0; i < active.size; ++i)
            finish(active.index[i], batch.iterations + 1, active.state, i);
    }
};

}  // namespace VERSORIUM_TARGET
}  // namespace versorium
