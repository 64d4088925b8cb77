// SPDX-License-Identifier: MIT
#pragma once
// How a measured value becomes a position in [0, 1] on a palette:
//   linear         (v - low) / (high - low)
//   log            the same for ln v, with 0 < low < high
//   truncated_log  v > 0 is a modulus; ln v is cut to [low, high], which are themselves natural
//                  logarithms, usually -m and m (S Fig 2); v = 0 lies at low, inf at high
//   sqrt           sign(v) sqrt|v|, linear between the roots of low and high
//   cyclic         linear, and periodic with period high - low
// All but `cyclic` are cut to [0, 1]. NaN stays NaN, which a palette shows in its own colour. A
// scale may run downwards (low > high).

#include "base/status.h"
#include "base/words.h"

namespace versorium {

enum class ScaleKind { linear, log, truncatedLog, sqrt, cyclic };

template <>
struct EnumWords<ScaleKind> {
    static constexpr std::array<std::string_view, 5> table{"linear", "log", "truncated_log", "sqrt",
                                                           "cyclic"};
};

struct Scale {
    ScaleKind kind = ScaleKind::linear;
    double low = 0;
    double high = 1;

    double position(double value) const;
    // The value at a position in [0, 1]: the inverse, for ticks of a colour bar. On truncated_log
    // it is the logarithm itself, since that is what the bar shows.
    double value(double position) const;
    // ErrorKind::usage when the range is empty, not finite, or not positive where it must be.
    Status check() const;

    friend bool operator==(const Scale&, const Scale&) = default;
};

}  // namespace versorium
