// SPDX-License-Identifier: MIT
// One step of the orbits of all maps, without and with a derivative, for one instruction set and
// one flavour (see target.h).

#include "maps/kernels/escape.h"
#include "maps/kernels/target.h"

namespace versorium {
inline namespace VERSORIUM_TARGET {
namespace {

// R is Lanes<double> or Dual<Lanes<double>>.
template <class M, class R>
void advanceWith(OrbitBatch<double>& batch) {
    using T = double;
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

template <template <class> class Number, class... Maps>
const BatchFunction<double>* advancesOf(MapList<Maps...>) {
    static constexpr BatchFunction<double> kTable[] = {
        &advanceWith<Maps, Number<Lanes<double>>>...};
    return kTable;
}

template <class L>
using Plain = L;

}  // namespace
}  // namespace VERSORIUM_TARGET

const BatchFunction<double>* VERSORIUM_OF_TARGET(advance_)() {
    return advancesOf<Plain>(TargetMaps{});
}
const BatchFunction<double>* VERSORIUM_OF_TARGET(advance_dual_)() {
    return advancesOf<Dual>(TargetMaps{});
}

}  // namespace versorium
