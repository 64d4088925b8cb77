// SPDX-License-Identifier: MIT
// Line plots: ranges from data, clipping, dashes and markers.
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/clip.h"
#include "math/elementary.h"
#include "plate/panel.h"

namespace versorium {
namespace {

// Dashes in line widths; round ends add one width to each dash.
const std::array<std::vector<double>, 6> kDashes = {
    std::vector<double>{}, {5, 3.5},   {0.05, 2.6},
    {8, 3, 0.05, 3},       {2.5, 2.5}, {8, 3, 0.05, 2.6, 0.05, 3}};
constexpr double kPad = 0.04;  // of the range, around the data

bool usable(const PlotAxis& axis, double value) { return axis.scale != "log" || value > 0; }

Scale axisScale(const PlotAxis& axis, double low, double high) {
    const bool logarithmic = axis.scale == "log";
    const bool none = !(low <= high);
    if (none) {
        low = logarithmic ? 1 : 0;
        high = logarithmic ? 10 : 1;
    }
    if (logarithmic) {
        const double span = high > low ? log(high / low) : 1;
        const double pad = none ? 1 : exp(kPad * span);
        low /= pad;
        high *= pad;
    } else {
        // A constant gets room in proportion to its size.
        const double span = high > low ? high - low : std::max(1.0, std::abs(high));
        if (!none) low -= kPad * span;
        if (!none) high += kPad * span;
    }
    if (axis.low) low = *axis.low;
    if (axis.high) high = *axis.high;
    if (!(low < high)) {
        if (axis.low)
            high = logarithmic ? low * 10 : low + std::max(1.0, std::abs(low));
        else
            low = logarithmic ? high / 10 : high - std::max(1.0, std::abs(high));
    }
    return {logarithmic ? ScaleKind::log : ScaleKind::linear, low, high};
}

// The position without the cut to [0, 1].
double place(const Scale& scale, double value) {
    if (scale.kind == ScaleKind::log) return log(value / scale.low) / log(scale.high / scale.low);
    return (value - scale.low) / (scale.high - scale.low);
}

// The part of a segment inside the box. False when there is none.
bool clip(const Box& box, Point& a, Point& b) {
    const auto part =
        clipSegment({a.x, a.y}, {b.x, b.y}, {box.left, box.top}, {box.right, box.bottom});
    if (!part) return false;
    const Point start = a;
    const double dx = b.x - a.x, dy = b.y - a.y;
    a = {start.x + part->from * dx, start.y + part->from * dy};
    b = {start.x + part->to * dx, start.y + part->to * dy};
    return true;
}

void strokeSeries(Canvas& canvas, const SeriesLook& look, const std::vector<Point>& points,
                  double width) {
    std::vector<double> dashes = look.dashes;
    for (double& dash : dashes) dash *= width;
    canvas.polyline(points, width, look.colour, dashes);
}

}  // namespace

void drawMarker(Canvas& canvas, int marker, Point p, double r, const Colour& colour,
                const Colour& background) {
    const double s = 0.9 * r;
    switch (marker) {
        case 1:
            canvas.fillRect({p.x - s, p.y - s, p.x + s, p.y + s}, colour);
            break;
        case 2:
            canvas.polygon({{p.x, p.y - 1.2 * r},
                            {p.x + 1.1 * r, p.y + 0.8 * r},
                            {p.x - 1.1 * r, p.y + 0.8 * r}},
                           colour);
            break;
        case 3:
            canvas.polygon({{p.x, p.y - 1.3 * r},
                            {p.x + 1.3 * r, p.y},
                            {p.x, p.y + 1.3 * r},
                            {p.x - 1.3 * r, p.y}},
                           colour);
            break;
        case 4:
            canvas.polygon({{p.x, p.y + 1.2 * r},
                            {p.x + 1.1 * r, p.y - 0.8 * r},
                            {p.x - 1.1 * r, p.y - 0.8 * r}},
                           colour);
            break;
        default:
            canvas.disc(p, r, colour);
            if (marker == 5) canvas.disc(p, 0.5 * r, background);
    }
}

SeriesLook seriesLook(const Theme& theme, std::size_t index) {
    const std::size_t count = theme.series.size();
    // After six lines the colours come again with other dashes.
    const std::size_t other = (index + index / count) % count;
    return {theme.series[index % count], kDashes[other], static_cast<int>(other)};
}

PanelContent plotContent(const LinePlot& plot, const Words& words, const Theme& theme) {
    double low[2] = {1e308, 1e308}, high[2] = {-1e308, -1e308};
    for (const PlotLine& line : plot.lines)
        for (std::size_t i = 0; i < line.x.size(); ++i) {
            if (!usable(plot.x, line.x[i]) || !usable(plot.y, line.y[i])) continue;
            low[0] = std::min(low[0], line.x[i]);
            high[0] = std::max(high[0], line.x[i]);
            low[1] = std::min(low[1], line.y[i]);
            high[1] = std::max(high[1], line.y[i]);
        }
    PanelContent content;
    content.words = words;
    content.plot = &plot;
    content.aspect = plot.aspect;
    content.x = PanelAxis{plot.x.name, axisScale(plot.x, low[0], high[0])};
    content.y = PanelAxis{plot.y.name, axisScale(plot.y, low[1], high[1])};
    for (std::size_t i = 0; i < plot.lines.size(); ++i) {
        const PlotLine& line = plot.lines[i];
        if (line.name.empty()) continue;
        const SeriesLook look = seriesLook(theme, i);
        content.legend.push_back({.colour = look.colour,
                                  .line = look,
                                  .stroke = line.style != "points",
                                  .points = line.style != "line",
                                  .text = line.name});
    }
    return content;
}

void drawPlot(Canvas& canvas, const LinePlot& plot, const PanelContent& content, const Box& frame,
              const Metrics& metrics, const Theme& theme) {
    const double reach = 0.5 * metrics.plotLine;
    // Strokes stay inside the frame, their width included.
    const Box inner = frame.grown(-reach);
    const double radius = 1.7 * metrics.plotLine;
    for (std::size_t l = 0; l < plot.lines.size(); ++l) {
        const PlotLine& line = plot.lines[l];
        const SeriesLook look = seriesLook(theme, l);
        std::vector<Point> points;
        std::vector<bool> good;
        for (std::size_t i = 0; i < line.x.size(); ++i) {
            good.push_back(usable(plot.x, line.x[i]) && usable(plot.y, line.y[i]));
            points.push_back(
                good.back()
                    ? Point{frame.left + frame.width() * place(content.x->scale, line.x[i]),
                            frame.bottom - frame.height() * place(content.y->scale, line.y[i])}
                    : Point{});
        }
        std::vector<Point> part;
        for (std::size_t i = 0; line.style != "points" && i + 1 < points.size(); ++i) {
            Point a = points[i], b = points[i + 1];
            const bool visible = good[i] && good[i + 1] && clip(inner, a, b);
            const bool joins =
                visible && !part.empty() && part.back().x == a.x && part.back().y == a.y;
            if (!joins && !part.empty()) {
                strokeSeries(canvas, look, part, metrics.plotLine);
                part.clear();
            }
            if (!visible) continue;
            if (part.empty()) part.push_back(a);
            part.push_back(b);
        }
        if (!part.empty()) strokeSeries(canvas, look, part, metrics.plotLine);
        // A marker on the border reaches beyond it, by less than a tick does.
        const Box room = frame.grown(0.5);
        for (std::size_t i = 0; line.style != "line" && i < points.size(); ++i) {
            const Point p = points[i];
            if (good[i] && p.x >= room.left && p.x <= room.right && p.y >= room.top &&
                p.y <= room.bottom)
                drawMarker(canvas, look.marker, p, radius, look.colour, theme.background);
        }
    }
}

void drawSample(Canvas& canvas, const LegendRow& row, const Box& box, const Metrics& metrics,
                const Theme& theme) {
    const double y = 0.5 * (box.top + box.bottom), reach = 0.5 * metrics.plotLine;
    if (row.stroke)
        strokeSeries(canvas, *row.line, {{box.left + reach, y}, {box.right - reach, y}},
                     metrics.plotLine);
    if (row.points)
        drawMarker(canvas, row.line->marker, {0.5 * (box.left + box.right), y},
                   1.7 * metrics.plotLine, row.colour, theme.background);
}

}  // namespace versorium
