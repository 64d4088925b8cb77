// SPDX-License-Identifier: MIT
#include "lesson/spoken.h"

#include <algorithm>
#include <cctype>

namespace versorium {
namespace {

struct Sign {
    const char* sign;
    const char* english;
    const char* spanish;
    bool mathematical;  // by itself it makes a formula of the words beside it
};

// Longer ones before those that they begin with.
constexpr Sign kSigns[] = {
    {"²", "squared", "al cuadrado", true},
    {"³", "cubed", "al cubo", true},
    {"⁴", "to the fourth", "a la cuarta", true},
    {"ⁿ", "to the n", "a la n", true},
    {"⁻¹", "to the minus 1", "a la menos 1", true},
    {"→", "goes to", "va a", true},
    {"·", "times", "por", true},
    {"×", "times", "por", true},
    {"−", "minus", "menos", false},
    {"+", "plus", "más", false},
    {"±", "plus or minus", "más menos", true},
    {"=", "equals", "igual a", true},
    {"≠", "is not", "distinto de", true},
    {"≈", "is about", "aproximadamente", true},
    {"≤", "is at most", "menor o igual que", true},
    {"≥", "is at least", "mayor o igual que", true},
    {"<", "is less than", "menor que", true},
    {">", "is greater than", "mayor que", true},
    {"√", "the square root of", "la raíz cuadrada de", true},
    {"∞", "infinity", "infinito", true},
    {"^", "to the power", "elevado a", true},
    {"/", "over", "entre", false},
    {"…", "and so on", "etcétera", false},
    {"α", "alpha", "alfa", true},
    {"β", "beta", "beta", true},
    {"φ", "phi", "fi", true},
    {"π", "pi", "pi", true},
    {"ℂ", "the complex numbers", "los números complejos", true},
    {"ℍ", "the quaternions", "los cuaterniones", true},
    {"ℝ", "the real numbers", "los números reales", true},
    {"′", "prime", "prima", true},
    {"\u0302", "hat", "con circunflejo", true},
    {"₀", "sub 0", "sub 0", true},
    {"₁", "sub 1", "sub 1", true},
    {"₂", "sub 2", "sub 2", true},
    {"ₙ", "sub n", "sub n", true},
};

const Sign* signAt(const std::string& text, std::size_t at) {
    for (const Sign& sign : kSigns)
        if (text.compare(at, std::char_traits<char>::length(sign.sign), sign.sign) == 0)
            return &sign;
    return nullptr;
}

// A word of a text without the punctuation that ends a clause.
std::size_t coreLength(const std::string& word) {
    std::size_t length = word.size();
    while (length > 0 && std::string(",.;:!?").find(word[length - 1]) != std::string::npos)
        --length;
    return length;
}

bool hasMathematics(const std::string& word) {
    if (word.find('|') != std::string::npos) return true;
    for (std::size_t at = 0; at < word.size(); ++at)
        if (const Sign* sign = signAt(word, at); sign && sign->mathematical) return true;
    return false;
}

// What may stand in a formula beside something mathematical: an operator, a number, one letter.
bool mayJoin(const std::string& word) {
    const std::string core = word.substr(0, coreLength(word));
    if (core.empty()) return false;
    if (hasMathematics(core)) return true;
    int letters = 0;
    for (std::size_t at = 0; at < core.size(); ++at) {
        if (const Sign* sign = signAt(core, at)) {
            at += std::char_traits<char>::length(sign->sign) - 1;
            continue;
        }
        if (std::isalpha(static_cast<unsigned char>(core[at])))
            ++letters;
        else if (core[at] & 0x80)
            return false;
    }
    return letters <= 1;
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words(1);
    for (const char c : text) {
        if (c == ' ')
            words.emplace_back();
        else
            words.back() += c;
    }
    return words;
}

}  // namespace

std::string spokenFormula(const std::string& formula, const std::string& language) {
    const bool spanish = language == "es";
    std::string words;
    const auto say = [&](const std::string& word) {
        if (!words.empty() && words.back() != ' ') words += ' ';
        words += word + " ";
    };
    bool bar = false;               // within |…|
    std::vector<bool> silent = {};  // brackets that are not spoken
    for (std::size_t at = 0; at < formula.size();) {
        const char c = formula[at];
        if (const Sign* sign = signAt(formula, at)) {
            say(spanish ? sign->spanish : sign->english);
            at += std::char_traits<char>::length(sign->sign);
            continue;
        }
        ++at;
        if (c == '-') {
            say(spanish ? "menos" : "minus");
        } else if (c == '|') {
            if (!bar) say(spanish ? "el módulo de" : "the modulus of");
            bar = !bar;
        } else if (c == '(') {
            // "f(x)": f of x.
            const bool of = at > 1 && std::isalpha(static_cast<unsigned char>(formula[at - 2]));
            silent.push_back(of);
            say(of ? (spanish ? "de" : "of") : (spanish ? "abre paréntesis" : "open parenthesis"));
        } else if (c == ')') {
            const bool quiet = !silent.empty() && silent.back();
            if (!silent.empty()) silent.pop_back();
            if (!quiet) say(spanish ? "cierra paréntesis" : "close parenthesis");
        } else if (c == ' ') {
            if (!words.empty() && words.back() != ' ') words += ' ';
        } else {
            // Letters that stand beside each other are spoken one by one only in names of one.
            words += c;
        }
    }
    while (!words.empty() && words.back() == ' ') words.pop_back();
    return words;
}

std::vector<SpokenPart> spokenParts(const std::string& text, const std::string& language) {
    const std::vector<std::string> words = wordsOf(text);
    std::vector<SpokenPart> parts;
    const auto add = [&](const std::string& piece, bool formula) {
        if (piece.empty()) return;
        if (formula)
            parts.push_back({piece, spokenFormula(piece, language)});
        else if (!parts.empty() && parts.back().spoken.empty())
            parts.back().text += piece;
        else
            parts.push_back({piece, {}});
    };
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (k > 0) add(" ", false);
        // The longest run of words that belong together and hold something mathematical.
        std::size_t end = k;
        bool mathematical = false;
        while (end < words.size() && mayJoin(words[end])) {
            mathematical = mathematical || hasMathematics(words[end]);
            ++end;
            // Punctuation ends it.
            if (coreLength(words[end - 1]) < words[end - 1].size()) break;
        }
        if (!mathematical) {
            add(words[k], false);
            continue;
        }
        std::string formula;
        for (std::size_t j = k; j < end; ++j) formula += (j > k ? " " : "") + words[j];
        const std::size_t length = coreLength(formula);
        add(formula.substr(0, length), true);
        add(formula.substr(length), false);
        k = end - 1;
    }
    return parts;
}

}  // namespace versorium
