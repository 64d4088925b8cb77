// SPDX-License-Identifier: MIT
#include "io/document.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "io/files.h"
#include "io/png.h"
#include "io/root_files.h"
#include "io/text_scanner.h"
#include "scene/numbers.h"

namespace versorium {
namespace {

constexpr int kDocumentVersion = 1;

// Keys that stand for a path, where the last part alone would be ambiguous or is no part at all.
constexpr std::pair<const char*, const char*> kShort[] = {{"shape", "shape.source"},
                                                          {"center_low", "slice.center_low"}};
constexpr const char* kSections[] = {"", "slice.", "shape.", "colour.", "trap."};

const Json* at(const Json& json, const std::string& path) {
    const Json* value = &json;
    std::size_t start = 0;
    while (start <= path.size()) {
        const std::size_t dot = std::min(path.find('.', start), path.size());
        const std::string key = path.substr(start, dot - start);
        if (!value->is_object() || !value->contains(key)) return nullptr;
        value = &*value->find(key);
        start = dot + 1;
    }
    return value;
}

// The path in the scene's JSON that a key means, or an empty text.
std::string pathOf(const Json& json, const std::string& key) {
    for (const auto& [name, path] : kShort)
        if (key == name) return at(json, path) ? path : "";
    for (const char* section : kSections)
        if (at(json, section + key)) return section + key;
    // A scene without an ensemble does not write one; what is put there makes one.
    if (key == "ensemble" || key.starts_with("ensemble.")) return key;
    // Names of parameters may hold dots themselves.
    const std::string parameters = "parameters.";
    const std::string name = key.starts_with(parameters) ? key.substr(parameters.size()) : key;
    if (json.contains("parameters") && json["parameters"].contains(name)) return parameters + name;
    return "";
}

Json parseValue(const std::string& text) {
    if (!text.empty() && (text[0] == '{' || text[0] == '[' || text[0] == '"')) {
        Expected<Json> json = parseJson(text);
        if (json) return *json;
    }
    if (text == "true" || text == "false") return text == "true";
    Json list = Json::array();
    std::size_t start = 0;
    while (start <= text.size()) {
        const std::size_t comma = std::min(text.find(',', start), text.size());
        const std::optional<double> number = parseDecimal(text.substr(start, comma - start));
        if (!number || !std::isfinite(*number)) return text;
        const bool negativeZero = *number == 0 && std::signbit(*number);
        if (*number == std::floor(*number) && std::abs(*number) < 1e15 && !negativeZero)
            list.push_back(static_cast<std::int64_t>(*number));
        else
            list.push_back(*number);
        start = comma + 1;
    }
    return list.size() == 1 ? list[0] : list;
}

// Puts a value where the path leads; parameter names may hold dots ("g.b1").
void put(Json& json, const std::string& path, const Json& value) {
    const std::string parameters = "parameters.";
    if (path.starts_with(parameters)) {
        json["parameters"][path.substr(parameters.size())] = value;
        return;
    }
    Json* place = &json;
    std::size_t start = 0;
    while (true) {
        const std::size_t dot = path.find('.', start);
        if (dot == std::string::npos) break;
        place = &(*place)[path.substr(start, dot - start)];
        start = dot + 1;
    }
    (*place)[path.substr(start)] = value;
}

bool isFileName(const std::string& value) {
    for (const char* ending :
         {".obj", ".ply", ".stl", ".f3d", ".field2d", ".grid", ".png", ".jpg", ".jpeg", ".bmp"})
        if (value.size() > 4 && value.ends_with(ending)) return true;
    return false;
}

// The scene's shape, or one that alpha or beta follows.
Status assignShape(Scene& scene, const std::string& key, const std::string& value) {
    std::string& source = key == "modulation.alpha.shape"  ? scene.alphaOverSpace.shape
                          : key == "modulation.beta.shape" ? scene.betaOverSpace.shape
                                                           : scene.shape.source;
    if (!isFileName(value)) {
        source = value;
        return {};
    }
    Expected<Bytes> bytes = readFile(value, kMostAssetBytes);
    if (!bytes) return bytes.status();
    const std::size_t slash = value.find_last_of('/');
    if (&source == &scene.shape.source) scene.assets.clear();
    source = addAsset(
        scene, {slash == std::string::npos ? value : value.substr(slash + 1), std::move(*bytes)});
    return {};
}

Status assignList(RootList& list, const std::string& value) {
    Expected<Bytes> bytes = readFile(value, kMostAssetBytes);
    if (!bytes) return bytes.status();
    Expected<RootList> roots = readRoots(*bytes);
    if (!roots) return roots.status().in(value);
    list = std::move(*roots);
    return {};
}

Status refused(const Assignment& assignment, const std::string& message) {
    return Status::usage("--set " + assignment.key + "=" + assignment.value + ": " + message);
}

}  // namespace

Json documentToJson(const Document& document) {
    Json json;
    json["document"] = kDocumentVersion;
    json["kind"] = document.kind;
    json["render"] = document.render;
    json["body"] = document.body;
    if (!document.assets.empty()) json["assets"] = document.assets;
    return json;
}

Expected<Document> documentFromJson(const Json& json) {
    Document document;
    if (!json.is_object()) return Status::data("an object { … } is expected: a scene or a plate");
    if (!json.contains("document")) {
        document.kind = json.contains("panels") ? "plate"
                        : json.contains("keys") ? "animation"
                                                : "scene";
        document.body = withoutAssets(json, document.assets);
        return document;
    }
    ObjectReader reader(json, "");
    int version = 0;
    reader.integer("document", version, 1, 1000000);
    if (version > kDocumentVersion)
        return Status::data("document: version " + std::to_string(version) +
                            " is newer than this program; update it");
    reader.word("kind", document.kind, {"scene", "plate", "animation"});
    if (const Json* render = reader.child("render")) document.render = *render;
    if (const Json* assets = reader.child("assets")) document.assets = *assets;
    const Json* body = reader.child("body");
    if (!body) reader.fail("\"body\" is missing: a scene or a plate");
    if (const Status status = reader.finish(); !status.ok()) return status;
    document.body = withoutAssets(*body, document.assets);
    return document;
}

Expected<Document> documentFromBytes(std::span<const unsigned char> bytes) {
    const bool png = bytes.size() > 4 && bytes[0] == 0x89 && bytes[1] == 'P';
    std::string text(bytes.begin(), bytes.end());
    if (png) {
        Expected<std::vector<PngText>> texts = decodePngText(bytes);
        if (!texts) return texts.status();
        text.clear();
        for (PngText& one : *texts)
            if (one.keyword == kDocumentKeyword) text = std::move(one.text);
        if (text.empty())
            return Status::data(
                "the PNG carries no scene; only pictures that Versorium wrote have one");
    }
    Expected<Json> json = parseJson(text);
    if (!json) return json.status();
    return documentFromJson(*json);
}

Expected<Document> readDocument(const std::string& path) {
    Expected<Bytes> bytes = readFile(path, kDocumentBytes);
    if (!bytes) return bytes.status();
    Expected<Document> document = documentFromBytes(*bytes);
    return document ? std::move(document) : document.status().in(path);
}

Json withoutAssets(Json scene, Json& assets) {
    if (!scene.is_object() || !scene.contains("assets")) return scene;
    if (scene["assets"].is_object())
        for (auto item = scene["assets"].begin(); item != scene["assets"].end(); ++item)
            assets[item.key()] = *item;
    scene.erase("assets");
    return scene;
}

void addAssets(const Scene& scene, Json& assets) {
    if (scene.assets.empty()) return;
    const std::vector<std::string> named = assetsNamed(sceneBody(scene));
    for (const auto& [hash, asset] : scene.assets)
        if (std::find(named.begin(), named.end(), hash) != named.end() && !assets.contains(hash))
            assets[hash] = assetToJson(*asset);
}

std::vector<std::string> assetsNamed(const Json& json) {
    constexpr std::string_view prefix = "asset:";
    std::vector<std::string> names;
    if (json.is_string()) {
        const std::string& text = json.get_ref<const std::string&>();
        if (text.starts_with(prefix)) names.push_back(text.substr(prefix.size()));
    } else if (json.is_structured()) {
        for (const Json& part : json)
            for (std::string& name : assetsNamed(part)) names.push_back(std::move(name));
    }
    return names;
}

Expected<Scene> sceneWithAssets(const Json& scene, const Json& assets) {
    Json whole = scene;
    // Only what the scene names: panels of a plate do not share what they do not use.
    for (const std::string& hash : assetsNamed(scene))
        if (assets.contains(hash)) whole["assets"][hash] = *assets.find(hash);
    return sceneFromJson(whole);
}

Expected<Assignment> parseAssignment(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        return Status::usage("--set " + text + ": key=value is expected, such as --set c=-0.1,0.7");
    return Assignment{text.substr(0, equals), text.substr(equals + 1)};
}

// With the parts that a scene leaves out where they say nothing, so that they can be set.
Json wholeJson(const Scene& scene) {
    Json json = sceneToJson(scene);
    if (!json.contains("ensemble")) json["ensemble"] = ensembleToJson(scene.ensemble);
    if (mapOf(scene).info.field)
        for (const auto& [name, spec] :
             {std::pair{"alpha", &scene.alphaOverSpace}, std::pair{"beta", &scene.betaOverSpace}})
            json["modulation"][name] = modulationToJson(*spec);
    return json;
}

bool knowsKey(const Scene& scene, const std::string& key) {
    return scene.lists.contains(key) || numberNamed(scene, key) ||
           !pathOf(wholeJson(scene), key).empty();
}

Status assign(Scene& scene, const Assignment& assignment) {
    const auto& [key, value] = assignment;
    if (scene.lists.contains(key) && !value.starts_with("{"))
        return assignList(scene.lists[key], value);
    const bool shape =
        key == "shape" || key == "modulation.alpha.shape" || key == "modulation.beta.shape";
    if (shape && mapOf(scene).info.field) return assignShape(scene, key, value);
    if (key == "map" || key == "formula") {
        Expected<Scene> chosen = sceneOfMap(value);
        if (!chosen) return refused(assignment, chosen.status().message());
        const Scene old = std::move(scene);
        scene = std::move(*chosen);
        scene.colour = old.colour;
        scene.samples = old.samples;
        return {};
    }
    Json assets = Json::object();
    Json json = withoutAssets(wholeJson(scene), assets);
    Json parsed = parseValue(value);
    const std::string path = scene.lists.contains(key) ? "lists." + key : pathOf(json, key);
    if (path == "colour.palette" && value.ends_with(".json")) {
        Expected<Bytes> bytes = readFile(value, kDocumentBytes);
        if (!bytes) return bytes.status();
        Expected<Json> palette =
            parseJson({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
        if (!palette) return palette.status().in(value);
        parsed = *palette;
    }
    if (path.empty()) {
        const std::optional<NumberRef> number = numberNamed(scene, key);
        if (!number)
            return refused(assignment,
                           "the map \"" + scene.map + "\" has no such key; its numbers are " +
                               numberNames(scene) + "; \"versorium schema\" lists the others");
        if (!parsed.is_number()) return refused(assignment, "a finite number is expected");
        Scene moved = scene;
        // A starting point that is typed takes the place of a critical one.
        if (number->kind == NumberKind::state) moved.criticalStart.reset();
        setNumber(moved, *number, parsed.get<double>());
        json = withoutAssets(sceneToJson(moved), assets);
    } else {
        put(json, path, parsed);
    }
    Expected<Scene> changed = sceneFromJson(json);
    if (!changed) return refused(assignment, changed.status().message());
    auto kept = std::move(scene.assets);
    scene = std::move(*changed);
    scene.assets = std::move(kept);
    return {};
}

}  // namespace versorium
