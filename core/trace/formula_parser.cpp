// SPDX-License-Identifier: MIT
// The statements and declarations of a formula.
#include <algorithm>

#include "trace/formula_expression.h"

namespace versorium {
namespace formulas {

namespace {

class Parser {
  public:
    explicit Parser(std::string_view text) : in_(text) { parsed.characters = in_.size(); }

    ParsedFormula parsed;
    const FormulaFault& fault() const { return in_.fault; }

    bool parse() {
        if (in_.size() > kFormulaCharacters)
            return in_.fail(
                kFormulaCharacters,
                "a formula has at most " + std::to_string(kFormulaCharacters) + " characters");
        do {
            if (!parseStatement()) return false;
            if (in_.atDecimalComma()) return in_.refuseDecimalComma();
            if (parsed.statements.size() > 2)
                return in_.fail(parsed.statements.back().position,
                                "a map has one component, or the two of the plane");
        } while (in_.take(','));
        while (in_.take(';')) {
            if (in_.atEnd()) break;
            do {
                if (!parseDeclaration()) return false;
                if (in_.atDecimalComma()) return in_.refuseDecimalComma();
            } while (in_.take(','));
        }
        in_.skipBlanks();
        return in_.atEnd() || in_.expected("an operator, \",\" or the formula's end");
    }

  private:
    bool parseStatement() {
        Statement statement;
        in_.skipBlanks();
        statement.position = in_.position;
        if (!parseHead(statement)) return false;
        if (!expressions_.parse(statement.expression)) return false;
        parsed.statements.push_back(std::move(statement));
        return true;
    }

    static bool isVariable(const std::string& name) {
        return name.size() == 1 && std::string_view("zqxy").find(name[0]) != std::string_view::npos;
    }
    // z' =, z ->, z :=, f(z) = and z_{n+1} =, each for z, q, x and y; nothing where none stands.
    bool parseHead(Statement& statement) {
        const std::size_t start = in_.position;
        const std::string name = in_.peekName();
        in_.position += name.size();
        if (isVariable(name)) {
            in_.skipBlanks();
            const std::size_t after = in_.position;
            if (isPrime(in_.peek())) {
                ++in_.position;
                if (!in_.take('=')) return in_.expected("\"=\" after " + name + "'");
                statement.head = name;
                return true;
            }
            if (in_.takeWord("->") || in_.take(0x2192) || in_.take(0x21a6) || in_.takeWord(":=") ||
                in_.take(0x2190)) {
                statement.head = name;
                return true;
            }
            if (in_.peek() == '=' && in_.peek(1) != '=')
                return in_.fail(after, "write " + name + "' = … for the next value of " + name);
        } else if (name.size() == 1 && in_.take('(')) {
            const std::string argument = in_.peekName();
            in_.position += argument.size();
            if (isVariable(argument) && in_.take(')') && takeEquals()) {
                statement.head = argument;
                return true;
            }
        } else if (name.size() >= 2 && name[1] == '_' && isVariable(name.substr(0, 1))) {
            const bool next =
                name.substr(1) == "_n" ? in_.takeWord("+1") || in_.takeWord("+ 1")
                : name.size() == 2
                    ? in_.takeWord("{n+1}") || in_.takeWord("{n + 1}") || in_.takeWord("(n+1)")
                    : false;
            if (next && takeEquals()) {
                statement.head = name.substr(0, 1);
                return true;
            }
        }
        in_.position = start;
        return true;
    }
    bool takeEquals() {
        in_.skipBlanks();
        if (in_.peek() == '=' && in_.peek(1) == '=') return false;
        return in_.takeWord(":=") || in_.take('=');
    }

    bool parseDeclaration() {
        Declaration declaration;
        declaration.name = in_.peekName();
        declaration.position = in_.position;
        if (declaration.name.empty())
            return in_.expected("a parameter's name, as in c = -0.1 + 0.7i,");
        in_.position += declaration.name.size();
        if (in_.take(':')) {
            const std::string word = in_.peekName();
            for (FormulaKind kind : {FormulaKind::real, FormulaKind::whole, FormulaKind::complex,
                                     FormulaKind::quaternion})
                if (word == kindName(kind)) declaration.kind = kind;
            if (!declaration.kind) return in_.expected("real, whole, complex or quaternion");
            in_.position += word.size();
        }
        if (in_.take('=')) {
            if (!expressions_.parse(declaration.value.emplace())) return false;
        }
        if (in_.takeWord("in")) {
            declaration.ranged = true;
            if (!in_.take('[')) return in_.expected("\"[\", as in [-2, 2],");
            if (!parseEnd(declaration.low)) return false;
            if (!in_.take(',')) return in_.expected("\",\" between the ends of the range");
            if (!parseEnd(declaration.high)) return false;
            const std::size_t end = in_.position;
            if (!in_.take(']')) return in_.expected("\"]\"");
            if (!(declaration.low < declaration.high))
                return in_.fail(end, "the lower end of the range comes first");
        }
        parsed.declarations.push_back(std::move(declaration));
        return true;
    }
    bool parseEnd(double& value) {
        const bool negative = in_.take('-') || in_.take(0x2212);
        in_.skipBlanks();
        if (!isDigit(in_.peek()) && in_.peek() != '.') return in_.expected("a number");
        if (!in_.takeNumber(value)) return false;
        if (negative) value = -value;
        return true;
    }

    Scanner in_;
    ExpressionParser expressions_{in_, parsed.names};
};

}  // namespace

bool parseText(std::string_view text, ParsedFormula& parsed, FormulaFault& fault) {
    Parser parser(text);
    const bool good = parser.parse();
    parsed = std::move(parser.parsed);
    fault = parser.fault();
    return good;
}

}  // namespace formulas
}  // namespace versorium
