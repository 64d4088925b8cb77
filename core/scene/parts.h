// SPDX-License-Identifier: MIT
#pragma once
// Parts of a scene that pass to another one: when it shows another map or another plane.

#include <set>
#include <string>

#include "scene/scene.h"

namespace versorium {

// The shape, alpha and beta over space, and the assets.
void keepShape(Scene& scene, const Scene& old);
// Colours, the images behind and in front, the aspect, and the assets.
void keepLook(Scene& scene, const Scene& old);

// The SHA-256 of every asset that something in the scene names, whether it has it or not.
std::set<std::string> namedAssets(const Scene& scene);
void dropAssetsExcept(Scene& scene, const std::set<std::string>& named);
// Takes what the scene names and has not yet.
void takeAssets(Scene& scene, const Assets& assets);

// The scene's body, and which assets it has of those that it names: equal for scenes that are drawn
// and saved alike.
Json sceneKey(const Scene& scene);

}  // namespace versorium
