// SPDX-License-Identifier: MIT
#include "render/cpu/averaged_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/hash.h"
#include "fields/ensemble.h"
#include "render/bind.h"
#include "render/cpu/tiles.h"

namespace versorium {
namespace {

constexpr std::string_view kMagic = "VRSAVG1\n";
constexpr std::size_t kHead = 8 + 64 + 4 + 4 + 8;
constexpr std::uint64_t kMostCounted = std::numeric_limits<std::uint32_t>::max();

// The scene without its colours, its layers and the number of members.
std::string textOf(Scene scene, Size size) {
    scene.colour = {};
    scene.layers.clear();
    scene.ensemble.count = 1;
    if (scene.ensemble.set != AveragedSet::solid) scene.iso = 0;
    std::map<std::string, std::shared_ptr<const Asset>> used;
    for (const auto& [hash, asset] : scene.assets)
        for (const std::string* shape :
             {&scene.shape.source, &scene.alphaOverSpace.shape, &scene.betaOverSpace.shape})
            if (*shape == "asset:" + hash) used[hash] = asset;
    scene.assets = used;
    return printJson(sceneToJson(scene)) + std::to_string(size.width) + "x" +
           std::to_string(size.height);
}

void put(std::vector<unsigned char>& bytes, std::uint64_t value, int size) {
    for (int k = 0; k < size; ++k) bytes.push_back(static_cast<unsigned char>(value >> (8 * k)));
}
std::uint64_t get(std::span<const unsigned char> bytes, std::size_t at, int size) {
    std::uint64_t value = 0;
    for (int k = 0; k < size; ++k)
        value |= std::uint64_t{bytes[at + static_cast<std::size_t>(k)]} << (8 * k);
    return value;
}

}  // namespace

bool showsEnsemble(const Scene& scene) {
    const Colouring& colour = scene.colour;
    return scene.ensemble.varies() && colour.rule == ColourRule::palette &&
           (colour.field == FieldName::meanMembership || colour.field == FieldName::standardError);
}

std::string AveragedMap::keyOf(const Scene& scene, Size size) {
    return sha256(textOf(scene, size));
}

Expected<AveragedMap> AveragedMap::make(const Scene& scene, Size size) {
    if (Status status = checkSize(scene, size); !status.ok()) return status;
    if (!scene.ensemble.varies())
        return Status::usage(
            "the scene's ensemble varies nothing: give \"ensemble\" roots, ranges or discs");
    AveragedMap map(scene, size);
    map.key_ = keyOf(scene, size);
    map.counts_ =
        Raster<std::uint32_t>({size.width * scene.samples, size.height * scene.samples}, 1);
    return map;
}

Status AveragedMap::add(Binder& binder, std::uint64_t members, const RenderOptions& options,
                        Job& job) {
    if (members_ + members > kMostCounted)
        return Status::usage("an ensemble has at most " + std::to_string(kMostCounted) +
                             " members");
    Expected<OrbitProgram> program = binder.bind(scene_, job);
    if (!program) return program.status();
    const Viewport view = viewportOf(scene_, counts_.size());
    const std::vector<Tile> tiles = tilesOf(counts_.size());
    Raster<std::uint32_t> sum = counts_;
    const EvaluateOptions evaluate{.flavour = options.flavour,
                                   .shortcuts = options.shortcuts,
                                   .stop = [&job] { return job.cancelled(); }};
    const bool done = job.parallelFor(tiles.size(), [&](std::size_t index) {
        const Tile& tile = tiles[index];
        const Samples samples = samplesOf(tile, 1, view, thirdCoordinate(scene_));
        const double* coordinates[3] = {samples.u.data(), samples.v.data(), samples.w.data()};
        std::vector<std::uint32_t> counts(samples.u.size(), 0);
        if (!countMembers(*program, members_, members, static_cast<int>(counts.size()), coordinates,
                          counts.data(), evaluate))
            return;
        for (int y = 0; y < tile.height; ++y)
            for (int x = 0; x < tile.width; ++x)
                sum.at(tile.x + x, tile.y + y) +=
                    counts[static_cast<std::size_t>(y * tile.width + x)];
    });
    if (!done || job.cancelled()) return Status::cancelled();
    counts_ = std::move(sum);
    members_ += members;
    return {};
}

Raster<double> AveragedMap::mean() const {
    Raster<double> mean(counts_.size(), 1);
    for (int y = 0; y < mean.height(); ++y)
        for (int x = 0; x < mean.width(); ++x) mean.at(x, y) = meanOf(counts_.at(x, y), members_);
    return mean;
}

Raster<double> AveragedMap::standardError() const {
    Raster<double> error(counts_.size(), 1);
    for (int y = 0; y < error.height(); ++y)
        for (int x = 0; x < error.width(); ++x)
            error.at(x, y) = standardErrorOf(counts_.at(x, y), members_);
    return error;
}

std::vector<std::uint32_t> AveragedMap::counts(int x, int y, int width, int height) const {
    std::vector<std::uint32_t> part;
    for (int row = y; row < y + height; ++row)
        for (int column = x; column < x + width; ++column) part.push_back(counts_.at(column, row));
    return part;
}

Status AveragedMap::check(const Scene& scene, Size size) const {
    if (keyOf(scene, size) == key_) return {};
    return Status::usage("the averaged map is of another scene or size");
}

std::vector<unsigned char> AveragedMap::save() const {
    const std::string head = std::string(kMagic) + key_;
    std::vector<unsigned char> bytes(head.begin(), head.end());
    put(bytes, static_cast<std::uint64_t>(counts_.width()), 4);
    put(bytes, static_cast<std::uint64_t>(counts_.height()), 4);
    put(bytes, members_, 8);
    for (std::uint32_t count : counts_.values()) put(bytes, count, 4);
    return bytes;
}

Status AveragedMap::restore(std::span<const unsigned char> bytes) {
    if (bytes.size() < kHead || !std::equal(kMagic.begin(), kMagic.end(), bytes.begin()))
        return Status::data("this is no file of an averaged map");
    if (!std::equal(key_.begin(), key_.end(), bytes.begin() + 8))
        return Status::data("the averaged map in this file is of another scene, size or seed");
    const std::uint64_t members = get(bytes, 80, 8);
    const auto& old = counts_.values();
    if (get(bytes, 72, 4) != static_cast<std::uint64_t>(counts_.width()) ||
        get(bytes, 76, 4) != static_cast<std::uint64_t>(counts_.height()) ||
        members > kMostCounted || bytes.size() != kHead + 4 * old.size())
        return Status::data("the file of the averaged map is cut or damaged");
    Raster<std::uint32_t> counts(counts_.size(), 1);
    std::size_t at = kHead;
    for (int y = 0; y < counts.height(); ++y)
        for (int x = 0; x < counts.width(); ++x, at += 4) {
            const std::uint64_t count = get(bytes, at, 4);
            if (count > members)
                return Status::data(
                    "the file of the averaged map is damaged: a count is larger "
                    "than the number of members");
            counts.at(x, y) = static_cast<std::uint32_t>(count);
        }
    counts_ = std::move(counts);
    members_ = members;
    return {};
}

}  // namespace versorium
