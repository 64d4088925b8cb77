// SPDX-License-Identifier: MIT
#pragma once
// The GPU as all pictures on it share it: the context's limits, the programs by
// their text, and the objects that every draw needs. OpenGL ES 3.0 with float render targets; a
// context must be current whenever anything of this room is called, always on the same thread.
//
// Nothing here is deleted by a destructor: names die with their context. `forget` drops them when
// the context was lost.

#include <GLES3/gl3.h>

#include <map>
#include <string>

#include "base/status.h"

namespace versorium {

struct GpuLimits {
    int textureSize = 0;  // pixels along a side
    int gridSize = 0;     // nodes along an edge of a 3D texture
    int uniformVectors = 0;
    bool parallelCompile = false;  // KHR_parallel_shader_compile
    GLuint64 longestWait = 0;      // ns that a fence may be waited for; 0 in a browser
    std::string device;
    // The driver computes on the CPU, slower than the project's own kernels do.
    bool software = false;
};

class GpuDevice {
  public:
    GpuDevice() = default;
    GpuDevice(const GpuDevice&) = delete;
    GpuDevice& operator=(const GpuDevice&) = delete;

    // Looks the context over, once. Says what is missing where pictures cannot be drawn here.
    Status prepare();
    const GpuLimits& limits() const { return limits_; }

    // The context is gone: every name is dropped, and all is made anew at the next use.
    void forget();
    // Grows with every `forget`.
    int generation() const { return generation_; }

    // The program of this fragment shader. `name` is 0 while it is being compiled; where the driver
    // compiles within the call, the first answer is that too, so that a frame can say so. `wait`
    // stays until it is there.
    struct Program {
        GLuint name = 0;
        Status status;
        bool compiling() const { return name == 0 && status.ok(); }
    };
    Program program(const std::string& fragmentText, bool wait = false);

    // Fills the viewport with the current program.
    void drawQuad();
    // Draws so far, for tests and for the performance display.
    long long iterationDraws = 0;

  private:
    struct Entry {
        GLuint vertex = 0, fragment = 0, name = 0;
        bool begun = false, linked = false;
        Status status;
    };
    void begin(Entry& entry, const std::string& fragmentText);
    void finish(Entry& entry);

    GpuLimits limits_;
    bool prepared_ = false;
    Status prepareStatus_;
    int generation_ = 0;
    GLuint vertexArray_ = 0;
    std::map<std::string, Entry> programs_;
};

}  // namespace versorium
