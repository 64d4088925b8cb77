// SPDX-License-Identifier: MIT
#pragma once
// The grammar of expressions (trace/formula.h), read by recursive descent.

#include <string>
#include <vector>

#include "trace/formula_scanner.h"
#include "trace/formula_terms.h"

namespace versorium::formulas {

class ExpressionParser {
  public:
    // New names are added to `names`. Both are kept by whoever made them.
    ExpressionParser(Scanner& in, std::vector<std::string>& names) : in_(in), names_(names) {}

    // The expression that comes next. False with the scanner's fault.
    bool parse(Expression& into) {
        expression_ = &into;
        return parseAny();
    }

  private:
    // Loosest operators first.
    bool parseAny();
    bool parseOr();
    bool parseAnd();
    bool parseNot();
    bool parseComparison();
    bool parseSum();
    bool parseProduct();
    bool parseSign();
    bool parsePower();
    bool parseExponent();
    bool parsePostfix();
    bool parseAtom();
    bool parseNamed(const std::string& name, std::size_t position);

    std::optional<TermKind> takeComparison();
    void addName(const std::string& name, std::size_t position);
    int add(TermKind kind, std::size_t position, int a = -1, int b = -1, int c = -1);
    int last() const { return static_cast<int>(expression_->terms.size()) - 1; }
    bool tooDeep();
    bool touchesNext() const;

    Scanner& in_;
    std::vector<std::string>& names_;
    Expression* expression_ = nullptr;
    bool bareNumber_ = false;  // a number was read, and nothing after it
    int depth_ = 0;
};

}  // namespace versorium::formulas
