// SPDX-License-Identifier: MIT
#include "gpu/gpu_textures.h"

namespace versorium::gpu {

GLuint makeTexture(GLenum kind) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(kind, name);
    for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(kind, filter, GL_NEAREST);
    for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(kind, wrap, GL_CLAMP_TO_EDGE);
    return name;
}

GLuint makeTarget(GLenum format, Size size) {
    const GLuint name = makeTexture(GL_TEXTURE_2D);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, size.width, size.height);
    return name;
}

GLuint makeFrame(std::initializer_list<GLuint> textures, bool& complete) {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    GLenum buffers[4] = {};
    GLsizei count = 0;
    for (GLuint texture : textures) {
        buffers[count] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(count);
        glFramebufferTexture2D(GL_FRAMEBUFFER, buffers[count], GL_TEXTURE_2D, texture, 0);
        ++count;
    }
    glDrawBuffers(count, buffers);
    complete = complete && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return name;
}

void plainUnpacking() {
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    for (GLenum length : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
                          GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES})
        glPixelStorei(length, 0);
}

}  // namespace versorium::gpu
