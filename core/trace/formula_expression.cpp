// SPDX-License-Identifier: MIT
#include "trace/formula_expression.h"

#include <algorithm>

#include "trace/index.h"

namespace versorium::formulas {

const std::vector<FunctionInfo> kFunctions = {
    {"exp", Function::exp, 1},     {"log", Function::log, 1},     {"ln", Function::log, 1},
    {"sqrt", Function::sqrt, 1},   {"sin", Function::sin, 1},     {"cos", Function::cos, 1},
    {"tan", Function::tan, 1},     {"sinh", Function::sinh, 1},   {"cosh", Function::cosh, 1},
    {"tanh", Function::tanh, 1},   {"asin", Function::asin, 1},   {"acos", Function::acos, 1},
    {"atan", Function::atan, 1},   {"asinh", Function::asinh, 1}, {"acosh", Function::acosh, 1},
    {"atanh", Function::atanh, 1}, {"abs", Function::abs, 1},     {"norm", Function::norm, 1},
    {"arg", Function::arg, 1},     {"re", Function::re, 1},       {"im", Function::im, 1},
    {"conj", Function::conj, 1},   {"floor", Function::floor, 1}, {"min", Function::min, 2},
    {"max", Function::max, 2},     {"atan2", Function::atan2, 2}, {"if", Function::choose, 3},
    {"shape", Function::shape, 1},
};

namespace {

constexpr std::size_t kNameCharacters = 24;

class Deeper {
  public:
    explicit Deeper(int& depth) : depth_(++depth) {}
    ~Deeper() { --depth_; }

  private:
    int& depth_;
};

}  // namespace

int ExpressionParser::add(TermKind kind, std::size_t position, int a, int b, int c) {
    Term term;
    term.kind = kind;
    term.a = a, term.b = b, term.c = c;
    term.position = position;
    expression_->terms.push_back(term);
    return static_cast<int>(expression_->terms.size()) - 1;
}

bool ExpressionParser::tooDeep() {
    if (depth_ <= kFormulaDepth) return false;
    in_.fail(in_.position, "brackets, signs and exponents stand in each other more than " +
                               std::to_string(kFormulaDepth) + " deep");
    return true;
}

// condition ? a : b
bool ExpressionParser::parseAny() {
    const Deeper deeper(depth_);
    if (tooDeep() || !parseOr()) return false;
    in_.skipBlanks();
    const std::size_t position = in_.position;
    if (!in_.take('?')) return true;
    const int condition = last();
    if (!parseAny()) return false;
    const int yes = last();
    if (!in_.take(':')) return in_.expected("\":\" of a ? b : c");
    if (!parseAny()) return false;
    const int no = last();
    const int choice = add(TermKind::call, position, condition, yes, no);
    expression_->terms[at(choice)].index = static_cast<int>(Function::choose);
    return true;
}

bool ExpressionParser::parseOr() {
    if (!parseAnd()) return false;
    while (true) {
        in_.skipBlanks();
        const std::size_t position = in_.position;
        if (!in_.takeWord("||") && !in_.takeWord("or")) return true;
        const int left = last();
        if (!parseAnd()) return false;
        add(TermKind::disjunction, position, left, last());
    }
}

bool ExpressionParser::parseAnd() {
    if (!parseNot()) return false;
    while (true) {
        in_.skipBlanks();
        const std::size_t position = in_.position;
        if (!in_.takeWord("&&") && !in_.takeWord("and")) return true;
        const int left = last();
        if (!parseNot()) return false;
        add(TermKind::conjunction, position, left, last());
    }
}

bool ExpressionParser::parseNot() {
    in_.skipBlanks();
    const std::size_t position = in_.position;
    if (in_.takeWord("not") || (in_.peek() == '!' && in_.peek(1) != '=' && in_.take('!'))) {
        const Deeper deeper(depth_);
        if (tooDeep() || !parseNot()) return false;
        add(TermKind::negation, position, last());
        return true;
    }
    return parseComparison();
}

std::optional<TermKind> ExpressionParser::takeComparison() {
    if (in_.takeWord("<=") || in_.take(0x2264)) return TermKind::lessEqual;
    if (in_.takeWord(">=") || in_.take(0x2265)) return TermKind::greaterEqual;
    if (in_.takeWord("==")) return TermKind::equal;
    if (in_.takeWord("!=") || in_.take(0x2260)) return TermKind::notEqual;
    if (in_.take('<')) return TermKind::less;
    if (in_.take('>')) return TermKind::greater;
    return std::nullopt;
}

bool ExpressionParser::parseComparison() {
    if (!parseSum()) return false;
    in_.skipBlanks();
    const std::size_t position = in_.position;
    const std::optional<TermKind> kind = takeComparison();
    if (!kind) return true;
    const int left = last();
    if (!parseSum()) return false;
    add(*kind, position, left, last());
    in_.skipBlanks();
    const std::size_t again = in_.position;
    if (takeComparison()) return in_.fail(again, "comparisons do not chain: write a < b and b < c");
    return true;
}

bool ExpressionParser::parseSum() {
    if (!parseProduct()) return false;
    while (true) {
        in_.skipBlanks();
        const std::size_t position = in_.position;
        const bool plus = in_.take('+');
        if (!plus && !(in_.peek() == '-' && in_.peek(1) != '>' && in_.take('-')) &&
            !in_.take(0x2212))
            return true;
        const int left = last();
        if (!parseProduct()) return false;
        add(plus ? TermKind::add : TermKind::subtract, position, left, last());
    }
}

// A number that stands directly before a name or a bracket.
bool ExpressionParser::touchesNext() const {
    return bareNumber_ && (isLetter(in_.peek()) || in_.peek() == '(' || in_.peek() == 0x3c0);
}

bool ExpressionParser::parseProduct() {
    if (!parseSign()) return false;
    while (true) {
        if (touchesNext()) {
            const std::size_t position = in_.position;
            const int left = last();
            if (!parseSign()) return false;
            add(TermKind::multiply, position, left, last());
            continue;
        }
        in_.skipBlanks();
        const std::size_t position = in_.position;
        const bool times = in_.take('*') || in_.take(0xb7) || in_.take(0xd7) || in_.take(0x22c5);
        if (!times && !in_.take('/')) return true;
        if (times && in_.peek() == '*')
            return in_.fail(position, "powers are written with ^, as in z^2");
        const int left = last();
        if (!parseSign()) return false;
        if (!times && touchesNext())
            return in_.fail(in_.position, "1/2z could mean two things: write 1/(2*z) or 1/2*z");
        add(times ? TermKind::multiply : TermKind::divide, position, left, last());
    }
}

bool ExpressionParser::parseSign() {
    in_.skipBlanks();
    const std::size_t position = in_.position;
    const bool plus = in_.take('+');
    if (plus || in_.take('-') || in_.take(0x2212)) {
        const Deeper deeper(depth_);
        if (tooDeep() || !parseSign()) return false;
        if (plus) return true;
        add(TermKind::negate, position, last());
        // -2z is (-2) z: the same, and the number is still bare.
        return true;
    }
    return parsePower();
}

bool ExpressionParser::parsePower() {
    if (!parsePostfix()) return false;
    in_.skipBlanksBeforePower();
    const std::size_t position = in_.position;
    const int base = last();
    if (const int digit = superscript(in_.peek()); digit >= 0) {
        ++in_.position;
        bareNumber_ = false;
        add(TermKind::number, position);
        expression_->terms.back().number = digit;
        add(TermKind::power, position, base, last());
        return true;
    }
    if (in_.peek() != '^') return true;
    ++in_.position;
    if (!parseExponent()) return false;
    if (touchesNext())
        return in_.fail(in_.position, "z^2c could mean two things: write z^2*c or z^(2*c)");
    bareNumber_ = false;
    add(TermKind::power, position, base, last());
    return true;
}

bool ExpressionParser::parseExponent() {
    const Deeper deeper(depth_);
    if (tooDeep()) return false;
    in_.skipBlanks();
    const std::size_t position = in_.position;
    if (in_.take('+')) return parseExponent();
    if (in_.take('-') || in_.take(0x2212)) {
        if (!parseExponent()) return false;
        add(TermKind::negate, position, last());
        return true;
    }
    return parsePower();
}

bool ExpressionParser::parsePostfix() {
    if (!parseAtom()) return false;
    while (in_.peek() == '.' && !bareNumber_) {
        const std::size_t position = in_.position;
        ++in_.position;
        const std::string word = in_.peekName();
        constexpr std::pair<std::string_view, int> kComponents[] = {{"re", 0}, {"im", 1}, {"w", 0},
                                                                    {"x", 1},  {"y", 2},  {"z", 3}};
        const auto* found =
            std::find_if(std::begin(kComponents), std::end(kComponents),
                         [&](const auto& component) { return component.first == word; });
        if (found == std::end(kComponents))
            return in_.expected("a component, .re, .im, .w, .x, .y or .z,");
        in_.position += word.size();
        const int whole = last();
        add(TermKind::component, position, whole);
        expression_->terms.back().index = found->second;
    }
    return true;
}

bool ExpressionParser::parseAtom() {
    in_.skipBlanks();
    bareNumber_ = false;
    const std::size_t position = in_.position;
    if (isDigit(in_.peek()) || (in_.peek() == '.' && isDigit(in_.peek(1)))) {
        double value = 0;
        if (!in_.takeNumber(value)) return false;
        add(TermKind::number, position);
        expression_->terms.back().number = value;
        bareNumber_ = true;
        return true;
    }
    if (in_.take('(')) {
        if (!parseAny()) return false;
        bareNumber_ = false;
        if (!in_.take(')')) return in_.expected("an operator or \")\"");
        return true;
    }
    if (in_.take('|')) return in_.fail(position, "write abs(z) for the modulus, and || for \"or\"");
    if (in_.take(0x3c0)) {
        addName("pi", position);
        return true;
    }
    const std::string name = in_.peekName();
    if (name.empty()) return in_.expected("a number, a name or \"(\"");
    if (name.size() > kNameCharacters)
        return in_.fail(position,
                        "a name has at most " + std::to_string(kNameCharacters) + " characters");
    in_.position += name.size();
    // The value before, as books write it: z_n.
    if (name.size() >= 2 && name[1] == '_' &&
        std::string_view("zqxy").find(name[0]) != std::string_view::npos) {
        const bool braces = name.size() == 2 && in_.peek() == '{';
        if (braces && !in_.takeWord("{n}"))
            return in_.fail(position, "a formula knows the value before, z_n, and none but this");
        if (braces || name.substr(1) == "_n") {
            addName(name.substr(0, 1), position);
            return true;
        }
    }
    return parseNamed(name, position);
}

bool ExpressionParser::parseNamed(const std::string& name, std::size_t position) {
    const auto function = std::find_if(kFunctions.begin(), kFunctions.end(),
                                       [&](const FunctionInfo& info) { return name == info.name; });
    const bool bracket = in_.peek() == '(';
    if (function == kFunctions.end()) {
        if (bracket && name.size() > 1) {
            std::string small = name;
            for (char& c : small)
                if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
            for (const FunctionInfo& info : kFunctions)
                if (small == info.name)
                    return in_.fail(
                        position,
                        "functions are written in small letters: did you mean " + small + "(…)?");
            std::string all;
            for (const FunctionInfo& info : kFunctions)
                all += (all.empty() ? "" : ", ") + std::string(info.name);
            return in_.fail(position, "there is no function \"" + name + "\"; there are " + all +
                                          "; for a product write " + name + "*(…)");
        }
        if (bracket) return in_.fail(in_.position, "for a product write " + name + "*(…)");
        if (name == "and" || name == "or" || name == "not" || name == "in")
            return in_.fail(position,
                            "a number, a name or \"(\" is expected, not \"" + name + "\"");
        addName(name, position);
        return true;
    }
    if (!in_.take('(')) return in_.expected("\"(\" after " + name);
    int arguments[3] = {-1, -1, -1};
    for (int k = 0; k < function->arguments; ++k) {
        if (k > 0 && !in_.take(','))
            return in_.expected("\",\" and " +
                                std::string(function->arguments - k > 1 ? "two more arguments"
                                                                        : "one more argument") +
                                " of " + name);
        if (!parseAny()) return false;
        arguments[k] = last();
    }
    bareNumber_ = false;
    if (!in_.take(')')) return in_.expected("an operator or \")\"");
    add(TermKind::call, position, arguments[0], arguments[1], arguments[2]);
    expression_->terms.back().index = static_cast<int>(function->function);
    return true;
}

void ExpressionParser::addName(const std::string& name, std::size_t position) {
    auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) {
        names_.push_back(name);
        found = names_.end() - 1;
    }
    add(TermKind::name, position);
    expression_->terms.back().index = static_cast<int>(found - names_.begin());
}

}  // namespace versorium::formulas
