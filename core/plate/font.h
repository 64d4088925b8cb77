// SPDX-License-Identifier: MIT
#pragma once
// The embedded letters: outlines, advances and kerning of DejaVu by stb_truetype. Sizes are pixels
// per em. All arithmetic is plain float without contraction, so a glyph has the same pixels native
// and in WebAssembly.

#include <vector>

namespace versorium {

enum class Face { serif, serifBold, sans, sansBold, mono };
Face boldOf(Face face);

// A rectangle of the page in pixels, y down. Empty when right <= left.
struct Box {
    double left = 0, top = 0, right = 0, bottom = 0;
    double width() const { return right - left; }
    double height() const { return bottom - top; }
    bool empty() const { return right <= left || bottom <= top; }
    Box moved(double dx, double dy) const { return {left + dx, top + dy, right + dx, bottom + dy}; }
    Box grown(double by) const { return {left - by, top - by, right + by, bottom + by}; }
    // Empty boxes do not count.
    void include(const Box& other);
    friend bool operator==(const Box&, const Box&) = default;
};
bool overlap(const Box& one, const Box& other);

// A glyph of one of the faces: where the face itself lacks a letter, another one lends it.
struct Glyph {
    Face face = Face::sans;
    int index = 0;
};
Glyph glyphOf(Face face, char32_t letter);
double advanceOf(Glyph glyph, double size);
// What to add to the advance between two glyphs; 0 across faces.
double kerningOf(Glyph first, Glyph second, double size);
// The pixels that the glyph touches with its origin at (x, y): whole numbers.
Box inkOf(Glyph glyph, double size, double x, double y);

// Coverage of a rectangle of pixels, 0 … 255, row after row.
struct Coverage {
    int left = 0, top = 0, width = 0, height = 0;
    std::vector<unsigned char> values;
};
// Adds the glyph by maximum; pixels outside are dropped.
void drawGlyph(Coverage& coverage, Glyph glyph, double size, double x, double y);

}  // namespace versorium
