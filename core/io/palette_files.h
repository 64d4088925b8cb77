// SPDX-License-Identifier: MIT
#pragma once
// Palettes of other programs: maps of Fractint (.map), palettes and gradients of GIMP (.gpl, .ggr),
// palettes of Paint Shop Pro (.pal), colour tables of GMT (.cpt), gradients of Ultra Fractal (.ugr)
// and plain lists of #rrggbb; and the program's own JSON. The content says which it is. Lists of
// colours become stops at equal distances; gradients that curve are sampled.

#include <span>
#include <string>
#include <string_view>

#include "colour/palette.h"

namespace versorium {

struct PaletteFile {
    Palette palette;
    std::string note;  // what was left out, as a sentence; often empty
};

// `name` names the palette where the file does not. Fails with ErrorKind::data and the line.
Expected<PaletteFile> readPaletteFile(std::span<const unsigned char> bytes, std::string_view name);

// Whether a name ends as such files do.
bool namesPalette(std::string_view name);
// Whether bytes begin as one of these files, plain lists with at least two colours included.
bool looksLikePalette(std::span<const unsigned char> bytes);

}  // namespace versorium
