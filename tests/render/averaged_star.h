// SPDX-License-Identifier: MIT
#pragma once
// A scene whose average over random versors is quickly counted, for tests.

#include "scene/scene.h"

namespace versorium {

// A star large enough for its middle to be a trap: some points are in every set, some in none.
inline Scene averagedStar(int count, int seed = 1) {
    Scene scene = sceneOf(*findMap("shape-modulus-complex-rational"));
    scene.shape.source = "star(5, 1.2, 0.6)";
    scene.slice.height = 3.6;
    scene.iterations = 8;
    scene.samples = 1;
    scene.ensemble.count = count;
    scene.ensemble.seed = seed;
    scene.ensemble.roots.emplace();
    scene.colour.field = FieldName::meanMembership;
    scene.colour.interior = SetName::none;
    return scene;
}

}  // namespace versorium
