// SPDX-License-Identifier: MIT
#include "render/outline.h"

#include <algorithm>
#include <cmath>

namespace versorium {
namespace {

// `over` on top of an `under` that may be transparent itself (Porter and Duff).
Colour onTop(const Colour& over, const Colour& under) {
    const double rest = (1 - over.a) * under.a, alpha = over.a + rest;
    if (alpha == 0) return under;
    return {(over.a * over.r + rest * under.r) / alpha, (over.a * over.g + rest * under.g) / alpha,
            (over.a * over.b + rest * under.b) / alpha, alpha};
}

}  // namespace

void drawOutline(const Raster<unsigned char>& sides, int perSide, double width,
                 const Colour& colour, Raster<float>& picture) {
    const int w = sides.width(), h = sides.height();
    // How much of each sample the line covers, in 255ths: all of it where its centre is more than
    // half a sample within the line, half of it where the line ends at its centre.
    Raster<unsigned char> line(sides.size(), 1);
    const double radius = std::max(0.5, 0.5 * width * perSide);
    const int reach = static_cast<int>(std::ceil(radius)) + 1;
    const auto stamp = [&](double x, double y) {
        for (int sy = std::max(0, static_cast<int>(y) - reach);
             sy <= std::min(h - 1, static_cast<int>(y) + reach); ++sy)
            for (int sx = std::max(0, static_cast<int>(x) - reach);
                 sx <= std::min(w - 1, static_cast<int>(x) + reach); ++sx) {
                const double dx = sx + 0.5 - x, dy = sy + 0.5 - y;
                const double covered = radius + 0.5 - std::sqrt(dx * dx + dy * dy);
                const double parts = 255 * std::clamp(covered, 0.0, 1.0) + 0.5;
                unsigned char& sample = line.at(sx, sy);
                sample = std::max(sample, static_cast<unsigned char>(parts));
            }
    };
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            if (x + 1 < w && sides.at(x, y) != sides.at(x + 1, y)) stamp(x + 1, y + 0.5);
            if (y + 1 < h && sides.at(x, y) != sides.at(x, y + 1)) stamp(x + 0.5, y + 1);
        }
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            int covered = 0;
            for (int sy = 0; sy < perSide; ++sy)
                for (int sx = 0; sx < perSide; ++sx)
                    covered += line.at(x * perSide + sx, y * perSide + sy);
            if (covered == 0) continue;
            float* p = &picture.at(x, y);
            Colour over = colour;
            over.a *= covered / (255.0 * perSide * perSide);
            const Colour mixed = onTop(over, {p[0], p[1], p[2], p[3]});
            p[0] = static_cast<float>(mixed.r);
            p[1] = static_cast<float>(mixed.g);
            p[2] = static_cast<float>(mixed.b);
            p[3] = static_cast<float>(mixed.a);
        }
}

}  // namespace versorium
