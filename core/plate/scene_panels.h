// SPDX-License-Identifier: MIT
#pragma once
// The renderer's side of the seam of plates: what a scene says about its picture (axes, colour bar,
// facts for captions, a sentence for the alternative text), and the picture itself.

#include "plate/plate.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {

// `renderer` and `job` outlive the source. `assets` are those of the plate's document, of whose
// scenes there are `panels`: each draws its part of the job.
PanelSource scenePanels(CpuRenderer& renderer, const Json& assets, Job& job, int panels);

Expected<PanelInfo> describeScene(CpuRenderer& renderer, const Scene& scene, Job& job);
// A sentence about the picture, plain text: map, parameters, plane, rule of colour.
std::string sceneSentence(const Scene& scene);

}  // namespace versorium
