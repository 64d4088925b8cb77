// SPDX-License-Identifier: MIT
#include "render/viewport.h"

namespace versorium {

Viewport viewportOf(const Scene& scene, Size samples) {
    Viewport view;
    view.size = samples;
    for (std::size_t k = 0; k < 2 && k < scene.slice.centre.size(); ++k) {
        view.centre[k] = scene.slice.centre[k];
        view.centreLow[k] = scene.slice.centreLow[k];
    }
    view.height = scene.slice.height;
    return view;
}

}  // namespace versorium
