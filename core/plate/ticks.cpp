// SPDX-License-Identifier: MIT
#include "plate/ticks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/json.h"

namespace versorium {
namespace {

const std::string kMinus = "\u2212";
constexpr double kPi = 3.141592653589793;
// Labels with more digits than this are shortened by an offset or an exponent.
constexpr int kLabelDigits = 5;
// Whole multiples of the step are kept below this, where doubles still hold them exactly enough.
constexpr double kMultipleLimit = 1e15;

// 10^n by repeated multiplication of exact factors: no more than an ulp or two off.
double tenTo(int n) {
    double power = 1, factor = 10;
    for (int m = std::abs(n); m > 0; m >>= 1, factor *= factor)
        if (m & 1) power *= factor;
    return n < 0 ? 1 / power : power;
}

// The greatest n with 10^n <= x, for x > 0.
int tenExponent(double x) {
    int n = 0;
    if (x >= 10)
        while (n < 308 && tenTo(n + 1) <= x) ++n;
    else
        while (n > -320 && tenTo(n) > x) --n;
    return n;
}

int digitsOf(std::int64_t n) {
    int digits = 1;
    for (n = std::abs(n); n >= 10; n /= 10) ++digits;
    return digits;
}

// n · 10^k as a decimal.
std::string decimal(std::int64_t n, int k) {
    std::string digits = std::to_string(std::abs(n));
    if (k > 0 && n != 0) digits += std::string(static_cast<std::size_t>(k), '0');
    if (k < 0) {
        const auto decimals = static_cast<std::size_t>(-k);
        if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
        digits.insert(digits.size() - decimals, ".");
    }
    return (n < 0 ? kMinus : "") + digits;
}

struct Step {
    int mantissa = 1;  // 1, 2 or 5, or 4
    int exponent = 0;
    double size() const { return mantissa * tenTo(exponent); }
};

// Whole numbers n with low <= n·step <= high, give or take a rounding.
struct Multiples {
    double first = 0, last = -1;
    double count() const { return last - first + 1; }
};
Multiples multiples(double low, double high, const Step& step) {
    const double slack = 1e-9 * (high - low) / step.size();
    return {std::ceil(low / step.size() - slack), std::floor(high / step.size() + slack)};
}

// The finest step with no more than `most` ticks.
Step chooseStep(double low, double high, int most) {
    Step step{1, tenExponent((high - low) / std::max(1, most)) - 1};
    while (multiples(low, high, step).count() > most)
        step = step.mantissa == 1   ? Step{2, step.exponent}
               : step.mantissa == 2 ? Step{5, step.exponent}
                                    : Step{1, step.exponent + 1};
    return step;
}

// The finest step with 3 to `most` ticks of which two are the ends; `otherwise` when there is none.
Step chooseEndStep(double low, double high, int most, const Step& otherwise) {
    for (Step step{1, tenExponent((high - low) / std::max(1, most)) - 1};;) {
        const Multiples range = multiples(low, high, step);
        if (range.count() < 3) return otherwise;
        const double slack = 1e-9 * (high - low);
        if (range.count() <= most && std::abs(range.first * step.size() - low) <= slack &&
            std::abs(range.last * step.size() - high) <= slack)
            return step;
        step = step.mantissa == 1   ? Step{2, step.exponent}
               : step.mantissa == 2 ? Step{4, step.exponent}
               : step.mantissa == 4 ? Step{5, step.exponent}
                                    : Step{1, step.exponent + 1};
    }
}

// The multiple of a power of ten nearest to the middle whose distance to all ticks is small.
std::int64_t chooseOffset(std::int64_t first, std::int64_t last) {
    std::int64_t unit = 10;
    while (unit < 2 * (last - first)) unit *= 10;
    const std::int64_t middle = first + (last - first) / 2;
    const std::int64_t half = middle < 0 ? -unit / 2 : unit / 2;
    return (middle + half) / unit * unit;
}

// Trailing zeros go, so that the offset is as short as it can be.
std::string offsetText(std::int64_t n, int k) {
    while (n != 0 && n % 10 == 0 && k < 0) {
        n /= 10;
        ++k;
    }
    return decimal(n, k);
}

TickSet decadeTicks(double low, double high, int most) {
    TickSet set;
    const double from = std::min(low, high), to = std::max(low, high);
    const Scale scale{ScaleKind::log, low, high};
    const int first = tenExponent(from * (1 + 1e-12)) +
                      (tenTo(tenExponent(from * (1 + 1e-12))) < from * (1 - 1e-12) ? 1 : 0);
    const int last = tenExponent(to * (1 + 1e-12));
    // Fewer than two decades: ordinary ticks at their places on the logarithmic axis.
    if (last - first < 1) {
        set = linearTicks(from, to, most);
        for (Tick& tick : set.ticks)
            tick.position = scale.position(from + tick.position * (to - from));
        return set;
    }
    int stride = 1;
    while ((last - first) / stride + 1 > most) ++stride;
    for (int n = first - 1; n <= last; ++n) {
        if (n >= first) {
            const bool labelled = (n - first) % stride == 0;
            const std::string power =
                n == 0   ? "1"
                : n == 1 ? "10"
                         : "10^{" + (n < 0 ? kMinus : "") + std::to_string(std::abs(n)) + "}";
            set.ticks.push_back({scale.position(tenTo(n)), labelled ? power : ""});
        }
        for (int m = 2; m < 10 && last - first <= 3; ++m)
            if (const double value = m * tenTo(n); value >= from && value <= to)
                set.ticks.push_back({scale.position(value), ""});
    }
    return set;
}

TickSet turnTicks(const Scale& scale, int most) {
    const bool half = std::abs(scale.low + kPi) < 1e-6;
    TickSet set;
    const char* const signedNames[] = {"−π", "−π/2", "0", "π/2", "π"};
    const char* const names[] = {"0", "π/2", "π", "3π/2", "2π"};
    const int stride = most >= 5 ? 1 : most >= 3 ? 2 : 4;
    for (int k = 0; k <= 4; k += stride)
        set.ticks.push_back({k / 4.0, half ? signedNames[k] : names[k]});
    return set;
}

}  // namespace

TickSet linearTicks(double low, double high, int most, bool wantEnds) {
    TickSet set;
    const double from = std::min(low, high), to = std::max(low, high);
    const double span = to - from;
    if (most < 1 || !std::isfinite(from) || !std::isfinite(to) || !std::isfinite(span)) return set;
    // Below some hundred ulps the ticks would not be where their labels say.
    if (!(span > 1e-13 * std::max(std::abs(from), std::abs(to))) || span < 1e-290) return set;
    Step step = chooseStep(from, to, most);
    if (wantEnds) step = chooseEndStep(from, to, most, step);
    const Multiples range = multiples(from, to, step);
    if (range.count() < 1 || std::max(std::abs(range.first), std::abs(range.last)) > kMultipleLimit)
        return set;

    const auto first = static_cast<std::int64_t>(range.first) * step.mantissa;
    const auto last = static_cast<std::int64_t>(range.last) * step.mantissa;
    const std::int64_t largest = std::max(std::abs(first), std::abs(last));
    std::int64_t offset = 0;
    int exponent = step.exponent;  // of the printed numbers
    if (digitsOf(largest) > kLabelDigits) {
        offset = chooseOffset(first, last);
        if (offset != 0) set.offset = offsetText(offset, step.exponent);
    }
    const std::int64_t shown = std::max(std::abs(first - offset), std::abs(last - offset));
    const int leading = digitsOf(shown) - 1 + step.exponent;  // decimal exponent of the largest
    if (shown != 0 &&
        (leading > kLabelDigits - 1 || leading < -2 || step.exponent < -kLabelDigits)) {
        set.exponent = leading;
        exponent = step.exponent - leading;
    }
    if (shown == 0) exponent = 0;  // a single tick at the offset or at 0
    for (std::int64_t n = first; n <= last; n += step.mantissa) {
        const double value = static_cast<double>(n) * tenTo(step.exponent);
        set.ticks.push_back(
            {std::clamp((value - low) / (high - low), 0.0, 1.0), decimal(n - offset, exponent)});
    }
    return set;
}

TickSet scaleTicks(const Scale& scale, int most, bool wantEnds) {
    if (!scale.check().ok() || most < 1) return {};
    if (scale.kind == ScaleKind::log) return decadeTicks(scale.low, scale.high, most);
    if (scale.kind == ScaleKind::cyclic && std::abs(scale.high - scale.low - 2 * kPi) < 1e-6 &&
        (std::abs(scale.low) < 1e-6 || std::abs(scale.low + kPi) < 1e-6))
        return turnTicks(scale, most);
    TickSet set = linearTicks(scale.low, scale.high, most, wantEnds);
    if (scale.kind == ScaleKind::sqrt)
        for (Tick& tick : set.ticks)
            tick.position = scale.position(scale.low + tick.position * (scale.high - scale.low));
    return set;
}

TickSet fittingTicks(const Scale& scale, int most, double length, double gap,
                     const std::function<double(const std::string&)>& extent, bool wantEnds) {
    for (int count = most; count >= 1; --count) {
        TickSet set = scaleTicks(scale, count, wantEnds);
        std::vector<Tick> labelled;
        for (const Tick& tick : set.ticks)
            if (!tick.label.empty()) labelled.push_back(tick);
        std::sort(labelled.begin(), labelled.end(),
                  [](const Tick& a, const Tick& b) { return a.position < b.position; });
        bool fits = true;
        for (std::size_t i = 0; i + 1 < labelled.size(); ++i)
            fits =
                fits && length * (labelled[i + 1].position - labelled[i].position) >=
                            0.5 * (extent(labelled[i].label) + extent(labelled[i + 1].label)) + gap;
        if (fits) return set;
    }
    return {};
}

std::string axisName(const std::string& name, const TickSet& ticks, const Words& words) {
    // No line breaks within what the parentheses hold.
    const std::string glue = "\u00a0";
    std::string text;
    for (const char c : name) text += c == ' ' && !ticks.offset.empty() ? glue : std::string(1, c);
    if (!ticks.offset.empty()) {
        const bool negative = ticks.offset.starts_with(kMinus);
        const std::string size = negative ? ticks.offset.substr(kMinus.size()) : ticks.offset;
        if (text.empty()) text = words.tr("value");
        text += glue + (negative ? "+" : kMinus) + glue + words.number(size);
        if (ticks.exponent != 0) text = "(" + text + ")";
    }
    if (ticks.exponent != 0)
        text += (text.empty() ? words.tr("unit") + " 10^{" : " /" + glue + "10^{") +
                (ticks.exponent < 0 ? kMinus : "") + std::to_string(std::abs(ticks.exponent)) + "}";
    return text;
}

}  // namespace versorium
