// SPDX-License-Identifier: MIT
#pragma once
// An OpenGL ES 3 context without a window, through EGL, so that the graphics room can be tested on
// machines that have neither screen nor GPU.

#include <string>

namespace versorium {

// Makes a new context current in place of the last one. Empty, or why there is none.
std::string makeHeadlessContext();
// The current context is destroyed with all that is in it.
void loseHeadlessContext();

}  // namespace versorium
