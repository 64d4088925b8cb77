// SPDX-License-Identifier: MIT
// `versorium glsl` prints the very texts that the driver is given.
#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <string>

#include "gpu/gpu_picture.h"

namespace versorium {
namespace {

std::string printed(const std::string& arguments) {
    const std::string line = std::string(VERSORIUM_PROGRAM) + " glsl " + arguments;
    std::string text;
    FILE* pipe = popen(line.c_str(), "r");
    if (!pipe) return text;
    char part[4096];
    while (const std::size_t length = std::fread(part, 1, sizeof part, pipe))
        text.append(part, length);
    pclose(pipe);
    return text;
}

constexpr GLuint kMostNames = 2000;

// What other tests have left in the context.
void deletePrograms() {
    for (GLuint name = 1; name < kMostNames; ++name)
        if (glIsProgram(name)) glDeleteProgram(name);
}

// Sources of all fragment shaders that belong to a program of this context.
std::set<std::string> compiledTexts() {
    std::set<std::string> texts;
    for (GLuint name = 1; name < kMostNames; ++name) {
        if (!glIsProgram(name)) continue;
        GLuint shaders[2] = {};
        GLsizei count = 0;
        glGetAttachedShaders(name, 2, &count, shaders);
        for (GLsizei k = 0; k < count; ++k) {
            GLint length = 0;
            glGetShaderiv(shaders[k], GL_SHADER_SOURCE_LENGTH, &length);
            std::string text(static_cast<std::size_t>(length), '\0');
            glGetShaderSource(shaders[k], length, nullptr, text.data());
            texts.insert(text.c_str());
        }
    }
    return texts;
}

TEST(PrintedShaders, AreThoseThatTheDriverIsGiven) {
    deletePrograms();
    GpuDevice gpu;
    for (const char* name : {"quadratic", "burning-ship", "mandelbulb", "shape-modulus-quadratic",
                             "newton", "z^3 - a*z + conj(c)", "shape(q^2 + c)"}) {
        GpuPicture picture(gpu);
        ASSERT_TRUE(picture.start(*sceneOfMap(name), {8, 8}).ok()) << name;
        const std::string quoted = "'" + std::string(name) + "'";
        const std::string orbits = printed(quoted);
        EXPECT_FALSE(compiledTexts().contains(orbits)) << name << ": compiled too early";
        ASSERT_TRUE(picture.finish().ok()) << name;
        const auto compiled = compiledTexts();
        EXPECT_TRUE(compiled.contains(orbits)) << name;
        EXPECT_TRUE(compiled.contains(printed(quoted + " --pass colours"))) << name;
    }
}

}  // namespace
}  // namespace versorium
