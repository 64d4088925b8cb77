// SPDX-License-Identifier: MIT
#pragma once
// Where a scene's slice lies on a picture.

#include "scene/scene.h"
#include "view/slice.h"

namespace versorium {

// `samples` is the picture's size in samples, which may be several for each pixel.
Viewport viewportOf(const Scene& scene, Size samples);

}  // namespace versorium
