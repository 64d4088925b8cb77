// SPDX-License-Identifier: MIT
#include "io/text_scanner.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

namespace versorium {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

// Decimal syntax: sign, digits with one point, exponent.
bool isDecimal(std::string_view word) {
    std::size_t i = 0;
    const auto digits = [&] {
        const std::size_t start = i;
        while (i < word.size() && isDigit(word[i])) ++i;
        return i - start;
    };
    const auto sign = [&] {
        if (i < word.size() && (word[i] == '+' || word[i] == '-')) ++i;
    };
    sign();
    std::size_t mantissa = digits();
    if (i < word.size() && word[i] == '.') {
        ++i;
        mantissa += digits();
    }
    if (mantissa == 0) return false;
    if (i < word.size() && (word[i] == 'e' || word[i] == 'E')) {
        ++i;
        sign();
        if (digits() == 0) return false;
    }
    return i == word.size();
}

}  // namespace

std::optional<double> parseDecimal(std::string_view word) {
    char buffer[128];
    if (word.size() >= sizeof buffer || !isDecimal(word)) return std::nullopt;
    std::memcpy(buffer, word.data(), word.size());
    buffer[word.size()] = '\0';
    const double value = std::strtod(buffer, nullptr);
    if (!std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<std::int64_t> parseInteger(std::string_view word) {
    const bool negative = !word.empty() && word[0] == '-';
    if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.remove_prefix(1);
    if (word.empty() || word.size() > 18) return std::nullopt;
    std::int64_t value = 0;
    for (char c : word) {
        if (!isDigit(c)) return std::nullopt;
        value = value * 10 + (c - '0');
    }
    return negative ? -value : value;
}

bool TextScanner::nextLine() {
    if (next_ >= text_.size()) {
        line_ = {};
        return false;
    }
    const std::size_t end = text_.find('\n', next_);
    const std::size_t stop = end == std::string_view::npos ? text_.size() : end;
    line_ = text_.substr(next_, stop - next_);
    next_ = end == std::string_view::npos ? stop : stop + 1;
    ++number_;
    return true;
}

std::string_view TextScanner::word() {
    std::size_t start = 0;
    while (start < line_.size() && isBlank(line_[start])) ++start;
    std::size_t stop = start;
    while (stop < line_.size() && !isBlank(line_[stop])) ++stop;
    const std::string_view found = line_.substr(start, stop - start);
    line_.remove_prefix(stop);
    return found;
}

std::string_view TextScanner::wordAcrossLines() {
    while (true) {
        const std::string_view found = word();
        if (!found.empty() || !nextLine()) return found;
    }
}

}  // namespace versorium
