// SPDX-License-Identifier: MIT
#include "ui/backend/software_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ui/backend/texture.h"

namespace versorium {
namespace {

constexpr const char* kName = "versorium_software_canvas";

using Rgba = unsigned char[4];

// Exact for products of two bytes: round(x / 255).
unsigned char over255(unsigned x) { return static_cast<unsigned char>((x + 128) * 257 >> 16); }

// The first pixel whose centre lies at or behind x, cut to a range that an int can hold.
int firstPixel(float x, int low, int high) {
    const float at = std::ceil(x - 0.5f);
    if (!(at > static_cast<float>(low))) return low;
    return at < static_cast<float>(high) ? static_cast<int>(at) : high;
}

void unpack(ImU32 colour, Rgba& out) {
    out[0] = static_cast<unsigned char>(colour >> IM_COL32_R_SHIFT);
    out[1] = static_cast<unsigned char>(colour >> IM_COL32_G_SHIFT);
    out[2] = static_cast<unsigned char>(colour >> IM_COL32_B_SHIFT);
    out[3] = static_cast<unsigned char>(colour >> IM_COL32_A_SHIFT);
}

void multiply(Rgba& colour, const Rgba& by) {
    for (int k = 0; k < 4; ++k) colour[k] = over255(static_cast<unsigned>(colour[k]) * by[k]);
}

// Two neighbours along one axis of a texture and how much of the second, in 256ths; the edge goes
// on.
struct Tap {
    int first, second;
    unsigned part;
};
Tap tap(float coordinate, int length) {
    const float at = std::clamp(coordinate * static_cast<float>(length) - 0.5f, -1.0f,
                                static_cast<float>(length));
    const int fixed = static_cast<int>(std::floor(at * 256 + 0.5f));
    const int first = fixed >> 8;
    return {std::clamp(first, 0, length - 1), std::clamp(first + 1, 0, length - 1),
            static_cast<unsigned>(fixed & 255)};
}

void sample(const unsigned char* rgba, int width, const Tap& x, const Tap& y, Rgba& out) {
    const auto texel = [&](int column, int row) {
        return rgba + (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(column)) *
                          4;
    };
    if (x.part == 0 && y.part == 0) {
        std::memcpy(out, texel(x.first, y.first), 4);
        return;
    }
    const unsigned char* corners[4] = {texel(x.first, y.first), texel(x.second, y.first),
                                       texel(x.first, y.second), texel(x.second, y.second)};
    for (int k = 0; k < 4; ++k) {
        const unsigned above = corners[0][k] * (256 - x.part) + corners[1][k] * x.part;
        const unsigned below = corners[2][k] * (256 - x.part) + corners[3][k] * x.part;
        out[k] = static_cast<unsigned char>((above * (256 - y.part) + below * y.part) >> 16);
    }
}

bool same(ImVec2 a, ImVec2 b) { return a.x == b.x && a.y == b.y; }

// ImGui writes a rectangle as the triangles 0 1 2 and 0 2 3 of its corners, clockwise.
bool isRectangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c,
                 const ImDrawVert& d) {
    const auto along = [](ImVec2 p, ImVec2 q, ImVec2 r, ImVec2 s) {
        return p.y == q.y && q.x == r.x && r.y == s.y && s.x == p.x;
    };
    return a.col == b.col && a.col == c.col && a.col == d.col &&
           along(a.pos, b.pos, c.pos, d.pos) && along(a.uv, b.uv, c.uv, d.uv) &&
           a.pos.x <= c.pos.x && a.pos.y <= c.pos.y;
}

}  // namespace

SoftwareCanvas::SoftwareCanvas() {
    ImGuiIO& io = ImGui::GetIO();
    io.BackendRendererName = kName;
    io.BackendRendererUserData = this;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
}

SoftwareCanvas::~SoftwareCanvas() {
    if (current() != this) return;
    ImGui::GetIO().BackendRendererName = nullptr;
    ImGui::GetIO().BackendRendererUserData = nullptr;
}

SoftwareCanvas* SoftwareCanvas::current() {
    const ImGuiIO& io = ImGui::GetIO();
    const bool here = io.BackendRendererName && std::strcmp(io.BackendRendererName, kName) == 0;
    return here ? static_cast<SoftwareCanvas*>(io.BackendRendererUserData) : nullptr;
}

void SoftwareCanvas::takeFonts() {
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
    fonts_ = putTexture(fonts_, {width, height}, pixels);
    atlas.SetTexID(textureId(fonts_));
    atlas.ClearTexData();
}

unsigned SoftwareCanvas::putTexture(unsigned name, Size size, const unsigned char* rgba) {
    if (name == 0) name = ++last_;
    const auto length =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 4;
    textures_[name] = {size, {rgba, rgba + length}};
    return name;
}

void SoftwareCanvas::draw(const ImDrawData& data, Size size) {
    size_ = size;
    const auto pixels =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    rgba_.assign(pixels * 4, 0);
    for (std::size_t k = 0; k < pixels; ++k) rgba_[4 * k + 3] = 255;
    const Clip whole{0, 0, size.width, size.height};
    for (const ImDrawList* list : data.CmdLists)
        for (const ImDrawCmd& command : list->CmdBuffer) {
            if (command.UserCallback) continue;  // they speak to OpenGL
            const ImVec4& cut = command.ClipRect;
            Clip clip = whole;
            clip.left = std::max(clip.left, static_cast<int>(std::max(0.0f, cut.x)));
            clip.top = std::max(clip.top, static_cast<int>(std::max(0.0f, cut.y)));
            clip.right = std::min(clip.right, firstPixel(cut.z + 0.5f, 0, size.width));
            clip.bottom = std::min(clip.bottom, firstPixel(cut.w + 0.5f, 0, size.height));
            if (clip.left < clip.right && clip.top < clip.bottom) drawCommand(*list, command, clip);
        }
}

void SoftwareCanvas::drawCommand(const ImDrawList& list, const ImDrawCmd& command,
                                 const Clip& clip) {
    const auto found =
        textures_.find(static_cast<unsigned>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
    const Texture* texture = found == textures_.end() ? nullptr : &found->second;
    const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
    const ImDrawIdx* at = list.IdxBuffer.Data + command.IdxOffset;
    const ImDrawIdx* end = at + command.ElemCount;
    while (end - at >= 3) {
        if (end - at >= 6 && at[0] == at[3] && at[2] == at[4] &&
            isRectangle(vertices[at[0]], vertices[at[1]], vertices[at[2]], vertices[at[5]])) {
            rectangle(vertices[at[0]], vertices[at[2]], texture, clip);
            at += 6;
            continue;
        }
        const ImDrawVert* corners[3] = {&vertices[at[0]], &vertices[at[1]], &vertices[at[2]]};
        triangle(corners, texture, clip);
        at += 3;
    }
}

void SoftwareCanvas::blend(int x, int y, const unsigned char* colour) {
    unsigned char* pixel =
        rgba_.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
                        static_cast<std::size_t>(x)) *
                           4;
    const unsigned alpha = colour[3];
    if (alpha == 255) {
        std::memcpy(pixel, colour, 4);
        return;
    }
    if (alpha == 0) return;
    for (int k = 0; k < 3; ++k) pixel[k] = over255(colour[k] * alpha + pixel[k] * (255 - alpha));
}

void SoftwareCanvas::rectangle(const ImDrawVert& low, const ImDrawVert& high,
                               const Texture* texture, const Clip& clip) {
    const int left = firstPixel(low.pos.x, clip.left, clip.right);
    const int right = firstPixel(high.pos.x, clip.left, clip.right);
    const int top = firstPixel(low.pos.y, clip.top, clip.bottom);
    const int bottom = firstPixel(high.pos.y, clip.top, clip.bottom);
    if (left >= right || top >= bottom) return;
    Rgba tint;
    unpack(low.col, tint);
    if (!texture || same(low.uv, high.uv)) {
        if (texture) {
            Rgba texel;
            sample(texture->rgba.data(), texture->size.width, tap(low.uv.x, texture->size.width),
                   tap(low.uv.y, texture->size.height), texel);
            multiply(tint, texel);
        }
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) blend(x, y, tint);
        return;
    }
    const ImVec2 step{(high.uv.x - low.uv.x) / (high.pos.x - low.pos.x),
                      (high.uv.y - low.uv.y) / (high.pos.y - low.pos.y)};
    std::vector<Tap> columns;
    columns.reserve(static_cast<std::size_t>(right - left));
    for (int x = left; x < right; ++x)
        columns.push_back(tap(low.uv.x + (static_cast<float>(x) + 0.5f - low.pos.x) * step.x,
                              texture->size.width));
    const bool plain = low.col == 0xffffffffu;
    for (int y = top; y < bottom; ++y) {
        const Tap row = tap(low.uv.y + (static_cast<float>(y) + 0.5f - low.pos.y) * step.y,
                            texture->size.height);
        for (int x = left; x < right; ++x) {
            Rgba colour;
            sample(texture->rgba.data(), texture->size.width,
                   columns[static_cast<std::size_t>(x - left)], row, colour);
            if (!plain) multiply(colour, tint);
            blend(x, y, colour);
        }
    }
}

void SoftwareCanvas::triangle(const ImDrawVert* const corners[3], const Texture* texture,
                              const Clip& clip) {
    // From top to bottom: an edge that two triangles share is walked in the same direction by both,
    // so that each pixel on it belongs to exactly one.
    const ImDrawVert* v[3] = {corners[0], corners[1], corners[2]};
    const auto before = [](const ImDrawVert* a, const ImDrawVert* b) {
        return a->pos.y < b->pos.y || (a->pos.y == b->pos.y && a->pos.x < b->pos.x);
    };
    std::sort(v, v + 3, before);
    const ImVec2 a = v[0]->pos, b = v[1]->pos, c = v[2]->pos;
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (!(std::abs(area) > 1e-6f)) return;
    const int top = firstPixel(a.y, clip.top, clip.bottom);
    const int bottom = firstPixel(c.y, clip.top, clip.bottom);

    // Weights of v[1] and v[2] at a pixel: w = wx (x - a.x) + wy (y - a.y).
    const ImVec2 weight1{(c.y - a.y) / area, -(c.x - a.x) / area};
    const ImVec2 weight2{-(b.y - a.y) / area, (b.x - a.x) / area};
    Rgba colours[3];
    for (int k = 0; k < 3; ++k) unpack(v[k]->col, colours[k]);
    const bool oneColour = v[0]->col == v[1]->col && v[0]->col == v[2]->col;
    const bool oneTexel = same(v[0]->uv, v[1]->uv) && same(v[0]->uv, v[2]->uv);
    Rgba texel{255, 255, 255, 255};
    const auto look = [&](float s, float t) {
        sample(texture->rgba.data(), texture->size.width, tap(s, texture->size.width),
               tap(t, texture->size.height), texel);
    };
    if (texture && oneTexel) look(v[0]->uv.x, v[0]->uv.y);

    const auto crossing = [](ImVec2 p, ImVec2 q, float y) {
        return p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y));
    };
    for (int row = top; row < bottom; ++row) {
        const float y = static_cast<float>(row) + 0.5f;
        const float x0 = crossing(a, c, y);
        const float x1 = y < b.y ? crossing(a, b, y) : crossing(b, c, y);
        const int left = firstPixel(std::min(x0, x1), clip.left, clip.right);
        const int right = firstPixel(std::max(x0, x1), clip.left, clip.right);
        for (int column = left; column < right; ++column) {
            const float dx = static_cast<float>(column) + 0.5f - a.x, dy = y - a.y;
            const float w1 = std::clamp(weight1.x * dx + weight1.y * dy, 0.0f, 1.0f);
            const float w2 = std::clamp(weight2.x * dx + weight2.y * dy, 0.0f, 1.0f - w1);
            const float w0 = 1 - w1 - w2;
            Rgba colour;
            if (oneColour)
                std::memcpy(colour, colours[0], 4);
            else
                for (int k = 0; k < 4; ++k)
                    colour[k] =
                        static_cast<unsigned char>(static_cast<float>(colours[0][k]) * w0 +
                                                   static_cast<float>(colours[1][k]) * w1 +
                                                   static_cast<float>(colours[2][k]) * w2 + 0.5f);
            if (texture) {
                if (!oneTexel)
                    look(v[0]->uv.x * w0 + v[1]->uv.x * w1 + v[2]->uv.x * w2,
                         v[0]->uv.y * w0 + v[1]->uv.y * w1 + v[2]->uv.y * w2);
                multiply(colour, texel);
            }
            blend(column, row, colour);
        }
    }
}

}  // namespace versorium
