// SPDX-License-Identifier: MIT
#include <map>

#include "scene/properties.h"

namespace versorium {
namespace {

using Infos = std::map<std::string, ValueInfo>;

Json listOf(const std::vector<std::string>& words) {
    Json all = Json::array();
    for (const std::string& word : words) all.push_back(word);
    return all;
}

// "layers[0].x" is said once for all layers: "layers.x".
std::string withoutPlaces(const std::string& path) {
    std::string plain;
    for (std::size_t k = 0; k < path.size(); ++k)
        if (path[k] == '[')
            k = path.find(']', k);
        else
            plain += path[k];
    return plain;
}

Infos infosOf(const Scene& scene) {
    Infos infos;
    for (const SceneProperty& property : propertiesOf(scene))
        infos.emplace(withoutPlaces(property.path), property);
    infos["versorium"].help = "version of this format";
    infos["map"].help = "name of the map; \"versorium maps\" lists them; \"formula\" is one's own";
    infos["map"].kind = ValueKind::word;
    for (const MapKernels& map : catalogue()) infos["map"].words.emplace_back(map.info.name);
    infos["map"].words.emplace_back(kFormulaName);
    return infos;
}

const char* typeOf(const Json& value) {
    return value.is_array()            ? "array"
           : value.is_string()         ? "string"
           : value.is_boolean()        ? "boolean"
           : value.is_number_integer() ? "integer"
                                       : "number";
}

// A number, a word and the like. Those that take two forms say only what they may be.
void describeValue(Json& schema, const Json& value, const std::string& path,
                   const ValueInfo& info) {
    if (path == "start") {
        schema["type"] = Json::array({"array", "object"});
    } else if (path == "colour.palette") {
        schema["anyOf"] = Json::array(
            {Json{{"enum", listOf(info.words)}}, Json{{"type", "object"},
                                                      {"description",
                                                       "a palette of the scene's own, as "
                                                       "versorium palettes --json shows"}}});
    } else if (path == "layers.source") {
        schema["type"] = Json::array({"string", "array"});
    } else if (path == "escape_radius") {
        schema["type"] = Json::array({"number", "string"});
    } else {
        schema["type"] = typeOf(value);
        if (!info.words.empty()) schema["enum"] = listOf(info.words);
    }
    const bool number = info.kind == ValueKind::number || info.kind == ValueKind::whole;
    if (number && info.low < info.high) {
        schema["minimum"] = info.low;
        schema["maximum"] = info.high;
    }
    if (!info.unit.empty()) schema["x-unit"] = std::string(info.unit);
    schema["default"] = value;
}

Json schemaOf(const Json& value, const std::string& path, const Infos& infos) {
    Json schema;
    const auto found = infos.find(path);
    const ValueInfo info = found == infos.end() ? ValueInfo{} : found->second;
    if (!info.help.empty()) schema["description"] = std::string(info.help);
    const bool listed = info.kind == ValueKind::group && value.is_array();
    if (listed) {
        schema["type"] = "array";
        schema["items"] = schemaOf(value[0], path, infos);
        schema["default"] = Json::array();
    } else if (value.is_object()) {
        schema["type"] = "object";
        // Their keys depend on the map.
        if (path == "parameters") schema["default"] = value;
        if (path == "parameters" || path == "lists" || path == "slice.origin") return schema;
        schema["additionalProperties"] = false;
        for (auto item = value.begin(); item != value.end(); ++item)
            schema["properties"][item.key()] = schemaOf(*item, joined(path, item.key()), infos);
    } else {
        describeValue(schema, value, path, info);
    }
    return schema;
}

}  // namespace

Json sceneSchema() {
    // A map with a field and lists, with one of everything, shows every section.
    Scene whole = sceneOf(
        *findMapWhere([](const MapInfo& info) { return info.field && !info.lists.empty(); }));
    whole.layers.emplace_back();
    whole.ensemble.roots.emplace();
    whole.ensemble.ranges.emplace_back();
    whole.ensemble.discs.emplace_back();
    Json example = sceneToJson(whole);
    for (const char* number : {"alpha", "beta"})
        example["modulation"][number] = writeObject(ModulationSpec{}, modulationTable());
    writeProperties(whole.shape, shapeTable(), example["shape"], true);
    const Json schema = schemaOf(example, "", infosOf(whole));
    Json result{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                {"title", "Versorium scene"}};
    for (auto item = schema.begin(); item != schema.end(); ++item) result[item.key()] = *item;
    result["properties"]["assets"] = Json{
        {"type", "object"},
        {"description", "files that the scene needs, by SHA-256: {\"name\", \"data\" in base64}"}};
    result["properties"]["formula"] =
        Json{{"type", "string"},
             {"description",
              "what the map \"formula\" does, such as \"z^2 + c\"; its names are the parameters"}};
    // Defaults depend on the map: these are the parameters and the home view of each.
    for (const MapKernels& map : catalogue()) {
        const Json scene = sceneToJson(sceneOf(map));
        result["x-maps"][std::string(map.info.name)] = Json{{"parameters", scene["parameters"]},
                                                            {"start", scene["start"]},
                                                            {"slice", scene["slice"]},
                                                            {"iterations", scene["iterations"]}};
    }
    return result;
}

}  // namespace versorium
