// SPDX-License-Identifier: MIT
#pragma once
// A condition on what the studio shows, in the formula language of typed maps (trace/formula.h):
//
//   critical_period == 3 and c.im > 0
//   distance(z.re, z.im, 0, 0) < 0.1 is written   (z.re^2 + z.im^2) < 0.01
//
// Names are those of observables (lesson/observables.h).

#include <functional>
#include <string>
#include <vector>

#include "base/status.h"
#include "trace/tape.h"

namespace versorium {

struct Condition {
    std::string text;
    std::vector<std::string> names;  // of the observables that stand in it
    Tape tape;                       // whose parameters are their values
};

// ErrorKind::data where it is no condition, or names what `known` does not know.
Expected<Condition> parseCondition(const std::string& text,
                                   const std::function<bool(const std::string&)>& known);
// False where a value that decides it is NaN.
bool holds(const Condition& condition, const std::function<double(const std::string&)>& value);

}  // namespace versorium
