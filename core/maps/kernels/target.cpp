// SPDX-License-Identifier: MIT
// The kernels of all maps for one instruction set and one flavour. This file is compiled once for
// each of them, with VERSORIUM_KERNEL_TARGET as the name of its own namespace, so that no function
// made for one processor is ever called on another.

#include "maps/catalogue_maps.h"
#include "maps/formula_step.h"
#include "maps/kernels/escape.h"
#include "maps/kernels/stepwise.h"

namespace versorium {
inline namespace VERSORIUM_TARGET {
namespace {

template <class M, class T>
void escapeWith(OrbitBatch<T>& batch) {
    using R = typename BlockOf<registersOf<M, T>(), T>::type;
    if constexpr (requires { M::kStepwise; })
        StepwiseKernel<M, R>(batch).run();
    else
        EscapeKernel<M, R>(batch).run();
}

// The first of the map's shorter forms that applies, else the map itself.
template <class M, class T>
void escape(OrbitBatch<T>& batch) {
    if constexpr (requires { typename M::Forms; }) {
        bool nonzero[kParameters<M>];
        for (int k = 0; k < kParameters<M>; ++k)
            nonzero[k] = batch.parameters[k].varies || *batch.parameters[k].values != T(0);
        bool done = false;
        const auto attempt = [&]<class Form>(Form) {
            if (done) return;
            for (int k = 0; k < kParameters<M>; ++k)
                if (nonzero[k] && !Form::kPlaces.has[k]) return;
            done = true;
            escapeWith<Form>(batch);
        };
        [&]<class... Forms>(std::tuple<Forms...>) { (attempt(Forms{}), ...); }(typename M::Forms{});
        if (done) return;
    }
    escapeWith<M>(batch);
}

// R is Lanes<T> or Dual<Lanes<T>>.
template <class M, class R, class T>
void advanceWith(OrbitBatch<T>& batch) {
    using L = Lanes<T>;
    constexpr bool kDual = !std::is_same_v<R, L>;
    constexpr int kD = kDimension<M>, kP = kParameters<M>;
    const auto make = [](const L& value, T slope) {
        if constexpr (kDual)
            return R(value, L(slope));
        else
            return (void)slope, value;
    };
    R parameters[kP > 0 ? kP : 1];
    Environment<R> environment;
    for (int k = 0; k < kMostLists; ++k) environment.lists[k] = batch.lists[k];
    environment.field = batch.field;
    environment.program = batch.program;
    const int count = parameterCount<M>(batch);
    environment.overrideCount = batch.overrideCount;
    const auto load = [](const Stream<T>& stream, int first) {
        L lanes(*stream.values);
        if (stream.varies) loadLanes(lanes, stream.values + first);
        return lanes;
    };
    for (int first = 0; first < batch.count; first += L::kCount) {
        for (int k = 0; k < count; ++k)
            parameters[k] = make(load(batch.parameters[k], first), batch.parameterSlopes[k]);
        for (int k = 0; k < batch.overrideCount; ++k)
            environment.overrides[k] = {
                batch.overrides[k].list, batch.overrides[k].item, batch.overrides[k].component,
                make(load(batch.overrides[k].stream, first), batch.overrideSlopes[k])};
        R state[kD];
        for (int k = 0; k < kD; ++k) {
            L value;
            loadLanes(value, batch.state[k] + first);
            state[k] = make(value, T(0));
            if constexpr (kDual) loadLanes(state[k].slope, batch.slope[k] + first);
        }
        stepFlat<M, R>(state, parameters, environment);
        for (int k = 0; k < kD; ++k) {
            if constexpr (kDual) {
                storeLanes(state[k].value, batch.state[k] + first);
                storeLanes(state[k].slope, batch.slope[k] + first);
            } else {
                storeLanes(state[k], batch.state[k] + first);
            }
        }
    }
}

template <class T, class... Maps>
struct Rows {
    static constexpr BatchRow<T> kTable[] = {{&escape<Maps, T>, &advanceWith<Maps, Lanes<T>, T>,
                                              &advanceWith<Maps, Dual<Lanes<T>>, T>}...};
};

template <class T, class... Maps>
const BatchRow<T>* rowsOf(MapList<Maps...>) {
    return Rows<T, Maps..., FormulaStep<1>, FormulaStep<2>, FormulaStep<4>>::kTable;
}

}  // namespace
}  // namespace VERSORIUM_TARGET

#define VERSORIUM_JOIN(a, b) a##b
#define VERSORIUM_NAMED(a, b) VERSORIUM_JOIN(a, b)
const BatchRow<double>* VERSORIUM_NAMED(doubles_, VERSORIUM_KERNEL_TARGET)() {
    return rowsOf<double>(AllMaps{});
}
const BatchRow<float>* VERSORIUM_NAMED(floats_, VERSORIUM_KERNEL_TARGET)() {
    return rowsOf<float>(AllMaps{});
}

}  // namespace versorium
