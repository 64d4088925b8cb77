// SPDX-License-Identifier: MIT
#pragma once
// What the readers of palette_files.h share.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "colour/palette.h"
#include "io/palette_files.h"
#include "io/text_scanner.h"

namespace versorium {

Status paletteFault(const TextScanner& scanner, const std::string& what);
// "#rrggbb", "#rgb", "rrggbb" or "0xrrggbb".
std::optional<Colour> hexColour(std::string_view word);
// Stops at equal distances.
Expected<Palette> paletteOfList(const std::string& name, const std::vector<Colour>& colours);
// Hue in degrees, the others from 0 to 1, as red, green, blue.
std::array<double, 3> rgbFromHsv(double hue, double saturation, double value);

Expected<PaletteFile> readGimpGradient(std::string_view text, std::string name);
Expected<PaletteFile> readColourTable(std::string_view text, std::string name);    // .cpt
Expected<PaletteFile> readUltraGradient(std::string_view text, std::string name);  // .ugr

}  // namespace versorium
