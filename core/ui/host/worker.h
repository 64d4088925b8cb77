// SPDX-License-Identifier: MIT
#pragma once
// Does a WorkRequest on the CPU. What runs it, a thread or a web worker, is the host's.

#include "render/cpu/averaged_maps.h"
#include "render/cpu/cpu_renderer.h"
#include "ui/host/asset_store.h"
#include "ui/host/host.h"

namespace versorium {

// With what the next job can go on from: grids of shapes, members that were counted, fields that
// were measured, assets that came.
struct Worker {
    // Fields of the last pictures of two large views, so that other colours of them come at once;
    // in a page, which has less memory, of one.
    static constexpr std::size_t kMostFieldBytes = std::size_t{sizeof(void*) == 4 ? 80 : 192} << 20;

    Worker() { renderer.keepFields(kMostFieldBytes); }

    CpuRenderer renderer;
    AveragedMaps averaged;
    AssetStore assets;
};

WorkAnswer compute(Worker& worker, const WorkRequest& request, Job& job);
// The bytes of the file that an export makes: a PNG, or of a motion a ZIP archive of them.
Expected<std::vector<unsigned char>> computeExport(CpuRenderer& renderer,
                                                   const ExportRequest& request, Job& job);

}  // namespace versorium
