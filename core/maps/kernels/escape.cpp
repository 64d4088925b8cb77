// SPDX-License-Identifier: MIT
// How orbits of all maps escape, for one instruction set and one flavour (see target.h).

#include "maps/kernels/escape.h"

#include "maps/kernels/stepwise.h"
#include "maps/kernels/target.h"

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

// Pictures are drawn in double. Single precision is there for what measures it: the quadratic
// family and typed formulas over the complex numbers.
template <class M>
constexpr bool kInFloat = std::is_same_v<M, Quadratic> || std::is_same_v<M, FormulaStep<2>>;

template <class M, class T>
constexpr BatchFunction<T> escapeOf() {
    if constexpr (std::is_same_v<T, double> || kInFloat<M>)
        return &escape<M, T>;
    else
        return nullptr;
}

template <class T, class... Maps>
const BatchFunction<T>* escapesOf(MapList<Maps...>) {
    static constexpr BatchFunction<T> kTable[] = {escapeOf<Maps, T>()...};
    return kTable;
}

}  // namespace
}  // namespace VERSORIUM_TARGET

const BatchFunction<double>* VERSORIUM_OF_TARGET(escape_)() {
    return escapesOf<double>(TargetMaps{});
}
const BatchFunction<float>* VERSORIUM_OF_TARGET(escape_float_)() {
    return escapesOf<float>(TargetMaps{});
}

}  // namespace versorium
