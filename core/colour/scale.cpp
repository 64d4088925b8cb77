// SPDX-License-Identifier: MIT
#include "colour/scale.h"

#include <array>
#include <cmath>
#include <string>

#include "math/elementary.h"

namespace versorium {
namespace {

double signedRoot(double x) { return x < 0 ? -versorium::sqrt(-x) : versorium::sqrt(x); }

// The quantity in which the scale is linear. `value` may be anything.
double straighten(ScaleKind kind, double value) {
    switch (kind) {
        case ScaleKind::log:
        case ScaleKind::truncatedLog:
            return versorium::log(value > 0 ? value : 0.0);
        case ScaleKind::sqrt:
            return signedRoot(value);
        default:
            return value;
    }
}

struct Range {
    double low, high;
};

Range straightRange(const Scale& scale) {
    // The ends of a truncated logarithm are logarithms already.
    if (scale.kind == ScaleKind::truncatedLog) return {scale.low, scale.high};
    return {straighten(scale.kind, scale.low), straighten(scale.kind, scale.high)};
}

}  // namespace

double Scale::position(double value) const {
    if (std::isnan(value)) return value;
    const Range range = straightRange(*this);
    const double x = straighten(kind, value);
    const double t = (x - range.low) / (range.high - range.low);
    if (kind == ScaleKind::cyclic) return t - std::floor(t);
    return t < 0 ? 0 : t > 1 ? 1 : t;
}

double Scale::value(double position) const {
    const Range range = straightRange(*this);
    const double x = range.low + position * (range.high - range.low);
    if (kind == ScaleKind::log) return versorium::exp(x);
    if (kind == ScaleKind::sqrt) return x < 0 ? -x * x : x * x;
    return x;
}

Status Scale::check() const {
    if (!std::isfinite(low) || !std::isfinite(high) || low == high || !std::isfinite(high - low))
        return Status::usage("the range of a colour scale needs two different finite ends");
    if (kind == ScaleKind::log && !(low > 0 && high > 0))
        return Status::usage("a logarithmic colour scale needs ends above 0");
    return {};
}

}  // namespace versorium
