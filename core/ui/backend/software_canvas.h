// SPDX-License-Identifier: MIT
#pragma once
// SoftwareCanvas: ImGui's draw lists on the CPU, for where there is no OpenGL. Triangles with
// colours at their corners and a texture, cut to a rectangle, over one another; a pixel belongs to
// a triangle when its centre lies inside. Rectangles along the axes, which are most of what ImGui
// draws, have a path of their own.

#include <cstdint>
#include <map>
#include <vector>

#include "image/raster.h"
#include "imgui.h"

namespace versorium {

class SoftwareCanvas {
  public:
    // Becomes the back end of the current ImGui context, and stops being it.
    SoftwareCanvas();
    ~SoftwareCanvas();
    SoftwareCanvas(const SoftwareCanvas&) = delete;
    SoftwareCanvas& operator=(const SoftwareCanvas&) = delete;
    // Of the current ImGui context; null where something else draws it.
    static SoftwareCanvas* current();

    // Takes ImGui's letters: before the first frame and whenever they were loaded anew.
    void takeFonts();
    void draw(const ImDrawData& data, Size size);

    Size size() const { return size_; }
    // Opaque RGBA, row 0 on top.
    const std::vector<unsigned char>& rgba() const { return rgba_; }

    // As in ui/backend/texture.h.
    unsigned putTexture(unsigned name, Size size, const unsigned char* rgba);
    void freeTexture(unsigned name) { textures_.erase(name); }

  private:
    struct Texture {
        Size size;
        std::vector<unsigned char> rgba;
    };
    struct Clip {
        int left, top, right, bottom;  // right and bottom are outside
    };

    std::map<unsigned, Texture> textures_;
    unsigned last_ = 0, fonts_ = 0;
    Size size_{0, 0};
    std::vector<unsigned char> rgba_;

    void drawCommand(const ImDrawList& list, const ImDrawCmd& command, const Clip& clip);
    void rectangle(const ImDrawVert& low, const ImDrawVert& high, const Texture* texture,
                   const Clip& clip);
    void triangle(const ImDrawVert* const corners[3], const Texture* texture, const Clip& clip);
    void blend(int x, int y, const unsigned char* colour);
};

}  // namespace versorium
