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

struct MapKernels {
    const MapInfo& info;
    int index;       // its place in the catalogue and in every kernel table
    int dimension;   // numbers in a state, 1 … 4
    int parameters;  // numbers in its parameters
    // One step in place; parameters in the order of info.parameters, component by component.
    void (*step)(double* state, const double* parameters, const Environment<double>&);
    void (*stepFloat)(float* state, const float* parameters, const Environment<float>&);
    void (*stepDual)(DualNumber* state, const DualNumber* parameters,
                     const Environment<DualNumber>&);
    // Second derivatives, for maps of the plane without a distance field; null for others.
    void (*stepSecond)(SecondNumber* state, const SecondNumber* parameters,
                       const Environment<SecondNumber>&);
    // Records the step.
    Tape (*trace)();
    // Critical points in closed form: their number (0: see maps/critical.h) and the k-th of them.
    int criticalPoints;
    void (*critical)(int k, double* state, const double* parameters);
    void (*criticalDual)(int k, DualNumber* state, const DualNumber* parameters);
};

std::span<const MapKernels> catalogue();
// Null when no map has this name.
const MapKernels* findMap(std::string_view name);

// The kernel tables that this processor can run, narrowest first.
std::span<const KernelTarget> kernelTargets();
// The widest one of a flavour; where no fast one exists, the exact one.
const KernelTarget& kernelTarget(Flavour flavour);

}  // namespace versorium
