// SPDX-License-Identifier: MIT
#pragma once
// What several sections of the inspector are made of.

#include <string>
#include <vector>

namespace versorium {

// The name of a section, with a line below it.
void heading(const char* text);
// A heading whose part is closed until it is opened by a click, or by being in use. True while the
// part is to be drawn.
bool section(const char* text, bool inUse);
// A label on the left; what is drawn next takes the rest of the line.
void labelled(const char* label);
// A choice of words; true when another one was taken. `empty` stands for the empty word.
bool choose(const char* label, const char* control, std::string& value,
            const std::vector<std::string>& words, const char* empty = "");

}  // namespace versorium
