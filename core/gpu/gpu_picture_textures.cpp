// SPDX-License-Identifier: MIT
// The textures of a picture: what orbits are kept in, what they read, and what is shown.
#include <algorithm>
#include <cmath>

#include "fields/ensemble.h"
#include "gpu/gpu_picture.h"
#include "gpu/gpu_state.h"
#include "math/elementary.h"
#include "render/glsl/colour_shader.h"

namespace versorium {
namespace {

constexpr int kPaletteSize = 1024;

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

void GpuPicture::dropNames() {
    // Names of a context that is gone must not be deleted in the next one.
    if (generation_ == device_.generation()) {
        const GLuint textures[] = {names_.fields[0], names_.fields[1], names_.states[0],
                                   names_.states[1], names_.image,     names_.roots,
                                   names_.grid,      names_.palette,   names_.picture};
        const GLuint frames[] = {names_.orbitFrames[0], names_.orbitFrames[1], names_.firstFrame,
                                 names_.pictureFrame};
        glDeleteTextures(9, textures);
        glDeleteFramebuffers(4, frames);
        if (fence_) glDeleteSync(fence_);
    }
    fence_ = nullptr;
    names_ = {};
    bound_ = painted_ = false;
}

Status GpuPicture::makeTextures() {
    const Size size = sampled();
    if (names_.size == size && names_.pictureSize == size_) return {};
    dropNames();
    names_.size = size;
    names_.pictureSize = size_;
    for (int i = 0; i < 2; ++i) {
        names_.fields[i] = makeTarget(GL_RGBA32F, size);
        names_.states[i] = makeTarget(GL_RGBA32F, size);
    }
    names_.image = makeTarget(GL_RGBA32F, size);
    names_.picture = makeTarget(GL_RGBA8, size_);
    bool complete = glGetError() == GL_NO_ERROR;
    for (int i = 0; i < 2; ++i)
        names_.orbitFrames[i] = makeFrame({names_.fields[i], names_.states[i]}, complete);
    // The first sweep goes from textures 0, which nobody has written, to textures 1.
    names_.firstFrame = makeFrame({names_.fields[1], names_.states[1], names_.image}, complete);
    names_.pictureFrame = makeFrame({names_.picture}, complete);
    glBindTexture(GL_TEXTURE_2D, 0);
    if (complete) return {};
    dropNames();
    return Status::usage("the CPU draws this: the graphics processor has no room for " +
                         std::to_string(size.width) + " x " + std::to_string(size.height) +
                         " orbits");
}

// Members whose roots are kept in a texture at once.
int GpuPicture::memberWindow() const {
    constexpr int kMost = 256, kTexels = 1 << 18;
    const int roots = std::max(orbits_.program.ensemble->roots.most, 1);
    return std::clamp(kTexels / roots, 1, kMost);
}

// Three rows for each member; render/glsl/shader.h says what is in them.
void GpuPicture::uploadMembers(std::vector<float>& texels, std::size_t width) {
    const Ensemble& ensemble = *orbits_.program.ensemble;
    OrbitProgram member = orbits_.program;
    // All of them, since the ensemble may grow before they are counted.
    const int count = memberWindow();
    const std::size_t before = texels.size();
    texels.resize(before + 4 * width * 3 * static_cast<std::size_t>(count), 0.0F);
    for (int m = 0; m < count; ++m) {
        ensemble.choose(static_cast<std::uint64_t>(firstMember_ + m), member);
        float* roots = &texels[before + 4 * width * 3 * static_cast<std::size_t>(m)];
        float* powers = roots + 4 * width;
        if (ensemble.list >= 0) {
            const BoundList& list = member.lists[static_cast<std::size_t>(ensemble.list)];
            for (std::size_t i = 0; i < list.size(); ++i) {
                for (std::size_t k = 0; k < 4; ++k)
                    roots[4 * i + k] = static_cast<float>(list[i].q[k]);
                powers[4 * i] = static_cast<float>(list[i].power);
                if (member.map->dimension <= 2) roots[4 * i + 2] = powers[4 * i];
            }
            powers[1] = static_cast<float>(list.size());
        }
        float* drawn = powers + 4 * width;
        const auto put = [&](std::size_t number) {
            drawn[0] = static_cast<float>(member.slice.origin[number]);
            drawn[1] = static_cast<float>(orbits_.places[number]);
            drawn += 4;
        };
        for (const Ensemble::Range& range : ensemble.ranges) put(range.number);
        for (const Ensemble::Disc& disc : ensemble.discs) put(disc.re), put(disc.im);
    }
}

void GpuPicture::uploadLists() {
    std::size_t width = 1;
    const auto& lists = orbits_.program.lists;
    for (const BoundList& list : lists) width = std::max(width, list.size());
    if (orbits_.counts()) {
        const Ensemble& ensemble = *orbits_.program.ensemble;
        const auto most = static_cast<std::size_t>(ensemble.roots.most);
        if (ensemble.list >= 0) width = std::max(width, most);
        width = std::max(width, ensemble.ranges.size() + 2 * ensemble.discs.size());
    }
    std::vector<float> texels(4 * width * 2 * kMostLists, 0.0F);
    for (std::size_t l = 0; l < lists.size(); ++l)
        for (std::size_t i = 0; i < lists[l].size(); ++i) {
            float* components = &texels[4 * (2 * l * width + i)];
            for (std::size_t k = 0; k < 4; ++k)
                components[k] = static_cast<float>(lists[l][i].q[k]);
            texels[4 * ((2 * l + 1) * width + i)] = static_cast<float>(lists[l][i].power);
        }
    if (orbits_.counts()) uploadMembers(texels, width);
    const std::size_t rows = texels.size() / (4 * width);
    glDeleteTextures(1, &names_.roots);
    names_.roots = makeTexture(GL_TEXTURE_2D);
    plainUnpacking();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(width),
                 static_cast<GLsizei>(rows), 0, GL_RGBA, GL_FLOAT, texels.data());
    glBindTexture(GL_TEXTURE_2D, 0);
}

void GpuPicture::uploadGrid() {
    glDeleteTextures(1, &names_.grid);
    names_.grid = 0;
    const DistanceField* field = orbits_.program.field.get();
    if (!field || !field->grid()) return;
    const Grid& grid = *field->grid();
    const std::vector<float> values(grid.values.begin(), grid.values.end());
    names_.grid = makeTexture(GL_TEXTURE_3D);
    plainUnpacking();
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R32F, grid.resolution.x, grid.resolution.y, grid.resolution.z,
                 0, GL_RED, GL_FLOAT, values.data());
    glBindTexture(GL_TEXTURE_3D, 0);
}

void GpuPicture::uploadPalette() {
    std::vector<float> texels;
    for (int i = 0; i < kPaletteSize; ++i) {
        const Colour c = pass_->palette().at(static_cast<double>(i) / (kPaletteSize - 1));
        for (double part : {c.r, c.g, c.b, c.a}) texels.push_back(static_cast<float>(part));
    }
    glDeleteTextures(1, &names_.palette);
    names_.palette = makeTexture(GL_TEXTURE_2D);
    plainUnpacking();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kPaletteSize, 1, 0, GL_RGBA, GL_FLOAT,
                 texels.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    painted_ = true;
}

void GpuPicture::bindOrbitInputs(GLuint program) {
    const auto at = [&](const char* name) { return glGetUniformLocation(program, name); };
    // Each texture has a unit of its own: samplers of two kinds must not share one.
    gpu::bindTexture(program, "uFields", 0, GL_TEXTURE_2D, first_ ? 0 : names_.fields[source_]);
    gpu::bindTexture(program, "uState", 1, GL_TEXTURE_2D, first_ ? 0 : names_.states[source_]);
    gpu::bindTexture(program, "uRoots", 2, GL_TEXTURE_2D, names_.roots);
    gpu::bindTexture(program, "uGrid", 3, GL_TEXTURE_3D, names_.grid);
    const OrbitProgram& orbits = orbits_.program;
    GLint sizes[kMostLists] = {};
    for (std::size_t l = 0; l < orbits.lists.size(); ++l)
        sizes[l] = static_cast<GLint>(orbits.lists[l].size());
    glUniform1iv(at("uListSize"), kMostLists, sizes);
    GLint overrides[3 * kMostOverrides] = {};
    for (std::size_t k = 0; k < orbits.overrides.size(); ++k) {
        overrides[3 * k] = orbits.overrides[k].list;
        overrides[3 * k + 1] = orbits.overrides[k].item;
        overrides[3 * k + 2] = orbits.overrides[k].component;
    }
    glUniform3iv(at("uOverride"), kMostOverrides, overrides);
    glUniform1i(at("uOverrideCount"), static_cast<GLint>(orbits.overrides.size()));
    if (!orbits_.shapeNumbers.empty())
        glUniform1fv(at("uShape"), static_cast<GLsizei>(orbits_.shapeNumbers.size()),
                     orbits_.shapeNumbers.data());
    if (!orbits.field || !orbits.field->grid()) return;
    const Grid& grid = *orbits.field->grid();
    glm::dvec3 low = grid.minimum, high = grid.maximum;
    // A planar grid has no depth to divide by.
    if (grid.planar()) low.z = -1, high.z = 1;
    glUniform3f(at("uGridMinimum"), static_cast<float>(low.x), static_cast<float>(low.y),
                static_cast<float>(low.z));
    glUniform3f(at("uGridMaximum"), static_cast<float>(high.x), static_cast<float>(high.y),
                static_cast<float>(high.z));
    glUniform1i(at("uOutsideAddsDistance"), orbits.field->outside() == Outside::distance);
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
    number("uLogDegree", versorium::log(orbits.degree > 1 ? orbits.degree : 2));
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
    const GLuint texture = makeTarget(GL_RGBA32F, size);
    const GLuint frame = makeFrame({texture}, complete);
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
    const GLuint texture = makeTarget(GL_RGBA8, size);
    const GLuint frame = makeFrame({texture}, complete);
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
