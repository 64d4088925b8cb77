// SPDX-License-Identifier: MIT
#include "trace/formula_reading.h"

#include <algorithm>

#include "trace/formula_scanner.h"
#include "trace/formula_terms.h"

namespace versorium {
namespace formulas {
namespace {

constexpr std::size_t kLetters = 3;  // of a name that is taken apart letter by letter

constexpr std::string_view kGreek[] = {
    "alpha", "beta",  "gamma",   "delta", "epsilon", "eps", "zeta",    "eta", "theta",
    "iota",  "kappa", "lambda",  "mu",    "nu",      "xi",  "omicron", "pi",  "rho",
    "sigma", "tau",   "upsilon", "phi",   "chi",     "psi", "omega"};

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::vector<std::string> variablesOf(FormulaSpace space) {
    switch (space) {
        case FormulaSpace::line:
            return {"x"};
        case FormulaSpace::complex:
            return {"z"};
        case FormulaSpace::plane:
            return {"x", "y"};
        default:
            return {"q"};
    }
}

std::vector<std::string> unitsOf(FormulaSpace space) {
    if (space == FormulaSpace::complex) return {"i"};
    if (space == FormulaSpace::quaternion) return {"i", "j", "k"};
    return {};
}

bool contains(const std::vector<std::string>& all, const std::string& name) {
    return std::find(all.begin(), all.end(), name) != all.end();
}

const FunctionInfo* functionNamed(std::string_view name) {
    for (const FunctionInfo& info : kFunctions)
        if (info.arguments == 1 && info.name == name) return &info;
    return nullptr;
}

// Takes a name apart into known names, the longest first.
class Apart {
  public:
    Apart(FormulaSpace space, const std::string& name, const std::vector<std::string>& others)
        : variables_(variablesOf(space)) {
        known_ = unitsOf(space);
        known_.insert(known_.end(), variables_.begin(), variables_.end());
        for (const char* constant : {"pi", "e", "c"}) known_.emplace_back(constant);
        known_.insert(known_.end(), std::begin(kGreek), std::end(kGreek));
        for (const std::string& other : others)
            if (other != name) known_.push_back(other);
        std::sort(known_.begin(), known_.end(), [](const std::string& a, const std::string& b) {
            return a.size() != b.size() ? a.size() > b.size() : a < b;
        });
        letters_ = name.size() <= kLetters && std::any_of(name.begin(), name.end(), [&](char c) {
                       return contains(variables_, std::string(1, c));
                   });
    }
    // "c*z"; empty where it cannot be.
    std::string product(std::string_view name) const {
        if (name.empty()) return {};
        // A variable with digits behind it is a power or a product: z2.
        if (contains(variables_, std::string(1, name[0])) && name.size() > 1 &&
            std::all_of(name.begin() + 1, name.end(), [](char c) { return isDigit(char32_t(c)); }))
            return std::string(1, name[0]) + "^" + std::string(name.substr(1));
        for (std::size_t size = std::min<std::size_t>(name.size() - 1, 8); size >= 2; --size)
            if (functionNamed(name.substr(0, size)) &&
                contains(variables_, std::string(name.substr(size))))
                return std::string(name.substr(0, size)) + "(" + std::string(name.substr(size)) +
                       ")";
        for (const std::string& piece : known_)
            if (const std::string rest = behind(name, piece); !rest.empty()) return rest;
        const auto letter = static_cast<char32_t>(name[0]);
        return letters_ && isLetter(letter) ? behind(name, std::string(1, name[0])) : std::string();
    }

  private:
    std::string behind(std::string_view name, const std::string& piece) const {
        if (name.substr(0, piece.size()) != piece) return {};
        if (name.size() == piece.size()) return piece;
        const std::string rest = product(name.substr(piece.size()));
        return rest.empty() ? std::string() : piece + "*" + rest;
    }

    std::vector<std::string> variables_, known_;
    bool letters_ = false;
};

}  // namespace

std::string doubtAbout(const std::string& name, FormulaSpace space,
                       const std::vector<std::string>& others) {
    const std::string wayOut = "; for a parameter of this name write \"; " + name +
                               " = 1\" behind "
                               "the formula";
    if (std::find(std::begin(kGreek), std::end(kGreek), name) != std::end(kGreek)) return {};
    if (space == FormulaSpace::complex && name == "j")
        return "the imaginary unit is i, and j is one of quaternions: did you mean i?" + wayOut;
    // Capitals are letters of their own.
    if (const std::string small = lower(name); small != name) {
        std::vector<std::string> known = variablesOf(space);
        for (const std::string& unit : unitsOf(space)) known.push_back(unit);
        for (const char* word : {"c", "e", "pi"}) known.emplace_back(word);
        if (space == FormulaSpace::complex && small == "j")
            return "the imaginary unit is i: did you mean i?" + wayOut;
        if (contains(known, small) || contains(others, small))
            return "capital letters are names of their own: did you mean " + small +
                   " in place of " + name + "?" + wayOut;
    }
    if (name.size() < 2) return {};
    const std::string product = Apart(space, name, others).product(name);
    if (product.empty() || product == name) return {};
    return "\"" + name + "\" would be one name: did you mean " + product + "?" + wayOut;
}

}  // namespace formulas
}  // namespace versorium
