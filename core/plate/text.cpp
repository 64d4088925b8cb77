// SPDX-License-Identifier: MIT
#include "plate/text.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace versorium {
namespace {

constexpr double kScriptSize = 0.72;    // of the size around it
constexpr double kRaise = 0.40;         // of superscripts, in ems of the size around them
constexpr double kDrop = 0.16;          // of subscripts
constexpr double kAscent = 0.76;        // of the letters b, d, l, in ems
constexpr double kDescent = 0.24;       // of g, p, q
constexpr double kLineGap = 0.12;       // least white between the ink of two lines, in ems
constexpr double kParagraphGap = 0.45;  // more between paragraphs, in ems
constexpr char32_t kCircumflex = 0x2c6;

using Items = std::span<const MarkupItem>;

// Sets items side by side on one baseline.
class Setter {
  public:
    Setter(const TextStyle& style, std::vector<PlacedGlyph>& out) : style_(style), out_(out) {}

    // Returns the pen's position after the items.
    double set(Items items, double size, double x, double y) {
        bool hasLast = false;
        Glyph last;
        for (const MarkupItem& item : items) {
            if (item.kind == MarkupItem::Kind::script) {
                x = script(item, size, x, y);
                hasLast = false;
            } else if (item.kind == MarkupItem::Kind::hat) {
                x = hat(item, size, x, y);
                hasLast = false;
            } else {
                const Glyph glyph =
                    glyphOf(item.bold ? boldOf(style_.face) : style_.face, item.letter);
                if (hasLast) x += kerningOf(last, glyph, size);
                if (item.kind == MarkupItem::Kind::letter) out_.push_back({glyph, size, x, y});
                x += advanceOf(glyph, size);
                last = glyph;
                hasLast = true;
            }
        }
        return x;
    }

  private:
    double script(const MarkupItem& item, double size, double x, double y) {
        const double small = std::min(size, std::max(kScriptSize * size, style_.smallest));
        // White beside an italic or upright letter, so that nothing touches.
        x += 0.04 * size;
        const double upper = set(item.upper, small, x, y - kRaise * size);
        const double lower = set(item.lower, small, x, y + kDrop * size);
        return std::max(upper, lower) + 0.05 * size;
    }

    double hat(const MarkupItem& item, double size, double x, double y) {
        const std::size_t first = out_.size();
        const double end = set(item.upper, size, x, y);
        Box ink;
        for (std::size_t i = first; i < out_.size(); ++i)
            ink.include(inkOf(out_[i].glyph, out_[i].size, out_[i].x, out_[i].y));
        const Face face = item.bold ? boldOf(style_.face) : style_.face;
        const Glyph mark = glyphOf(face, kCircumflex);
        const Box markInk = inkOf(mark, size, 0, 0);
        const double xHeight = inkOf(glyphOf(face, 'x'), size, 0, 0).height();
        // Its natural place is above an x; over taller letters it rises by the difference.
        const double rise = std::max(0.0, y - ink.top - xHeight);
        const double centre = 0.5 * (ink.left + ink.right);
        out_.push_back({mark, size, centre - 0.5 * (markInk.left + markInk.right), y - rise});
        return end;
    }

    const TextStyle& style_;
    std::vector<PlacedGlyph>& out_;
};

bool isSpace(const MarkupItem& item) { return item.kind == MarkupItem::Kind::space; }
bool isParagraph(const MarkupItem& item) { return item.kind == MarkupItem::Kind::paragraph; }

struct Line {
    Items items;
    bool begins = false;  // a paragraph
};

// Signs that a line should neither begin nor end with, where it can be helped.
bool binds(Items word) {
    if (word.size() != 1 || word[0].kind != MarkupItem::Kind::letter) return false;
    const std::u32string_view signs = U"=<>≤≥≈≠∈→↦+−×·±";
    return signs.find(word[0].letter) != std::u32string_view::npos;
}

class Breaker {
  public:
    Breaker(const Markup& markup, const TextStyle& style, double width)
        : markup_(markup), style_(style), width_(width) {}

    std::vector<Line> lines() {
        std::size_t i = 0;
        while (i < markup_.size()) {
            if (isParagraph(markup_[i])) {
                finishLine();
                begins_ = true;
            }
            if (isSpace(markup_[i]) || isParagraph(markup_[i])) {
                ++i;
                continue;
            }
            const std::size_t end = unitEnd(i);
            if (measure(i, end) <= width_) {
                add(i, end);
                i = end;
            }
            // A formula wider than the line breaks before its signs.
            while (i < end) {
                std::size_t part = wordEnd(i);
                if (part < end && binds(slice(i, part))) part = wordEnd(nextWord(part));
                add(i, part);
                i = nextWord(part);
            }
        }
        finishLine();
        return std::move(lines_);
    }

  private:
    std::size_t wordEnd(std::size_t i) const {
        while (i < markup_.size() && !isSpace(markup_[i]) && !isParagraph(markup_[i])) ++i;
        return i;
    }
    std::size_t nextWord(std::size_t i) const {
        while (i < markup_.size() && isSpace(markup_[i])) ++i;
        return i;
    }
    // A word together with what a sign binds to it: "α = 6".
    std::size_t unitEnd(std::size_t begin) const {
        std::size_t end = wordEnd(begin);
        bool bound = binds(slice(begin, end));
        while (true) {
            const std::size_t next = nextWord(end);
            if (next >= markup_.size() || isParagraph(markup_[next])) return end;
            const std::size_t after = wordEnd(next);
            const bool sign = binds(slice(next, after));
            if (!sign && !bound) return end;
            end = after;
            bound = sign;
        }
    }
    Items slice(std::size_t begin, std::size_t end) const {
        return Items(markup_).subspan(begin, end - begin);
    }
    double measure(std::size_t begin, std::size_t end) const {
        std::vector<PlacedGlyph> glyphs;
        return Setter(style_, glyphs).set(slice(begin, end), style_.size, 0, 0);
    }
    void add(std::size_t begin, std::size_t end) {
        if (open_ && measure(start_, end) <= width_) {
            end_ = end;
            return;
        }
        finishLine();
        // A word that is wider than the line is cut wherever it must be.
        while (measure(begin, end) > width_ && end - begin > 1) {
            std::size_t cut = begin + 1;
            while (cut + 1 < end && measure(begin, cut + 1) <= width_) ++cut;
            addLine(slice(begin, cut));
            begin = cut;
        }
        open_ = true;
        start_ = begin;
        end_ = end;
    }
    void finishLine() {
        if (open_) addLine(slice(start_, end_));
        open_ = false;
    }
    void addLine(Items items) {
        lines_.push_back({items, begins_ && !lines_.empty()});
        begins_ = false;
    }

    const Markup& markup_;
    const TextStyle& style_;
    double width_;
    std::vector<Line> lines_;
    bool open_ = false, begins_ = false;
    std::size_t start_ = 0, end_ = 0;
};

Markup asItStands(std::string_view text) {
    Markup markup;
    for (const char c : text) {
        const bool ascii = c > 0;
        if (c == ' ')
            markup.push_back(
                {.kind = MarkupItem::Kind::space, .letter = ' ', .upper = {}, .lower = {}});
        else
            markup.push_back(
                {.letter = ascii ? static_cast<char32_t>(c) : 0xfffd, .upper = {}, .lower = {}});
    }
    return markup;
}

Box inkOfGlyphs(const std::vector<PlacedGlyph>& glyphs) {
    Box ink;
    for (const PlacedGlyph& placed : glyphs)
        ink.include(inkOf(placed.glyph, placed.size, placed.x, placed.y));
    return ink;
}

}  // namespace

TextBlock layoutText(std::string_view text, const TextStyle& style, double maximalWidth) {
    Expected<Markup> parsed = parseMarkup(text);
    const Markup markup = parsed.ok() ? *std::move(parsed) : asItStands(text);
    TextBlock block;
    double lastDescent = 0;
    std::vector<std::pair<std::size_t, double>> lineWidths;  // number of glyphs, width
    block.smallest = style.size;
    for (const auto& [line, begins] : Breaker(markup, style, maximalWidth).lines()) {
        std::vector<PlacedGlyph> glyphs;
        lineWidths.emplace_back(0, Setter(style, glyphs).set(line, style.size, 0, 0));
        lineWidths.back().first = glyphs.size();
        block.width = std::max(block.width, lineWidths.back().second);
        const Box ink = inkOfGlyphs(glyphs);
        const double ascent = std::max(kAscent * style.size, -ink.top);
        const double baseline =
            block.lines == 0
                ? std::ceil(ascent)
                : std::ceil((begins ? kParagraphGap * style.size : 0) +
                            std::max(block.height - lastDescent + style.lineSpacing * style.size,
                                     block.height + kLineGap * style.size + ascent));
        for (PlacedGlyph& placed : glyphs) {
            placed.y = std::floor(baseline + placed.y + 0.5);
            block.smallest = std::min(block.smallest, placed.size);
            block.glyphs.push_back(placed);
        }
        // One pixel more, since scripts are rounded to whole rows.
        lastDescent = std::max(kDescent * style.size, ink.bottom + 1);
        block.height = baseline + lastDescent;
        if (block.lines == 0) block.baseline = baseline;
        ++block.lines;
    }
    std::size_t next = 0;
    for (const auto& [count, width] : lineWidths)
        for (std::size_t k = 0; k < count; ++k, ++next)
            if (style.centred) block.glyphs[next].x += 0.5 * (block.width - width);
    block.ink = inkOfGlyphs(block.glyphs);
    return block;
}

Box placedInk(const TextBlock& block, double x, double y, bool turned) {
    const double left = std::floor(x + 0.5), top = std::floor(y + 0.5);
    if (!turned) return block.ink.moved(left, top);
    // (u, v) of the block comes to (left + v, top - u).
    return {left + block.ink.top, top - block.ink.right, left + block.ink.bottom,
            top - block.ink.left};
}

Coverage textCoverage(const TextBlock& block, double x, double y, bool turned) {
    const Box& ink = block.ink;
    Coverage upright{.left = static_cast<int>(ink.left),
                     .top = static_cast<int>(ink.top),
                     .width = static_cast<int>(ink.width()),
                     .height = static_cast<int>(ink.height()),
                     .values = {}};
    upright.values.resize(static_cast<std::size_t>(upright.width) *
                          static_cast<std::size_t>(upright.height));
    for (const PlacedGlyph& placed : block.glyphs)
        drawGlyph(upright, placed.glyph, placed.size, placed.x, placed.y);
    const Box placed = placedInk(block, x, y, turned);
    if (!turned) {
        upright.left = static_cast<int>(placed.left);
        upright.top = static_cast<int>(placed.top);
        return upright;
    }
    Coverage out{.left = static_cast<int>(placed.left),
                 .top = static_cast<int>(placed.top),
                 .width = upright.height,
                 .height = upright.width,
                 .values = {}};
    out.values.resize(upright.values.size());
    for (int row = 0; row < out.height; ++row)
        for (int column = 0; column < out.width; ++column)
            out.values[static_cast<std::size_t>(row * out.width + column)] =
                upright.values[static_cast<std::size_t>(column * upright.width +
                                                        (upright.width - 1 - row))];
    return out;
}

}  // namespace versorium
