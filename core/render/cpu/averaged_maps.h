// SPDX-License-Identifier: MIT
#pragma once
// The averaged maps that live pictures count, kept between one request and the next: other colours
// of the same counts count nothing anew, and a larger ensemble goes on from what is there.

#include <memory>
#include <vector>

#include "render/cpu/averaged_map.h"
#include "scene/scene.h"

namespace versorium {

class AveragedMaps {
  public:
    // The map of this scene and size, with what it has counted before where that is no more than
    // the scene's ensemble has members.
    Expected<std::shared_ptr<AveragedMap>> of(const Scene& scene, Size size);

    // Counts for about so many seconds, at least one member, at most up to the scene's. The counts
    // are those of the exact kernels, so that they are the same wherever they are made.
    Status count(AveragedMap& map, const Scene& scene, double seconds, Binder& binder, Job& job);

  private:
    struct Entry {
        std::shared_ptr<AveragedMap> map;
        double rate = 0;  // members in a second, of the last portion; 0: not known
        std::size_t samples = 0;
    };
    // The last ones that were asked for, the newest in front. Each view has a coarse one and two
    // finer ones.
    static constexpr std::size_t kMostMaps = 15;
    static constexpr std::size_t kMostSamples = std::size_t{1} << 25;  // 4 bytes each
    std::vector<Entry> entries_;
};

}  // namespace versorium
