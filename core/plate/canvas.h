// SPDX-License-Identifier: MIT
#pragma once
// An opaque sheet of linear-light pixels. Shapes are antialiased by the area that a straight edge
// covers of each pixel, and composited in linear light. Coordinates are
// pixels, y down, (0, 0) the upper left corner of the sheet; a pixel's centre is at +0.5.

#include <vector>

#include "colour/srgb.h"
#include "image/raster.h"
#include "plate/text.h"

namespace versorium {

struct Point {
    double x = 0, y = 0;
};

class Canvas {
  public:
    Canvas(Size size, const Colour& background);

    Size size() const { return pixels_.size(); }

    void fillRect(const Box& box, const Colour& colour);
    // The outline just outside the box, of whole pixels when box and width are.
    void strokeRect(const Box& box, double width, const Colour& colour);
    // Round joints and ends. `dashes` are lengths drawn and skipped in turn; none means solid.
    void polyline(const std::vector<Point>& points, double width, const Colour& colour,
                  const std::vector<double>& dashes = {});
    void disc(Point centre, double radius, const Colour& colour);
    // Corners in either direction; the polygon must be convex.
    void polygon(const std::vector<Point>& corners, const Colour& colour);
    // Linear straight-alpha RGBA with its upper left pixel at (x, y).
    void picture(int x, int y, const Raster<float>& rgba);
    void text(const TextBlock& block, double x, double y, const Colour& colour,
              bool turned = false);

    const Raster<float>& pixels() const { return pixels_; }
    // 8-bit sRGB, three channels.
    Raster<unsigned char> encode() const { return encodeSrgb(pixels_); }

  private:
    void blend(int x, int y, const Colour& colour, double coverage);
    template <class Inside>
    void cover(const Box& box, const Colour& colour, Inside coverageAt);

    Raster<float> pixels_;
};

}  // namespace versorium
