// SPDX-License-Identifier: MIT
#include "scene/parts.h"

namespace versorium {

void keepShape(Scene& scene, const Scene& old) {
    scene.shape = old.shape;
    scene.alphaOverSpace = old.alphaOverSpace;
    scene.betaOverSpace = old.betaOverSpace;
    scene.assets = old.assets;
}

void keepLook(Scene& scene, const Scene& old) {
    scene.colour = old.colour;
    scene.layers = old.layers;
    scene.aspect = old.aspect;
    scene.assets = old.assets;
}

std::set<std::string> namedAssets(const Scene& scene) {
    constexpr std::string_view prefix = "asset:";
    std::set<std::string> named;
    const auto add = [&](const std::string& source) {
        if (source.starts_with(prefix)) named.insert(source.substr(prefix.size()));
    };
    for (const std::string* shape :
         {&scene.shape.source, &scene.alphaOverSpace.shape, &scene.betaOverSpace.shape})
        add(*shape);
    for (const Layer& layer : scene.layers)
        for (const std::string& source : layer.sources) add(source);
    return named;
}

void dropAssetsExcept(Scene& scene, const std::set<std::string>& named) {
    std::erase_if(scene.assets, [&](const auto& asset) { return !named.contains(asset.first); });
}

void takeAssets(Scene& scene, const Assets& assets) {
    for (const std::string& hash : namedAssets(scene))
        if (const auto found = assets.find(hash); found != assets.end())
            scene.assets.insert(*found);
}

Json sceneKey(const Scene& scene) {
    Json key = sceneBody(scene);
    for (const std::string& hash : namedAssets(scene))
        if (scene.assets.contains(hash)) key["assets"].push_back(hash);
    return key;
}

}  // namespace versorium
