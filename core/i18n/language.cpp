// SPDX-License-Identifier: MIT
#include "i18n/language.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <mutex>
#include <vector>

#include "base/embedded.h"
#include "base/json.h"
#include "base/text.h"

namespace versorium {

struct Dictionary {
    // A sentence with places is cut at them: "a {1} b" is {"a ", " b"}.
    struct Sentence {
        std::vector<std::string> pieces;
        std::vector<std::size_t> places;
        std::string_view other;  // in the language
        std::size_t length = 0;  // of the pieces
    };

    std::map<std::string, std::string, std::less<>> texts;
    std::vector<Sentence> sentences;
};

namespace {

using Sentence = Dictionary::Sentence;

const std::array<Language, 2> kLanguages{{{"en", "English", '.'}, {"es", "Español", ','}}};

// What has less text than this between its places fits by chance.
constexpr std::size_t kLeastText = 6;
// Of parts of one message.
constexpr int kMostLooks = 64;

std::optional<std::size_t> placeAt(std::string_view text, std::size_t at) {
    if (at + 2 >= text.size() || text[at] != '{' || text[at + 2] != '}') return {};
    const char digit = text[at + 1];
    if (digit < '1' || digit > '9') return {};
    return static_cast<std::size_t>(digit - '1');
}

Sentence sentenceOf(std::string_view english, std::string_view other) {
    Sentence sentence{.pieces = {{}}, .places = {}, .other = other};
    for (std::size_t k = 0; k < english.size(); ++k)
        if (const auto place = placeAt(english, k)) {
            sentence.places.push_back(*place);
            sentence.pieces.emplace_back();
            k += 2;
        } else {
            sentence.pieces.back() += english[k];
            ++sentence.length;
        }
    return sentence;
}

// The file of a language was tested with the program: what does not parse is left out.
Dictionary read(const std::string& id) {
    Dictionary dictionary;
    const Expected<Json> json = parseJson(embeddedText("i18n/" + id + ".json"));
    if (!json || !json->is_object()) return dictionary;
    for (const auto& [english, other] : json->items())
        if (other.is_string()) dictionary.texts[english] = other.get<std::string>();
    for (const auto& [english, other] : dictionary.texts)
        if (Sentence sentence = sentenceOf(english, other);
            !sentence.places.empty() && sentence.length >= kLeastText)
            dictionary.sentences.push_back(std::move(sentence));
    return dictionary;
}

// Dictionaries stay: what tr() returned points into them.
const Dictionary* dictionaryOf(const std::string& id) {
    static std::map<std::string, Dictionary> all;
    static std::mutex mutex;
    if (id == kLanguages[0].id) return nullptr;
    const std::lock_guard lock(mutex);
    const auto found = all.find(id);
    return found != all.end() ? &found->second : &all.emplace(id, read(id)).first->second;
}

const Language* languageNamed(std::string_view id) {
    for (const Language& language : kLanguages)
        if (language.id == id) return &language;
    return nullptr;
}

std::string filled(std::string_view sentence, std::span<const std::string> values) {
    std::string text;
    for (std::size_t k = 0; k < sentence.size(); ++k) {
        const auto place = placeAt(sentence, k);
        if (!place || *place >= values.size()) {
            text += sentence[k];
            continue;
        }
        text += values[*place];
        k += 2;
    }
    return text;
}

// What stands in the places of a sentence that the text is; nothing where it is another one.
std::optional<std::vector<std::string>> valuesIn(const Sentence& sentence, std::string_view text) {
    const std::string& head = sentence.pieces.front();
    const std::string& tail = sentence.pieces.back();
    if (text.size() < sentence.length || !text.starts_with(head) || !text.ends_with(tail))
        return {};
    std::vector<std::string> values(sentence.places.size());
    std::size_t at = head.size();
    for (std::size_t k = 0; k < sentence.places.size(); ++k) {
        const bool last = k + 1 == sentence.places.size();
        const std::size_t end =
            last ? text.size() - tail.size() : text.find(sentence.pieces[k + 1], at);
        if (end == std::string_view::npos || end < at || sentence.places[k] >= values.size())
            return {};
        values[sentence.places[k]] = text.substr(at, end - at);
        at = end + sentence.pieces[k + 1].size();
    }
    return values;
}

// A message in the language, and how much of it its sentences are.
struct Said {
    std::string text;
    std::size_t length = 0;
};

// `looks` bounds the work, whatever a message repeats.
Said saidBest(const Dictionary& dictionary, std::string_view english, int& looks) {
    if (english.empty() || --looks < 0) return {std::string(english)};
    if (const auto known = dictionary.texts.find(english); known != dictionary.texts.end())
        return {known->second, english.size()};
    Said best{std::string(english)};
    for (const Sentence& sentence : dictionary.sentences) {
        std::optional<std::vector<std::string>> values = valuesIn(sentence, english);
        if (!values) continue;
        std::size_t length = sentence.length;
        for (std::string& value : *values) {
            if (value.find(' ') == std::string::npos) continue;  // a name, or a number
            Said said = saidBest(dictionary, value, looks);
            value = std::move(said.text);
            length += said.length;
        }
        if (length > best.length) best = {filled(sentence.other, *values), length};
    }
    // "where: what".
    const std::size_t colon = english.find(": ");
    if (colon == std::string_view::npos) return best;
    const Said what = saidBest(dictionary, english.substr(colon + 2), looks);
    if (what.length <= best.length) return best;
    return {std::string(english.substr(0, colon + 2)) + what.text, what.length};
}

}  // namespace

std::span<const Language> languages() { return kLanguages; }

Words::Words(std::string_view id)
    : language_(languageNamed(id) ? languageNamed(id) : &kLanguages[0]),
      dictionary_(dictionaryOf(language_->id)) {}

const std::string* Words::find(std::string_view english) const {
    if (!dictionary_) return nullptr;
    const auto found = dictionary_->texts.find(english);
    return found == dictionary_->texts.end() ? nullptr : &found->second;
}

std::string Words::tr(std::string_view english) const {
    const std::string* other = find(english);
    return other ? *other : std::string(english);
}

std::string Words::tr(std::string_view english, std::initializer_list<std::string> values) const {
    return filled(tr(english), {values.begin(), values.size()});
}

std::string Words::message(std::string_view english) const {
    int looks = kMostLooks;
    return dictionary_ ? saidBest(*dictionary_, english, looks).text : std::string(english);
}

std::string Words::number(std::string formatted) const {
    std::replace(formatted.begin(), formatted.end(), '.', language_->decimal);
    return formatted;
}

const char* Words::separator() const { return language_->decimal == ',' ? "; " : ", "; }

namespace {
Words now;
}

bool setLanguage(std::string_view id) {
    if (!languageNamed(id)) return false;
    now = Words(id);
    return true;
}

const Words& wordsNow() { return now; }

const std::string& languageOf(std::string_view locale) {
    const Language* language = languageNamed(locale.substr(0, locale.find_first_of("_-.@")));
    return language ? language->id : kLanguages[0].id;
}

const char* tr(const char* english) {
    const std::string* other = now.find(english);
    return other ? other->c_str() : english;
}

std::string tr(std::string_view english) { return now.tr(english); }
std::string tr(const char* english, std::initializer_list<std::string> values) {
    return now.tr(english, values);
}
std::string trMessage(std::string_view english) { return now.message(english); }
std::string withDecimalSign(std::string number) { return now.number(std::move(number)); }

std::string shownNumber(double value) { return withDecimalSign(formatNumber(value)); }
std::string shownNumber(double value, int digits) {
    return withDecimalSign(formatNumber(value, digits));
}

const char* numberSeparator() { return now.separator(); }

std::optional<double> parseShownNumber(std::string_view text) {
    std::string number = trimmed(std::string(text));
    std::replace(number.begin(), number.end(), ',', '.');
    char* end = nullptr;
    const double value = std::strtod(number.c_str(), &end);
    if (number.empty() || *end != 0 || !std::isfinite(value)) return {};
    return value;
}

}  // namespace versorium
