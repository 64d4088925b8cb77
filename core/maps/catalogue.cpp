// SPDX-License-Identifier: MIT
#include "maps/catalogue.h"

#include <algorithm>
#include <array>
#include <vector>

#include "maps/apply.h"
#include "maps/catalogue_maps.h"
#include "maps/formula_map.h"

namespace versorium {

#define VERSORIUM_DECLARE_TARGET(target)                  \
    const BatchFunction<double>* escape_##target();       \
    const BatchFunction<double>* advance_##target();      \
    const BatchFunction<double>* advance_dual_##target(); \
    const BatchFunction<float>* escape_float_##target();
VERSORIUM_DECLARE_TARGET(v2_exact)
VERSORIUM_DECLARE_TARGET(v3_exact)
VERSORIUM_DECLARE_TARGET(v4_exact)
VERSORIUM_DECLARE_TARGET(v3_fast)
VERSORIUM_DECLARE_TARGET(v4_fast)
VERSORIUM_DECLARE_TARGET(generic_exact)

namespace {

template <class M>
Tape traceOf() {
    Tape tape;
    constexpr int kD = kDimension<M>, kP = kParameters<M>;
    tape.stateSize = kD;
    tape.parameterSize = kP;
    Expr state[kD], parameters[kP > 0 ? kP : 1];
    for (int k = 0; k < kD; ++k) state[k] = {&tape, tape.add({.op = Op::state, .index = k})};
    for (int k = 0; k < kP; ++k)
        parameters[k] = {&tape, tape.add({.op = Op::parameter, .index = k})};
    Environment<Expr> environment;
    environment.tape = &tape;
    stepFlat<M, Expr>(state, parameters, environment);
    for (int k = 0; k < kD; ++k) tape.outputs.push_back(state[k].on(&tape));
    return tape;
}

// Critical points in closed form depend on sliced parameters only.
template <class M, class R>
void criticalOf(int k, R* state, const R* parameters) {
    if constexpr (requires { M::kCriticalPoints; }) {
        const Environment<R> none;
        const auto arguments = ArgumentList<ArgumentsOf<M, R>>::take(parameters, none);
        const auto point = std::apply(
            [&](const auto&... as) { return M::template critical<R>(k, as...); }, arguments);
        Layout<StateOf<M, R>>::store(point, state);
    }
}

template <class M>
constexpr int criticalCount() {
    if constexpr (requires { M::kCriticalPoints; })
        return M::kCriticalPoints;
    else
        return 0;
}

using SecondStep = void (*)(SecondNumber*, const SecondNumber*, const Environment<SecondNumber>&);
template <class M>
constexpr SecondStep secondOf() {
    if constexpr (kDimension<M> == 2 && !M::info.field)
        return &stepFlat<M, SecondNumber>;
    else
        return nullptr;
}

template <class M>
constexpr MapKernels rowOf(int index) {
    static_assert(kDimension<M> == dimensionOf(M::info.algebra));
    static_assert(kParameters<M> == parameterSize(M::info), "parameters and step disagree");
    static_assert(kParameters<M> <= kMostParameters);
    return {M::info,
            index,
            kDimension<M>,
            kParameters<M>,
            &stepFlat<M, double>,
            &stepFlat<M, float>,
            &stepFlat<M, DualNumber>,
            secondOf<M>(),
            &traceOf<M>,
            criticalCount<M>(),
            &criticalOf<M, double>,
            &criticalOf<M, DualNumber>};
}

template <class... Maps>
std::span<const MapKernels> rowsOf(MapList<Maps...>) {
    static constexpr std::array<MapKernels, sizeof...(Maps)> kRows = [] {
        int index = 0;
        return std::array<MapKernels, sizeof...(Maps)>{rowOf<Maps>(index++)...};
    }();
    return kRows;
}

#define VERSORIUM_TABLES_OF(target) \
    escape_##target(), advance_##target(), advance_dual_##target(), escape_float_##target()
std::vector<KernelTarget> allTargets() {
    [[maybe_unused]] const auto always = [] { return true; };
    std::vector<KernelTarget> targets;
#ifdef VERSORIUM_X86_KERNELS
    [[maybe_unused]] const auto v3 = [] {
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
               __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    };
    [[maybe_unused]] const auto v4 = [] {
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
               __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
               __builtin_cpu_supports("avx512cd");
    };
#endif
#ifdef VERSORIUM_HAS_v2_exact
    targets.push_back({"x86-64-v2", Flavour::exact, always, VERSORIUM_TABLES_OF(v2_exact)});
#endif
#ifdef VERSORIUM_HAS_v3_exact
    targets.push_back({"x86-64-v3", Flavour::exact, v3, VERSORIUM_TABLES_OF(v3_exact)});
#endif
#ifdef VERSORIUM_HAS_v4_exact
    targets.push_back({"x86-64-v4", Flavour::exact, v4, VERSORIUM_TABLES_OF(v4_exact)});
#endif
#ifdef VERSORIUM_HAS_v3_fast
    targets.push_back({"x86-64-v3", Flavour::fast, v3, VERSORIUM_TABLES_OF(v3_fast)});
#endif
#ifdef VERSORIUM_HAS_v4_fast
    targets.push_back({"x86-64-v4", Flavour::fast, v4, VERSORIUM_TABLES_OF(v4_fast)});
#endif
#ifdef VERSORIUM_HAS_generic_exact
    targets.push_back({"128-bit", Flavour::exact, always, VERSORIUM_TABLES_OF(generic_exact)});
#endif
    return targets;
}

}  // namespace

Tape MapKernels::trace() const { return formula ? formula->formula().tape : record(); }

const TapeCode* MapKernels::program() const { return formula ? &formula->code() : nullptr; }

std::span<const MapKernels> catalogue() { return rowsOf(AllMaps{}); }

const MapKernels* findMap(std::string_view name) {
    for (const MapKernels& map : catalogue())
        if (map.info.name == name) return &map;
    return nullptr;
}

const MapKernels* sumOrProductOf(const MapInfo& info) {
    const bool sum = info.rootForm == RootForm::sum;
    if (!sum && info.rootForm != RootForm::product) return nullptr;
    const auto sameName = [](const ParameterInfo& a, const ParameterInfo& b) {
        return a.name == b.name;
    };
    return findMapWhere([&](const MapInfo& other) {
        return other.rootForm == (sum ? RootForm::product : RootForm::sum) &&
               other.algebra == info.algebra && other.field == info.field &&
               std::equal(other.lists.begin(), other.lists.end(), info.lists.begin(),
                          info.lists.end()) &&
               std::equal(other.parameters.begin(), other.parameters.end(), info.parameters.begin(),
                          info.parameters.end(), sameName);
    });
}

std::span<const KernelTarget> kernelTargets() {
    static const std::vector<KernelTarget> kTargets = [] {
        std::vector<KernelTarget> usable;
        for (const KernelTarget& target : allTargets())
            if (target.available()) usable.push_back(target);
        return usable;
    }();
    return kTargets;
}

const KernelTarget& kernelTarget(Flavour flavour) {
    const KernelTarget* best = nullptr;
    for (const KernelTarget& target : kernelTargets())
        if (target.flavour == flavour) best = &target;
    return best ? *best : kernelTarget(Flavour::exact);
}

}  // namespace versorium
