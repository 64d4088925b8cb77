// SPDX-License-Identifier: MIT
#pragma once
// What commands take as SCENE: a preset, the name of a map or a formula (its home view), a JSON
// file, a PNG that carries a scene, or "-".

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "render/picture.h"

namespace versorium {

struct OpenedScene {
    Scene scene;
    PictureOptions options;
};

// What a command was given: SCENE or --map or both, then --set.
struct SceneRequest {
    std::string scene, map;
    std::vector<std::string> sets;
};
void addSceneOptions(CLI::App& command, SceneRequest& request);

// The map first, then the assignments ("key=value") in their order.
Expected<OpenedScene> openScene(const SceneRequest& request);

}  // namespace versorium
