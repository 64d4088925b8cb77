// SPDX-License-Identifier: MIT
#include "render/layers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "colour/srgb.h"
#include "image/leaf.h"
#include "io/image_files.h"

namespace versorium {
namespace {

constexpr int kLeafSide = 1024;
constexpr std::size_t kMostKept = 64;

using Light = std::array<float, 4>;  // multiplied by alpha

Raster<float> multiplied(Raster<float> image) {
    for (std::size_t i = 0; i + 3 < image.values().size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c) image.values()[i + c] *= image.values()[i + 3];
    return image;
}

Raster<float> linear(const Raster<unsigned char>& image) {
    std::array<float, 256> light{};
    for (std::size_t k = 0; k < light.size(); ++k)
        light[k] = static_cast<float>(linearFromSrgb(static_cast<double>(k) / 255));
    Raster<float> result(image.size(), 4);
    for (std::size_t i = 0; i < result.values().size(); ++i)
        result.values()[i] =
            i % 4 == 3 ? static_cast<float>(image.values()[i]) / 255 : light[image.values()[i]];
    return result;
}

Raster<float> halved(const Raster<float>& image) {
    const Size size{std::max(1, image.width() / 2), std::max(1, image.height() / 2)};
    Raster<float> half(size, 4);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < 4; ++c) {
                const int right = std::min(2 * x + 1, image.width() - 1);
                const int below = std::min(2 * y + 1, image.height() - 1);
                half.at(x, y, c) = 0.25f * (image.at(2 * x, 2 * y, c) + image.at(right, 2 * y, c) +
                                            image.at(2 * x, below, c) + image.at(right, below, c));
            }
    return half;
}

LayerImage withLevels(Raster<float> image) {
    LayerImage result;
    result.levels.push_back(multiplied(std::move(image)));
    while (result.levels.back().width() > 1 && result.levels.back().height() > 1)
        result.levels.push_back(halved(result.levels.back()));
    return result;
}

// Between the four nearest pixels; transparent beyond the border. x and y in pixels.
Light lookUp(const Raster<float>& image, double x, double y) {
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const auto across = static_cast<float>(x - 0.5 - left);
    const auto down = static_cast<float>(y - 0.5 - top);
    Light sum{};
    if (!(left >= -1 && top >= -1 && left < image.width() && top < image.height())) return sum;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const int column = static_cast<int>(left) + i, row = static_cast<int>(top) + j;
            if (column < 0 || row < 0 || column >= image.width() || row >= image.height()) continue;
            const float weight = (i == 0 ? 1 - across : across) * (j == 0 ? 1 - down : down);
            const float* pixel = &image.at(column, row);
            for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * pixel[c];
        }
    return sum;
}

// Where an image lies in a picture of some height.
class Placed {
  public:
    Placed(const Layer& layer, const LayerImage& image, Size picture)
        : sheet_(image.sheet), opacity_(static_cast<float>(layer.opacity)) {
        const double shown = layer.scale * picture.height;  // the image's height in pixels
        std::size_t level = 0;
        double step = image.levels[0].height() / shown;
        while (step >= 2 && level + 1 < image.levels.size()) {
            ++level;
            step = image.levels[level].height() / shown;
        }
        image_ = &image.levels[level];
        step_ = step;
        x0_ = 0.5 * image_->width() - step * (0.5 * picture.width + layer.x * picture.height);
        y0_ = 0.5 * image_->height() - step * (0.5 * picture.height - layer.y * picture.height);
    }
    Light at(int x, int y) const {
        Light light{};
        if (sheet_)
            std::copy_n(image_->row(0), light.size(), light.begin());
        else
            light = lookUp(*image_, x0_ + step_ * (x + 0.5), y0_ + step_ * (y + 0.5));
        for (float& part : light) part *= opacity_;
        return light;
    }

  private:
    const Raster<float>* image_ = nullptr;
    bool sheet_ = false;
    float opacity_ = 1;
    double step_ = 1, x0_ = 0, y0_ = 0;
};

void layOver(Light& under, const Light& over) {
    for (std::size_t c = 0; c < 4; ++c) under[c] = over[c] + (1 - over[3]) * under[c];
}

// The frame of a sequence that is shown.
const std::string& sourceOf(const Layer& layer) {
    const auto count = static_cast<double>(layer.sources.size());
    double at = std::floor(layer.frame);
    at -= count * std::floor(at / count);
    return layer.sources[static_cast<std::size_t>(std::clamp(at, 0.0, count - 1))];
}

}  // namespace

Expected<std::shared_ptr<const LayerImage>> LayerImages::get(const Scene& scene,
                                                             const std::string& source) {
    const std::lock_guard lock(mutex_);
    if (const auto found = kept_.find(source); found != kept_.end()) return found->second;
    std::shared_ptr<const LayerImage> made;
    if (source == kLeafLayer) {
        made = std::make_shared<const LayerImage>(withLevels(leafImage(kLeafSide)));
    } else if (const Expected<Colour> colour = colourFromHex(source); colour.ok()) {
        Raster<float> pixel({1, 1}, 4);
        const double parts[4] = {colour->r, colour->g, colour->b, colour->a};
        for (int c = 0; c < 4; ++c) pixel.at(0, 0, c) = static_cast<float>(parts[c]);
        LayerImage image = withLevels(std::move(pixel));
        image.sheet = true;
        made = std::make_shared<const LayerImage>(std::move(image));
    } else {
        const auto asset =
            scene.assets.find(source.substr(std::min<std::size_t>(6, source.size())));
        if (asset == scene.assets.end())
            return Status::data("layers: the scene names " + source +
                                " but does not carry it; give the image again");
        Expected<Raster<unsigned char>> image = readImage(asset->second->bytes);
        if (!image) return image.status().in("layers: " + asset->second->name);
        made = std::make_shared<const LayerImage>(withLevels(linear(*image)));
    }
    if (kept_.size() >= kMostKept) kept_.clear();
    kept_[source] = made;
    return made;
}

Status composeLayers(const Scene& scene, LayerImages& images, Raster<float>& picture) {
    if (scene.layers.empty()) return {};
    std::vector<std::shared_ptr<const LayerImage>> held;
    std::vector<Placed> behind, front;
    for (const Layer& layer : scene.layers) {
        Expected<std::shared_ptr<const LayerImage>> image = images.get(scene, sourceOf(layer));
        if (!image) return image.status();
        held.push_back(*image);
        (layer.front ? front : behind).emplace_back(layer, *held.back(), picture.size());
    }
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            float* pixel = &picture.at(x, y);
            Light all{};
            for (const Placed& layer : behind) layOver(all, layer.at(x, y));
            layOver(all, {pixel[0] * pixel[3], pixel[1] * pixel[3], pixel[2] * pixel[3], pixel[3]});
            for (const Placed& layer : front) layOver(all, layer.at(x, y));
            const float scale = all[3] > 0 ? 1 / all[3] : 0;
            for (std::size_t c = 0; c < 3; ++c) pixel[c] = all[c] * scale;
            pixel[3] = all[3];
        }
    return {};
}

}  // namespace versorium
