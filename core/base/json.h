// SPDX-License-Identifier: MIT
#pragma once
// Strict JSON (RFC 8259) for foreign input: nesting is capped, a key that stands twice is refused,
// and every fault names its path, such as "panels[2].scene.iterations".

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "base/words.h"

namespace versorium {

// Keys keep the order in which they were written.
using Json = nlohmann::ordered_json;

inline constexpr int kJsonDepth = 64;
inline constexpr std::size_t kJsonKeys = 4096;  // of one object

// Fails with ErrorKind::data: line and column of a syntax error, the path of a duplicate key.
Expected<Json> parseJson(std::string_view text);

// Two spaces of indentation, lists of numbers on one line, numbers so that they read back exactly.
std::string printJson(const Json& value);

// The shortest text that reads back as the same number: "0.1", "-1e-07".
std::string formatNumber(double value);
// The same rounded to the given number of significant digits.
std::string formatNumber(double value, int digits);

// Checked reading of one value; the message has no path.
Status readNumber(const Json& json, double low, double high, double& value);
Status readWhole(const Json& json, int low, int high, int& value);
Status readToggle(const Json& json, bool& value);
Status readText(const Json& json, std::string& value);
Status readWord(const Json& json, const std::vector<std::string>& words, std::string& value);
// A single number stands for a list of one.
Status readNumbers(const Json& json, std::size_t least, std::size_t most,
                   std::vector<double>& value);
Json numbersToJson(const std::vector<double>& values);
// Reads the members of one object with checks. Every key that is asked for is known; `finish`
// reports the first fault, or the first key that nobody asked for. A key that is absent leaves the
// value as it was.
class ObjectReader {
  public:
    ObjectReader(const Json& value, std::string path);

    bool has(const char* key) const;
    ObjectReader& number(const char* key, double& value, double low, double high);
    ObjectReader& integer(const char* key, int& value, int low, int high);
    ObjectReader& boolean(const char* key, bool& value);
    ObjectReader& text(const char* key, std::string& value);
    // One of the given words.
    ObjectReader& word(const char* key, std::string& value, const std::vector<std::string>& words);
    template <Worded E>
    ObjectReader& word(const char* key, E& value) {
        std::string chosen(wordOf(value));
        word(key, chosen, wordsOf<E>());
        value = *fromWord<E>(chosen);
        return *this;
    }
    template <Worded E>
    ObjectReader& word(const char* key, std::optional<E>& value) {
        std::string chosen(wordOf(value));
        std::vector<std::string> words = wordsOf<E>();
        words.insert(words.begin(), "");
        word(key, chosen, words);
        value = fromWord<E>(chosen);
        return *this;
    }
    // A list of finite numbers with least ≤ size ≤ most.
    ObjectReader& numbers(const char* key, std::vector<double>& value, std::size_t least,
                          std::size_t most);
    // The member itself, or null when it is absent; for members that have a reader of their own.
    const Json* child(const char* key);

    void fail(const std::string& message);
    void fail(const char* key, const std::string& message);
    void fail(const Status& status);
    bool failed() const { return !status_.ok(); }
    // "path.key", for the readers of children.
    std::string pathOf(const char* key) const;
    Status finish();

  private:
    const Json& value_;
    std::string path_;
    std::set<std::string> known_;
    Status status_;
};

}  // namespace versorium
