// SPDX-License-Identifier: MIT
#include <limits>

#include "base/base64.h"
#include "base/hash.h"
#include "scene/properties.h"

namespace versorium {
namespace {

void readAssets(ObjectReader& reader, Scene& scene) {
    const Json* found = reader.child("assets");
    if (!found) return;
    if (!found->is_object()) return reader.fail("assets", "an object is expected");
    std::size_t total = 0;
    for (auto item = found->begin(); item != found->end(); ++item) {
        const std::string path = reader.pathOf("assets") + "." + item.key();
        ObjectReader one(*item, path);
        std::string name, data;
        one.text("name", name).text("data", data);
        if (const Status status = one.finish(); !status.ok()) return reader.fail(status);
        Expected<std::vector<unsigned char>> bytes = base64Decode(data, kMostAssetBytes - total);
        if (!bytes) return reader.fail(bytes.status().in(path + ".data"));
        total += bytes->size();
        if (sha256(*bytes) != item.key())
            return reader.fail(Status::data(path + ": the content does not have this SHA-256"));
        addAsset(scene, {name, std::move(*bytes)});
    }
}

}  // namespace

Expected<Scene> sceneFromJson(const Json& value) {
    ObjectReader reader(value, "");
    int version = Scene::kVersion;
    reader.integer("versorium", version, 1, std::numeric_limits<int>::max());
    if (!reader.failed() && version > Scene::kVersion)
        return Status::data("versorium: version " + std::to_string(version) +
                            " is newer than this program, which reads up to " +
                            std::to_string(Scene::kVersion) + "; update it");
    std::string name = "quadratic";
    reader.text("map", name);
    if (reader.failed()) return reader.finish();
    const MapKernels* map = findMap(name);
    std::shared_ptr<const FormulaMap> typed;  // keeps the map
    if (name == kFormulaName) {
        std::string text;
        reader.text("formula", text);
        if (!reader.has("formula"))
            reader.fail("formula",
                        "is missing: what the map \"formula\" does, such as \"z^2 + c\"");
        if (reader.failed()) return reader.finish();
        Expected<std::shared_ptr<const FormulaMap>> made = FormulaMap::make(text);
        if (!made) return Status::data("formula, " + made.status().message());
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
    readAssets(reader, scene);
    if (const Status status = reader.finish(); !status.ok()) return status;
    if (const Status status = checkScene(scene); !status.ok()) return status;
    return scene;
}

Json assetToJson(const Asset& asset) {
    return Json{{"name", asset.name}, {"data", base64Encode(asset.bytes)}};
}

Json sceneToJson(const Scene& scene) {
    Json json = sceneBody(scene);
    for (const auto& [hash, asset] : scene.assets) json["assets"][hash] = assetToJson(*asset);
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
