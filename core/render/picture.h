// SPDX-License-Identifier: MIT
#pragma once
// A scene as the bytes of a PNG that carries the scene and how it was rendered: rendering what it
// carries gives the same bytes again.

#include "io/document.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {

struct PictureOptions {
    Size size{0, 0};  // 0: 800 pixels high, as wide as the scene's aspect asks
    Flavour flavour = Flavour::exact;
    bool shortcuts = true;
    std::vector<FieldName> also = {};  // RenderOptions::also
};

// The options that a document was rendered with; what it does not say keeps its default.
Expected<PictureOptions> pictureOptions(const Document& document);
// What a picture of this scene carries.
Document pictureDocument(const Scene& scene, const PictureOptions& options);
Size pictureSize(const Scene& scene, const PictureOptions& options);

Expected<std::vector<unsigned char>> renderPicture(CpuRenderer& renderer, const Scene& scene,
                                                   const PictureOptions& options, Job& job);

}  // namespace versorium
