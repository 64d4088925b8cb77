// SPDX-License-Identifier: MIT
#pragma once
// Textures for ImGui's lists, by names that are its ImTextureID: OpenGL's, or those of the
// SoftwareCanvas where that draws.

#include <cstdint>

#include "image/raster.h"
#include "imgui.h"

namespace versorium {

// False where the current ImGui context is drawn by the CPU.
bool drawsWithOpenGl();

// Makes a texture, or with a name that is not 0 gives that one new pixels: RGBA with straight
// alpha, row 0 on top. Returns its name.
unsigned putTexture(unsigned name, Size size, const unsigned char* rgba);
void freeTexture(unsigned name);

inline ImTextureID textureId(unsigned name) {
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name));
}

}  // namespace versorium
