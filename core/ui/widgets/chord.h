// SPDX-License-Identifier: MIT
#pragma once
// A key with the modifiers that go with it. Letters, digits and named keys ("Home", "Page Down",
// "Space") are keys of the keyboard. Signs ("?", "+", ".") are what is typed, wherever a layout has
// them: they take no Shift of their own.

#include <array>
#include <string>

namespace versorium {

struct Chord {
    std::string key;       // empty: none
    bool command = false;  // Ctrl, or on Apple's machines ⌘
    bool shift = false;

    explicit operator bool() const { return !key.empty(); }
    bool isSign() const;
    friend bool operator==(const Chord&, const Chord&) = default;
};

// The keys that have a name in place of a letter.
const std::array<const char*, 6>& namedKeys();
// "Shift Ctrl Z".
std::string nameOf(const Chord& chord);
// The same in the language.
std::string textOf(const Chord& chord);

}  // namespace versorium
