// SPDX-License-Identifier: MIT
#pragma once
// The catalogue: all maps, type-erased. Everything that offers or checks maps walks it.

#include <span>
#include <string_view>

#include "maps/map_info.h"
#include "maps/orbit_batch.h"
#include "trace/tape.h"

namespace versorium {

using DualNumber = Dual<double>;
using SecondNumber = Dual<Dual<double>>;

class FormulaMap;

// A step in place, over one type of number: the parameters in the order of info.parameters,
// component by component. That of a typed formula runs a program.
template <class R>
class StepFunction {
  public:
    using Plain = void (*)(R* state, const R* parameters, const Environment<R>&);
    constexpr StepFunction(Plain plain, const TapeCode* program = nullptr)
        : plain_(plain), program_(program) {}

    void operator()(R* state, const R* parameters, const Environment<R>& environment) const {
        if (!program_) return plain_(state, parameters, environment);
        Environment<R> own = environment;
        own.program = program_;
        plain_(state, parameters, own);
    }
    explicit constexpr operator bool() const { return plain_ != nullptr; }

  private:
    Plain plain_;
    const TapeCode* program_;
};

struct MapKernels {
    const MapInfo& info;
    int index;       // its place in every kernel table, and in the catalogue if it is there
    int dimension;   // numbers in a state, 1 … 4
    int parameters;  // numbers in its parameters
    StepFunction<double> step;
    StepFunction<float> stepFloat;
    StepFunction<DualNumber> stepDual;
    // Second derivatives, for maps of the plane without a distance field; null for others.
    StepFunction<SecondNumber> stepSecond;
    // Records the step; null for a typed formula, which is a tape already.
    Tape (*record)();
    // Critical points in closed form: their number (0: see maps/critical.h) and the k-th of them.
    int criticalPoints;
    void (*critical)(int k, double* state, const double* parameters);
    void (*criticalDual)(int k, DualNumber* state, const DualNumber* parameters);
    // What a user has typed (maps/formula_map.h); null for the maps of the catalogue.
    const FormulaMap* formula = nullptr;

    Tape trace() const;
    // What batches need beside their numbers; null but for typed formulas.
    const TapeCode* program() const;
};

std::span<const MapKernels> catalogue();
// Null when no map has this name.
const MapKernels* findMap(std::string_view name);
// The first map that `wanted(info)` is true of; null where there is none.
template <class Wanted>
const MapKernels* findMapWhere(Wanted wanted) {
    for (const MapKernels& map : catalogue())
        if (wanted(map.info)) return &map;
    return nullptr;
}
// The map with the same parameters and lists that takes the sum over roots and poles where this one
// takes the product, or the product where it takes the sum; null where there is none.
const MapKernels* sumOrProductOf(const MapInfo& info);

// The kernel tables that this processor can run, narrowest first.
std::span<const KernelTarget> kernelTargets();
// The widest one of a flavour; where no fast one exists, the exact one.
const KernelTarget& kernelTarget(Flavour flavour);

}  // namespace versorium
