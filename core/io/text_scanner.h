// SPDX-License-Identifier: MIT
#pragma once
// Takes words and numbers from text line by line: the one reader of the text forms of meshes,
// tables, palettes and other programs' files. A byte order mark is dropped. A line ends with a line
// feed, a carriage return, or both. Only decimal numbers are taken: the C library would also
// accept hexadecimal ones and names.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/status.h"

namespace versorium {

// The whole word as a decimal number; nothing when it is none. Infinity by overflow is nothing too.
std::optional<double> parseDecimal(std::string_view word);
// The same, and what programs print for a value that is none: nan, inf, -nan(ind), 1.#INF, 1e999.
std::optional<double> parseReal(std::string_view word);
// The whole word as a decimal integer that fits 63 bits.
std::optional<std::int64_t> parseInteger(std::string_view word);

inline std::string_view textOf(std::span<const unsigned char> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
// Without the byte order mark of UTF-8.
std::string_view withoutMark(std::string_view text);
// The same with a line feed at the end of every line, whatever it was.
std::string withLineFeeds(std::string_view text);
// Refuses what cannot be text of bytes: UTF-16 and UTF-32 by their byte order marks, and zeros.
Status checkText(std::string_view text);
// ASCII letters made small; others stay.
std::string lowered(std::string_view text);
// Whether the text begins with these letters, whatever their case; `start` is in small ones.
bool beginsWithWord(std::string_view text, std::string_view start);
// A word for a message: short, and without control characters.
std::string shownWord(std::string_view word);
// Why a word is no finite number, as the end of a message: a decimal comma is named as such.
std::string numberFault(std::string_view word);

struct TextOptions {
    // A line that ends in a backslash goes on in the next one. A line that begins with # does not.
    bool continued = false;
};

class TextScanner {
  public:
    explicit TextScanner(std::string_view text, TextOptions options = {});

    // Goes to the next line; false at the end of the text. The first call goes to the first line.
    bool nextLine();
    // The next word of the current line, empty at its end. Blanks and tabs separate.
    std::string_view word();
    // The next word of the text, whatever its line.
    std::string_view wordAcrossLines();
    // What is left of the current line, without blanks around it.
    std::string_view rest() const;
    // Leaves the rest of the current line.
    void skipRest() { line_ = {}; }
    // The current line, counted from 1; of a continued one, its first part.
    std::size_t lineNumber() const { return number_; }
    // How the current line ends: "\n", "\r", "\r\n", or nothing at the end of the text.
    std::string_view lineEnd() const { return lineEnd_; }
    // Where the text after the current line begins.
    std::size_t offset() const { return next_; }
    // Characters that are not taken yet, those of the current line included.
    std::size_t remaining() const { return text_.size() - next_ + line_.size(); }

  private:
    // Where the line that begins at `start` stops; sets how it ends.
    std::size_t lineStop(std::size_t start);

    std::string_view text_;
    TextOptions options_;
    std::string_view line_;
    std::string_view lineEnd_;
    std::size_t next_ = 0;
    std::size_t number_ = 0;
    std::size_t extra_ = 0;  // lines that the current one was continued by
};

}  // namespace versorium
