// SPDX-License-Identifier: MIT
// The text form of shapes: word(number, …, shape, …), read by recursive descent.
#include <cmath>
#include <cstdlib>

#include "base/json.h"
#include "shape/shape_words.h"
#include "shape/tree.h"

namespace versorium {
namespace {

constexpr std::size_t kTextSize = 1 << 20;

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

class Parser {
  public:
    explicit Parser(std::string_view text) : text_(text) {}

    Expected<ShapeTree> parse() {
        Expected<ShapeTree> shape = parseTree(1);
        if (!shape) return shape;
        skipBlanks();
        if (position_ < text_.size()) return expected("the end");
        return shape;
    }

  private:
    void skipBlanks() {
        while (position_ < text_.size() && isBlank(text_[position_])) ++position_;
    }
    char peek() {
        skipBlanks();
        return position_ < text_.size() ? text_[position_] : '\0';
    }
    bool take(char c) {
        if (peek() != c) return false;
        ++position_;
        return true;
    }

    Status faultAt(std::size_t position, const std::string& what) const {
        return Status::data("shape, character " + std::to_string(position + 1) + ": " + what);
    }
    Status expected(const std::string& what) const {
        std::string found = "the text ends";
        if (position_ < text_.size()) {
            const char c = text_[position_];
            found = c > ' ' && c <= '~' ? std::string("found '") + c + "'"
                                        : std::string("found another character");
        }
        return faultAt(position_, what + " is expected, " + found);
    }

    // Sign, digits with one point, exponent.
    Expected<double> parseNumber() {
        const std::size_t start = position_;
        const auto digits = [&] {
            const std::size_t from = position_;
            while (position_ < text_.size() && isDigit(text_[position_])) ++position_;
            return position_ - from;
        };
        const auto takeOne = [&](std::string_view set) {
            const bool found =
                position_ < text_.size() && set.find(text_[position_]) != std::string_view::npos;
            if (found) ++position_;
            return found;
        };
        takeOne("+-");
        std::size_t mantissa = digits();
        if (takeOne(".")) mantissa += digits();
        if (mantissa == 0) return expected("a number");
        if (takeOne("eE")) {
            takeOne("+-");
            if (digits() == 0) return expected("the number's exponent");
        }
        const std::string word(text_.substr(start, position_ - start));
        return std::strtod(word.c_str(), nullptr);
    }

    const ShapeWord* parseWord() {
        skipBlanks();
        const std::size_t start = position_;
        while (position_ < text_.size() && isLetter(text_[position_])) ++position_;
        const std::string_view name = text_.substr(start, position_ - start);
        for (const ShapeWord& word : kShapeWords)
            if (name == word.name) return &word;
        position_ = start;
        return nullptr;
    }

    // One argument: a number where the word takes numbers and none of its shapes came yet.
    Status parseArgument(const ShapeWord& word, int depth, std::vector<double>& numbers,
                         std::vector<ShapeTree>& children) {
        const bool letter = isLetter(peek());
        if (!letter) {
            const bool wanted =
                children.empty() && static_cast<int>(numbers.size()) < word.mostNumbers;
            if (!wanted)
                return expected(word.mostChildren != 0 ? "a shape" : "')' after " + usage(word));
            const Expected<double> number = parseNumber();
            if (!number) return number.status();
            numbers.push_back(*number);
            return {};
        }
        if (static_cast<int>(numbers.size()) < word.leastNumbers)
            return expected("a number of " + usage(word));
        if (word.mostChildren >= 0 && static_cast<int>(children.size()) >= word.mostChildren)
            return expected("')' after " + usage(word));
        Expected<ShapeTree> child = parseTree(depth + 1);
        if (!child) return child.status();
        children.push_back(std::move(*child));
        return {};
    }

    Expected<ShapeTree> parseTree(int depth) {
        skipBlanks();
        const std::size_t start = position_;
        if (depth > kShapeDepth)
            return faultAt(start,
                           "shapes are nested more than " + std::to_string(kShapeDepth) + " deep");
        if (++nodes_ > kShapeNodes)
            return faultAt(start,
                           "the shape has more than " + std::to_string(kShapeNodes) + " parts");
        const ShapeWord* word = parseWord();
        if (word == nullptr) return expected("a shape such as disc(0.4) or union(…)");
        if (!take('(')) return expected("'(' as in " + usage(*word));
        std::vector<double> numbers;
        std::vector<ShapeTree> children;
        do {
            if (Status status = parseArgument(*word, depth, numbers, children); !status.ok())
                return status;
        } while (take(','));
        if (!take(')')) return expected("',' or ')' as in " + usage(*word));
        Expected<ShapeTree> tree =
            ShapeTree::make(word->kind, std::move(numbers), std::move(children));
        if (!tree) return faultAt(start, tree.status().message());
        return tree;
    }

    static std::string usage(const ShapeWord& word) { return word.usage; }

    std::string_view text_;
    std::size_t position_ = 0;
    int nodes_ = 0;
};

}  // namespace

Expected<ShapeTree> parseShape(std::string_view text) {
    if (text.size() > kTextSize)
        return Status::data("the text of the shape has " + std::to_string(text.size()) +
                            " characters; at most " + std::to_string(kTextSize) + " are read");
    return Parser(text).parse();
}

}  // namespace versorium
