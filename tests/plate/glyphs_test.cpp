// SPDX-License-Identifier: MIT
// The faces have what their list promises (tests/checks/glyphs.py compares the list with the
// texts).
#include <gtest/gtest.h>

#include "plate/font.h"

namespace versorium {
namespace {

TEST(Glyphs, OfMarksAndHighLettersAreInTheFonts) {
    const int none = glyphOf(Face::sans, U'\xe000').index;
    for (char32_t letter : {U'\x2713', U'\x25cb', U'\x1d4d', U'\x02b0', U'\x2081', U'\x2074',
                            U'\x207b', U'\x00b7', U'\x2032', U'\x03c0', U'\x2212', U'\x2264'})
        for (Face face : {Face::serif, Face::serifBold, Face::sans, Face::sansBold, Face::mono})
            EXPECT_NE(glyphOf(face, letter).index, none) << std::hex << int(letter);
    // The studio draws with the sans face alone.
    for (char32_t letter : {U'\x2713', U'\x1d4d', U'\x02b0', U'\x2081'})
        EXPECT_EQ(glyphOf(Face::sans, letter).face, Face::sans) << std::hex << int(letter);
}

}  // namespace
}  // namespace versorium
