// SPDX-License-Identifier: MIT
#pragma once
// A tape for parameters of which some are 0 and stay so: products with them are left out, sums with
// those as well, and whatever only they needed. The rest is done in the same order, so that the
// result is the same wherever all numbers are finite (and but for the sign of a zero): the rule by
// which maps/planar.h leaves out zero terms. Thus one definition of the planar quartic with its 30
// coefficients gives the GPU a step of x² - y² + c.

#include <vector>

#include "trace/tape.h"

namespace versorium {

// zero[k]: the k-th parameter is 0. The tape's parameters keep their places.
Tape specialise(const Tape& tape, const std::vector<char>& zero);

}  // namespace versorium
