// SPDX-License-Identifier: MIT
#include "plate/panel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "plate/ticks.h"

namespace versorium {
namespace {

constexpr double kCapHeight = 0.73;  // of digits and capitals, in ems
constexpr int kMostTicks = 7;

class Builder {
  public:
    Builder(const PanelContent& content, Size picture, const Metrics& metrics, const Theme& theme)
        : content_(content),
          width_(picture.width),
          height_(picture.height),
          m_(metrics),
          theme_(theme) {}

    Sheet build() {
        const Box frame{0, 0, width_, height_};
        outline("picture", frame);
        if (content_.plot)
            sheet_.mark(frame, [frame, content = &content_, m = m_, theme = theme_](
                                   Canvas& canvas, double dx, double dy) {
                drawPlot(canvas, *content->plot, *content, frame.moved(dx, dy), m, theme);
            });
        if (content_.x) horizontalAxis(*content_.x);
        if (content_.y) verticalAxis(*content_.y);
        if (content_.bar) colourBar(*content_.bar);
        if (content_.versorKey) versorKey();
        legend();
        heading();
        return std::move(sheet_);
    }

  private:
    TextStyle style(double size, Face face = Face::sans) const {
        return {.face = face, .size = size, .smallest = m_.smallest};
    }
    TextBlock tickBlock(const std::string& label) const {
        return layoutText(label, style(m_.tick));
    }
    void put(const std::string& name, const TextBlock& block, double x, double y,
             const Colour& colour, bool turned = false) {
        sheet_.text(name, block, x, y, colour, m_.point, turned);
    }
    void fill(const Box& box, const Colour& colour) {
        sheet_.mark(box, [box, colour](Canvas& canvas, double dx, double dy) {
            canvas.fillRect(box.moved(dx, dy), colour);
        });
    }
    void outline(const std::string& name, const Box& box) {
        sheet_.reserve(name, box.grown(m_.lineWidth));
        sheet_.mark(box.grown(m_.lineWidth), [box, width = m_.lineWidth, colour = theme_.line](
                                                 Canvas& canvas, double dx, double dy) {
            canvas.strokeRect(box.moved(dx, dy), width, colour);
        });
    }
    double tickLength(const Tick& tick) const {
        return tick.label.empty() ? std::floor(0.6 * m_.tickLength + 0.5) : m_.tickLength;
    }

    void horizontalAxis(const PanelAxis& axis) {
        const TickSet set =
            fittingTicks(axis.scale, kMostTicks, width_, 0.8 * m_.tick,
                         [&](const std::string& label) { return tickBlock(label).width; });
        const double edge = height_ + m_.lineWidth;
        double bottom = edge;
        int count = 0;
        for (const Tick& tick : set.ticks) {
            // The outermost ticks continue the outline's sides.
            const double left =
                std::floor(tick.position * (width_ + m_.lineWidth) - m_.lineWidth + 0.5);
            fill({left, edge, left + m_.lineWidth, edge + tickLength(tick)}, theme_.line);
            if (tick.label.empty()) continue;
            const TextBlock block = tickBlock(tick.label);
            const double top = edge + m_.tickLength + m_.tickGap - block.baseline +
                               kCapHeight * m_.tick + superscriptRoom(block);
            put("x tick " + std::to_string(++count), block,
                left + 0.5 * (m_.lineWidth - block.width), top, theme_.text);
            bottom = std::max(bottom, placedInk(block, 0, top).bottom);
        }
        const std::string name = axisName(axis.name, set);
        if (name.empty()) return;
        const TextBlock block = layoutText(name, style(m_.label), width_);
        put("x name", block, 0.5 * (width_ - block.width), bottom + 0.45 * m_.label - block.ink.top,
            theme_.text);
    }

    // How far a block reaches above the capitals of its first line.
    double superscriptRoom(const TextBlock& block) const {
        return std::max(0.0, block.baseline - kCapHeight * m_.tick - block.ink.top);
    }

    void verticalTicks(const TickSet& set, const std::string& name, double edge, bool leftward,
                       Box& ink) {
        int count = 0;
        for (const Tick& tick : set.ticks) {
            const double top =
                std::floor((1 - tick.position) * (height_ + m_.lineWidth) - m_.lineWidth + 0.5);
            const double length = tickLength(tick);
            fill({leftward ? edge - length : edge, top, leftward ? edge : edge + length,
                  top + m_.lineWidth},
                 theme_.line);
            if (tick.label.empty()) continue;
            const TextBlock block = tickBlock(tick.label);
            const double reach = m_.tickLength + m_.tickGap;
            const double x = leftward ? edge - reach - block.width : edge + reach;
            const double y = top + 0.5 * m_.lineWidth + 0.5 * kCapHeight * m_.tick - block.baseline;
            put(name + std::to_string(++count), block, x, y, theme_.text);
            ink.include(placedInk(block, x, y));
        }
    }

    TickSet verticalTickSet(const Scale& scale) const {
        return fittingTicks(
            scale, kMostTicks, height_, 0.9 * m_.tick,
            [&](const std::string& label) { return tickBlock(label).ink.height(); });
    }

    void verticalAxis(const PanelAxis& axis) {
        const TickSet set = verticalTickSet(axis.scale);
        Box ink;
        verticalTicks(set, "y tick ", -m_.lineWidth, true, ink);
        const std::string name = axisName(axis.name, set);
        if (name.empty()) return;
        const double right =
            (ink.empty() ? -m_.lineWidth - m_.tickLength : ink.left) - 0.45 * m_.label;
        TextBlock block = layoutText(name, style(m_.label));
        if (block.lines == 1 && block.width <= 1.6 * m_.label) {
            put("y name", block, right - block.ink.right,
                0.5 * (height_ + kCapHeight * m_.label) - block.baseline, theme_.text);
            return;
        }
        block = layoutText(name, style(m_.label), height_);
        put("y name", block, right - block.ink.bottom,
            0.5 * (height_ + block.ink.left + block.ink.right), theme_.text, true);
    }

    // Ticks on the right of a bar, and the name beyond them.
    void barAxis(const Scale& scale, const std::string& name, double edge) {
        const TickSet set = verticalTickSet(scale);
        Box ink;
        verticalTicks(set, "bar tick ", edge, false, ink);
        const std::string text = axisName(name, set);
        if (text.empty()) return;
        const TextBlock block = layoutText(text, style(m_.label), height_);
        const double left = (ink.empty() ? edge + m_.tickLength : ink.right) + 0.45 * m_.label;
        put("bar name", block, left - block.ink.top,
            0.5 * (height_ + block.ink.left + block.ink.right), theme_.text, true);
    }

    void colourBar(const ColourBar& bar) {
        // Beside the picture even where a label of the x axis reaches beyond its corner: that is
        // further down.
        const double left = std::ceil(width_ + m_.lineWidth + 1.1 * m_.label);
        const Box box{left, 0, left + m_.barWidth, height_};
        sheet_.mark(box, [box, palette = bar.palette](Canvas& canvas, double dx, double dy) {
            for (double y = box.top; y < box.bottom; ++y) {
                const double t = 1 - (y + 0.5 - box.top) / box.height();
                canvas.fillRect(Box{box.left, y, box.right, y + 1}.moved(dx, dy), palette.at(t));
            }
        });
        outline("bar", box);
        barAxis(bar.scale, bar.name, box.right + m_.lineWidth);
    }

    void versorKey() {
        const double width = std::floor(0.75 * m_.barWidth + 0.5), gap = std::ceil(0.45 * width);
        // Its letters stand as low as the labels of the x axis, so beyond the last of them.
        const double start = std::ceil(std::max(width_ + m_.lineWidth + 1.1 * m_.label,
                                                sheet_.extent().right + 0.6 * m_.label));
        double left = start;
        const std::array<const char*, 3> names = {"i", "j", "k"};
        for (std::size_t part = 0; part < 3; ++part) {
            const Box box{left, 0, left + width, height_};
            sheet_.mark(box, [box, part](Canvas& canvas, double dx, double dy) {
                for (double y = box.top; y < box.bottom; ++y) {
                    const double t = 1 - (y + 0.5 - box.top) / box.height();
                    const Colour colour = colourFromSrgb(part == 0 ? t : 0.5, part == 1 ? t : 0.5,
                                                         part == 2 ? t : 0.5);
                    canvas.fillRect(Box{box.left, y, box.right, y + 1}.moved(dx, dy), colour);
                }
            });
            outline("key " + std::string(names[part]), box);
            const TextBlock block = layoutText(names[part], style(m_.label));
            put("key name " + std::string(names[part]), block,
                left + 0.5 * width - 0.5 * (block.ink.left + block.ink.right),
                height_ + m_.lineWidth + 0.5 * m_.label - block.baseline + kCapHeight * m_.label,
                theme_.text);
            left = box.right + gap + 2 * m_.lineWidth;
        }
        barAxis({ScaleKind::linear, -1, 1}, "parts of the versor", left - gap - m_.lineWidth);
    }

    void legend() {
        if (content_.legend.empty()) return;
        const double right = std::max(width_, sheet_.extent().right);
        const double swatch = std::floor(m_.label), gap = 0.5 * m_.label;
        double y = std::ceil(sheet_.extent().bottom + 0.9 * m_.label);
        double x = 0, bottom = y;
        int count = 0;
        for (const LegendRow& row : content_.legend) {
            const double sample = row.line ? 2.6 * swatch : swatch;
            TextBlock block =
                layoutText(row.text, style(m_.label), std::max(swatch, right - sample - gap));
            if (x > 0 && x + sample + gap + block.width > right) {
                x = 0;
                y = std::ceil(bottom + 0.5 * m_.label);
            }
            const double middle = y + block.baseline - 0.5 * kCapHeight * m_.label;
            const double top = std::floor(middle - 0.5 * swatch + 0.5);
            const Box box{x, top, std::floor(x + sample), top + swatch};
            ++count;
            if (row.line) {
                sheet_.reserve("swatch " + std::to_string(count), box);
                sheet_.mark(
                    box, [row, box, m = m_, theme = theme_](Canvas& canvas, double dx, double dy) {
                        drawSample(canvas, row, box.moved(dx, dy), m, theme);
                    });
            } else {
                const Box inner = box.grown(-m_.lineWidth);
                fill(inner, row.colour);
                outline("swatch " + std::to_string(count), inner);
            }
            put("legend " + std::to_string(count), block, x + sample + gap, y, theme_.text);
            bottom = std::max({bottom, y + block.height, box.bottom});
            x = std::ceil(x + sample + gap + block.width + 1.6 * m_.label);
        }
    }

    void heading() {
        if (content_.heading.empty()) return;
        const double right = std::max(width_, sheet_.extent().right);
        const TextBlock block = layoutText(content_.heading, style(m_.header), right);
        // Half a tick label rises above the frame; the heading keeps clear of it everywhere, so
        // that all headings of a row stand at the same height.
        const double bottom = -m_.lineWidth - 0.5 * m_.tick - 0.25 * m_.header;
        put("heading", block, 0, std::floor(bottom - std::max(block.height, block.ink.bottom)),
            theme_.text);
    }

    const PanelContent& content_;
    double width_, height_;
    const Metrics& m_;
    const Theme& theme_;
    Sheet sheet_;
};

}  // namespace

Sheet buildPanel(const PanelContent& content, Size picture, const Metrics& metrics,
                 const Theme& theme) {
    return Builder(content, picture, metrics, theme).build();
}

}  // namespace versorium
