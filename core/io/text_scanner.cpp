// SPDX-License-Identifier: MIT
#include "io/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace versorium {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }
bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

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

// Of decimal syntax, infinite where it overflows.
std::optional<double> decimal(std::string_view word) {
    char buffer[128];
    if (word.size() >= sizeof buffer || !isDecimal(word)) return std::nullopt;
    std::memcpy(buffer, word.data(), word.size());
    buffer[word.size()] = '\0';
    return std::strtod(buffer, nullptr);
}

// A backslash and blanks up to the line's end, from `at` on.
bool isContinuation(std::string_view line, std::size_t at) {
    if (line[at] != '\\') return false;
    for (++at; at < line.size() && isBlank(line[at]);) ++at;
    return at == line.size() || isLineEnd(line[at]);
}

}  // namespace

std::optional<double> parseDecimal(std::string_view word) {
    const std::optional<double> value = decimal(word);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> parseReal(std::string_view word) {
    if (const std::optional<double> value = decimal(word)) return value;
    const bool negative = !word.empty() && word[0] == '-';
    std::string name = lowered(word.substr(0, 32));
    if (!name.empty() && (name[0] == '-' || name[0] == '+')) name.erase(0, 1);
    const double infinity = std::numeric_limits<double>::infinity();
    if (name == "inf" || name == "infinity" || name == "1.#inf" || name == "1.#inf00")
        return negative ? -infinity : infinity;
    const bool none = name == "nan" || name.starts_with("nan(") || name.starts_with("1.#ind") ||
                      name.starts_with("1.#qnan") || name.starts_with("1.#snan");
    if (none) return std::numeric_limits<double>::quiet_NaN();
    return std::nullopt;
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

std::string_view withoutMark(std::string_view text) {
    constexpr std::string_view kMark = "\xef\xbb\xbf";
    return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

std::string withLineFeeds(std::string_view text) {
    text = withoutMark(text);
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\r')
            result += text[i];
        else if (i + 1 == text.size() || text[i + 1] != '\n')
            result += '\n';
    }
    return result;
}

Status checkText(std::string_view text) {
    using namespace std::string_view_literals;
    if (text.starts_with("\xff\xfe"sv) || text.starts_with("\xfe\xff"sv) ||
        text.starts_with("\0\0\xfe\xff"sv))
        return Status::data(
            "the file is text in UTF-16 or UTF-32; save it as UTF-8 or plain text and try again");
    if (text.find('\0') != std::string_view::npos)
        return Status::data("the file is no text: it has zero bytes");
    return {};
}

std::string lowered(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = small(c);
    return result;
}

bool beginsWithWord(std::string_view text, std::string_view start) {
    if (text.size() < start.size()) return false;
    for (std::size_t i = 0; i < start.size(); ++i)
        if (small(text[i]) != start[i]) return false;
    return true;
}

std::string shownWord(std::string_view word) {
    std::string text;
    for (char c : word.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
    return "\"" + text + "\"";
}

std::string numberFault(std::string_view word) {
    if (word.empty()) return "a number is missing";
    if (const std::optional<double> value = parseReal(word); value && !std::isfinite(*value))
        return shownWord(word) + " is not a finite number";
    std::string pointed(word.substr(0, 100));
    std::replace(pointed.begin(), pointed.end(), ',', '.');
    if (pointed != word && parseDecimal(pointed))
        return shownWord(word) + " has a decimal comma; write the number with a point";
    return shownWord(word) + " is not a number";
}

TextScanner::TextScanner(std::string_view text, TextOptions options)
    : text_(text), options_(options), next_(text.size() - withoutMark(text).size()) {}

std::size_t TextScanner::lineStop(std::size_t start) {
    const std::size_t stop = std::min(text_.find_first_of("\r\n", start), text_.size());
    const bool both = stop + 1 < text_.size() && text_[stop] == '\r' && text_[stop + 1] == '\n';
    lineEnd_ = text_.substr(stop, both ? 2 : 1);
    return stop;
}

bool TextScanner::nextLine() {
    line_ = lineEnd_ = {};
    if (next_ >= text_.size()) return false;
    number_ += 1 + extra_;
    extra_ = 0;
    const std::size_t start = next_;
    std::size_t stop = lineStop(start);
    const bool comment = text_[start] == '#';
    while (options_.continued && !comment && !lineEnd_.empty()) {
        std::size_t last = stop;
        while (last > start && isBlank(text_[last - 1])) --last;
        if (last == start || text_[last - 1] != '\\') break;
        ++extra_;
        stop = lineStop(stop + lineEnd_.size());
    }
    line_ = text_.substr(start, stop - start);
    next_ = stop + lineEnd_.size();
    return true;
}

std::string_view TextScanner::word() {
    const auto separates = [&](std::size_t i) {
        return isBlank(line_[i]) || isLineEnd(line_[i]) ||
               (options_.continued && isContinuation(line_, i));
    };
    std::size_t start = 0;
    while (start < line_.size() && separates(start)) ++start;
    std::size_t stop = start;
    while (stop < line_.size() && !separates(stop)) ++stop;
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

std::string_view TextScanner::rest() const {
    std::string_view text = line_;
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

}  // namespace versorium
