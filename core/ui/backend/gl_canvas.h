// SPDX-License-Identifier: MIT
#pragma once
// GlCanvas: ImGui's draw lists by OpenGL ES 3 that never asks OpenGL for anything. ImGui's own back
// end reads some twenty values of state in every frame; in a browser each of them waits until the
// graphics process has done all that it was told before. So this sets whatever it needs and leaves
// no promise of what stays bound.

#include "image/raster.h"
#include "imgui.h"

namespace versorium {

class GlCanvas {
  public:
    // Draws the current ImGui context.
    GlCanvas();

    // Takes ImGui's letters: before the first frame and whenever they were loaded anew, or the
    // context is a new one.
    void takeFonts();
    // Clears the default framebuffer and draws.
    void draw(const ImDrawData& data, Size size);
    // Forgets all names of a context that is gone.
    void contextLost() { *this = GlCanvas(); }

  private:
    unsigned program_ = 0, vertices_ = 0, indices_ = 0, array_ = 0, fonts_ = 0;
    int scale_ = -1;

    void prepare();
    void drawList(const ImDrawList& list, Size size) const;
};

}  // namespace versorium
