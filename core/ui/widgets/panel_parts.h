// SPDX-License-Identifier: MIT
#pragma once
// What several sections of the inspector are made of.

#include <string>
#include <vector>

#include "base/words.h"

namespace versorium {

// Texts are given in English and shown in the language of the interface (i18n/language.h).

// An ImGui label in the language, whose id is the English one: for what must stay open, or where it
// was, when the language changes.
std::string named(const char* english);
// The name of a section, with a line below it.
void heading(const char* text);
// A heading whose part is closed until it is opened by a click, or by being in use. True while the
// part is to be drawn.
bool section(const char* text, bool inUse);
// What is drawn next, so wide in all, stands beside what was drawn last where the line has room.
void sameLineIfRoom(float wide);
// A button beside the last one, or below it where the line has no room; true when it was pressed.
// `control` explains it (ui/widgets/help.h).
bool rowButton(const char* text, const char* control);
// A label on the left; what is drawn next takes the rest of the line.
void labelled(const char* label);
// A choice of words; true when another one was taken. `empty` stands for the empty word. Names,
// such as those of numbers, are shown as they are.
bool choose(const char* label, const char* control, std::string& value,
            const std::vector<std::string>& words, const char* empty = "");
bool chooseName(const char* label, const char* control, std::string& value,
                const std::vector<std::string>& names, const char* empty = "");

// The words of an enumeration.
template <Worded E>
bool chooseWord(const char* label, const char* control, E& value) {
    std::string word(wordOf(value));
    if (!choose(label, control, word, wordsOf<E>())) return false;
    value = *fromWord<E>(word);
    return true;
}

}  // namespace versorium
