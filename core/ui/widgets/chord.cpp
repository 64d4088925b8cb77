// SPDX-License-Identifier: MIT
#include "ui/widgets/chord.h"

#include <cctype>

#include "i18n/language.h"

namespace versorium {

const std::array<const char*, 6>& namedKeys() {
    static constexpr std::array<const char*, 6> names{trLater("Home"),    trLater("Backspace"),
                                                      trLater("Delete"),  trLater("Space"),
                                                      trLater("Page Up"), trLater("Page Down")};
    return names;
}

bool Chord::isSign() const {
    return key.size() == 1 && std::isalnum(static_cast<unsigned char>(key[0])) == 0;
}

std::string nameOf(const Chord& chord) {
    return std::string(chord.shift ? "Shift " : "") + (chord.command ? "Ctrl " : "") + chord.key;
}

std::string textOf(const Chord& chord) {
    std::string text;
    if (chord.shift) text += tr("Shift") + std::string(" ");
    if (chord.command) text += tr("Ctrl") + std::string(" ");
    return text + tr(std::string_view(chord.key));
}

}  // namespace versorium
