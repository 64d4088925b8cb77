// SPDX-License-Identifier: MIT
#pragma once
// What a layout has decided to draw, before there is a canvas: texts and marks in whole-pixel
// coordinates of their own, and the room that they take. Sheets are put into sheets at an offset.

#include <functional>
#include <string>
#include <vector>

#include "plate/canvas.h"
#include "plate/plate.h"

namespace versorium {

class Sheet {
  public:
    // A text, and its room under a name. `x`, `y` as for Canvas::text.
    void text(std::string name, TextBlock block, double x, double y, const Colour& colour,
              double pixelsPerPoint, bool turned = false);
    // Anything else: draws at the offset (dx, dy) and stays within `extent`.
    void mark(const Box& extent, std::function<void(Canvas&, double dx, double dy)> draw);
    // Room that nothing else may take.
    void reserve(std::string name, const Box& box);

    void add(const Sheet& other, double dx, double dy, const std::string& prefix);
    void draw(Canvas& canvas) const;

    // Whether a box takes room that is reserved or has a text.
    bool collides(const Box& box) const;
    const Box& extent() const { return extent_; }
    const std::vector<PlateBox>& boxes() const { return boxes_; }

  private:
    struct Command {
        std::function<void(Canvas&, double, double)> draw;
        double dx = 0, dy = 0;
    };
    std::vector<Command> commands_;
    std::vector<PlateBox> boxes_;
    Box extent_;
};

}  // namespace versorium
