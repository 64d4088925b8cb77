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
    Builder(const PanelContent& content, Size picture, double headingRight, const Metrics& metrics,
            const Theme& theme)
        : content_(content),
          width_(picture.width),
          height_(picture.height),
          headingRight_(headingRight),
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
        for (const PanelCurves& part : content_.overlay) overlaid(part);
        for (const PanelMark& mark : content_.marks) marked(mark);
        double nameTop = 0;
        std::string name;
        if (content_.x) name = horizontalAxis(*content_.x, nameTop);
        if (content_.y) verticalAxis(*content_.y);
        if (content_.bar) colourBar(*content_.bar);
        if (content_.versorKey) versorKey();
        if (!name.empty()) horizontalName(name, nameTop);
        legend();
        heading();
        return std::move(sheet_);
    }

  private:
    TextStyle style(double size, Face face = Face::sans) const {
        return {.face = face, .size = size, .smallest = m_.smallest};
    }
    TextStyle centredStyle() const {
        TextStyle centred = style(m_.label);
        centred.centred = true;
        return centred;
    }
    // Turned names may reach beyond a low picture: the corners beside it are free, and width is
    // dearer than height.
    double turnedRoom() const { return std::max(height_ + 3 * m_.label, 12 * m_.label); }
    TextBlock tickBlock(const std::string& label) const {
        return layoutText(content_.words.number(label), style(m_.tick));
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
    void overlaid(const PanelCurves& part) {
        const double width = 0.55 * m_.plotLine;
        // A cloud of points is drawn finer than a few of them.
        constexpr std::size_t kCloud = 100;
        const bool cloud = part.points && !part.curves.empty() && part.curves[0].size() > kCloud;
        const double radius = (cloud ? 0.12 : 0.3) * m_.label;
        sheet_.mark({0, 0, width_, height_}, [=, &part, w = width_, h = height_, theme = theme_](
                                                 Canvas& canvas, double dx, double dy) {
            for (const std::vector<Point>& curve : part.curves) {
                std::vector<Point> pixels;
                for (const Point& p : curve) pixels.push_back({dx + p.x * w, dy + (1 - p.y) * h});
                if (!part.points) {
                    if (part.rim) canvas.polyline(pixels, 2.6 * width, theme.background);
                    canvas.polyline(pixels, part.rim ? 1.5 * width : width, part.look.colour);
                    continue;
                }
                for (const Point& p : pixels) {
                    drawMarker(canvas, part.look.marker, p, 1.5 * radius, theme.background,
                               theme.background);
                    drawMarker(canvas, part.look.marker, p, radius, part.look.colour,
                               theme.background);
                }
            }
        });
    }

    // A marker on a rim of the background, so that it shows on any picture, and its label on a
    // ground of its own. Both are cut at the picture's border by standing inside it.
    void marked(const PanelMark& mark) {
        if (!(mark.x >= 0 && mark.x <= 1 && mark.y >= 0 && mark.y <= 1)) return;
        const double radius = 0.42 * m_.label;
        const double reach = 2.0 * radius;
        if (width_ < 3 * reach || height_ < 3 * reach) return;
        const Point at{std::clamp(mark.x * width_, reach, width_ - reach),
                       std::clamp((1 - mark.y) * height_, reach, height_ - reach)};
        const TextBlock block = layoutText(mark.label, style(m_.tick, Face::sansBold));
        const double gap = 0.2 * m_.tick;
        const double wide = block.ink.width() + 2 * gap, high = kCapHeight * m_.tick + 2 * gap;
        // To the upper right, else to the left or below where there is no room.
        const double left =
            at.x + reach + wide <= width_ ? at.x + 0.8 * reach : at.x - 0.8 * reach - wide;
        const double top =
            at.y - 0.4 * reach - high >= 0 ? at.y - 0.4 * reach - high : at.y + 0.4 * reach;
        const Box ground{std::floor(left), std::floor(top), std::ceil(left + wide),
                         std::ceil(top + high)};
        sheet_.mark({0, 0, width_, height_}, [=, look = mark.look, theme = theme_](
                                                 Canvas& canvas, double dx, double dy) {
            const Point centre{at.x + dx, at.y + dy};
            if (block.lines > 0) {
                canvas.fillRect(ground.moved(dx, dy), theme.background);
                canvas.text(block, dx + left + gap - block.ink.left,
                            dy + top + high - gap - block.baseline, theme.text);
            }
            drawMarker(canvas, look.marker, centre, 1.55 * radius, theme.background,
                       theme.background);
            drawMarker(canvas, look.marker, centre, radius, look.colour, theme.background);
        });
    }

    double tickLength(const Tick& tick) const {
        return tick.label.empty() ? std::floor(0.6 * m_.tickLength + 0.5) : m_.tickLength;
    }

    // Ticks and their labels; returns the name for below them, which waits until it is known how
    // far the panel reaches.
    std::string horizontalAxis(const PanelAxis& axis, double& bottom) {
        const TickSet set =
            fittingTicks(axis.scale, kMostTicks, width_, 0.8 * m_.tick,
                         [&](const std::string& label) { return tickBlock(label).width; });
        const double edge = height_ + m_.lineWidth;
        bottom = edge;
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
        return axisName(axis.name, set, content_.words);
    }

    // In the middle below the picture. A long name may use the room below the y axis and the bar
    // where that is free, and stands below everything else where even the middle is not.
    void horizontalName(const std::string& name, double tickBottom) {
        const double gap = 0.45 * m_.label;
        const double left = std::min(0.0, sheet_.extent().left);
        const double right = std::max(width_, sheet_.extent().right);
        const double below = sheet_.extent().bottom;
        struct Place {
            double left, right, top;
        };
        for (const Place& place : {Place{left, right, tickBottom}, Place{0, width_, tickBottom},
                                   Place{left, right, below}}) {
            const TextBlock block = layoutText(name, centredStyle(), place.right - place.left);
            const double x = std::clamp(0.5 * (width_ - block.width), place.left,
                                        std::max(place.left, place.right - block.width));
            const double y = place.top + gap - block.ink.top;
            if (place.top != below && sheet_.collides(placedInk(block, x, y).grown(0.5 * gap)))
                continue;
            put("x name", block, x, y, theme_.text);
            return;
        }
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
        const std::string name = axisName(axis.name, set, content_.words);
        if (name.empty()) return;
        // Left of everything so far: labels of both axes. Above and below, the corner is free.
        const double right = std::floor(sheet_.extent().left - 0.45 * m_.label);
        TextBlock block = layoutText(name, style(m_.label));
        if (block.lines == 1 && block.width <= 1.6 * m_.label) {
            put("y name", block, right - block.ink.right,
                0.5 * (height_ + kCapHeight * m_.label) - block.baseline, theme_.text);
            return;
        }
        block = layoutText(name, centredStyle(), turnedRoom());
        put("y name", block, right - block.ink.bottom,
            0.5 * (height_ + block.ink.left + block.ink.right), theme_.text, true);
    }

    // Ticks on the right of a bar. Its name stands below it where it fits beside the labels of the
    // x axis, else it is turned and stands beyond the ticks.
    void barAxis(const Scale& scale, const std::string& name, const Box& bar, double axisRight) {
        const double edge = bar.right + m_.lineWidth;
        const TickSet set = fittingTicks(
            scale, kMostTicks, height_, 0.9 * m_.tick,
            [&](const std::string& label) { return tickBlock(label).ink.height(); }, true);
        Box ink;
        verticalTicks(set, "bar tick ", edge, false, ink);
        const std::string text = axisName(name, set, content_.words);
        if (text.empty()) return;
        const double right = ink.empty() ? edge + m_.tickLength : ink.right;
        TextBlock block = layoutText(text, style(m_.label));
        const double middle = std::max(bar.left + 0.5 * block.width, 0.5 * (bar.left + right));
        if (block.width <= right - bar.left + m_.label &&
            middle - 0.5 * block.width >=
                std::max(axisRight - m_.lineWidth, width_) + 0.5 * m_.label) {
            const double top = std::max(ink.bottom, height_ + m_.lineWidth) + 0.4 * m_.label;
            put("bar name", block, middle - 0.5 * block.width, top - block.ink.top, theme_.text);
            return;
        }
        block = layoutText(text, centredStyle(), turnedRoom());
        put("bar name", block, right + 0.45 * m_.label - block.ink.top,
            0.5 * (height_ + block.ink.left + block.ink.right), theme_.text, true);
    }

    void colourBar(const ColourBar& bar) {
        // Where the last label of the x axis reaches beyond the corner, it stands lower than a bar.
        const double left = std::ceil(width_ + m_.lineWidth + m_.label);
        const Box box{left, 0, left + m_.barWidth, height_};
        const double axisRight = sheet_.extent().right;
        gradient("bar", box, [palette = bar.palette](double t) { return palette.at(t); });
        barAxis(bar.scale, bar.name, box, axisRight);
    }

    void gradient(const std::string& name, const Box& box, std::function<Colour(double)> at) {
        sheet_.mark(box, [box, at = std::move(at)](Canvas& canvas, double dx, double dy) {
            for (double y = box.top; y < box.bottom; ++y) {
                const double t = 1 - (y + 0.5 - box.top) / box.height();
                canvas.fillRect(Box{box.left, y, box.right, y + 1}.moved(dx, dy), at(t));
            }
        });
        outline(name, box);
    }

    // Three bars, one for each imaginary part from -1 to 1, the other two being 0.
    void versorKey() {
        const double width = std::floor(0.6 * m_.barWidth + 0.5);
        const double step = width + 2 * m_.lineWidth + std::ceil(0.4 * width);
        // Its letters stand as low as the labels of the x axis, so beyond the last of them.
        double left = std::ceil(
            std::max(width_ + m_.lineWidth + m_.label, sheet_.extent().right + 0.5 * m_.label));
        Box box;
        for (int part = 0; part < 3; ++part, left += step) {
            const std::string name(1, "ijk"[part]);
            box = {left, 0, left + width, height_};
            gradient("key " + name, box, [part](double t) {
                return colourFromSrgb(part == 0 ? t : 0.5, part == 1 ? t : 0.5,
                                      part == 2 ? t : 0.5);
            });
            const TextBlock block = layoutText(name, style(m_.label));
            put("key name " + name, block,
                left + 0.5 * width - 0.5 * (block.ink.left + block.ink.right),
                height_ + m_.lineWidth + 0.5 * m_.label - block.ink.top, theme_.text);
        }
        Box ink;
        const TickSet set =
            fittingTicks({ScaleKind::linear, -1, 1}, 3, height_, 0.9 * m_.tick,
                         [&](const std::string& label) { return tickBlock(label).ink.height(); });
        verticalTicks(set, "key tick ", box.right + m_.lineWidth, false, ink);
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
        const double right = std::max({width_, sheet_.extent().right, headingRight_});
        const TextBlock letter = layoutText(content_.letter, style(m_.header, Face::sansBold));
        double indent = letter.lines == 0 ? 0 : std::ceil(letter.width + 0.6 * m_.header);
        const double signRadius = 0.34 * m_.header, signMiddle = indent + 1.3 * signRadius;
        if (content_.sign) indent += std::ceil(2.6 * signRadius + 0.5 * m_.header);
        const TextBlock title =
            layoutText(content_.title, style(m_.header), std::max(m_.header, right - indent));
        if (letter.lines + title.lines == 0) return;
        // Half a tick label rises above the frame; the heading keeps clear of it everywhere, so
        // that all headings of a row stand at the same height.
        double bottom = -m_.lineWidth - 0.5 * m_.tick - 0.25 * m_.header;
        const double height = std::max({letter.height, title.height, title.ink.bottom});
        const Box room{0, bottom - height, indent + title.width, bottom};
        if (sheet_.collides(room)) bottom = sheet_.extent().top - 0.25 * m_.header;
        const double top = std::floor(bottom - height);
        const double first = std::max(letter.baseline, title.baseline);
        if (letter.lines > 0) put("letter", letter, 0, top + first - letter.baseline, theme_.text);
        if (title.lines > 0)
            put("heading", title, indent, top + first - title.baseline, theme_.text);
        if (!content_.sign) return;
        const Point at{signMiddle, top + first - 0.5 * kCapHeight * m_.header};
        const double reach = 1.3 * signRadius;
        const Box box{at.x - reach, at.y - reach, at.x + reach, at.y + reach};
        sheet_.reserve("sign", box);
        sheet_.mark(
            box, [=, look = *content_.sign, theme = theme_](Canvas& canvas, double dx, double dy) {
                drawMarker(canvas, look.marker, {at.x + dx, at.y + dy}, signRadius, look.colour,
                           theme.background);
            });
    }

    const PanelContent& content_;
    double width_, height_, headingRight_;
    const Metrics& m_;
    const Theme& theme_;
    Sheet sheet_;
};

}  // namespace

Sheet buildPanel(const PanelContent& content, Size picture, double headingRight,
                 const Metrics& metrics, const Theme& theme) {
    return Builder(content, picture, headingRight, metrics, theme).build();
}

}  // namespace versorium
