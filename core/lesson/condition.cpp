// SPDX-License-Identifier: MIT
#include "lesson/condition.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "trace/formula.h"
#include "trace/interpret.h"

namespace versorium {
namespace {

bool beginsName(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool inName(char c) { return beginsName(c) || isDigit(c) || c == '.' || c == '[' || c == ']'; }

bool isWord(const std::string& name) {
    static constexpr const char* kWords[] = {"and", "or", "not", "pi", "e"};
    return std::find(std::begin(kWords), std::end(kWords), name) != std::end(kWords);
}

}  // namespace

Expected<Condition> parseCondition(const std::string& text,
                                   const std::function<bool(const std::string&)>& known) {
    Condition condition;
    condition.text = text;
    const auto unknown = [&](const std::string& name) {
        return Status::data("\"" + text + "\": there is no number named \"" + name + "\" here");
    };
    // Observables become the parameters v0, v1, … of a formula of the line.
    std::string formula = "x' = if(";
    for (std::size_t i = 0; i < text.size();) {
        if (!beginsName(text[i])) {
            const std::size_t digits = i;
            while (i < text.size() && (isDigit(text[i]) || text[i] == '.')) ++i;
            // A number takes its exponent along: 1e-3.
            if (i > digits && i < text.size() && text[i] == 'e') {
                const bool sign = i + 1 < text.size() && (text[i + 1] == '-' || text[i + 1] == '+');
                std::size_t end = i + (sign ? 2 : 1);
                if (end < text.size() && isDigit(text[end])) {
                    while (end < text.size() && isDigit(text[end])) ++end;
                    i = end;
                }
            }
            if (i == digits) ++i;
            formula += text.substr(digits, i - digits);
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && inName(text[end])) ++end;
        const std::string name = text.substr(i, end - i);
        std::size_t next = end;
        while (next < text.size() && text[next] == ' ') ++next;
        i = end;
        if (isWord(name) || (next < text.size() && text[next] == '(')) {
            formula += name;
            continue;
        }
        if (!known(name)) return unknown(name);
        const auto found = std::find(condition.names.begin(), condition.names.end(), name);
        formula += "v" + std::to_string(found - condition.names.begin());
        if (found == condition.names.end()) condition.names.push_back(name);
    }
    formula += ", 1, 0)";
    FormulaFault fault;
    const Expected<Formula> parsed = parseFormula(formula, &fault);
    if (!parsed) return Status::data("\"" + text + "\" is no condition: " + fault.message);
    // Constants fold: parameters may be fewer than names, and in another order.
    std::vector<std::string> order;
    for (const FormulaParameter& parameter : parsed->parameters) {
        // Letters beyond ASCII are names to the formula's parser.
        std::size_t k = 0;
        while (k < condition.names.size() && parameter.name != "v" + std::to_string(k)) ++k;
        if (k == condition.names.size()) return unknown(parameter.name);
        order.push_back(condition.names[k]);
    }
    condition.names = order;
    condition.tape = parsed->tape;
    return condition;
}

bool holds(const Condition& condition, const std::function<double(const std::string&)>& value) {
    std::vector<double> values;
    for (const std::string& name : condition.names) values.push_back(value(name));
    for (double number : values)
        if (std::isnan(number)) return false;
    const double state = 0;
    double result = 0;
    values.push_back(0);  // so that there is an address
    interpret(condition.tape, &state, values.data(), NothingBound{}, &result);
    return result == 1;
}

}  // namespace versorium
