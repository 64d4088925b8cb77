// SPDX-License-Identifier: MIT
#include "plate/sheet.h"

#include <memory>
#include <utility>

namespace versorium {

void Sheet::text(std::string name, TextBlock block, double x, double y, const Colour& colour,
                 double pixelsPerPoint, bool turned) {
    const Box ink = placedInk(block, x, y, turned);
    boxes_.push_back({std::move(name), ink, block.smallest / pixelsPerPoint});
    auto shared = std::make_shared<const TextBlock>(std::move(block));
    mark(ink, [shared, x, y, colour, turned](Canvas& canvas, double dx, double dy) {
        canvas.text(*shared, x + dx, y + dy, colour, turned);
    });
}

void Sheet::mark(const Box& extent, std::function<void(Canvas&, double, double)> draw) {
    extent_.include(extent);
    commands_.push_back({std::move(draw)});
}

void Sheet::reserve(std::string name, const Box& box) {
    extent_.include(box);
    boxes_.push_back({std::move(name), box, 0});
}

void Sheet::add(const Sheet& other, double dx, double dy, const std::string& prefix) {
    extent_.include(other.extent_.moved(dx, dy));
    for (const Command& command : other.commands_)
        commands_.push_back({command.draw, command.dx + dx, command.dy + dy});
    for (const PlateBox& box : other.boxes_)
        boxes_.push_back({prefix + box.name, box.box.moved(dx, dy), box.pointSize});
}

bool Sheet::collides(const Box& box) const {
    for (const PlateBox& other : boxes_)
        if (overlap(box, other.box)) return true;
    return false;
}

void Sheet::draw(Canvas& canvas) const {
    for (const Command& command : commands_) command.draw(canvas, command.dx, command.dy);
}

}  // namespace versorium
