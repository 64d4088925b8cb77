// SPDX-License-Identifier: MIT
#pragma once
// Takes words and numbers from text line by line, as the ASCII forms of mesh files need it. Only
// decimal numbers are taken: the C library would also accept hexadecimal ones and names.

#include <cstdint>
#include <optional>
#include <string_view>

namespace versorium {

// The whole word as a decimal number; nothing when it is none. Infinity by overflow is nothing too.
std::optional<double> parseDecimal(std::string_view word);
// The whole word as a decimal integer that fits 63 bits.
std::optional<std::int64_t> parseInteger(std::string_view word);

class TextScanner {
  public:
    explicit TextScanner(std::string_view text) : text_(text) {}

    // Goes to the next line; false at the end of the text. The first call goes to the first line.
    bool nextLine();
    // The next word of the current line, empty at its end. Blanks, tabs and returns separate.
    std::string_view word();
    // The next word of the text, whatever its line.
    std::string_view wordAcrossLines();
    // The current line, counted from 1.
    std::size_t lineNumber() const { return number_; }
    // Where the text after the current line begins.
    std::size_t offset() const { return next_; }
    // Characters that are not taken yet, those of the current line included.
    std::size_t remaining() const { return text_.size() - next_ + line_.size(); }

  private:
    std::string_view text_;
    std::string_view line_;
    std::size_t next_ = 0;
    std::size_t number_ = 0;
};

}  // namespace versorium
