// SPDX-License-Identifier: MIT
#pragma once
// A picture that the GPU iterates and colours, a little at a time: orbits are kept
// in float textures between frames, so that a frame never waits for a picture. Values have 24 bits;
// scenes that need more, or fields that are not carried, are refused with the reason, and the CPU
// draws them. Row 0 of the texture is the top of the picture.
//
//   GpuPicture picture(device);
//   Status status = picture.start(scene, size);           // cancels what was under way
//   while (!picture.advance(0.010)) show(picture.texture());
//
// Needs its context current wherever it is called, also in its destructor (unless the device has
// been told to forget).

#include "gpu/gpu_device.h"
#include "gpu/gpu_orbits.h"
#include "image/raster.h"
#include "render/colouring.h"
#include "render/glsl/colour_shader.h"

namespace versorium {

struct GpuOptions {
    int samples = 1;                // along each side of a pixel
    Colour background{0, 0, 0, 1};  // linear light; behind colours that are not opaque
    double lineWidth = 1;           // in pixels: of contours of width 1
};

class GpuPicture {
  public:
    enum class State { empty, compiling, iterating, finished, failed };

    explicit GpuPicture(GpuDevice& device) : device_(device) {}
    ~GpuPicture();
    GpuPicture(const GpuPicture&) = delete;
    GpuPicture& operator=(const GpuPicture&) = delete;

    // Begins anew at once, whatever was under way. A failure says why the CPU has to draw this;
    // the picture is then empty. Scenes whose shape must be made into a grid go to the second form.
    Status start(const Scene& scene, Size size, const GpuOptions& options = {});
    Status start(const Scene& scene, const OrbitProgram& program, Size size,
                 const GpuOptions& options = {});
    // Other colours (and iso) of the same orbits: nothing is iterated.
    Status recolour(const Scene& scene);

    // Works for about this long; true when nothing is left to do: finished or failed. One draw is
    // kept below about 50 ms, and may outlast the budget by that.
    bool advance(double budgetSeconds);

    // Works to the end, however long it takes: for where there are no frames to be drawn between.
    Status finish();

    State state() const { return state_; }
    // Why it failed.
    const Status& status() const { return status_; }
    // Of an averaged map: how many members every pixel has counted.
    int members() const { return orbits_.counts() ? done_ : 0; }
    // Share of the iterations that every pixel has had, 0 to 1.
    double progress() const;

    // sRGB, opaque, of the size that was asked for; 0 before the first orbits are there.
    GLuint texture();
    Size size() const { return size_; }
    // The same, copied into a texture of the caller's; false before the first orbits are there.
    bool copyInto(GLuint texture);

    // What was measured, one value a sample (the versor: as many as a state has numbers). For tests
    // and probes: it waits for the GPU.
    Status readFields(const std::vector<FieldName>& fields, std::vector<Raster<float>>& rasters);
    Status readPicture(Raster<unsigned char>& rgba);
    // The picture drawn into few pixels, without smoothing: to see how bright it is where.
    Status readSmall(Size size, Raster<unsigned char>& rgba);

  private:
    struct Textures {
        GLuint fields[2] = {}, states[2] = {}, image = 0;
        GLuint roots = 0, grid = 0, palette = 0, picture = 0;
        GLuint orbitFrames[2] = {}, firstFrame = 0, pictureFrame = 0;
        Size size, pictureSize;
    };
    void dropNames();
    void rewind();
    Status makeTextures();
    void uploadLists();
    // Of an averaged map: the members that the next draws count.
    void uploadMembers(std::vector<float>& texels, std::size_t width);
    int memberWindow() const;
    int units() const { return orbits_.counts() ? orbits_.members : orbits_.iterations; }
    void setContours(GLuint program, int samples);
    void uploadGrid();
    void uploadPalette();
    void bindOrbitInputs(GLuint program);
    bool recover();
    bool ready(GLuint& program, bool wait = false);
    void drawUnit(GLuint program, double target);
    bool awaitUnit(double seconds, double target);
    Status colourInto(GLuint frame, Size size, int rule, FieldName shown, int samples);
    Size sampled() const {
        return {size_.width * options_.samples, size_.height * options_.samples};
    }

    GpuDevice& device_;
    const std::string colourText_ = colourShader();
    int generation_ = -1;
    State state_ = State::empty;
    Status status_;
    Scene scene_;
    GpuOptions options_;
    Size size_;
    GpuOrbits orbits_;
    std::optional<ColourPass> pass_;
    Textures names_;
    bool bound_ = false;     // lists and grid of this scene are uploaded
    bool painted_ = false;   // the palette is uploaded
    bool coloured_ = false;  // the texture shows the newest orbits

    // The sweep: all rows get `steps_` iterations, or members, from textures `source_` to the
    // others.
    int source_ = 0;
    int row_ = 0, steps_ = 0, done_ = 0;  // steps, or members of an averaged map
    int firstMember_ = 0;                 // of those whose roots are uploaded
    bool first_ = true, anyOrbits_ = false;
    GLsync fence_ = nullptr;
    double issued_ = 0, workIssued_ = 0;
    int looks_ = 0;       // at the fence of that draw
    double rate_ = 0;     // pixels times iterations a second that the next draw counts on
    double slowest_ = 0;  // the least that this picture has shown
};

}  // namespace versorium
