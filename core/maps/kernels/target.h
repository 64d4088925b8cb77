// SPDX-License-Identifier: MIT
#pragma once
// The files of this folder are compiled once for each instruction set and flavour, with
// VERSORIUM_KERNEL_TARGET as the name of a namespace of their own, so that no function made for one
// processor is ever called on another. Here stands what they share.

#include "maps/catalogue_maps.h"
#include "maps/formula_step.h"
#include "maps/orbit_batch.h"

#define VERSORIUM_JOIN(a, b) a##b
#define VERSORIUM_JOINED(a, b) VERSORIUM_JOIN(a, b)
// A function's name with the target's at its end: escape_v3_exact.
#define VERSORIUM_OF_TARGET(function) VERSORIUM_JOINED(function, VERSORIUM_KERNEL_TARGET)

namespace versorium {

template <class... Maps>
MapList<Maps..., FormulaStep<1>, FormulaStep<2>, FormulaStep<4>> withFormulas(MapList<Maps...>);
// All maps in the order of a target's tables.
using TargetMaps = decltype(withFormulas(AllMaps{}));

}  // namespace versorium
