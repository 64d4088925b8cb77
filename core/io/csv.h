// SPDX-License-Identifier: MIT
#pragma once
// Tables as text (RFC 4180 and its relatives). Cells are separated by commas, semicolons or tabs:
// the head line decides, or a first line "sep=;" as some programs write it. A cell may stand in
// double quotes; within them two are one, and separators and line ends are part of it. A byte order
// mark is dropped; a line ends with CR, LF or both. Lines
// whose cells are all empty are passed over.

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace versorium {

class CsvReader {
  public:
    // Reads the head line. Fails with ErrorKind::data where there is none, where it has commas
    // beside semicolons or tabs, so that nobody can say what separates, and on what is no text.
    // The text must live as long as the reader.
    static Expected<CsvReader> open(std::string_view text);

    // As written, without blanks around; a cell may be empty.
    const std::vector<std::string>& header() const { return header_; }
    std::size_t headerLine() const { return headerLine_; }
    char delimiter() const { return delimiter_; }

    // Goes to the next row; false at the end. A row has as many cells as the head line, or it is
    // refused with its line.
    Expected<bool> next();
    // Of the current row, as written, without blanks around cells that are not quoted.
    const std::vector<std::string>& cells() const { return cells_; }
    // Where the current row begins, counted from 1.
    std::size_t line() const { return line_; }

    // A finite number. Where no comma separates cells, one may be the decimal point: 0,5. The
    // message has no line.
    Expected<double> number(std::string_view cell) const;

  private:
    explicit CsvReader(std::string_view text) : text_(text) {}
    // The cells of the next line that has any; false at the end.
    Expected<bool> readRow(std::vector<std::string>& cells);
    Status readCell(std::string& cell);
    Status readQuoted(std::string& cell);
    Status chooseDelimiter();
    bool atLineEnd() const;
    void takeLineEnd();

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t row_ = 1;  // the line of `at_`
    char delimiter_ = ',';
    std::vector<std::string> header_, cells_;
    std::size_t headerLine_ = 0, line_ = 0;
};

}  // namespace versorium
