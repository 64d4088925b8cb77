// SPDX-License-Identifier: MIT
#include "ui/backend/texture.h"

#include <GLES3/gl3.h>

#include "ui/backend/software_canvas.h"

namespace versorium {

bool drawsWithOpenGl() { return SoftwareCanvas::current() == nullptr; }

unsigned putTexture(unsigned name, Size size, const unsigned char* rgba) {
    if (SoftwareCanvas* canvas = SoftwareCanvas::current())
        return canvas->putTexture(name, size, rgba);
    GLuint texture = name;
    if (texture == 0) glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 rgba);
    return texture;
}

void freeTexture(unsigned name) {
    if (name == 0) return;
    if (SoftwareCanvas* canvas = SoftwareCanvas::current()) return canvas->freeTexture(name);
    const GLuint texture = name;
    glDeleteTextures(1, &texture);
}

}  // namespace versorium
