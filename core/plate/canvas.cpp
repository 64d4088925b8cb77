// SPDX-License-Identifier: MIT
#include "plate/canvas.h"

#include <algorithm>
#include <cmath>

namespace versorium {
namespace {

double cut(double x) { return x > 0 ? (x < 1 ? x : 1.0) : 0.0; }

// The part of a unit square that lies on the inner side of a straight edge. The edge's outward
// normal is (nx, ny), and the square's centre lies `inside` pixels within it. Seen along the normal
// a square is a trapezium, whose integral this is.
double coveredBy(double inside, double nx, double ny) {
    const double wide = std::max(std::abs(nx), std::abs(ny));
    const double narrow = std::min(std::abs(nx), std::abs(ny));
    const double flat = 0.5 * (wide - narrow), end = 0.5 * (wide + narrow);
    const double t = std::abs(inside);
    double half = 0.5;  // what lies between the edge through the centre and this one
    if (t <= flat)
        half = t / wide;
    else if (t < end)
        half = 0.5 - (end - t) * (end - t) / (2 * wide * narrow);
    return inside < 0 ? 0.5 - half : 0.5 + half;
}

struct Segment {
    Point a, b;
    // The part of the pixel around p that a stroke of this half width with round ends covers.
    double covers(Point p, double halfWidth) const {
        const double dx = b.x - a.x, dy = b.y - a.y;
        const double length2 = dx * dx + dy * dy;
        const double t = length2 > 0 ? cut(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2) : 0;
        double nx = p.x - a.x - t * dx, ny = p.y - a.y - t * dy;
        const double d = std::sqrt(nx * nx + ny * ny);
        if (d > halfWidth + 1) return 0;
        if (d > 1e-6) {
            nx /= d;
            ny /= d;
        } else {
            const double length = std::sqrt(length2);
            nx = length > 0 ? -dy / length : 1;
            ny = length > 0 ? dx / length : 0;
        }
        return coveredBy(halfWidth - d, nx, ny) - coveredBy(-halfWidth - d, nx, ny);
    }
};

// Cuts a polyline into the parts that are drawn.
std::vector<std::vector<Point>> dashed(const std::vector<Point>& points,
                                       const std::vector<double>& dashes) {
    std::vector<std::vector<Point>> parts;
    std::size_t index = 0;
    double left = dashes[0];
    bool on = true;
    std::vector<Point> part;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        Point p = points[i];
        const Point q = points[i + 1];
        double length = std::sqrt((q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y));
        if (on && part.empty()) part.push_back(p);
        while (length > left) {
            const double t = left / length;
            p = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
            length -= left;
            if (on) {
                part.push_back(p);
                parts.push_back(std::move(part));
                part = {};
            } else {
                part = {p};
            }
            on = !on;
            index = (index + 1) % dashes.size();
            left = dashes[index];
        }
        left -= length;
        if (on) part.push_back(q);
    }
    if (part.size() > 1) parts.push_back(std::move(part));
    return parts;
}

// The greatest coverage that any segment of a polyline gives to each pixel.
class StrokeMask {
  public:
    StrokeMask(const Box& box, double halfWidth)
        : left_(static_cast<int>(box.left)),
          top_(static_cast<int>(box.top)),
          half_(halfWidth),
          mask_({static_cast<int>(box.width()), static_cast<int>(box.height())}, 1, 0.0F) {}

    void segment(Point a, Point b) {
        const double reach = half_ + 1;
        const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
        // Walk along the longer axis and across only as far as the line reaches.
        const double slope =
            steep ? (b.x - a.x) / (b.y - a.y) : (b.x == a.x ? 0 : (b.y - a.y) / (b.x - a.x));
        const double across = reach * std::sqrt(1 + slope * slope) + std::abs(slope);
        const double low = (steep ? std::min(a.y, b.y) : std::min(a.x, b.x)) - reach;
        const double high = (steep ? std::max(a.y, b.y) : std::max(a.x, b.x)) + reach;
        const int offset = steep ? top_ : left_, count = steep ? mask_.height() : mask_.width();
        const int first = std::max(0, static_cast<int>(std::floor(low)) - offset);
        const int last = std::min(count - 1, static_cast<int>(std::floor(high)) - offset);
        for (int i = first; i <= last; ++i) {
            const double along = offset + i + 0.5;
            const double start = steep ? a.y : a.x;
            const double reachable = std::clamp(along, low + reach, high - reach);
            const double centre = (steep ? a.x : a.y) + slope * (reachable - start);
            row(steep, i, along, centre - across, centre + across, a, b);
        }
    }

    float at(int x, int y) const { return mask_.at(x - left_, y - top_); }

  private:
    void row(bool steep, int i, double along, double low, double high, Point a, Point b) {
        const int offset = steep ? left_ : top_, count = steep ? mask_.width() : mask_.height();
        const int first = std::max(0, static_cast<int>(std::floor(low)) - offset);
        const int last = std::min(count - 1, static_cast<int>(std::floor(high)) - offset);
        for (int j = first; j <= last; ++j) {
            const double other = offset + j + 0.5;
            const Point p = steep ? Point{other, along} : Point{along, other};
            const double coverage = Segment{a, b}.covers(p, half_);
            float& value = steep ? mask_.at(j, i) : mask_.at(i, j);
            value = std::max(value, static_cast<float>(coverage));
        }
    }

    int left_, top_;
    double half_;
    Raster<float> mask_;
};

Box wholePixels(const Box& box, Size size) {
    return {std::clamp(std::floor(box.left), 0.0, static_cast<double>(size.width)),
            std::clamp(std::floor(box.top), 0.0, static_cast<double>(size.height)),
            std::clamp(std::ceil(box.right), 0.0, static_cast<double>(size.width)),
            std::clamp(std::ceil(box.bottom), 0.0, static_cast<double>(size.height))};
}

}  // namespace

Canvas::Canvas(Size size, const Colour& background) : pixels_(size, 3) {
    std::vector<float>& values = pixels_.values();
    for (std::size_t i = 0; i < values.size(); i += 3) {
        values[i] = static_cast<float>(background.r);
        values[i + 1] = static_cast<float>(background.g);
        values[i + 2] = static_cast<float>(background.b);
    }
}

void Canvas::blend(int x, int y, const Colour& colour, double coverage) {
    float* pixel = pixels_.row(y) + std::ptrdiff_t{3} * x;
    const double alpha = coverage * colour.a;
    const double values[3] = {colour.r, colour.g, colour.b};
    for (int k = 0; k < 3; ++k)
        pixel[k] =
            static_cast<float>((1 - alpha) * static_cast<double>(pixel[k]) + alpha * values[k]);
}

template <class Inside>
void Canvas::cover(const Box& box, const Colour& colour, Inside coverageAt) {
    const Box area = wholePixels(box, size());
    for (int y = static_cast<int>(area.top); y < static_cast<int>(area.bottom); ++y)
        for (int x = static_cast<int>(area.left); x < static_cast<int>(area.right); ++x)
            if (const double coverage = coverageAt(x, y); coverage > 0)
                blend(x, y, colour, coverage);
}

void Canvas::fillRect(const Box& box, const Colour& colour) {
    cover(box, colour, [&](int x, int y) {
        const double across = std::min(box.right, x + 1.0) - std::max(box.left, double(x));
        const double down = std::min(box.bottom, y + 1.0) - std::max(box.top, double(y));
        return across > 0 && down > 0 ? across * down : 0;
    });
}

void Canvas::strokeRect(const Box& box, double width, const Colour& colour) {
    const Box outer = box.grown(width);
    fillRect({outer.left, outer.top, outer.right, box.top}, colour);
    fillRect({outer.left, box.bottom, outer.right, outer.bottom}, colour);
    fillRect({outer.left, box.top, box.left, box.bottom}, colour);
    fillRect({box.right, box.top, outer.right, box.bottom}, colour);
}

void Canvas::polyline(const std::vector<Point>& points, double width, const Colour& colour,
                      const std::vector<double>& dashes) {
    Box box;
    for (const Point& p : points) box.include(Box{p.x, p.y, p.x, p.y}.grown(0.5 * width + 1.5));
    const Box area = wholePixels(box, size());
    if (area.empty()) return;
    StrokeMask mask(area, 0.5 * width);
    double period = 0;
    for (const double dash : dashes) period += dash;
    // A period below a tenth of a pixel would look like a solid line of another colour.
    const auto parts =
        period > 0.1 ? dashed(points, dashes) : std::vector<std::vector<Point>>{points};
    for (const std::vector<Point>& part : parts)
        for (std::size_t i = 0; i + 1 < part.size(); ++i) mask.segment(part[i], part[i + 1]);
    cover(area, colour, [&](int x, int y) { return static_cast<double>(mask.at(x, y)); });
}

void Canvas::disc(Point centre, double radius, const Colour& colour) {
    const Box box = Box{centre.x, centre.y, centre.x, centre.y}.grown(radius + 1);
    const Segment point{centre, centre};
    cover(box, colour, [&](int x, int y) { return point.covers({x + 0.5, y + 0.5}, radius); });
}

void Canvas::polygon(const std::vector<Point>& corners, const Colour& colour) {
    Box box;
    double area = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point p = corners[i], q = corners[(i + 1) % corners.size()];
        box.include(Box{p.x, p.y, p.x, p.y}.grown(1));
        area += p.x * q.y - p.y * q.x;
    }
    const double side = area < 0 ? -1 : 1;
    cover(box, colour, [&](int x, int y) {
        // Of a pixel at a corner, each edge cuts off its part.
        double coverage = 1;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point p = corners[i], q = corners[(i + 1) % corners.size()];
            const double dx = q.x - p.x, dy = q.y - p.y, length = std::sqrt(dx * dx + dy * dy);
            if (length == 0) continue;
            const double cross = dx * (y + 0.5 - p.y) - dy * (x + 0.5 - p.x);
            coverage -= 1 - coveredBy(side * cross / length, dy / length, dx / length);
        }
        return coverage;
    });
}

void Canvas::picture(int left, int top, const Raster<float>& rgba) {
    for (int y = std::max(0, -top); y < std::min(rgba.height(), size().height - top); ++y)
        for (int x = std::max(0, -left); x < std::min(rgba.width(), size().width - left); ++x) {
            const float* p = rgba.row(y) + std::ptrdiff_t{4} * x;
            blend(left + x, top + y,
                  {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]),
                   static_cast<double>(p[3])},
                  1);
        }
}

void Canvas::text(const TextBlock& block, double x, double y, const Colour& colour, bool turned) {
    const Coverage coverage = textCoverage(block, x, y, turned);
    for (int row = 0; row < coverage.height; ++row)
        for (int column = 0; column < coverage.width; ++column) {
            const int value = coverage.values[static_cast<std::size_t>(row) *
                                                  static_cast<std::size_t>(coverage.width) +
                                              static_cast<std::size_t>(column)];
            const int px = coverage.left + column, py = coverage.top + row;
            if (value == 0 || px < 0 || py < 0 || px >= size().width || py >= size().height)
                continue;
            blend(px, py, colour, value / 255.0);
        }
}

}  // namespace versorium
