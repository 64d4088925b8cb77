// SPDX-License-Identifier: MIT
#include <limits>

#include "base/base64.h"
#include "base/hash.h"
#include "scene/properties.h"

namespace versorium {

Expected<Scene> sceneFromJson(const Json& value) {
    ObjectReader reader(value, "");
    int version = Scene::kVersion;
    reader.integer("versorium", version, 1, std::numeric_limits<int>::max());
    if (!reader.failed() && version > Scene::kVersion)
        return Status::data("versorium: version " + std::to_string(version) +
                            " is newer than this program, which reads up to " +
                            std::to_string(Scene::kVersion) + "; update it");
    std::string name = Scene().map;
    reader.text("map", name);
    if (reader.failed()) return reader.finish();
    const MapKernels* map = findMap(name);
    std::shared_ptr<const FormulaMap> typed;  // keeps the map
    // "map": "z^2 + c" is short for "map": "formula", "formula": "z^2 + c".
    const bool inPlace = !map && name != kFormulaName && looksLikeFormula(name);
    if (name == kFormulaName || inPlace) {
        std::string text = inPlace ? name : std::string();
        if (!inPlace) reader.text("formula", text);
        if (inPlace && reader.has("formula"))
            return Status::data("formula: stands beside \"map\": \"formula\" only");
        if (!inPlace && !reader.has("formula"))
            reader.fail("formula",
                        "is missing: what the map \"formula\" does, such as \"z^2 + c\"");
        if (reader.failed()) return reader.finish();
        Expected<std::shared_ptr<const FormulaMap>> made = FormulaMap::make(text);
        if (!made) return Status::data((inPlace ? "map, " : "formula, ") + made.status().message());
        typed = *made;
        map = &typed->kernels();
    } else if (reader.has("formula")) {
        return Status::data("formula: stands beside \"map\": \"formula\" only");
    }
    if (!map)
        return Status::data("map: no map is named \"" + name +
                            "\"; the command \"versorium maps\" lists them");
    Scene scene = sceneOf(*map);
    readProperties(reader, scene, sceneTable());
    if (const Json* assets = reader.child("assets"))
        reader.fail(assetsFromJson(*assets, reader.pathOf("assets"), scene.assets));
    if (const Status status = reader.finish(); !status.ok()) return status;
    if (const Status status = checkScene(scene); !status.ok()) return status;
    return scene;
}

Json assetsToJson(const Assets& assets) {
    Json json = Json::object();
    for (const auto& [hash, asset] : assets)
        json[hash] = Json{{"name", asset->name}, {"data", base64Encode(asset->bytes)}};
    return json;
}

Status assetsFromJson(const Json& value, const std::string& path, Assets& assets) {
    if (!value.is_object()) return Status::data(path + ": an object is expected");
    std::size_t total = 0;
    for (auto item = value.begin(); item != value.end(); ++item) {
        const std::string own = path + "." + item.key();
        ObjectReader one(*item, own);
        Asset asset;
        std::string data;
        one.text("name", asset.name).text("data", data);
        if (Status status = one.finish(); !status.ok()) return status;
        Expected<std::vector<unsigned char>> bytes = base64Decode(data, kMostAssetBytes - total);
        if (!bytes) return bytes.status().in(own + ".data");
        total += bytes->size();
        if (sha256(*bytes) != item.key())
            return Status::data(own + ": the content does not have this SHA-256");
        asset.bytes = std::move(*bytes);
        assets[item.key()] = std::make_shared<const Asset>(std::move(asset));
    }
    return {};
}

Json sceneToJson(const Scene& scene) {
    Json json = sceneBody(scene);
    if (!scene.assets.empty()) json["assets"] = assetsToJson(scene.assets);
    return json;
}

Json sceneBody(const Scene& scene) {
    Json json;
    json["versorium"] = Scene::kVersion;
    json["map"] = scene.map;
    if (scene.formula) json["formula"] = scene.formula->formula().text;
    writeProperties(scene, sceneTable(), json);
    return json;
}

}  // namespace versorium
