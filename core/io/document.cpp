// SPDX-License-Identifier: MIT
#include "io/document.h"

#include <cmath>
#include <cstdlib>

#include "io/files.h"
#include "io/foreign_views.h"
#include "io/image_files.h"
#include "io/known_formats.h"
#include "io/mesh_files.h"
#include "io/palette_files.h"
#include "io/png.h"
#include "io/root_files.h"
#include "io/text_scanner.h"
#include "scene/numbers.h"
#include "scene/parts.h"
#include "scene/properties.h"

namespace versorium {
namespace {

constexpr int kDocumentVersion = 1;

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

// The scene's shape, or one that alpha or beta follows.
Status assignShape(Scene& scene, const std::string& key, const std::string& value) {
    std::string& source = key == "modulation.alpha.shape"  ? scene.alphaOverSpace.shape
                          : key == "modulation.beta.shape" ? scene.betaOverSpace.shape
                                                           : scene.shape.source;
    if (!namesShapeFile(value)) {
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

// A point of the plane or of the quaternions, or a real number, that is written as in formulas:
// c=-0.8+0.156i, c=i, c=-0.8, aspect=16/9.
Json pointOf(const Scene& scene, const SceneProperty& property, const std::string& text,
             const Json& parsed) {
    std::size_t width = 0;
    if (property.kind == ValueKind::number || property.kind == ValueKind::whole)
        width = parsed.is_number() ? 0 : 1;
    else if (const auto parameter = scene.parameters.find(property.path);
             parameter != scene.parameters.end())
        width = parameter->second.size();
    else if ((property.path == "start" || property.path == "slice.center") && !parsed.is_number())
        width = property.path == "start" ? scene.start.size() : scene.slice.axes.size();
    if (width != 1 && width != 2 && width != 4) return parsed;
    const Expected<std::array<double, 4>> point =
        parseFormulaNumber(text, width == 1   ? FormulaKind::real
                                 : width == 2 ? FormulaKind::complex
                                              : FormulaKind::quaternion);
    if (!point) return parsed;
    if (width == 1) return (*point)[0];
    Json list = Json::array();
    for (std::size_t k = 0; k < width; ++k) list.push_back((*point)[k]);
    return list;
}

Status assignList(RootList& list, const std::string& value) {
    Expected<Bytes> bytes = readFile(value, kMostAssetBytes);
    if (!bytes) return bytes.status();
    Expected<RootList> roots = readRoots(*bytes);
    if (!roots) return roots.status().in(value);
    list = std::move(*roots);
    return {};
}

// Those that stand in the body itself.
Status moveAssets(Document& document) {
    Json& body = document.body;
    if (!body.is_object() || !body.contains("assets")) return {};
    Status status = assetsFromJson(body["assets"], "assets", document.assets);
    body.erase("assets");
    return status;
}

Status refused(const Assignment& assignment, const std::string& message) {
    return Status::usage("--set " + assignment.key + "=" + assignment.value + ": " + message);
}

// Another map keeps what is no map's own: colours, images, aspect and samples.
Status assignMap(Scene& scene, const Assignment& assignment) {
    Expected<Scene> chosen = sceneOfMap(assignment.value);
    if (!chosen) return refused(assignment, chosen.status().message());
    keepLook(*chosen, scene);
    chosen->samples = scene.samples;
    dropAssetsExcept(*chosen, namedAssets(*chosen));
    scene = std::move(*chosen);
    return {};
}

// Of a palette that stands in a file.
Expected<Json> readPaletteAt(const std::string& path) {
    Expected<Bytes> bytes = readFile(path, kDocumentBytes);
    if (!bytes) return bytes.status();
    Expected<PaletteFile> file = readPaletteFile(*bytes, path);
    if (!file) return file.status().in(path);
    return paletteToJson(file->palette);
}

// An image behind the fractal, over those that are there already.
Status addLayer(Scene& scene, const Assignment& assignment) {
    const std::string& value = assignment.value;
    if (scene.layers.size() >= kMostLayers)
        return refused(assignment, "there are " + std::to_string(kMostLayers) + " layers already");
    if (value == kLeafLayer || colourFromHex(value).ok()) {
        scene.layers.push_back({.sources = {value}});
        return {};
    }
    Expected<Bytes> bytes = readFile(value, kMostAssetBytes);
    if (!bytes) return bytes.status();
    if (Status status = readImage(*bytes).status(); !status.ok()) return status.in(value);
    const std::size_t slash = value.find_last_of('/');
    const std::string source = addAsset(
        scene, {slash == std::string::npos ? value : value.substr(slash + 1), std::move(*bytes)});
    scene.layers.push_back({.sources = {source}});
    return {};
}

}  // namespace

Json documentToJson(const Document& document) {
    Json json;
    json["document"] = kDocumentVersion;
    json["kind"] = std::string(wordOf(document.kind));
    json["render"] = document.render;
    json["body"] = document.body;
    if (!document.assets.empty()) json["assets"] = assetsToJson(document.assets);
    return json;
}

Expected<Document> documentFromJson(const Json& json) {
    Document document;
    if (!json.is_object()) return Status::data("an object { … } is expected: a scene or a plate");
    if (!json.contains("document")) {
        document.kind = json.contains("panels") ? DocumentKind::plate
                        : json.contains("keys") ? DocumentKind::animation
                                                : DocumentKind::scene;
        document.body = json;
        if (Status status = moveAssets(document); !status.ok()) return status;
        return document;
    }
    ObjectReader reader(json, "");
    int version = 0;
    reader.integer("document", version, 1, 1000000);
    if (version > kDocumentVersion)
        return Status::data("document: version " + std::to_string(version) +
                            " is newer than this program; update it");
    reader.word("kind", document.kind);
    if (const Json* render = reader.child("render")) document.render = *render;
    if (const Json* assets = reader.child("assets"))
        reader.fail(assetsFromJson(*assets, "assets", document.assets));
    const Json* body = reader.child("body");
    if (!body) reader.fail("\"body\" is missing: a scene or a plate");
    if (const Status status = reader.finish(); !status.ok()) return status;
    document.body = *body;
    if (Status status = moveAssets(document); !status.ok()) return status.in("body");
    return document;
}

Expected<Document> documentFromBytes(std::span<const unsigned char> bytes) {
    const bool png = isPng(bytes);
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
    if (Status status = foreignFault(bytes); !status.ok()) return status;
    if (looksLikePicture(bytes) && !png)
        return Status::data(
            "this is a picture that carries no scene; only PNGs that Versorium wrote have one");
    if (looksLikeMesh(bytes))
        return Status::data("this is a mesh and no scene; a scene takes it by --set shape=FILE");
    if (!png && looksLikeForeignView(bytes)) {
        Expected<ForeignView> view = readForeignView(bytes);
        if (!view) return view.status();
        Document document;
        document.body = sceneToJson(view->scene);
        document.note = std::move(view->note);
        return document;
    }
    if (const std::size_t first = text.find_first_not_of(" \t\r\n");
        !png && looksLikePalette(bytes) && first != std::string::npos && text[first] != '{')
        return Status::data(
            "this is a palette and no scene; a scene takes it by --set palette=FILE");
    Expected<Json> json = parseJson(std::string(withoutMark(text)));
    if (!json) return json.status();
    return documentFromJson(*json);
}

Expected<Document> readDocument(const std::string& path) {
    Expected<Bytes> bytes = readFile(path, kDocumentBytes);
    if (!bytes) return bytes.status();
    Expected<Document> document = documentFromBytes(*bytes);
    return document ? std::move(document) : document.status().in(path);
}

void addAssets(const Scene& scene, Assets& assets) {
    const std::set<std::string> named = namedAssets(scene);
    for (const auto& asset : scene.assets)
        if (named.contains(asset.first)) assets.insert(asset);
}

Expected<Scene> sceneWithAssets(const Json& scene, const Assets& assets) {
    Expected<Scene> read = sceneFromJson(scene);
    if (read) takeAssets(*read, assets);
    return read;
}

Expected<Assignment> parseAssignment(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        return Status::usage("--set " + text + ": key=value is expected, such as --set c=-0.1,0.7");
    return Assignment{text.substr(0, equals), text.substr(equals + 1)};
}

bool knowsKey(const Scene& scene, const std::string& key) {
    return key == "map" || key == "formula" || key == "layer" ||
           propertyNamed(scene, key).has_value();
}

Status assign(Scene& scene, const Assignment& assignment) {
    const auto& [key, value] = assignment;
    if (key == "map" || key == "formula") return assignMap(scene, assignment);
    if (key == "layer") return addLayer(scene, assignment);
    const std::optional<SceneProperty> property = propertyNamed(scene, key);
    if (!property)
        return refused(assignment,
                       unknownValue(scene, key).message() + " (\"versorium values\" lists all)");
    if (scene.lists.contains(property->path) && !value.starts_with("{"))
        return assignList(scene.lists[property->path], value);
    if (property->path == "shape.source" || property->path == "modulation.alpha.shape" ||
        property->path == "modulation.beta.shape")
        return assignShape(scene, property->path, value);
    Json parsed = parseValue(value);
    if (!parsed.is_array() && !parsed.is_object())
        parsed = pointOf(scene, *property, value, parsed);
    if (property->path == "colour.palette" && namesPalette(value)) {
        Expected<Json> palette = readPaletteAt(value);
        if (!palette) return palette.status();
        parsed = std::move(*palette);
    }
    const Status status = setProperty(scene, *property, parsed);
    return status.ok() ? status : refused(assignment, status.message());
}

}  // namespace versorium
