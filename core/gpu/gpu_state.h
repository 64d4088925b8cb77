// SPDX-License-Identifier: MIT
#pragma once
// The state that a draw of this room needs, set in full, since others draw into the same context;
// afterwards framebuffer 0 is bound and the scissor is off, as a toolkit expects.

#include <GLES3/gl3.h>

#include "image/raster.h"

namespace versorium::gpu {

class DrawState {
  public:
    DrawState(GLuint frame, Size size) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        glViewport(0, 0, size.width, size.height);
        for (GLenum unwanted : {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_STENCIL_TEST,
                                GL_SCISSOR_TEST, GL_RASTERIZER_DISCARD, GL_DITHER})
            glDisable(static_cast<GLenum>(unwanted));
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
    ~DrawState() {
        glDisable(GL_SCISSOR_TEST);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glUseProgram(0);
        glActiveTexture(GL_TEXTURE0);
    }
    DrawState(const DrawState&) = delete;
    DrawState& operator=(const DrawState&) = delete;

    void scissor(int x, int y, int width, int height) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(x, y, width, height);
    }
};

inline void bindTexture(GLuint program, const char* uniform, int unit, GLenum kind, GLuint name) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(kind, name);
    // The texture says how it is read, not whatever sampler another drawer left here.
    glBindSampler(static_cast<GLuint>(unit), 0);
    glUniform1i(glGetUniformLocation(program, uniform), unit);
}

}  // namespace versorium::gpu
