// SPDX-License-Identifier: MIT
#pragma once
// Text set in lines: kerning, sub- and superscripts, hats centred over what wears them, lines
// broken at spaces. A block knows exactly which pixels it touches, so that a layout can keep blocks
// apart; its own lines never touch each other.

#include <limits>
#include <string_view>
#include <vector>

#include "plate/font.h"
#include "plate/markup.h"

namespace versorium {

struct TextStyle {
    Face face = Face::sans;
    double size = 12;          // pixels per em
    double smallest = 0;       // scripts are never smaller than this, in pixels per em
    double lineSpacing = 1.3;  // distance of baselines in ems, more where a line is tall
    bool centred = false;      // lines of a block in the middle, else on the left
};

struct PlacedGlyph {
    Glyph glyph;
    double size = 0;
    double x = 0, y = 0;  // of the origin, on the baseline; y is a whole number
};

struct TextBlock {
    std::vector<PlacedGlyph> glyphs;  // relative to the upper left corner
    double width = 0;                 // of the widest line, by advances
    double height = 0;                // from the ascenders of the first line to the last descenders
    double baseline = 0;              // of the first line
    int lines = 0;
    double smallest = 0;  // the smallest size in it
    Box ink;              // all pixels touched: whole numbers
};

// A text whose markup is wrong is set as it stands.
TextBlock layoutText(std::string_view markup, const TextStyle& style,
                     double maximalWidth = std::numeric_limits<double>::infinity());

// The pixels of a block whose corner is put at (x, y), rounded to whole pixels; `turned` blocks
// read upwards: their first line is on the left, and (x, y) is the corner where it begins, the
// lower left one.
Box placedInk(const TextBlock& block, double x, double y, bool turned = false);
Coverage textCoverage(const TextBlock& block, double x, double y, bool turned = false);

}  // namespace versorium
