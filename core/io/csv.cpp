// SPDX-License-Identifier: MIT
#include "io/csv.h"

#include <algorithm>

#include "base/text.h"
#include "io/text_scanner.h"

namespace versorium {
namespace {

Status faultAt(std::size_t line, const std::string& what) {
    return Status::data("line " + std::to_string(line) + ": " + what);
}

const char* nameOf(char delimiter) {
    return delimiter == ',' ? "commas" : delimiter == ';' ? "semicolons" : "tabs";
}

}  // namespace

Expected<CsvReader> CsvReader::open(std::string_view text) {
    if (Status status = checkText(text); !status.ok()) return status;
    CsvReader reader(withoutMark(text));
    if (Status status = reader.chooseDelimiter(); !status.ok()) return status;
    const Expected<bool> found = reader.readRow(reader.header_);
    if (!found) return found.status();
    if (!*found) return Status::data("the table is empty: it has no head line");
    reader.headerLine_ = reader.line_;
    return reader;
}

// By the first line that is not blank, which is left where it stands.
Status CsvReader::chooseDelimiter() {
    while (at_ < text_.size() && (atLineEnd() || text_[at_] == ' ')) {
        if (atLineEnd())
            takeLineEnd();
        else
            ++at_;
    }
    const std::string_view rest = text_.substr(at_);
    if (beginsWithWord(rest, "sep=") && rest.size() > 4) {
        const std::size_t stop = rest.find_first_of("\r\n");
        if (std::min(stop, rest.size()) == 5 &&
            (rest[4] == ',' || rest[4] == ';' || rest[4] == '\t')) {
            delimiter_ = rest[4];
            at_ += 5;
            takeLineEnd();
            return {};
        }
    }
    bool found[3] = {}, quoted = false;
    for (const char c : rest) {
        if (!quoted && (c == '\r' || c == '\n')) break;
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        for (std::size_t k = 0; k < 3; ++k) found[k] = found[k] || c == ",;\t"[k];
    }
    const int kinds =
        static_cast<int>(found[0]) + static_cast<int>(found[1]) + static_cast<int>(found[2]);
    if (kinds > 1)
        return faultAt(row_,
                       "the head line has more than one of comma, semicolon and tab; cells "
                       "are separated by one of them, and quotes keep the others");
    delimiter_ = found[1] ? ';' : found[2] ? '\t' : ',';
    return {};
}

bool CsvReader::atLineEnd() const {
    return at_ < text_.size() && (text_[at_] == '\r' || text_[at_] == '\n');
}

void CsvReader::takeLineEnd() {
    if (at_ >= text_.size()) return;
    at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
    ++row_;
}

Status CsvReader::readQuoted(std::string& cell) {
    const std::size_t start = row_;
    for (++at_; at_ < text_.size();) {
        if (text_[at_] == '"') {
            ++at_;
            if (at_ >= text_.size() || text_[at_] != '"') return {};
            cell += '"';
            ++at_;
        } else if (atLineEnd()) {
            cell += '\n';
            takeLineEnd();
        } else {
            cell += text_[at_++];
        }
    }
    return faultAt(start, "a quoted cell has no end");
}

Status CsvReader::readCell(std::string& cell) {
    const auto skipBlanks = [&] {
        while (at_ < text_.size() && text_[at_] != delimiter_ &&
               (text_[at_] == ' ' || text_[at_] == '\t'))
            ++at_;
    };
    skipBlanks();
    if (at_ < text_.size() && text_[at_] == '"') {
        if (Status status = readQuoted(cell); !status.ok()) return status;
        skipBlanks();
        if (at_ < text_.size() && text_[at_] != delimiter_ && !atLineEnd())
            return faultAt(row_, "after a quoted cell " + shownWord(text_.substr(at_, 1)) +
                                     " stands where the next cell or line should begin");
        return {};
    }
    while (at_ < text_.size() && text_[at_] != delimiter_ && !atLineEnd()) {
        if (text_[at_] == '"')
            return faultAt(row_, "a quote stands within a cell; quote the whole cell");
        cell += text_[at_++];
    }
    cell = trimmed(cell);
    return {};
}

Expected<bool> CsvReader::readRow(std::vector<std::string>& cells) {
    while (at_ < text_.size()) {
        cells.clear();
        line_ = row_;
        bool quoted = false;
        while (true) {
            cells.emplace_back();
            quoted = quoted || (at_ < text_.size() && text_[at_] == '"');
            if (Status status = readCell(cells.back()); !status.ok()) return status;
            if (at_ >= text_.size() || text_[at_] != delimiter_) break;
            ++at_;
        }
        takeLineEnd();
        const bool empty = std::all_of(cells.begin(), cells.end(),
                                       [](const std::string& cell) { return cell.empty(); });
        if (!empty || quoted) return true;
    }
    return false;
}

Expected<bool> CsvReader::next() {
    const Expected<bool> found = readRow(cells_);
    if (!found || !*found) return found;
    if (cells_.size() == header_.size()) return true;
    std::string what = std::to_string(cells_.size()) + (cells_.size() == 1 ? " cell" : " cells") +
                       " separated by " + nameOf(delimiter_) + ", but the head line has " +
                       std::to_string(header_.size());
    if (delimiter_ == ',' && cells_.size() == 2 * header_.size())
        what += "; numbers with a decimal comma need semicolons or tabs between the cells";
    return faultAt(line_, what);
}

Expected<double> CsvReader::number(std::string_view cell) const {
    std::string word(cell);
    if (delimiter_ != ',' && std::count(word.begin(), word.end(), ',') == 1 &&
        word.find('.') == std::string::npos)
        std::replace(word.begin(), word.end(), ',', '.');
    if (const std::optional<double> value = parseDecimal(word)) return *value;
    return Status::data(numberFault(cell));
}

}  // namespace versorium
