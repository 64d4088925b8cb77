// SPDX-License-Identifier: MIT
#pragma once
// Fields that pictures were coloured from, kept at their samples: other colours of the same orbits
// measure nothing. Those that nobody asked for the longest go first once there are too many.

#include <memory>
#include <string>
#include <vector>

#include "fields/field_names.h"
#include "render/frame.h"

namespace versorium {

struct FieldTiles {
    std::string key;  // what the orbits follow from: the scene but for its colours, size, options
    double iso = 0;   // matters to some fields only
    std::vector<FieldName> fields;
    // tiles[t][f]: of tile t (render/cpu/tiles.h) what evaluateFields gives for fields[f].
    std::vector<std::vector<std::vector<double>>> tiles;
    std::size_t bytes() const;
};

class KeptFields {
  public:
    // No more than so many bytes; 0, as at first: nothing is kept.
    void keepUpTo(std::size_t bytes) { most_ = bytes; }
    bool keeps() const { return most_ > 0; }
    bool fits(double bytes) const { return bytes <= static_cast<double>(most_); }

    // An empty one for a picture of this scene and size.
    static FieldTiles tilesFor(const Scene& scene, Size size, const RenderOptions& options,
                               std::vector<FieldName> fields);
    // One that has all fields of the wanted one, measured in the same way; else null.
    std::shared_ptr<const FieldTiles> find(const FieldTiles& wanted);
    // False where it is larger than all that may be kept.
    bool put(FieldTiles measured);

  private:
    std::size_t most_ = 0;
    std::vector<std::shared_ptr<const FieldTiles>> kept_;  // newest last
};

}  // namespace versorium
