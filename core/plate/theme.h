// SPDX-License-Identifier: MIT
#pragma once
// How plates look: two themes as one table of tokens, and the sizes of type and lines for a width.

#include <array>
#include <string_view>

#include "base/status.h"
#include "colour/srgb.h"

namespace versorium {

struct Theme {
    const char* name;
    Colour background, text, secondary, line;
    // Lines of plots: each differs in lightness or hue, and has its own dashes and marker besides.
    std::array<Colour, 6> series;
};

// "paper" (white) or "slide" (dark). ErrorKind::usage.
Expected<Theme> themeNamed(std::string_view name);

// Everything in pixels of the plate.
struct Metrics {
    double point = 0;       // 1/72 inch
    double millimetre = 0;  // 1/25.4 inch
    double smallest = 0;    // 6 pt: no letter is smaller
    double title = 0, header = 0, label = 0, tick = 0, caption = 0, note = 0;  // type sizes
    double margin = 0;                                                         // around the plate
    double columnGap = 0, rowGap = 0;
    double lineWidth = 0;  // of axes and outlines, whole pixels
    double plotLine = 0;
    double tickLength = 0, tickGap = 0;
    double barWidth = 0;
};

// Sizes grow gently from a single column (89 mm) to a whole page (178 mm) and in proportion beyond,
// so that a wide plate still reads from afar.
Metrics metricsFor(double widthMillimetres, double dotsPerInch);

}  // namespace versorium
