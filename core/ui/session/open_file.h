// SPDX-License-Identifier: MIT
#pragma once
// What can be opened, pasted or dropped, told apart by its content and its name: a scene, a plate,
// a link, a picture that carries one of these, a palette, roots; and a mesh, a grid or an image,
// which become the shape of the scene.

#include <span>
#include <string>

#include "plate/plate_picture.h"
#include "ui/session/context.h"

namespace versorium {

// On failure everything stays as it was. What was done is said.
Status openBytes(StudioContext& context, const std::string& name,
                 std::span<const unsigned char> bytes);
// A link, the JSON of a scene or of a palette, or the path of a file.
Status openText(StudioContext& context, const std::string& text);
Status openFile(StudioContext& context, const std::string& path);
// The first panel of a plate that shows a scene.
Status openPlate(StudioContext& context, const std::string& name, const PlateDocument& plate);
// Whether a file with this name may be one that opens.
bool mayOpen(const std::string& name);

// A layer of the program's own: the leaf lies in front of all images, a white sheet behind them.
void addBuiltInLayer(Scene& scene, bool leaf);

}  // namespace versorium
