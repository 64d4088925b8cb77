// SPDX-License-Identifier: MIT
#pragma once
// Images behind and in front of a picture (A section 5.3), laid over one another in linear light.

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/status.h"
#include "image/raster.h"
#include "scene/scene.h"

namespace versorium {

// An image in linear light, multiplied by its alpha, with halved copies of itself, so that it can
// be looked up at any size.
struct LayerImage {
    bool sheet = false;                 // fills the picture, wherever it lies
    std::vector<Raster<float>> levels;  // four channels; the first is the image itself
};

// Decoded images, kept by their source.
class LayerImages {
  public:
    // ErrorKind::data where the scene lacks the file, or where it is no image.
    Expected<std::shared_ptr<const LayerImage>> get(const Scene& scene, const std::string& source);

  private:
    std::mutex mutex_;
    std::map<std::string, std::shared_ptr<const LayerImage>> kept_;
};

// Lays the scene's layers behind and in front of `picture` (linear light, straight alpha).
Status composeLayers(const Scene& scene, LayerImages& images, Raster<float>& picture);

}  // namespace versorium
