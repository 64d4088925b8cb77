// SPDX-License-Identifier: MIT
#pragma once
// The words of enumerations: what a value is called in files, on the command line and, through
// tr(), in the interface. Each enumeration has one table, a specialisation of `EnumWords` that
// stands beside it, in the order of its values.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace versorium {

// Specialise with `static constexpr std::array<std::string_view, n> table`.
template <class E>
struct EnumWords;

template <class E>
concept Worded = requires {
    EnumWords<E>::table.size();
};

template <Worded E>
constexpr std::string_view wordOf(E value) {
    return EnumWords<E>::table[static_cast<std::size_t>(value)];
}
// Nothing where it is no word of this enumeration.
template <Worded E>
constexpr std::optional<E> fromWord(std::string_view word) {
    for (std::size_t k = 0; k < EnumWords<E>::table.size(); ++k)
        if (EnumWords<E>::table[k] == word) return static_cast<E>(k);
    return std::nullopt;
}
template <Worded E>
std::vector<std::string> wordsOf() {
    return {EnumWords<E>::table.begin(), EnumWords<E>::table.end()};
}

// Where nothing is chosen the word is empty.
template <Worded E>
constexpr std::string_view wordOf(std::optional<E> value) {
    return value ? wordOf(*value) : std::string_view();
}

}  // namespace versorium
