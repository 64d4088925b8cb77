// SPDX-License-Identifier: MIT
#include "gpu/gpu_device.h"

#include <string_view>

namespace versorium {
namespace {

// Of extensions that the plain header does not know.
constexpr GLenum kCompletionStatus = 0x91B1;   // KHR_parallel_shader_compile
constexpr GLenum kLongestClientWait = 0x9247;  // WebGL 2 only
constexpr GLenum kUnmaskedRenderer = 0x9246;   // WEBGL_debug_renderer_info
constexpr GLuint64 kLongestNativeWait = 1000000000;
constexpr std::size_t kMostPrograms = 64;
constexpr std::size_t kLongestLog = 2000;

// One triangle that covers the viewport.
constexpr const char* kVertexText = R"(#version 300 es
void main() {
    vec2 corner = vec2(float((gl_VertexID & 1) << 2), float((gl_VertexID & 2) << 1));
    gl_Position = vec4(corner - 1.0, 0.0, 1.0);
}
)";

bool hasExtension(std::string_view wanted) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* name =
            reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
        // Some list names with "GL_" in front, some without.
        if (name && (name == wanted || std::string_view(name) == "GL_" + std::string(wanted)))
            return true;
    }
    return false;
}

std::string text(GLenum name) {
    const auto* value = reinterpret_cast<const char*>(glGetString(name));
    return value ? value : "";
}

GLuint shader(GLenum kind, const char* source) {
    const GLuint name = glCreateShader(kind);
    glShaderSource(name, 1, &source, nullptr);
    glCompileShader(name);
    return name;
}

bool computesInSoftware(const std::string& device) {
    for (const char* word :
         {"llvmpipe", "softpipe", "swrast", "SwiftShader", "Basic Render", "Software", "software"})
        if (device.find(word) != std::string::npos) return true;
    return false;
}

void clearErrors() {
    // A lost context gives errors for ever.
    for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
    }
}

}  // namespace

Status GpuDevice::prepare() {
    if (prepared_) return prepareStatus_;
    prepared_ = true;
    clearErrors();
    limits_ = {};
    limits_.device = text(GL_RENDERER);
    // A browser may hide the device's name behind an extension of its own.
    if (hasExtension("WEBGL_debug_renderer_info"))
        if (const std::string name = text(kUnmaskedRenderer); !name.empty()) limits_.device = name;
    clearErrors();
    limits_.software = computesInSoftware(limits_.device);
    const std::string version = text(GL_VERSION);
    if (version.find("OpenGL ES 3") == std::string::npos &&
        version.find("WebGL 2") == std::string::npos) {
        prepareStatus_ = Status::usage("the GPU offers \"" + version +
                                       "\", and OpenGL ES 3.0 is needed: the CPU draws");
        return prepareStatus_;
    }
    if (!hasExtension("EXT_color_buffer_float")) {
        prepareStatus_ = Status::usage(
            "the GPU cannot draw into float textures (EXT_color_buffer_float): the "
            "CPU draws");
        return prepareStatus_;
    }
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limits_.textureSize);
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limits_.gridSize);
    glGetIntegerv(GL_MAX_FRAGMENT_UNIFORM_VECTORS, &limits_.uniformVectors);
    limits_.parallelCompile = hasExtension("KHR_parallel_shader_compile");
    // Only a browser knows this name; elsewhere it is an error that leaves the value alone.
    GLint64 longest = -1;
    glGetInteger64v(kLongestClientWait, &longest);
    clearErrors();
    limits_.longestWait = longest >= 0 ? static_cast<GLuint64>(longest) : kLongestNativeWait;
    glGenVertexArrays(1, &vertexArray_);
    prepareStatus_ = {};
    return prepareStatus_;
}

void GpuDevice::forget() {
    programs_.clear();
    vertexArray_ = 0;
    prepared_ = false;
    prepareStatus_ = {};
    ++generation_;
}

void GpuDevice::begin(Entry& entry, const std::string& fragmentText) {
    entry.vertex = shader(GL_VERTEX_SHADER, kVertexText);
    entry.fragment = shader(GL_FRAGMENT_SHADER, fragmentText.c_str());
    entry.name = glCreateProgram();
    glAttachShader(entry.name, entry.vertex);
    glAttachShader(entry.name, entry.fragment);
    glLinkProgram(entry.name);
    entry.begun = true;
}

void GpuDevice::finish(Entry& entry) {
    GLint good = 0;
    glGetProgramiv(entry.name, GL_LINK_STATUS, &good);
    if (!good) {
        std::string log(kLongestLog, '\0');
        GLsizei length = 0;
        GLint compiled = 0;
        glGetShaderiv(entry.fragment, GL_COMPILE_STATUS, &compiled);
        if (compiled)
            glGetProgramInfoLog(entry.name, kLongestLog, &length, log.data());
        else
            glGetShaderInfoLog(entry.fragment, kLongestLog, &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        entry.status = Status::data("the graphics driver refused a program: " +
                                    (log.empty() ? "no log" : log));
        glDeleteProgram(entry.name);
        entry.name = 0;
    }
    glDeleteShader(entry.vertex);
    glDeleteShader(entry.fragment);
    entry.linked = true;
}

GpuDevice::Program GpuDevice::program(const std::string& fragmentText, bool wait) {
    auto found = programs_.find(fragmentText);
    if (found == programs_.end()) {
        // Far more than the maps there are; shapes of many forms could fill it otherwise.
        if (programs_.size() >= kMostPrograms) {
            for (const auto& [own, entry] : programs_) {
                if (entry.name) glDeleteProgram(entry.name);
                if (entry.begun && !entry.linked) {
                    glDeleteShader(entry.vertex);
                    glDeleteShader(entry.fragment);
                }
            }
            programs_.clear();
        }
        found = programs_.emplace(fragmentText, Entry{}).first;
        if (!limits_.parallelCompile && !wait) return {};
    }
    Entry& entry = found->second;
    if (!entry.begun) begin(entry, fragmentText);
    if (!entry.linked) {
        GLint complete = 1;
        if (limits_.parallelCompile && !wait)
            glGetProgramiv(entry.name, kCompletionStatus, &complete);
        if (!complete) return {};
        finish(entry);
    }
    return {entry.name, entry.status};
}

void GpuDevice::drawQuad() {
    glBindVertexArray(vertexArray_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

}  // namespace versorium
