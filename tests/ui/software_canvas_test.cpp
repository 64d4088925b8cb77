// SPDX-License-Identifier: MIT
#include "ui/backend/software_canvas.h"

#include <gtest/gtest.h>

#include "ui/backend/texture.h"

namespace versorium {
namespace {

struct Context {
    Context() { ImGui::CreateContext(); }
    ~Context() { ImGui::DestroyContext(); }
};

struct Screen {
    Screen() : list(ImGui::GetDrawListSharedData()) {
        list._ResetForNewFrame();
        list.PushClipRect({0, 0}, {16, 16});
    }

    Context context;
    SoftwareCanvas canvas;
    ImDrawList list;

    void draw() {
        ImDrawData data;
        data.CmdLists.push_back(&list);
        canvas.draw(data, {16, 16});
    }
    int at(int x, int y, int channel) const {
        return canvas.rgba()[static_cast<std::size_t>(4 * (16 * y + x) + channel)];
    }
    void triangle(ImVec2 a, ImVec2 b, ImVec2 c, ImU32 colour) {
        list.PrimReserve(3, 3);
        for (const ImVec2& corner : {a, b, c}) list.PrimVtx(corner, {0, 0}, colour);
    }
};

TEST(SoftwareCanvas, IsTheBackEndWhileItLives) {
    const Context context;
    EXPECT_TRUE(drawsWithOpenGl());
    {
        const SoftwareCanvas canvas;
        EXPECT_EQ(SoftwareCanvas::current(), &canvas);
        EXPECT_FALSE(drawsWithOpenGl());
    }
    EXPECT_TRUE(drawsWithOpenGl());
}

TEST(SoftwareCanvas, ARectangleCoversTheCentresInsideItAndNothingBeyondItsClip) {
    Screen screen;
    screen.list.PushClipRect({0, 0}, {8, 16});
    screen.list.PrimReserve(6, 4);
    screen.list.PrimRect({2.4f, 3.6f}, {12, 6}, IM_COL32(10, 20, 30, 255));
    screen.draw();
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            EXPECT_EQ(screen.at(x, y, 2), x >= 2 && x < 8 && y >= 4 && y < 6 ? 30 : 0) << x << y;
}

// Round a common point: were an edge drawn by both of its triangles, or by none, half a white over
// black would not be the same everywhere.
TEST(SoftwareCanvas, TrianglesThatShareEdgesCoverEachPixelOnce) {
    Screen screen;
    const ImVec2 middle{7.3f, 8.1f};
    const ImVec2 ring[] = {{-3, -4}, {9, -7}, {30, 2}, {22, 25}, {3.5f, 33}, {-12, 11}};
    for (int k = 0; k < 6; ++k)
        screen.triangle(middle, ring[k], ring[(k + 1) % 6], IM_COL32(255, 255, 255, 128));
    screen.draw();
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) EXPECT_EQ(screen.at(x, y, 0), 128) << x << " " << y;
}

TEST(SoftwareCanvas, ColoursRunLinearlyBetweenTheCorners) {
    Screen screen;
    screen.list.AddRectFilledMultiColor({0, 0}, {16, 16}, IM_COL32(0, 0, 0, 255),
                                        IM_COL32(160, 0, 0, 255), IM_COL32(160, 160, 0, 255),
                                        IM_COL32(0, 160, 0, 255));
    screen.draw();
    // One for each rounding.
    for (int k = 0; k < 16; ++k) {
        EXPECT_NEAR(screen.at(k, 4, 0), 10 * k + 5, 1);
        EXPECT_NEAR(screen.at(4, k, 1), 10 * k + 5, 1);
    }
}

TEST(SoftwareCanvas, APictureAtItsOwnSizeComesUnchanged) {
    Screen screen;
    std::vector<unsigned char> pixels(16 * 16 * 4);
    for (std::size_t k = 0; k < pixels.size(); ++k)
        pixels[k] = k % 4 == 3 ? 255 : static_cast<unsigned char>(k * 37);
    const unsigned name = putTexture(0, {16, 16}, pixels.data());
    screen.list.AddImage(textureId(name), {0, 0}, {16, 16});
    screen.draw();
    EXPECT_EQ(screen.canvas.rgba(), pixels);
    freeTexture(name);
}

}  // namespace
}  // namespace versorium
