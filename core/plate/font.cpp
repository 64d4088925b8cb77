// SPDX-License-Identifier: MIT
#include "plate/font.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/embedded.h"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

namespace versorium {
namespace {

constexpr std::size_t kFaces = 5;
constexpr std::array<const char*, kFaces> kFiles = {
    "fonts/DejaVuSerif.ttf", "fonts/DejaVuSerif-Bold.ttf", "fonts/DejaVuSans.ttf",
    "fonts/DejaVuSans-Bold.ttf", "fonts/DejaVuSansMono.ttf"};
constexpr char32_t kReplacement = 0xfffd;

std::array<stbtt_fontinfo, kFaces> loadFonts() {
    std::array<stbtt_fontinfo, kFaces> fonts{};
    for (std::size_t i = 0; i < kFaces; ++i) {
        const auto bytes = embedded(kFiles[i]);
        const int good = bytes.empty() ? 0 : stbtt_InitFont(&fonts[i], bytes.data(), 0);
        assert(good && "the build embeds the fonts");
        static_cast<void>(good);
    }
    return fonts;
}

const stbtt_fontinfo& font(Face face) {
    static const std::array<stbtt_fontinfo, kFaces> fonts = loadFonts();
    return fonts[static_cast<std::size_t>(face)];
}

float scaleOf(Face face, double size) {
    return stbtt_ScaleForMappingEmToPixels(&font(face), static_cast<float>(size));
}

}  // namespace

void Box::include(const Box& other) {
    if (other.empty()) return;
    if (empty()) {
        *this = other;
        return;
    }
    left = std::min(left, other.left);
    top = std::min(top, other.top);
    right = std::max(right, other.right);
    bottom = std::max(bottom, other.bottom);
}

bool overlap(const Box& one, const Box& other) {
    return !one.empty() && !other.empty() && one.left < other.right && other.left < one.right &&
           one.top < other.bottom && other.top < one.bottom;
}

Face boldOf(Face face) {
    if (face == Face::serif) return Face::serifBold;
    return face == Face::sans ? Face::sansBold : face;
}

Glyph glyphOf(Face face, char32_t letter) {
    const Face spare = face == Face::serifBold ? Face::sansBold : Face::sans;
    for (const Face candidate : {face, spare, Face::sans})
        if (const int index = stbtt_FindGlyphIndex(&font(candidate), static_cast<int>(letter)))
            return {candidate, index};
    return {Face::sans, stbtt_FindGlyphIndex(&font(Face::sans), static_cast<int>(kReplacement))};
}

double advanceOf(Glyph glyph, double size) {
    int advance = 0, bearing = 0;
    stbtt_GetGlyphHMetrics(&font(glyph.face), glyph.index, &advance, &bearing);
    return static_cast<double>(static_cast<float>(advance) * scaleOf(glyph.face, size));
}

double kerningOf(Glyph first, Glyph second, double size) {
    if (first.face != second.face) return 0;
    const int kern = stbtt_GetGlyphKernAdvance(&font(first.face), first.index, second.index);
    return static_cast<double>(static_cast<float>(kern) * scaleOf(first.face, size));
}

Box inkOf(Glyph glyph, double size, double x, double y) {
    const double left = std::floor(x), top = std::floor(y);
    const float scale = scaleOf(glyph.face, size);
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&font(glyph.face), glyph.index, scale, scale,
                                    static_cast<float>(x - left), static_cast<float>(y - top), &x0,
                                    &y0, &x1, &y1);
    return {left + x0, top + y0, left + x1, top + y1};
}

void drawGlyph(Coverage& coverage, Glyph glyph, double size, double x, double y) {
    const Box ink = inkOf(glyph, size, x, y);
    if (ink.empty()) return;
    const int width = static_cast<int>(ink.width()), height = static_cast<int>(ink.height());
    std::vector<unsigned char> pixels(static_cast<std::size_t>(width) *
                                      static_cast<std::size_t>(height));
    const float scale = scaleOf(glyph.face, size);
    stbtt_MakeGlyphBitmapSubpixel(&font(glyph.face), pixels.data(), width, height, width, scale,
                                  scale, static_cast<float>(x - std::floor(x)),
                                  static_cast<float>(y - std::floor(y)), glyph.index);
    const int left = static_cast<int>(ink.left) - coverage.left;
    const int top = static_cast<int>(ink.top) - coverage.top;
    for (int row = std::max(0, -top); row < std::min(height, coverage.height - top); ++row)
        for (int column = std::max(0, -left); column < std::min(width, coverage.width - left);
             ++column) {
            unsigned char& target = coverage.values[static_cast<std::size_t>(top + row) *
                                                        static_cast<std::size_t>(coverage.width) +
                                                    static_cast<std::size_t>(left + column)];
            target = std::max(target, pixels[static_cast<std::size_t>(row * width + column)]);
        }
}

}  // namespace versorium
