// SPDX-License-Identifier: MIT
#pragma once
// What commands take as SCENE: a preset, the name of a map (its home view), a JSON file, a PNG that
// carries a scene, or "-".

#include <string>
#include <vector>

#include "render/picture.h"

namespace versorium {

struct OpenedScene {
    Scene scene;
    PictureOptions options;
};

// The assignments ("key=value") are made in their order.
Expected<OpenedScene> openScene(const std::string& what, const std::vector<std::string>& sets);

}  // namespace versorium
