// SPDX-License-Identifier: MIT
#include "trace/formula_scanner.h"

#include <algorithm>
#include <cstdlib>

#include "trace/index.h"

namespace versorium {
namespace formulas {
namespace {

constexpr std::size_t kNumberCharacters = 40;

// One character for each code point; a broken byte is one of its own.
std::vector<char32_t> charactersOf(std::string_view text) {
    std::vector<char32_t> all;
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = [&](std::size_t k) {
            return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
        };
        const unsigned first = byte(i);
        const int more = first < 0x80 ? 0 : first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
        char32_t value = more == 0 ? first : first & (0x3fu >> more);
        bool good = more == 0 || (first >= 0xc2 && first < 0xf5);
        for (int k = 1; k <= more && good; ++k) {
            good = (byte(i + at(k)) & 0xc0u) == 0x80u;
            value = (value << 6) | (byte(i + at(k)) & 0x3fu);
        }
        all.push_back(good ? value : 0xfffd);
        i += good ? at(more) + 1 : 1;
    }
    return all;
}

std::string utf8(char32_t c) {
    std::string text;
    if (c < 0x80) return text += static_cast<char>(c);
    if (c < 0x800) {
        text += static_cast<char>(0xc0 | (c >> 6));
    } else {
        if (c < 0x10000) {
            text += static_cast<char>(0xe0 | (c >> 12));
        } else {
            text += static_cast<char>(0xf0 | (c >> 18));
            text += static_cast<char>(0x80 | ((c >> 12) & 0x3f));
        }
        text += static_cast<char>(0x80 | ((c >> 6) & 0x3f));
    }
    return text += static_cast<char>(0x80 | (c & 0x3f));
}

}  // namespace

Scanner::Scanner(std::string_view text) : text_(charactersOf(text)) {}

bool Scanner::takeWord(std::string_view word) {
    skipBlanks();
    for (std::size_t k = 0; k < word.size(); ++k)
        if (peek(k) != static_cast<char32_t>(word[k])) return false;
    if (isLetter(static_cast<char32_t>(word.back())) &&
        (isLetter(peek(word.size())) || isDigit(peek(word.size())) || peek(word.size()) == '_'))
        return false;
    position += word.size();
    return true;
}

bool Scanner::fail(std::size_t where, std::string message) {
    fault = {std::min(where, text_.size()), std::move(message)};
    return false;
}

bool Scanner::expected(const std::string& what) {
    skipBlanks();
    if (atDecimalComma()) return refuseDecimalComma();
    const bool end = position >= text_.size();
    return fail(position, what + " is expected, not " +
                              (end ? "the end" : "\"" + utf8(text_[position]) + "\""));
}

std::string Scanner::peekName() {
    skipBlanks();
    std::string name;
    if (!isLetter(peek())) return name;
    for (std::size_t k = 0; isLetter(peek(k)) || isDigit(peek(k)) || peek(k) == '_'; ++k)
        name += static_cast<char>(peek(k));
    return name;
}

bool Scanner::takeNumber(double& value) {
    const std::size_t start = position;
    std::string word;
    const auto digits = [&] {
        while (isDigit(peek())) word += static_cast<char>(peek()), ++position;
    };
    digits();
    if (word == "0" && (peek() == 'x' || peek() == 'X' || peek() == 'b' || peek() == 'o') &&
        isDigit(peek(1)))
        return fail(start, "numbers are decimal: for a product write 0*" +
                               std::string(1, static_cast<char>(peek())));
    if (peek() == '.' && !isLetter(peek(1))) {
        word += '.';
        ++position;
        digits();
        if (peek() == '.') return expected("an operator");
    }
    const std::size_t sign = peek(1) == '-' || peek(1) == '+' ? 2 : 1;
    if ((peek() == 'e' || peek() == 'E') && isDigit(peek(sign))) {
        for (std::size_t k = 0; k < sign; ++k) word += static_cast<char>(peek()), ++position;
        digits();
    }
    if (word.size() > kNumberCharacters)
        return fail(start,
                    "a number has at most " + std::to_string(kNumberCharacters) + " characters");
    value = std::strtod(word.c_str(), nullptr);
    if (!(value <= kFormulaLargest)) return fail(start, "the number is too large: at most 1e100");
    return true;
}

void Scanner::skipBlanksBeforePower() {
    std::size_t next = position;
    while (next < text_.size() && isBlank(text_[next])) ++next;
    if (next < text_.size() && text_[next] == '^') position = next;
}

}  // namespace formulas

std::string withCaret(std::string_view text, const FormulaFault& fault) {
    std::string shown, line;
    std::size_t position = 0;
    for (char32_t c : formulas::charactersOf(text)) {
        shown += formulas::isBlank(c) || c < 0x20 ? " " : formulas::utf8(c);
        if (position++ < fault.position) line += ' ';
    }
    return fault.message + "\n    " + shown + "\n    " + line + "^";
}

bool looksLikeFormula(std::string_view text) {
    if (text.find_first_of("^*/+()=<>,; '") != std::string_view::npos ||
        std::any_of(text.begin(), text.end(), [](char c) { return c & 0x80; }))
        return true;
    // Minus signs stand in names of maps as well, but not beside a single letter. No name begins
    // with a digit.
    if (!text.empty() && (text[0] == '.' || formulas::isDigit(static_cast<unsigned char>(text[0]))))
        return true;
    for (std::size_t start = 0; text.size() > 1 && start <= text.size();) {
        const std::size_t end = std::min(text.find('-', start), text.size());
        if (end - start == 1) return true;
        start = end + 1;
    }
    return static_cast<bool>(parseFormula(text));
}

}  // namespace versorium
