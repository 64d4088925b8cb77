// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "base/base64.h"
#include "base/hash.h"
#include "colour/palette.h"
#include "fields/field_names.h"
#include "scene/numbers.h"
#include "scene/scene.h"

namespace versorium {
namespace {

constexpr double kLargest = 1e300;
const std::vector<std::string> kSets{"none", "membership", "solid"};

std::vector<std::string> fieldWords() {
    std::vector<std::string> words;
    for (const FieldInfo& field : allFields()) words.emplace_back(field.name);
    return words;
}

Json numbers(const std::vector<double>& values) {
    Json list = Json::array();
    for (double value : values) list.push_back(value);
    return list;
}

// ---- reading ---------------------------------------------------------------------------------

void readParameters(ObjectReader& reader, Scene& scene) {
    const Json* found = reader.child("parameters");
    if (!found) return;
    const MapKernels& map = mapOf(scene);
    ObjectReader parameters(*found, reader.pathOf("parameters"));
    for (const ParameterInfo& parameter : map.info.parameters) {
        const std::string name(parameter.name);
        const auto width = static_cast<std::size_t>(widthOf(parameter.kind));
        parameters.numbers(name.c_str(), scene.parameters[name], width, width);
    }
    reader.fail(parameters.finish());
}

void readStart(ObjectReader& reader, Scene& scene) {
    const Json* found = reader.child("start");
    if (!found) return;
    const auto dimension = static_cast<std::size_t>(mapOf(scene).dimension);
    if (!found->is_object()) {
        reader.numbers("start", scene.start, dimension, dimension);
        return;
    }
    ObjectReader start(*found, reader.pathOf("start"));
    int critical = 0;
    start.integer("critical", critical, 0, 63);
    if (!start.has("critical")) start.fail("{\"critical\": k} or a list of numbers is expected");
    reader.fail(start.finish());
    scene.criticalStart = critical;
}

void readRoot(const Json& value, const std::string& path, RootList& list, ObjectReader& owner) {
    ObjectReader reader(value, path);
    std::vector<double> q;
    RootList::Root root;
    reader.numbers("q", q, 1, 4).number("power", root.power, -1000, 1000);
    for (std::size_t k = 0; k < q.size(); ++k) root.q[k] = q[k];
    if (!reader.has("q")) reader.fail("\"q\": [w, x, y, z] is missing");
    owner.fail(reader.finish());
    list.roots.push_back(root);
}

void readLists(ObjectReader& reader, Scene& scene) {
    const Json* found = reader.child("lists");
    if (!found) return;
    ObjectReader lists(*found, reader.pathOf("lists"));
    for (auto& [name, list] : scene.lists) {
        const Json* json = lists.child(name.c_str());
        if (!json) continue;
        ObjectReader one(*json, lists.pathOf(name.c_str()));
        RootList read;
        one.number("scale", read.scale, -1000, 1000);
        const Json* roots = one.child("roots");
        if (!roots || !roots->is_array() || roots->size() > kMostRoots) {
            one.fail("roots", "a list of at most " + std::to_string(kMostRoots) +
                                  " roots {\"q\": […], \"power\": p} is expected");
        } else {
            for (std::size_t i = 0; i < roots->size(); ++i)
                readRoot((*roots)[i], one.pathOf("roots") + "[" + std::to_string(i) + "]", read,
                         one);
        }
        lists.fail(one.finish());
        list = read;
    }
    reader.fail(lists.finish());
}

void readShape(ObjectReader& reader, Scene& scene) {
    const Json* found = reader.child("shape");
    if (!found) return;
    ObjectReader shape(*found, reader.pathOf("shape"));
    shape.text("source", scene.shape.source)
        .integer("resolution", scene.shape.resolution, 8, 512)
        .number("padding", scene.shape.padding, 0, 100)
        .word("outside", scene.shape.outside, {"", "border", "distance"})
        .boolean("z_fastest", scene.shape.zFastest);
    reader.fail(shape.finish());
}

void readTerms(const Json& value, const std::string& path, ObjectReader& owner, SliceAxis& axis) {
    if (!value.is_object() || value.empty()) {
        owner.fail(Status::data(path + ": an object such as {\"z.re\": 1} is expected"));
        return;
    }
    axis.terms.clear();
    for (auto item = value.begin(); item != value.end(); ++item) {
        if (!item->is_number() || item->get<double>() == 0 || !std::isfinite(item->get<double>())) {
            owner.fail(Status::data(path + "." + item.key() +
                                    ": the weight must be a number other than 0"));
            return;
        }
        axis.terms.emplace_back(item.key(), item->get<double>());
    }
}

void readSlice(ObjectReader& reader, Scene& scene) {
    const Json* found = reader.child("slice");
    if (!found) return;
    ObjectReader slice(*found, reader.pathOf("slice"));
    if (const Json* axes = slice.child("axes")) {
        if (!axes->is_array() || axes->empty() || axes->size() > 3) {
            slice.fail("axes", "a list of 1 to 3 directions is expected");
        } else {
            scene.slice.axes.assign(axes->size(), {});
            for (std::size_t i = 0; i < axes->size(); ++i)
                readTerms((*axes)[i], slice.pathOf("axes") + "[" + std::to_string(i) + "]", slice,
                          scene.slice.axes[i]);
            if (scene.slice.centre.size() != axes->size()) {
                scene.slice.centre.assign(axes->size(), 0.0);
                scene.slice.centreLow.assign(axes->size(), 0.0);
            }
        }
    }
    if (const Json* origin = slice.child("origin")) {
        SliceAxis terms;
        scene.slice.origin.clear();
        if (!origin->is_object())
            slice.fail("origin", "an object such as {\"c.re\": 0.3} is expected");
        else
            for (auto item = origin->begin(); item != origin->end(); ++item) {
                if (item->is_number() && std::isfinite(item->get<double>()))
                    scene.slice.origin[item.key()] = item->get<double>();
                else
                    slice.fail("origin", item.key() + " must be a number");
            }
    }
    const std::size_t axes = scene.slice.axes.size();
    slice.numbers("center", scene.slice.centre, axes, axes)
        .numbers("center_low", scene.slice.centreLow, axes, axes)
        .number("height", scene.slice.height, 1e-300, 1e12);
    reader.fail(slice.finish());
}

void readGradient(ObjectReader& owner, const char* key, Gradient& gradient) {
    const Json* found = owner.child(key);
    if (!found) return;
    ObjectReader reader(*found, owner.pathOf(key));
    const auto colour = [&](const char* name, DisplayColour& value) {
        std::vector<double> parts{value.r, value.g, value.b, value.a};
        reader.numbers(name, parts, 3, 4);
        for (double part : parts)
            if (!(part >= 0 && part <= 1)) reader.fail(name, "every part lies in 0 to 1");
        value = {parts[0], parts[1], parts[2], parts.size() > 3 ? parts[3] : 1.0};
    };
    colour("start", gradient.start);
    colour("finish", gradient.finish);
    reader.number("exponent", gradient.exponent, 0.01, 100);
    owner.fail(reader.finish());
}

// A name, or a palette as an object.
void readPalette(ObjectReader& colour, Colouring& c) {
    const Json* found = colour.child("palette");
    if (!found) return;
    c.ownPalette = nullptr;
    if (!found->is_object()) {
        colour.word("palette", c.palette, paletteNames());
        return;
    }
    const Expected<Palette> palette = paletteFromJson(*found, colour.pathOf("palette"));
    if (!palette) return colour.fail(palette.status());
    c.palette = palette->name();
    c.ownPalette = paletteToJson(*palette);
}

void readColour(ObjectReader& reader, Scene& scene) {
    const Json* found = reader.child("colour");
    if (!found) return;
    Colouring& c = scene.colour;
    ObjectReader colour(*found, reader.pathOf("colour"));
    colour.word("rule", c.rule, {"palette", "gradient", "versor", "phase", "domain"})
        .word("field", c.field, fieldWords())
        .boolean("reverse", c.reverse)
        .word("scale", c.scale, {"", "linear", "log", "truncated_log", "sqrt", "cyclic"})
        .word("interior", c.interior, kSets)
        .word("smoothing", c.smoothing, {"none", "ratio", "log-log"})
        .word("outline", c.outline, kSets)
        .text("outline_colour", c.outlineColour)
        .number("outline_width", c.outlineWidth, 0, 100);
    readPalette(colour, c);
    colour.numbers("contours", c.contours, 0, kMostContours);
    if (const Json* range = colour.child("range"); range && !(range->is_array() && range->empty()))
        colour.numbers("range", c.range, 2, 2);
    else if (range)
        c.range.clear();
    readGradient(colour, "escaped", c.escaped);
    readGradient(colour, "attracted", c.attracted);
    if (!colourFromHex(c.outlineColour).ok())
        colour.fail("outline_colour", "\"" + c.outlineColour + "\" is not #rrggbb");
    reader.fail(colour.finish());
}

void readTrap(ObjectReader& reader, Scene& scene) {
    const Json* found = reader.child("trap");
    if (!found) return;
    ObjectReader trap(*found, reader.pathOf("trap"));
    trap.word("kind", scene.trap.kind, {"point", "line", "circle"})
        .numbers("point", scene.trap.point, 1, 4)
        .number("radius", scene.trap.radius, 0, 1e6)
        .number("angle", scene.trap.angle, -1e3, 1e3);
    reader.fail(trap.finish());
}

void readLayer(ObjectReader& reader, Layer& layer) {
    if (const Json* source = reader.child("source"); source && source->is_array()) {
        layer.sources.clear();
        for (const Json& frame : *source)
            layer.sources.push_back(frame.is_string() ? frame.get<std::string>() : "");
        if (layer.sources.empty() || layer.sources.size() > kMostFrames)
            reader.fail("source", "must name 1 to " + std::to_string(kMostFrames) + " frames");
    } else if (source) {
        reader.text("source", layer.sources[0]);
    }
    for (const std::string& source : layer.sources)
        if (source != kLeafLayer && !source.starts_with("asset:") && !colourFromHex(source).ok())
            reader.fail(
                "source",
                "\"leaf\", #rrggbb, or asset: and a SHA-256 is expected, or a list of such");
    reader.number("frame", layer.frame, -1e9, 1e9)
        .boolean("front", layer.front)
        .number("x", layer.x, -100, 100)
        .number("y", layer.y, -100, 100)
        .number("scale", layer.scale, 1e-3, 1000)
        .number("opacity", layer.opacity, 0, 1);
}

void readLayers(ObjectReader& reader, Scene& scene) {
    const Json* found = reader.child("layers");
    if (!found) return;
    if (!found->is_array() || found->size() > kMostLayers)
        return reader.fail("layers",
                           "must be a list of at most " + std::to_string(kMostLayers) + " images");
    for (std::size_t k = 0; k < found->size(); ++k) {
        ObjectReader one((*found)[k], reader.pathOf("layers") + "[" + std::to_string(k) + "]");
        Layer layer;
        readLayer(one, layer);
        reader.fail(one.finish());
        scene.layers.push_back(layer);
    }
}

Json layerJson(const Layer& layer) {
    Json source = layer.sources[0];
    if (layer.sources.size() > 1) {
        source = Json::array();
        for (const std::string& frame : layer.sources) source.push_back(frame);
    }
    return Json{
        {"source", source}, {"frame", layer.frame}, {"front", layer.front},    {"x", layer.x},
        {"y", layer.y},     {"scale", layer.scale}, {"opacity", layer.opacity}};
}

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

// ---- checks that need the whole scene --------------------------------------------------------

Status checkNames(const Scene& scene) {
    const auto check = [&](const std::string& name, const std::string& path) -> Status {
        if (numberNamed(scene, name)) return {};
        return Status::data(path + ": the map \"" + scene.map + "\" has no number named \"" + name +
                            "\"; it has " + numberNames(scene));
    };
    for (std::size_t k = 0; k < scene.slice.axes.size(); ++k)
        for (const auto& [name, weight] : scene.slice.axes[k].terms)
            if (Status s = check(name, "slice.axes[" + std::to_string(k) + "]"); !s.ok()) return s;
    for (const auto& [name, value] : scene.slice.origin)
        if (Status s = check(name, "slice.origin"); !s.ok()) return s;
    if (scene.criticalStart)
        for (const SliceAxis& axis : scene.slice.axes)
            for (const auto& [name, weight] : axis.terms)
                if (numberNamed(scene, name)->kind == NumberKind::state)
                    return Status::data("start: a critical point and an axis through \"" + name +
                                        "\" exclude each other; give the start as numbers");
    return {};
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
    readParameters(reader, scene);
    readStart(reader, scene);
    readLists(reader, scene);
    readShape(reader, scene);
    readModulation(reader, scene.alphaOverSpace, scene.betaOverSpace);
    readSlice(reader, scene);
    reader.integer("iterations", scene.iterations, 0, kMostIterations);
    if (const Json* radius = reader.child("escape_radius")) {
        double number = 0;
        if (radius->is_number()) {
            reader.number("escape_radius", number, 0, 1e150);
            scene.escapeRadius = number;
        } else if (!(radius->is_string() && radius->get<std::string>() == "auto")) {
            reader.fail("escape_radius", "a number or \"auto\" is expected");
        }
    }
    reader.word("escape_test", scene.escapeTest, {"first", "last"})
        .number("iso", scene.iso, -1e6, 1e6)
        .number("aspect", scene.aspect, 0.1, 10)
        .integer("samples", scene.samples, 1, kMostSamples);
    readTrap(reader, scene);
    readColour(reader, scene);
    readEnsemble(reader, scene.ensemble);
    readLayers(reader, scene);
    readAssets(reader, scene);
    for (const auto& [key, list] : scene.parameters)
        for (double number : list)
            if (!(std::abs(number) <= kLargest))
                reader.fail("parameters", key + " is not a finite number of moderate size");
    if (const Status status = reader.finish(); !status.ok()) return status;
    if (const Status status = checkNames(scene); !status.ok()) return status;
    if (const Status status = checkEnsemble(scene); !status.ok()) return status;
    if (const Status status = checkModulation(scene); !status.ok()) return status;
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
    Json parameters = Json::object();
    for (const ParameterInfo& parameter : mapOf(scene).info.parameters) {
        const auto& value = scene.parameters.at(std::string(parameter.name));
        parameters[std::string(parameter.name)] =
            value.size() == 1 ? Json(value[0]) : numbers(value);
    }
    json["parameters"] = parameters;
    if (scene.criticalStart)
        json["start"] = Json{{"critical", *scene.criticalStart}};
    else
        json["start"] = numbers(scene.start);
    if (!scene.lists.empty()) {
        for (const auto& [name, list] : scene.lists) {
            Json roots = Json::array();
            for (const RootList::Root& root : list.roots)
                roots.push_back(
                    Json{{"q", numbers({root.q.begin(), root.q.end()})}, {"power", root.power}});
            json["lists"][name] = Json{{"scale", list.scale}, {"roots", roots}};
        }
    }
    if (mapOf(scene).info.field)
        json["shape"] = Json{{"source", scene.shape.source},
                             {"resolution", scene.shape.resolution},
                             {"padding", scene.shape.padding},
                             {"outside", scene.shape.outside},
                             {"z_fastest", scene.shape.zFastest}};
    if (scene.alphaOverSpace != ModulationSpec{})
        json["modulation"]["alpha"] = modulationToJson(scene.alphaOverSpace);
    if (scene.betaOverSpace != ModulationSpec{})
        json["modulation"]["beta"] = modulationToJson(scene.betaOverSpace);
    Json axes = Json::array();
    for (const SliceAxis& axis : scene.slice.axes) {
        Json terms = Json::object();
        for (const auto& [name, weight] : axis.terms) terms[name] = weight;
        axes.push_back(terms);
    }
    Json origin = Json::object();
    for (const auto& [name, value] : scene.slice.origin) origin[name] = value;
    json["slice"] = Json{{"axes", axes},
                         {"origin", origin},
                         {"center", numbers(scene.slice.centre)},
                         {"center_low", numbers(scene.slice.centreLow)},
                         {"height", scene.slice.height}};
    json["iterations"] = scene.iterations;
    json["escape_radius"] = scene.escapeRadius ? Json(*scene.escapeRadius) : Json("auto");
    json["escape_test"] = scene.escapeTest;
    json["iso"] = scene.iso;
    json["trap"] = Json{{"kind", scene.trap.kind},
                        {"point", numbers(scene.trap.point)},
                        {"radius", scene.trap.radius},
                        {"angle", scene.trap.angle}};
    const auto gradient = [](const Gradient& g) {
        return Json{{"start", numbers({g.start.r, g.start.g, g.start.b, g.start.a})},
                    {"finish", numbers({g.finish.r, g.finish.g, g.finish.b, g.finish.a})},
                    {"exponent", g.exponent}};
    };
    const Colouring& c = scene.colour;
    json["colour"] = Json{{"rule", c.rule},
                          {"field", c.field},
                          {"palette", c.ownPalette.is_null() ? Json(c.palette) : c.ownPalette},
                          {"reverse", c.reverse},
                          {"scale", c.scale},
                          {"range", numbers(c.range)},
                          {"interior", c.interior},
                          {"escaped", gradient(c.escaped)},
                          {"attracted", gradient(c.attracted)},
                          {"smoothing", c.smoothing},
                          {"outline", c.outline},
                          {"outline_colour", c.outlineColour},
                          {"outline_width", c.outlineWidth},
                          {"contours", numbers(c.contours)}};
    if (!(scene.ensemble == EnsembleSpec{})) json["ensemble"] = ensembleToJson(scene.ensemble);
    for (const Layer& layer : scene.layers) json["layers"].push_back(layerJson(layer));
    json["aspect"] = scene.aspect;
    json["samples"] = scene.samples;
    return json;
}

}  // namespace versorium
