// SPDX-License-Identifier: MIT
#pragma once
// The renderer's side of the seam of plates: what a scene says about its picture (axes, colour bar,
// facts for captions, a sentence for the alternative text), and the picture itself. Texts and
// numbers are in the language of the words given.

#include "i18n/language.h"
#include "plate/plate.h"
#include "plate/scene_words.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {

// `renderer` and `job` outlive the source. Of `panels` scenes each draws its part of the job.
PanelSource scenePanels(CpuRenderer& renderer, const Words& words, Job& job, int panels);

Expected<PanelInfo> describeScene(CpuRenderer& renderer, const Scene& scene, const Words& words,
                                  Job& job);
// The axes and facts of a bifurcation diagram, and its picture.
Expected<PanelInfo> describeDiagram(CpuRenderer& renderer, const Scene& scene,
                                    const DiagramPlot& plot, const Words& words, Job& job);
Expected<DiagramPicture> drawDiagram(CpuRenderer& renderer, const Scene& scene,
                                     const DiagramPlot& plot, Size pixels, Job& job);
// Coordinates on the first two axes of `scene` of the parameters of `other`: by the first number of
// each axis. ErrorKind::data where `other` has no such number.
Expected<std::array<double, 2>> locateScene(const Scene& scene, const Scene& other);
// Cycles, manifolds and critical set over a dynamical plane.
Expected<std::vector<OverlayPart>> overlayOf(CpuRenderer& renderer, const Scene& scene,
                                             const PlateOverlay& overlay, const Words& words,
                                             Job& job);

}  // namespace versorium
