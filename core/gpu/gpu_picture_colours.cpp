// SPDX-License-Identifier: MIT
// Orbits become colours, and what was measured or drawn is read.
#include <algorithm>
#include <cmath>

#include "gpu/gpu_picture.h"
#include "gpu/gpu_state.h"
#include "gpu/gpu_textures.h"
#include "math/elementary.h"
#include "render/glsl/colour_shader.h"

namespace versorium {
namespace {

constexpr int kPaletteSize = 1024;

void plainPacking() {
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    for (GLenum length : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS})
        glPixelStorei(length, 0);
}

void vector4(GLint at, const DisplayColour& c) {
    glUniform4f(at, static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b),
                static_cast<float>(c.a));
}
void vector4(GLint at, const Colour& c) { vector4(at, DisplayColour{c.r, c.g, c.b, c.a}); }

// The ends of the scale where it is linear.
void straightRange(const Scale& scale, float& low, float& high) {
    const auto straight = [&](double x) {
        if (scale.kind == ScaleKind::log) return versorium::log(x);
        if (scale.kind == ScaleKind::sqrt) return x < 0 ? -std::sqrt(-x) : std::sqrt(x);
        return x;
    };
    low = static_cast<float>(straight(scale.low));
    high = static_cast<float>(straight(scale.high));
}

}  // namespace

void GpuPicture::uploadPalette() {
    std::vector<float> texels;
    for (int i = 0; i < kPaletteSize; ++i) {
        const Colour c = pass_->palette().at(static_cast<double>(i) / (kPaletteSize - 1));
        for (double part : {c.r, c.g, c.b, c.a}) texels.push_back(static_cast<float>(part));
    }
    glDeleteTextures(1, &names_.palette);
    names_.palette = gpu::makeTexture(GL_TEXTURE_2D);
    gpu::plainUnpacking();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kPaletteSize, 1, 0, GL_RGBA, GL_FLOAT,
                 texels.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    painted_ = true;
}

Status GpuPicture::colourInto(GLuint frame, Size size, int rule, FieldName shown, int samples) {
    if (!painted_) uploadPalette();
    const GpuDevice::Program made = device_.program(colourText_);
    if (!made.status.ok()) return made.status;
    if (made.compiling()) return Status::usage("the program is still being compiled");
    const GLuint program = made.name;
    const OrbitProgram& orbits = orbits_.program;
    const Colouring& colouring = scene_.colour;
    const Palette& palette = pass_->palette();
    glUseProgram(program);
    const auto at = [&](const char* name) { return glGetUniformLocation(program, name); };
    const auto number = [&](const char* name, double value) {
        glUniform1f(at(name), static_cast<float>(value));
    };
    gpu::bindTexture(program, "uFields", 0, GL_TEXTURE_2D, names_.fields[source_]);
    gpu::bindTexture(program, "uImage", 1, GL_TEXTURE_2D, names_.image);
    gpu::bindTexture(program, "uPalette", 2, GL_TEXTURE_2D, names_.palette);
    gpu::bindTexture(program, "", 3, GL_TEXTURE_3D, 0);
    const double radius = orbits.escapeRadius;
    glUniform1i(at("uDimension"), orbits.map->dimension);
    number("uIterations", orbits.iterations);
    glUniform1i(at("uBoundless"), !(radius * radius < 3e38));
    number("uSquaredRadius", radius * radius < 3e38 ? radius * radius : 0);
    glUniform1i(at("uOnlyLast"), orbits.onlyLastTested);
    number("uTwiceLogRadius", std::isfinite(radius) ? 2 * versorium::log(radius) : 0);
    number("uLogDegree", orbits.measuresGrowth() ? 0 : versorium::log(orbits.degree));
    number("uIso", orbits.iso);

    glUniform1i(at("uRule"), rule);
    glUniform1i(at("uShown"), static_cast<int>(shown));
    const std::optional<FieldName> interior = fieldOf(colouring.interior);
    glUniform1i(at("uInterior"), interior ? static_cast<int>(*interior) : -1);
    glUniform1i(at("uScale"), static_cast<int>(pass_->scale().kind));
    float low = 0, high = 1;
    straightRange(pass_->scale(), low, high);
    glUniform2f(at("uRange"), low, high);
    glUniform1i(at("uCyclicPalette"), palette.kind() == PaletteKind::cyclic);
    glUniform1i(at("uSteppedPalette"), palette.kind() == PaletteKind::qualitative);
    vector4(at("uInteriorColour"), palette.interior);
    vector4(at("uUndefinedColour"), palette.undefined);
    const Colour& under = options_.background;
    glUniform3f(at("uBackground"), static_cast<float>(under.r), static_cast<float>(under.g),
                static_cast<float>(under.b));
    const auto gradient = [&](const char* first, const char* second, const Gradient& g) {
        vector4(at(first), g.start);
        vector4(at(second), g.finish);
    };
    gradient("uEscaped[0]", "uEscaped[1]", colouring.escaped);
    gradient("uAttracted[0]", "uAttracted[1]", colouring.attracted);
    glUniform2f(at("uExponents"), static_cast<float>(colouring.escaped.exponent),
                static_cast<float>(colouring.attracted.exponent));
    glUniform1i(at("uSmoothing"), colouring.smoothing == Smoothing::ratio    ? 1
                                  : colouring.smoothing == Smoothing::logLog ? 2
                                                                             : 0);
    glUniform1i(at("uAttractedVaries"), !(colouring.attracted.start == colouring.attracted.finish));
    number("uMembers", orbits_.counts() ? done_ : 1);
    setContours(program, rule == static_cast<int>(ColourRule::palette) ? samples : 0);
    glUniform1i(at("uSamples"), samples);
    glUniform2i(at("uSize"), size.width, size.height);

    const gpu::DrawState state(frame, size);
    device_.drawQuad();
    return {};
}

// `samples` along each side of a pixel; 0: no contours.
void GpuPicture::setContours(GLuint program, int samples) {
    const auto at = [&](const char* name) { return glGetUniformLocation(program, name); };
    const Colouring& colouring = scene_.colour;
    float levels[kMostGpuContours] = {};
    const std::size_t count = samples > 0 ? colouring.contours.size() : 0;
    std::copy_n(colouring.contours.begin(), count, levels);
    glUniform1i(at("uContourCount"), static_cast<GLint>(count));
    glUniform1fv(at("uContours"), kMostGpuContours, levels);
    // As render/outline.cpp draws them.
    const double width = options_.lineWidth * colouring.outlineWidth;
    glUniform1f(at("uLineReach"), static_cast<float>(std::max(0.5, 0.5 * width * samples) + 0.5));
    vector4(at("uLineColour"), *colourFromHex(colouring.outlineColour));
}

GLuint GpuPicture::texture() {
    if (!anyOrbits_ || generation_ != device_.generation()) return 0;
    if (!coloured_) {
        const Status status =
            colourInto(names_.pictureFrame, size_, static_cast<int>(scene_.colour.rule),
                       pass_->shown(), options_.samples);
        if (!status.ok()) return 0;
        coloured_ = true;
    }
    return names_.picture;
}

bool GpuPicture::copyInto(GLuint target) {
    if (texture() == 0) return false;
    glBindFramebuffer(GL_FRAMEBUFFER, names_.pictureFrame);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, target);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, size_.width, size_.height, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return true;
}

Status GpuPicture::readFields(const std::vector<FieldName>& fields,
                              std::vector<Raster<float>>& rasters) {
    if (!anyOrbits_ || generation_ != device_.generation())
        return Status::usage("there are no orbits to read yet");
    if (Status status = carriesFields(orbits_, fields); !status.ok()) return status;
    const Size size = sampled();
    bool complete = true;
    const GLuint texture = gpu::makeTarget(GL_RGBA32F, size);
    const GLuint frame = gpu::makeFrame({texture}, complete);
    Status status;
    rasters.clear();
    Raster<float> texels(size, 4);
    for (FieldName field : fields) {
        status = colourInto(frame, size, kRawRule, field, 1);
        if (!status.ok()) break;
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        plainPacking();
        glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_FLOAT, texels.values().data());
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        const int channels = channelCount(field, orbits_.program);
        Raster<float>& raster = rasters.emplace_back(size, channels);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                for (int c = 0; c < channels; ++c) raster.at(x, y, c) = texels.at(x, y, c);
    }
    glDeleteFramebuffers(1, &frame);
    glDeleteTextures(1, &texture);
    return status;
}

Status GpuPicture::readPicture(Raster<unsigned char>& rgba) {
    if (texture() == 0) return Status::usage("there is no picture to read yet");
    rgba = Raster<unsigned char>(size_, 4);
    glBindFramebuffer(GL_FRAMEBUFFER, names_.pictureFrame);
    plainPacking();
    glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.values().data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return {};
}

Status GpuPicture::readSmall(Size size, Raster<unsigned char>& rgba) {
    if (texture() == 0) return Status::usage("there is no picture to read yet");
    bool complete = true;
    const GLuint texture = gpu::makeTarget(GL_RGBA8, size);
    const GLuint frame = gpu::makeFrame({texture}, complete);
    rgba = Raster<unsigned char>(size, 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, names_.pictureFrame);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame);
    glBlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size.width, size.height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    plainPacking();
    glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.values().data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &frame);
    glDeleteTextures(1, &texture);
    return {};
}

}  // namespace versorium
