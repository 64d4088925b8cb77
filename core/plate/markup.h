// SPDX-License-Identifier: MIT
#pragma once
// A small markup for mathematics in running text: x_{i}, e^{α(φ−β)}, \hat{r}, \bold{…}, nested as
// deep as needed; \par begins a new paragraph, outside of braces. A backslash before _ ^ { } or
// \ takes the sign itself; an underscore or caret without a brace stands for itself, so that names
// such as escape_step need no care. Everything else is UTF-8; a letter followed by U+0302 is the
// same as \hat{letter}.

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace versorium {

struct MarkupItem {
    enum class Kind { letter, space, script, hat, paragraph };
    Kind kind = Kind::letter;
    char32_t letter = 0;            // letter
    bool bold = false;              // letter, space
    std::vector<MarkupItem> upper;  // script: superscript; hat: what wears it
    std::vector<MarkupItem> lower;  // script: subscript
};
using Markup = std::vector<MarkupItem>;

// Fails with ErrorKind::data on a brace that is not closed, an unknown command, nesting beyond 8
// levels, text that is not UTF-8 or longer than 20000 bytes.
Expected<Markup> parseMarkup(std::string_view text);
inline Status checkMarkup(std::string_view text) {
    const Expected<Markup> markup = parseMarkup(text);
    return markup.ok() ? Status() : markup.status();
}
// The text for a reader without typesetting: "e^(α(φ−β))", "r_i", a combining circumflex for hats.
std::string plainText(std::string_view markup);
// A text that is shown as it stands: the signs of the markup get their backslashes.
std::string escapeMarkup(std::string_view text);

void appendUtf8(std::string& out, char32_t letter);

}  // namespace versorium
