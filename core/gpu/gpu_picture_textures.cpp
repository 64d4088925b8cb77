// SPDX-License-Identifier: MIT
// The textures of a picture: what orbits are kept in and what they read.
#include <algorithm>

#include "fields/ensemble.h"
#include "gpu/gpu_picture.h"
#include "gpu/gpu_state.h"
#include "gpu/gpu_textures.h"

namespace versorium {

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
        names_.fields[i] = gpu::makeTarget(GL_RGBA32F, size);
        names_.states[i] = gpu::makeTarget(GL_RGBA32F, size);
    }
    names_.image = gpu::makeTarget(GL_RGBA32F, size);
    names_.picture = gpu::makeTarget(GL_RGBA8, size_);
    bool complete = glGetError() == GL_NO_ERROR;
    for (int i = 0; i < 2; ++i)
        names_.orbitFrames[i] = gpu::makeFrame({names_.fields[i], names_.states[i]}, complete);
    // The first sweep goes from textures 0, which nobody has written, to textures 1.
    names_.firstFrame =
        gpu::makeFrame({names_.fields[1], names_.states[1], names_.image}, complete);
    names_.pictureFrame = gpu::makeFrame({names_.picture}, complete);
    glBindTexture(GL_TEXTURE_2D, 0);
    if (complete) return {};
    dropNames();
    return Status::usage("the CPU draws this: the GPU has no room for " +
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
    names_.roots = gpu::makeTexture(GL_TEXTURE_2D);
    gpu::plainUnpacking();
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
    names_.grid = gpu::makeTexture(GL_TEXTURE_3D);
    gpu::plainUnpacking();
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R32F, grid.resolution.x, grid.resolution.y, grid.resolution.z,
                 0, GL_RED, GL_FLOAT, values.data());
    glBindTexture(GL_TEXTURE_3D, 0);
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

}  // namespace versorium
