// SPDX-License-Identifier: MIT
#include "render/picture.h"

#include <algorithm>
#include <cmath>

#include "colour/srgb.h"
#include "io/png.h"

namespace versorium {
namespace {

constexpr int kDefaultHeight = 800;

bool opaque(const Raster<float>& picture) {
    for (std::size_t i = 3; i < picture.values().size(); i += 4)
        if (picture.values()[i] != 1) return false;
    return true;
}

Raster<unsigned char> withoutAlpha(const Raster<unsigned char>& rgba) {
    Raster<unsigned char> rgb(rgba.size(), 3);
    for (std::size_t i = 0; i < rgba.values().size() / 4; ++i)
        for (std::size_t c = 0; c < 3; ++c) rgb.values()[3 * i + c] = rgba.values()[4 * i + c];
    return rgb;
}

}  // namespace

Expected<PictureOptions> pictureOptions(const Document& document) {
    PictureOptions options;
    ObjectReader reader(document.render, "render");
    std::string flavour = "exact";
    reader.integer("width", options.size.width, 0, kMostPixels)
        .integer("height", options.size.height, 0, kMostPixels)
        .word("flavour", flavour, {"exact", "fast"});
    if (const Status status = reader.finish(); !status.ok()) return status;
    options.flavour = flavour == "fast" ? Flavour::fast : Flavour::exact;
    return options;
}

Size pictureSize(const Scene& scene, const PictureOptions& options) {
    if (options.size.width != 0 || options.size.height != 0) return options.size;
    return {std::max(1, static_cast<int>(std::lround(kDefaultHeight * scene.aspect))),
            kDefaultHeight};
}

Document pictureDocument(const Scene& scene, const PictureOptions& options) {
    const Size size = pictureSize(scene, options);
    Document document;
    document.body = sceneBody(scene);
    document.assets = scene.assets;
    document.render = Json{{"width", size.width},
                           {"height", size.height},
                           {"flavour", options.flavour == Flavour::fast ? "fast" : "exact"}};
    return document;
}

Expected<std::vector<unsigned char>> renderPicture(CpuRenderer& renderer, const Scene& scene,
                                                   const PictureOptions& options, Job& job) {
    const Size size = pictureSize(scene, options);
    if (Status status = checkSize(scene, size); !status.ok()) return status;
    // Said before hours are spent, not after.
    if ((4LL * size.width + 1) * size.height > kPngByteLimit)
        return Status::usage("a picture of " + std::to_string(size.width) + " x " +
                             std::to_string(size.height) + " pixels is too large for a PNG: " +
                             std::to_string(kPngByteLimit / 4000000) + " megapixels fit");
    Frame frame;
    // Outlines of width 1 keep their share of the picture, whatever its size.
    const RenderOptions render{options.flavour, options.shortcuts,
                               std::max(1.0, size.height / 400.0), options.also};
    if (Status status = renderer.render(scene, size, render, job, frame); !status.ok())
        return status;
    const Document document = pictureDocument(scene, options);
    const Raster<unsigned char> pixels = encodeSrgb(frame.colour);
    PngOptions png;
    png.texts = {{kDocumentKeyword, printJson(documentToJson(document))}};
    return encodePng(opaque(frame.colour) ? withoutAlpha(pixels) : pixels, png);
}

}  // namespace versorium
