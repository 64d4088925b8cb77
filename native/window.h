// SPDX-License-Identifier: MIT
#pragma once
// The studio in a window: GLFW and OpenGL ES 3.

#include <string>

#include "base/status.h"

namespace versorium {

struct WindowOptions {
    std::string open;  // a preset's name, a document's path or a link; empty: the beginning
    int width = 1280, height = 800;
    // For tests: writes the window's picture here once nothing moves any more, then ends.
    std::string screenshot;
};

// Runs until the window is closed. ErrorKind::usage where there is no display.
Status runStudio(const WindowOptions& options);

}  // namespace versorium
