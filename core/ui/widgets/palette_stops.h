// SPDX-License-Identifier: MIT
#pragma once
// Edits of a palette by its stops, as values. What makes no palette leaves it as it was. The first
// stop stays at 0 and the last at 1; on a cyclic palette these two have one colour.

#include "colour/palette.h"

namespace versorium {

inline constexpr const char* kOwnPalette = "own";

// A palette of the user's own that begins as this one.
Palette ownPaletteFrom(const Palette& palette);
// The place of the new stop, with the colour that was there; -1 where no stop can be.
int addStop(Palette& palette, double position);
// Within its neighbours.
void moveStop(Palette& palette, int stop, double position);
void colourStop(Palette& palette, int stop, const Colour& colour);
// False for the ends, and where but two are left.
bool deleteStop(Palette& palette, int stop);
void turnStops(Palette& palette);

}  // namespace versorium
