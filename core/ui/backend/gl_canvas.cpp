// SPDX-License-Identifier: MIT
#include "ui/backend/gl_canvas.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <cstddef>

#include "ui/backend/texture.h"

namespace versorium {
namespace {

constexpr const char* kVertex = R"(#version 300 es
uniform vec2 scale;
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 place;
layout(location = 2) in vec4 tint;
out vec2 texel;
out vec4 colour;
void main() {
    texel = place;
    colour = tint;
    gl_Position = vec4(position * scale + vec2(-1, 1), 0, 1);
}
)";
constexpr const char* kFragment = R"(#version 300 es
precision mediump float;
uniform sampler2D picture;
in highp vec2 texel;
in vec4 colour;
layout(location = 0) out vec4 result;
void main() { result = colour * texture(picture, texel); }
)";

GLuint compiled(GLenum kind, const char* text) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    return shader;
}

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

GlCanvas::GlCanvas() {
    ImGuiIO& io = ImGui::GetIO();
    io.BackendRendererName = "versorium_gl_canvas";
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
}

void GlCanvas::takeFonts() {
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
    fonts_ = putTexture(fonts_, {width, height}, pixels);
    atlas.SetTexID(textureId(fonts_));
}

void GlCanvas::prepare() {
    if (program_ != 0) return;
    program_ = glCreateProgram();
    for (const auto& [kind, text] :
         {std::pair{GL_VERTEX_SHADER, kVertex}, {GL_FRAGMENT_SHADER, kFragment}}) {
        const GLuint shader = compiled(static_cast<GLenum>(kind), text);
        glAttachShader(program_, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program_);
    scale_ = glGetUniformLocation(program_, "scale");
    GLuint names[2];
    glGenBuffers(2, names);
    vertices_ = names[0];
    indices_ = names[1];
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    array_ = array;
}

void GlCanvas::draw(const ImDrawData& data, Size size) {
    prepare();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.width, size.height);
    for (const GLenum off : {GL_CULL_FACE, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST})
        glDisable(off);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    glEnable(GL_SCISSOR_TEST);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(program_);
    glUniform2f(scale_, 2 / data.DisplaySize.x, -2 / data.DisplaySize.y);
    glActiveTexture(GL_TEXTURE0);
    glBindSampler(0, 0);
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    for (GLuint attribute = 0; attribute < 3; ++attribute) glEnableVertexAttribArray(attribute);
    for (const ImDrawList* list : data.CmdLists) drawList(*list, size);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glBindVertexArray(0);
}

void GlCanvas::drawList(const ImDrawList& list, Size size) const {
    const auto bytes = [](const auto& buffer) {
        return static_cast<GLsizeiptr>(buffer.size_in_bytes());
    };
    glBufferData(GL_ARRAY_BUFFER, bytes(list.VtxBuffer), list.VtxBuffer.Data, GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, bytes(list.IdxBuffer), list.IdxBuffer.Data,
                 GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list.CmdBuffer) {
        const ImVec4& clip = command.ClipRect;
        const int left = std::max(0, static_cast<int>(clip.x));
        const int top = std::max(0, static_cast<int>(clip.y));
        const int right = std::min(size.width, static_cast<int>(clip.z));
        const int bottom = std::min(size.height, static_cast<int>(clip.w));
        if (command.UserCallback || left >= right || top >= bottom) continue;
        glScissor(left, size.height - bottom, right - left, bottom - top);
        glBindTexture(GL_TEXTURE_2D,
                      static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
        const std::size_t first = command.VtxOffset * sizeof(ImDrawVert);
        const GLsizei stride = sizeof(ImDrawVert);
        glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride,
                              offset(first + offsetof(ImDrawVert, pos)));
        glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride,
                              offset(first + offsetof(ImDrawVert, uv)));
        glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                              offset(first + offsetof(ImDrawVert, col)));
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                       sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                       offset(command.IdxOffset * sizeof(ImDrawIdx)));
    }
}

}  // namespace versorium
