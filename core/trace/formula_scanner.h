// SPDX-License-Identifier: MIT
#pragma once
// The characters of a formula, taken one after another, and what was wrong with them.

#include <string>
#include <string_view>
#include <vector>

#include "trace/formula.h"

namespace versorium::formulas {

inline bool isBlank(char32_t c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == 0xa0;
}
inline bool isDigit(char32_t c) { return c >= '0' && c <= '9'; }
inline bool isLetter(char32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
inline bool isPrime(char32_t c) { return c == '\'' || c == 0x2032 || c == 0x2019; }
// The digit that is written high; -1 for other characters.
inline int superscript(char32_t c) {
    return c == 0xb2 ? 2 : c == 0xb3 ? 3 : c >= 0x2074 && c <= 0x2079 ? int(c) - 0x2070 : -1;
}

class Scanner {
  public:
    explicit Scanner(std::string_view text);

    std::size_t position = 0;  // of the next character
    FormulaFault fault;

    std::size_t size() const { return text_.size(); }
    char32_t peek(std::size_t ahead = 0) const {
        return position + ahead < text_.size() ? text_[position + ahead] : U'\0';
    }
    void skipBlanks() {
        while (position < text_.size() && isBlank(text_[position])) ++position;
    }
    // Only if a power follows: a blank after a bare number ends it, "2 z" is no product.
    void skipBlanksBeforePower();
    bool atEnd() {
        skipBlanks();
        return position >= text_.size();
    }

    // True, and behind it, where it comes next.
    bool take(char32_t c) {
        if (atEnd() || text_[position] != c) return false;
        ++position;
        return true;
    }
    bool takeWord(std::string_view word);
    // The name that comes next, which is not taken; empty where none does.
    std::string peekName();
    // A number that begins here. False with a fault.
    bool takeNumber(double& value);

    // Whether a comma comes next that stands between digits, as in 0,3.
    bool atDecimalComma() const {
        return position > 0 && peek() == ',' && isDigit(text_[position - 1]) && isDigit(peek(1));
    }
    bool refuseDecimalComma() {
        return fail(position,
                    "decimals are written with a point, as in 0.3; a comma that parts "
                    "two formulas or numbers has a blank behind it");
    }

    // Both are false, for whoever gives up.
    bool fail(std::size_t where, std::string message);
    bool expected(const std::string& what);  // "… is expected, not …"

  private:
    std::vector<char32_t> text_;
};

}  // namespace versorium::formulas
