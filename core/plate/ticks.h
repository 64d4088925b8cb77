// SPDX-License-Identifier: MIT
#pragma once
// Ticks at 1, 2 or 5 times a power of ten, as few as fit. Labels of one axis have the same number
// of decimals and true minus signs (U+2212). Where numbers would be long (deep zooms, tiny or huge
// ranges) the ticks show (value - offset) / 10^exponent, and the axis name says so.

#include <functional>
#include <string>
#include <vector>

#include "colour/scale.h"
#include "i18n/language.h"

namespace versorium {

struct Tick {
    double position = 0;  // in [0, 1] from the low to the high end of the axis
    std::string label;    // empty: a minor tick
};

struct TickSet {
    std::vector<Tick> ticks;
    std::string offset;  // "0.74364" or "−0.74364" when it was taken off, else empty
    int exponent = 0;
};

// At most `most` labelled ticks from low to high. Empty where doubles cannot tell them apart. With
// wantEnds, steps of 4 are allowed too, and a coarser step whose first and last tick stand exactly
// at the ends goes before a finer one that misses them: the ends of a colour bar are where values
// are cut.
TickSet linearTicks(double low, double high, int most, bool wantEnds = false);
// Any scale of a colour bar or an axis; cyclic ranges of a whole turn are labelled by π.
TickSet scaleTicks(const Scale& scale, int most, bool wantEnds = false);

// The most ticks, up to `most`, whose labels keep `gap` between each other on an axis of the given
// length; `extent` measures a label along the axis.
TickSet fittingTicks(const Scale& scale, int most, double length, double gap,
                     const std::function<double(const std::string&)>& extent,
                     bool wantEnds = false);

// "(Re c + 0.74364) / 10^{−9}": the name of an axis whose ticks were shortened. Markup.
std::string axisName(const std::string& name, const TickSet& ticks, const Words& words);

}  // namespace versorium
