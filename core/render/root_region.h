// SPDX-License-Identifier: MIT
#pragma once
// Where the roots of a scene's versor are drawn at random (geometry/random_roots.h): S section
// 3.3.2 takes the box of the target shape.

#include "geometry/random_roots.h"
#include "scene/scene.h"
#include "shape/field.h"

namespace versorium {

// The region becomes the box of the scene's shape, in the components of a point at which the shape
// is looked up; the component that it does not see is 0.
void takeShapeBox(const Scene& scene, const DistanceField& field, RandomRoots& roots);

}  // namespace versorium
