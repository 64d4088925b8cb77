// SPDX-License-Identifier: MIT
#include "plate/text.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "plate/canvas.h"

namespace versorium {
namespace {

const TextStyle kStyle{.face = Face::serif, .size = 33, .smallest = 25};
const char* const kFormula =
    "f(q) = \\hat{r}(q)·d(q), \\hat{r} = e^{α(φ−β)} with ∏ (q−r_{i})^{m_{i}}"
    " over ℂ, ℍ, ℝ, ℕ and ℤ: ‖f‖ ≤ 20, x ↦ ⌊x⌋ ≠ ∞, ∂φ ≈ ∇φ, √2 ∈ ℝ";

TEST(Markup, PlainText) {
    EXPECT_EQ(plainText("e^{α(φ−β)}, r_{i}^{2}, \\hat{r}, \\bold{Plate.}"),
              "e^(α(φ−β)), r_i^2, r\u0302, Plate.");
    EXPECT_EQ(plainText("escape_step 2^3 {x} \\_ \\{"), "escape_step 2^3 {x} _ {");
    const std::string wild = "a_{b}^{c} \\hat{} {_}";
    EXPECT_EQ(plainText(escapeMarkup(wild)), wild);
}

TEST(Markup, FaultsAreNamed) {
    for (const char* text : {"x_{i", "\\italic{x}", "\\", "\\hat{\\hat{", "\xff", "a\xc3",
                             "\\parts", "\\bold{a\\par b}"})
        EXPECT_FALSE(checkMarkup(text).ok()) << text;
    std::string deep;
    for (int i = 0; i < 50; ++i) deep += "x^{";
    EXPECT_FALSE(checkMarkup(deep).ok());
    EXPECT_FALSE(checkMarkup(std::string(30000, 'x')).ok());
    // Wrong markup is set as it stands, whatever its length.
    EXPECT_GT(layoutText("x_{i", kStyle).glyphs.size(), 3u);
    EXPECT_GT(layoutText("\xff\xfe", kStyle).glyphs.size(), 1u);
}

TEST(Text, EveryLetterOfMathematicsHasAGlyph) {
    const std::u32string letters =
        U"ABCxyz019αβγδεζηθικλμνξοπρστυφχψωΓΔΘΛΞΠΣΦΨΩϕℂℍℝℕℤℚ→←↑↓↦⇒⁰¹²³⁴⁵⁶⁷⁸⁹⁻₀₁₂₃₄₅₆₇₈₉ᵢⱼ"
        U"−×·∏∑≤≥≠≈∞∂∇√∈⌊⌋‖′″…–—‘’“”±∓∘∪∩⊂∅∀∃⟨⟩ℓ°äöüßéñçÅØ";
    for (const Face face : {Face::serif, Face::serifBold, Face::sans, Face::sansBold, Face::mono}) {
        const Glyph none = glyphOf(face, 0x10ffff);
        for (const char32_t letter : letters) {
            const Glyph glyph = glyphOf(face, letter);
            EXPECT_FALSE(glyph.face == none.face && glyph.index == none.index)
                << "U+" << std::hex << static_cast<unsigned>(letter);
        }
    }
}

TEST(Text, InkIsExactlyWhatIsDrawn) {
    for (const bool turned : {false, true}) {
        const TextBlock block = layoutText(kFormula, kStyle, 500);
        const Box ink = placedInk(block, 100, 700, turned);
        Canvas canvas({900, 1000}, {1, 1, 1});
        canvas.text(block, 100, 700, {0, 0, 0}, turned);
        Box drawn;
        for (int y = 0; y < 1000; ++y)
            for (int x = 0; x < 900; ++x)
                if (canvas.pixels().at(x, y) < 1)
                    drawn.include({double(x), double(y), x + 1.0, y + 1.0});
        // The box of an outline may be one pixel larger than the coverage that survives rounding.
        EXPECT_TRUE(ink.left <= drawn.left && drawn.left <= ink.left + 1);
        EXPECT_TRUE(ink.top <= drawn.top && drawn.top <= ink.top + 1);
        EXPECT_TRUE(ink.right >= drawn.right && drawn.right >= ink.right - 1);
        EXPECT_TRUE(ink.bottom >= drawn.bottom && drawn.bottom >= ink.bottom - 1);
    }
}

TEST(Text, LinesFitTheWidthAndNeverTouch) {
    const std::string text = std::string(kFormula) + " Averyveryverylongwordthatfitsnowhere " +
                             "\\hat{A}^{\\hat{A}^{2}} g_{g_{g}} " + kFormula;
    for (const double width : {180.0, 333.3, 1000.0}) {
        const TextBlock block = layoutText(text, kStyle, width);
        // A last letter may lean out of its advance by a pixel or two.
        EXPECT_LE(block.ink.right, width + 3);
        EXPECT_GE(block.ink.left, -3);
        EXPECT_LE(block.ink.bottom, block.height + 1);
        EXPECT_GE(block.ink.top, -1);
        EXPECT_GE(block.smallest, kStyle.smallest);
    }
    // Two lines of stacked scripts, one above the other: rows of white remain between them.
    const TextBlock block = layoutText("g_{g_{g}} A^{A^{\\hat{A}}}", kStyle, 80);
    ASSERT_EQ(block.lines, 2);
    Box first, second;
    for (const PlacedGlyph& placed : block.glyphs) {
        const Box ink = inkOf(placed.glyph, placed.size, placed.x, placed.y);
        (&placed - block.glyphs.data() < 3 ? first : second).include(ink);
    }
    EXPECT_LT(first.bottom, second.top);
}

TEST(Text, ParagraphsBeginLinesThatStandFurtherApart) {
    EXPECT_EQ(plainText("one\\par two \\bold{three}\\par"), "one\n\ntwo three\n\n");
    const auto heightOf = [](const char* text, double width) {
        const TextBlock block = layoutText(text, kStyle, width);
        EXPECT_EQ(block.lines, 2) << text;
        return block.height;
    };
    const double wrapped = heightOf("one two", 2.2 * kStyle.size);
    const double parted = heightOf("one\\par two", 1000);
    EXPECT_GT(parted, wrapped + 0.3 * kStyle.size);
    // Nothing before the first line, and nothing where a paragraph is empty.
    EXPECT_EQ(heightOf("\\par one\\par \\par two\\par", 1000), parted);
}

TEST(Text, HatStandsOverTheMiddle) {
    for (const char* letter : {"r", "x", "M", "i", "d"}) {
        const TextBlock block = layoutText("\\hat{" + std::string(letter) + "}", kStyle);
        ASSERT_EQ(block.glyphs.size(), 2u);
        const auto box = [&](std::size_t i) {
            const PlacedGlyph& p = block.glyphs[i];
            return inkOf(p.glyph, p.size, p.x, p.y);
        };
        // Boxes are whole pixels, so centres agree to a pixel.
        EXPECT_NEAR(box(0).left + box(0).right, box(1).left + box(1).right, 2) << letter;
        EXPECT_LT(box(1).bottom, box(0).top + 2) << letter;
        // A combining circumflex is the same.
        EXPECT_EQ(layoutText(std::string(letter) + "\u0302", kStyle).ink, block.ink);
    }
}

TEST(Text, SubAndSuperscriptStandAboveEachOther) {
    const double joined = layoutText("x_{i}^{2}", kStyle).width;
    EXPECT_LT(joined, layoutText("x_{i} ^{2}", kStyle).width);
    EXPECT_NEAR(joined, layoutText("x^{2}_{i}", kStyle).width, 1e-9);
}

TEST(Text, KerningPullsPairsTogether) {
    const TextStyle sans{.face = Face::sans, .size = 100};
    EXPECT_LT(layoutText("AV", sans).width,
              layoutText("A", sans).width + layoutText("V", sans).width - 2);
}

TEST(Text, SamePixelsEverywhere) {
    // The digest was computed natively; the WebAssembly run of this test shows that it is the same
    // there. It changes with the fonts' version.
    const Coverage coverage = textCoverage(layoutText(kFormula, kStyle, 700), 0, 0);
    EXPECT_EQ(sha256(coverage.values).substr(0, 16), "a6a5c72c420f4351");
}

}  // namespace
}  // namespace versorium
