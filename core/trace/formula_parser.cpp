// SPDX-License-Identifier: MIT
// The text of formulas, read by recursive descent.
#include <algorithm>
#include <cstdlib>

#include "trace/formula_terms.h"
#include "trace/index.h"

namespace versorium {
namespace formulas {

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
constexpr std::size_t kNumberCharacters = 40;

bool isBlank(char32_t c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == 0xa0; }
bool isDigit(char32_t c) { return c >= '0' && c <= '9'; }
bool isLetter(char32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isPrime(char32_t c) { return c == '\'' || c == 0x2032 || c == 0x2019; }

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

class Parser {
  public:
    explicit Parser(std::string_view text) : text_(charactersOf(text)) {
        parsed.characters = text_.size();
    }

    FormulaFault fault;
    ParsedFormula parsed;

    bool parse() {
        if (text_.size() > kFormulaCharacters)
            return fail(kFormulaCharacters, "a formula has at most " +
                                                std::to_string(kFormulaCharacters) + " characters");
        do {
            if (!parseStatement()) return false;
            if (parsed.statements.size() > 2)
                return fail(parsed.statements.back().position,
                            "a map has one component, or the two of the plane");
        } while (take(','));
        while (take(';')) {
            if (atEnd()) break;
            do {
                if (!parseDeclaration()) return false;
            } while (take(','));
        }
        skipBlanks();
        return atEnd() || expected("an operator, \",\" or the formula's end");
    }

  private:
    char32_t peek(std::size_t ahead = 0) const {
        return position_ + ahead < text_.size() ? text_[position_ + ahead] : U'\0';
    }
    void skipBlanks() {
        while (position_ < text_.size() && isBlank(text_[position_])) ++position_;
    }
    bool atEnd() {
        skipBlanks();
        return position_ >= text_.size();
    }
    bool take(char32_t c) {
        skipBlanks();
        if (position_ >= text_.size() || text_[position_] != c) return false;
        ++position_;
        return true;
    }
    bool takeWord(std::string_view word) {
        skipBlanks();
        for (std::size_t k = 0; k < word.size(); ++k)
            if (peek(k) != static_cast<char32_t>(word[k])) return false;
        if (isLetter(static_cast<char32_t>(word.back())) &&
            (isLetter(peek(word.size())) || isDigit(peek(word.size())) || peek(word.size()) == '_'))
            return false;
        position_ += word.size();
        return true;
    }
    bool fail(std::size_t position, std::string message) {
        fault = {std::min(position, text_.size()), std::move(message)};
        return false;
    }
    bool expected(const std::string& what) {
        skipBlanks();
        const bool end = position_ >= text_.size();
        return fail(position_, what + " is expected, not " +
                                   (end ? "the end" : "\"" + utf8(text_[position_]) + "\""));
    }

    std::string peekName() {
        skipBlanks();
        std::string name;
        if (!isLetter(peek())) return name;
        for (std::size_t k = 0; isLetter(peek(k)) || isDigit(peek(k)) || peek(k) == '_'; ++k)
            name += static_cast<char>(peek(k));
        return name;
    }

    bool parseStatement() {
        Statement statement;
        skipBlanks();
        statement.position = position_;
        const std::string name = peekName();
        if (name.size() == 1 && std::string_view("zqxy").find(name[0]) != std::string_view::npos) {
            const std::size_t start = position_;
            ++position_;
            skipBlanks();
            const std::size_t after = position_;
            if (isPrime(peek())) {
                ++position_;
                if (!take('=')) return expected("\"=\" after " + name + "'");
                statement.head = name;
            } else if (takeWord("->") || take(0x2192) || take(0x21a6)) {
                statement.head = name;
            } else if (peek() == '=' && peek(1) != '=') {
                return fail(after, "write " + name + "' = … for the next value of " + name);
            } else {
                position_ = start;
            }
        }
        expression_ = &statement.expression;
        if (!parseAny()) return false;
        parsed.statements.push_back(std::move(statement));
        return true;
    }

    bool parseDeclaration() {
        Declaration declaration;
        declaration.name = peekName();
        declaration.position = position_;
        if (declaration.name.empty()) return expected("a parameter's name, as in c = -0.1 + 0.7i,");
        position_ += declaration.name.size();
        if (take(':')) {
            const std::string word = peekName();
            for (FormulaKind kind : {FormulaKind::real, FormulaKind::whole, FormulaKind::complex,
                                     FormulaKind::quaternion})
                if (word == kindName(kind)) declaration.kind = kind;
            if (!declaration.kind) return expected("real, whole, complex or quaternion");
            position_ += word.size();
        }
        if (take('=')) {
            declaration.value.emplace();
            expression_ = &*declaration.value;
            inDeclaration_ = true;
            if (!parseAny()) return false;
        }
        if (takeWord("in")) {
            declaration.ranged = true;
            if (!take('[')) return expected("\"[\", as in [-2, 2],");
            if (!parseEnd(declaration.low)) return false;
            if (!take(',')) return expected("\",\" between the ends of the range");
            if (!parseEnd(declaration.high)) return false;
            const std::size_t end = position_;
            if (!take(']')) return expected("\"]\"");
            if (!(declaration.low < declaration.high))
                return fail(end, "the lower end of the range comes first");
        }
        parsed.declarations.push_back(std::move(declaration));
        return true;
    }
    bool parseEnd(double& value) {
        const bool negative = take('-') || take(0x2212);
        skipBlanks();
        if (!isDigit(peek()) && peek() != '.') return expected("a number");
        if (!parseNumber(value)) return false;
        if (negative) value = -value;
        return true;
    }

    int add(TermKind kind, std::size_t position, int a = -1, int b = -1, int c = -1) {
        Term term;
        term.kind = kind;
        term.a = a, term.b = b, term.c = c;
        term.position = position;
        expression_->terms.push_back(term);
        return static_cast<int>(expression_->terms.size()) - 1;
    }
    int last() const { return static_cast<int>(expression_->terms.size()) - 1; }

    class Deeper {
      public:
        explicit Deeper(int& depth) : depth_(++depth) {}
        ~Deeper() { --depth_; }

      private:
        int& depth_;
    };
    bool tooDeep() {
        if (depth_ <= kFormulaDepth) return false;
        fail(position_, "brackets, signs and exponents stand in each other more than " +
                            std::to_string(kFormulaDepth) + " deep");
        return true;
    }

    // condition ? a : b
    bool parseAny() {
        const Deeper deeper(depth_);
        if (tooDeep() || !parseOr()) return false;
        skipBlanks();
        const std::size_t position = position_;
        if (!take('?')) return true;
        const int condition = last();
        if (!parseAny()) return false;
        const int yes = last();
        if (!take(':')) return expected("\":\" of a ? b : c");
        if (!parseAny()) return false;
        const int no = last();
        const int choice = add(TermKind::call, position, condition, yes, no);
        expression_->terms[at(choice)].index = static_cast<int>(Function::choose);
        return true;
    }
    bool parseOr() {
        if (!parseAnd()) return false;
        while (true) {
            skipBlanks();
            const std::size_t position = position_;
            if (!takeWord("||") && !takeWord("or")) return true;
            const int left = last();
            if (!parseAnd()) return false;
            add(TermKind::disjunction, position, left, last());
        }
    }
    bool parseAnd() {
        if (!parseNot()) return false;
        while (true) {
            skipBlanks();
            const std::size_t position = position_;
            if (!takeWord("&&") && !takeWord("and")) return true;
            const int left = last();
            if (!parseNot()) return false;
            add(TermKind::conjunction, position, left, last());
        }
    }
    bool parseNot() {
        skipBlanks();
        const std::size_t position = position_;
        if (takeWord("not") || (peek() == '!' && peek(1) != '=' && take('!'))) {
            const Deeper deeper(depth_);
            if (tooDeep() || !parseNot()) return false;
            add(TermKind::negation, position, last());
            return true;
        }
        return parseComparison();
    }
    std::optional<TermKind> takeComparison() {
        if (takeWord("<=") || take(0x2264)) return TermKind::lessEqual;
        if (takeWord(">=") || take(0x2265)) return TermKind::greaterEqual;
        if (takeWord("==")) return TermKind::equal;
        if (takeWord("!=") || take(0x2260)) return TermKind::notEqual;
        if (take('<')) return TermKind::less;
        if (take('>')) return TermKind::greater;
        return std::nullopt;
    }
    bool parseComparison() {
        if (!parseSum()) return false;
        skipBlanks();
        const std::size_t position = position_;
        const std::optional<TermKind> kind = takeComparison();
        if (!kind) return true;
        const int left = last();
        if (!parseSum()) return false;
        add(*kind, position, left, last());
        skipBlanks();
        const std::size_t again = position_;
        if (takeComparison()) return fail(again, "comparisons do not chain: write a < b and b < c");
        return true;
    }
    bool parseSum() {
        if (!parseProduct()) return false;
        while (true) {
            skipBlanks();
            const std::size_t position = position_;
            const bool plus = take('+');
            if (!plus && !(peek() == '-' && peek(1) != '>' && take('-')) && !take(0x2212))
                return true;
            const int left = last();
            if (!parseProduct()) return false;
            add(plus ? TermKind::add : TermKind::subtract, position, left, last());
        }
    }
    // A number that stands directly before a name or a bracket.
    bool touchesNext() const {
        return bareNumber_ && (isLetter(peek()) || peek() == '(' || peek() == 0x3c0);
    }
    bool parseProduct() {
        if (!parseSign()) return false;
        while (true) {
            if (touchesNext()) {
                const std::size_t position = position_;
                const int left = last();
                if (!parseSign()) return false;
                add(TermKind::multiply, position, left, last());
                continue;
            }
            skipBlanks();
            const std::size_t position = position_;
            const bool times = take('*') || take(0xb7) || take(0xd7) || take(0x22c5);
            if (!times && !take('/')) return true;
            if (times && peek() == '*')
                return fail(position, "powers are written with ^, as in z^2");
            const int left = last();
            if (!parseSign()) return false;
            if (!times && touchesNext())
                return fail(position_, "1/2z could mean two things: write 1/(2*z) or 1/2*z");
            add(times ? TermKind::multiply : TermKind::divide, position, left, last());
        }
    }
    bool parseSign() {
        skipBlanks();
        const std::size_t position = position_;
        const bool plus = take('+');
        if (plus || take('-') || take(0x2212)) {
            const Deeper deeper(depth_);
            if (tooDeep() || !parseSign()) return false;
            if (plus) return true;
            add(TermKind::negate, position, last());
            // -2z is (-2) z: the same, and the number is still bare.
            return true;
        }
        return parsePower();
    }
    bool parsePower() {
        if (!parsePostfix()) return false;
        skipBlanksBeforePower();
        const std::size_t position = position_;
        const int base = last();
        if (const int digit = superscript(peek()); digit >= 0) {
            ++position_;
            bareNumber_ = false;
            add(TermKind::number, position);
            expression_->terms.back().number = digit;
            add(TermKind::power, position, base, last());
            return true;
        }
        if (peek() != '^') return true;
        ++position_;
        if (!parseExponent()) return false;
        if (touchesNext())
            return fail(position_, "z^2c could mean two things: write z^2*c or z^(2*c)");
        bareNumber_ = false;
        add(TermKind::power, position, base, last());
        return true;
    }
    // Only if a power follows: a blank after a bare number ends it, "2 z" is no product.
    void skipBlanksBeforePower() {
        std::size_t next = position_;
        while (next < text_.size() && isBlank(text_[next])) ++next;
        if (next < text_.size() && text_[next] == '^') position_ = next;
    }
    static int superscript(char32_t c) {
        return c == 0xb2 ? 2 : c == 0xb3 ? 3 : c >= 0x2074 && c <= 0x2079 ? int(c) - 0x2070 : -1;
    }
    bool parseExponent() {
        const Deeper deeper(depth_);
        if (tooDeep()) return false;
        skipBlanks();
        const std::size_t position = position_;
        if (take('+')) return parseExponent();
        if (take('-') || take(0x2212)) {
            if (!parseExponent()) return false;
            add(TermKind::negate, position, last());
            return true;
        }
        return parsePower();
    }
    bool parsePostfix() {
        if (!parseAtom()) return false;
        while (peek() == '.' && !bareNumber_) {
            const std::size_t position = position_;
            ++position_;
            const std::string word = peekName();
            constexpr std::pair<std::string_view, int> kComponents[] = {
                {"re", 0}, {"im", 1}, {"w", 0}, {"x", 1}, {"y", 2}, {"z", 3}};
            const auto* found =
                std::find_if(std::begin(kComponents), std::end(kComponents),
                             [&](const auto& component) { return component.first == word; });
            if (found == std::end(kComponents))
                return expected("a component, .re, .im, .w, .x, .y or .z,");
            position_ += word.size();
            const int whole = last();
            add(TermKind::component, position, whole);
            expression_->terms.back().index = found->second;
        }
        return true;
    }
    bool parseAtom() {
        skipBlanks();
        bareNumber_ = false;
        const std::size_t position = position_;
        if (isDigit(peek()) || (peek() == '.' && isDigit(peek(1)))) {
            double value = 0;
            if (!parseNumber(value)) return false;
            add(TermKind::number, position);
            expression_->terms.back().number = value;
            bareNumber_ = true;
            return true;
        }
        if (take('(')) {
            if (!parseAny()) return false;
            bareNumber_ = false;
            if (!take(')')) return expected("an operator or \")\"");
            return true;
        }
        if (take('|')) return fail(position, "write abs(z) for the modulus, and || for \"or\"");
        if (take(0x3c0)) {
            addName("pi", position);
            return true;
        }
        const std::string name = peekName();
        if (name.empty()) return expected("a number, a name or \"(\"");
        if (name.size() > kNameCharacters)
            return fail(position,
                        "a name has at most " + std::to_string(kNameCharacters) + " characters");
        position_ += name.size();
        return parseNamed(name, position);
    }
    bool parseNamed(const std::string& name, std::size_t position) {
        const auto function =
            std::find_if(kFunctions.begin(), kFunctions.end(),
                         [&](const FunctionInfo& info) { return name == info.name; });
        const bool bracket = peek() == '(';
        if (function == kFunctions.end()) {
            if (bracket && name.size() > 1) {
                std::string all;
                for (const FunctionInfo& info : kFunctions)
                    all += (all.empty() ? "" : ", ") + std::string(info.name);
                return fail(position, "there is no function \"" + name + "\"; there are " + all +
                                          "; for a product write " + name + "*(…)");
            }
            if (bracket) return fail(position_, "for a product write " + name + "*(…)");
            if (name == "and" || name == "or" || name == "not" || name == "in")
                return fail(position,
                            "a number, a name or \"(\" is expected, not \"" + name + "\"");
            addName(name, position);
            return true;
        }
        if (!take('(')) return expected("\"(\" after " + name);
        int arguments[3] = {-1, -1, -1};
        for (int k = 0; k < function->arguments; ++k) {
            if (k > 0 && !take(','))
                return expected("\",\" and " +
                                std::string(function->arguments - k > 1 ? "two more arguments"
                                                                        : "one more argument") +
                                " of " + name);
            if (!parseAny()) return false;
            arguments[k] = last();
        }
        bareNumber_ = false;
        if (!take(')')) return expected("an operator or \")\"");
        add(TermKind::call, position, arguments[0], arguments[1], arguments[2]);
        expression_->terms.back().index = static_cast<int>(function->function);
        return true;
    }
    void addName(const std::string& name, std::size_t position) {
        auto found = std::find(parsed.names.begin(), parsed.names.end(), name);
        if (found == parsed.names.end()) {
            parsed.names.push_back(name);
            found = parsed.names.end() - 1;
        }
        add(TermKind::name, position);
        expression_->terms.back().index = static_cast<int>(found - parsed.names.begin());
    }
    bool parseNumber(double& value) {
        const std::size_t start = position_;
        std::string word;
        const auto digits = [&] {
            while (isDigit(peek())) word += static_cast<char>(peek()), ++position_;
        };
        digits();
        if (peek() == '.' && !isLetter(peek(1))) {
            word += '.';
            ++position_;
            digits();
            if (peek() == '.') return expected("an operator");
        }
        const std::size_t sign = peek(1) == '-' || peek(1) == '+' ? 2 : 1;
        if ((peek() == 'e' || peek() == 'E') && isDigit(peek(sign))) {
            for (std::size_t k = 0; k < sign; ++k) word += static_cast<char>(peek()), ++position_;
            digits();
        }
        if (word.size() > kNumberCharacters)
            return fail(
                start, "a number has at most " + std::to_string(kNumberCharacters) + " characters");
        value = std::strtod(word.c_str(), nullptr);
        if (!(value <= kFormulaLargest))
            return fail(start, "the number is too large: at most 1e100");
        return true;
    }

    std::vector<char32_t> text_;
    std::size_t position_ = 0;
    Expression* expression_ = nullptr;
    bool inDeclaration_ = false;
    bool bareNumber_ = false;
    int depth_ = 0;
};

}  // namespace

bool parseText(std::string_view text, ParsedFormula& parsed, FormulaFault& fault) {
    Parser parser(text);
    const bool good = parser.parse();
    parsed = std::move(parser.parsed);
    fault = parser.fault;
    return good;
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
    return text.find_first_of("^*/+()=<>,; '") != std::string_view::npos ||
           std::any_of(text.begin(), text.end(), [](char c) { return c & 0x80; });
}

}  // namespace versorium
