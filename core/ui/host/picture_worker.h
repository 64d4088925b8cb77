// SPDX-License-Identifier: MIT
#pragma once
// Answers a PictureRequest on the processor. What runs it, a thread or a web worker, is the host's.

#include "render/cpu/averaged_maps.h"
#include "render/cpu/cpu_renderer.h"
#include "ui/host/host.h"

namespace versorium {

// What the next picture can go on from: grids of shapes, and members that were counted.
struct PictureMaker {
    CpuRenderer renderer;
    AveragedMaps averaged;
};

PictureAnswer computePicture(PictureMaker& maker, const PictureRequest& request, Job& job);
// The bytes of the file that an export makes: a PNG, or of a motion a ZIP archive of them.
Expected<std::vector<unsigned char>> computeExport(CpuRenderer& renderer,
                                                   const ExportRequest& request, Job& job);

}  // namespace versorium
