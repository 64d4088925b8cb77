// SPDX-License-Identifier: MIT
#pragma once
// The language of the interface. Texts stand in the sources in English; core/i18n/<id>.json has
// what another language says instead, and where it has nothing the English text is shown. One
// language at a time for the whole process: the studio is one thread, and so are its texts. What is
// written in a language of its own, such as a plate, takes Words, on any thread. Files, links,
// scenes, the ids of controls and the command line are English, with points in numbers, always.

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace versorium {

struct Language {
    std::string id;    // ISO 639-1: "es"
    std::string name;  // as its speakers call it: "Español"
    char decimal = '.';
};

// English first.
std::span<const Language> languages();
// The texts of one language.
class Words {
  public:
    // English where there is no language of this id.
    explicit Words(std::string_view id = "en");

    const Language& language() const { return *language_; }
    // What tr(), trMessage() and withDecimalSign() below do in the language of the interface.
    std::string tr(std::string_view english) const;
    std::string tr(std::string_view english, std::initializer_list<std::string> values) const;
    std::string message(std::string_view english) const;
    std::string number(std::string formatted) const;
    const char* separator() const;  // numberSeparator()
    // The text itself, which lives as long as the program; null where there is no other.
    const std::string* find(std::string_view english) const;

  private:
    const Language* language_;
    const struct Dictionary* dictionary_;  // null in English
};

// False, and nothing changes, where there is none of this id.
bool setLanguage(std::string_view id);
const Words& wordsNow();
inline const Language& languageNow() { return wordsNow().language(); }
// The language that a system's name such as "es_MX.UTF-8" or "es-419" stands for; else English.
const std::string& languageOf(std::string_view locale);

// What the language says for an English text; the text itself where it has nothing. The result
// lives as long as the program, or as the argument.
const char* tr(const char* english);
std::string tr(std::string_view english);
// A sentence with places {1}, {2} …, which each language puts where it needs them.
std::string tr(const char* english, std::initializer_list<std::string> values);
// A text that was put together elsewhere, such as the message of a Status: by the sentence with
// places that fits it best, and the same for what stands in them. As it is where none fits.
std::string trMessage(std::string_view english);
// Marks a text of a table, which is translated where it is shown.
constexpr const char* trLater(const char* english) { return english; }

// formatNumber with the decimal sign of the language.
std::string shownNumber(double value);
std::string shownNumber(double value, int digits);
// A number that was formatted otherwise, with the decimal sign of the language.
std::string withDecimalSign(std::string number);
// Stands between numbers: ", ", or "; " where they have a comma themselves.
const char* numberSeparator();
// Takes a point or a comma, whatever the language; nothing where the text is no finite number.
std::optional<double> parseShownNumber(std::string_view text);

}  // namespace versorium
