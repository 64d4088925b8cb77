// SPDX-License-Identifier: MIT
#pragma once
// The averaged membership of a scene's ensemble as a picture that sharpens while it counts: members
// are added in any portions, and the mean and its standard error may be drawn after each. Counts
// are whole numbers, so the result is the same to the bit for any portions and any number of
// threads, and a run may be stopped, saved, and gone on with later.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/raster.h"
#include "jobs/job.h"
#include "render/frame.h"
#include "scene/scene.h"

namespace versorium {

class Binder;

// Whether the picture of a scene shows what is counted over an ensemble.
bool showsEnsemble(const Scene& scene);

class AveragedMap {
  public:
    // Nothing is counted yet. `size` is in pixels; there is a count for each of the scene's
    // samples. ErrorKind::usage where the scene's ensemble varies nothing.
    static Expected<AveragedMap> make(const Scene& scene, Size size);

    // Counts that many members more. Cancelled: the counts stay what they were.
    Status add(Binder& binder, std::uint64_t members, const RenderOptions& options, Job& job);
    std::uint64_t members() const { return members_; }

    // One number for each sample, row 0 on top.
    Raster<double> mean() const;
    Raster<double> standardError() const;
    // Of a rectangle of samples, row after row.
    std::vector<std::uint32_t> counts(int x, int y, int width, int height) const;

    // What the counts of a scene and size follow from, as a hash: equal ones have equal counts.
    static std::string keyOf(const Scene& scene, Size size);
    const std::string& key() const { return key_; }
    // ErrorKind::usage unless this is the map of that scene and size. Colours, layers, iso where
    // the solid set is not counted, and the number of members may differ.
    Status check(const Scene& scene, Size size) const;

    // The counts as a file: "VRSAVG1\n", SHA-256 of what is counted (64 hexadecimal digits), then
    // little-endian: uint32 width and height in samples, uint64 members, uint32 counts.
    std::vector<unsigned char> save() const;
    // Takes the counts of such a file. ErrorKind::data where it is none or belongs to another
    // scene, size or seed.
    Status restore(std::span<const unsigned char> bytes);

  private:
    AveragedMap(Scene scene, Size size) : scene_(std::move(scene)), size_(size) {}

    Scene scene_;
    Size size_;  // in pixels
    std::string key_;
    std::uint64_t members_ = 0;
    Raster<std::uint32_t> counts_;  // at samples
};

}  // namespace versorium
