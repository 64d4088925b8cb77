// SPDX-License-Identifier: MIT
#pragma once
// Formulas in words, for those who hear a lesson: "z² + c" is "z squared plus c".

#include <string>
#include <vector>

namespace versorium {

// A text in parts: what is a formula stands by itself.
struct SpokenPart {
    std::string text;
    std::string spoken;  // of a formula; empty where the text speaks for itself
};

// `language` is "en" or "es".
std::string spokenFormula(const std::string& formula, const std::string& language);
std::vector<SpokenPart> spokenParts(const std::string& text, const std::string& language);

}  // namespace versorium
