// SPDX-License-Identifier: MIT
#include "colour/palette.h"
#include "fields/field_names.h"
#include "scene/scene.h"

namespace versorium {
namespace {

Json words(const std::vector<std::string>& list) {
    Json all = Json::array();
    for (const std::string& word : list) all.push_back(word);
    return all;
}

// Types follow from the values; descriptions stand by path.
const std::pair<const char*, const char*> kDescriptions[] = {
    {"versorium", "version of this format"},
    {"map", "name of the map; \"versorium maps\" lists them; \"formula\" is one's own"},
    {"parameters", "every parameter of the map, by name; numbers, or lists of components"},
    {"start",
     "starting point, or {\"critical\": k}: the k-th critical point, solved at each pixel"},
    {"lists",
     "roots bound to the map: {\"scale\": s, \"roots\": [{\"q\": [w, x, y, z], \"power\": p}]}"},
    {"shape", "the distance field of shape-modulus maps"},
    {"shape.source", "an analytic shape, a built-in mesh, or asset:SHA-256"},
    {"shape.resolution", "nodes along an edge of the grid made of a mesh"},
    {"shape.padding", "free cells around a mesh"},
    {"shape.outside", "beyond a grid's box: border, distance, or empty for the source's own"},
    {"shape.z_fastest", "a loaded .f3d runs along z first"},
    {"modulation", "alpha and beta over space; elsewhere they are the parameters"},
    {"modulation.alpha", "of alpha"},
    {"modulation.alpha.shape", "a second shape, like shape.source; empty: none"},
    {"modulation.alpha.between",
     "distances to it, the smaller first: the value up to there, the parameter from there on"},
    {"modulation.alpha.value", "within the second shape"},
    {"modulation.alpha.discs", "painted one over the other: [x, y, z, radius, value]"},
    {"modulation.beta", "of beta, in the same way"},
    {"slice", "which points of (start x parameters) the picture shows"},
    {"slice.axes", "1 to 3 directions, right and up first: weights of named numbers"},
    {"slice.origin", "where numbers on an axis start from, if not from 0"},
    {"slice.center", "coordinates of the picture's centre along the axes"},
    {"slice.center_low", "low parts of the same, added for deep views"},
    {"slice.height", "what the picture shows from bottom to top"},
    {"iterations", "N, up to 10000000"},
    {"escape_radius", "R, or \"auto\": the map's own"},
    {"escape_test", "first: the first iterate outside; last: only the last one counts (A eq 12)"},
    {"iso", "the field solid is 1 where log_modulus is below this"},
    {"trap", "what the field trap measures the distance to"},
    {"colour", "how fields become colours"},
    {"colour.rule", "palette, gradient (A eqs 14-15), versor or phase"},
    {"colour.field", "what the palette shows"},
    {"colour.palette", "name of a palette"},
    {"colour.reverse", "runs the palette backwards"},
    {"colour.scale", "how values become positions; empty for the field's own"},
    {"colour.range", "low and high value; empty for the field's own"},
    {"colour.interior", "the set that is painted in the palette's interior colour"},
    {"colour.escaped", "C_s, C_f (sRGB with alpha) and exponent e of orbits that escape"},
    {"colour.attracted", "the same for orbits that do not"},
    {"colour.smoothing", "none (eq 14), ratio (eq 15) or log-log"},
    {"colour.outline", "the set whose boundary is drawn"},
    {"colour.outline_colour", "#rrggbb"},
    {"colour.outline_width", "in line widths of the medium"},
    {"colour.contours", "levels of the field along which a line of the outline's look runs"},
    {"ensemble", "maps that differ in numbers drawn at random, for mean_membership"},
    {"ensemble.count", "members, 1 to 100000000"},
    {"ensemble.seed", "of the random numbers"},
    {"ensemble.set", "the set whose mean is taken: membership or solid"},
    {"ensemble.roots", "a list of roots that is drawn anew for each member, or null"},
    {"ensemble.roots.list", "which list"},
    {"ensemble.roots.count", "least and greatest number of roots"},
    {"ensemble.roots.region", "box, or ball: the ellipsoid within the box"},
    {"ensemble.roots.half", "half extents of the box; empty: the box of the shape"},
    {"ensemble.roots.center", "centre of the box"},
    {"ensemble.roots.power", "least and greatest power"},
    {"ensemble.roots.powers", "whole or real"},
    {"ensemble.roots.arrangement", "even, clustered or spread"},
    {"ensemble.roots.clusters", "number of clusters"},
    {"ensemble.roots.cluster_radius", "in half extents of the region, below 1"},
    {"ensemble.ranges", "numbers by name, each uniform between from and to"},
    {"ensemble.discs", "complex numbers by name, each uniform in a disc"},
    {"layers", "images behind and in front, from the bottom up"},
    {"layers.source", "leaf, #rrggbb or asset:SHA-256; a list of them is a sequence of frames"},
    {"layers.frame", "of a sequence; it begins again after the last one"},
    {"layers.front", "in front of the fractal; behind it otherwise"},
    {"layers.x", "the image's middle from the picture's, in heights of the picture"},
    {"layers.y", "the same upwards"},
    {"layers.scale", "the image's height in heights of the picture"},
    {"layers.opacity", "0 to 1"},
    {"aspect", "width / height of the picture"},
    {"samples", "along each side of a pixel, averaged in linear light"},
};

Json allowedWords(const std::string& path) {
    if (path == "colour.rule") return words({"palette", "gradient", "versor", "phase", "domain"});
    if (path == "colour.scale")
        return words({"", "linear", "log", "truncated_log", "sqrt", "cyclic"});
    if (path == "colour.interior" || path == "colour.outline")
        return words({"none", "membership", "solid"});
    if (path == "colour.smoothing") return words({"none", "ratio", "log-log"});
    if (path == "escape_test") return words({"first", "last"});
    if (path == "ensemble.set") return words({"membership", "solid"});
    if (path == "ensemble.roots.region") return words({"box", "ball"});
    if (path == "ensemble.roots.powers") return words({"whole", "real"});
    if (path == "ensemble.roots.arrangement") return words({"even", "clustered", "spread"});
    if (path == "trap.kind") return words({"point", "line", "circle"});
    if (path == "shape.outside") return words({"", "border", "distance"});
    Json all = Json::array();
    if (path == "colour.field")
        for (const FieldInfo& field : allFields()) all.push_back(std::string(field.name));
    if (path == "map")
        for (const MapKernels& map : catalogue()) all.push_back(std::string(map.info.name));
    if (path == "map") all.push_back(std::string(kFormulaName));
    return all;
}

Json schemaOf(const Json& value, const std::string& path) {
    Json schema;
    for (const auto& [key, text] : kDescriptions)
        if (path == key) schema["description"] = text;
    // Those that depend on the map, or that take two forms, say only what they may be.
    if (path == "start") {
        schema["type"] = Json::array({"array", "object"});
    } else if (path == "colour.palette") {
        schema["anyOf"] = Json::array(
            {Json{{"enum", words(paletteNames())}}, Json{{"type", "object"},
                                                         {"description",
                                                          "a palette of the scene's own, as "
                                                          "versorium palettes --json shows"}}});
    } else if (path == "layers" && value.is_array()) {
        schema["type"] = "array";
        schema["items"] = schemaOf(value[0], path);
        schema["default"] = Json::array();
        return schema;
    } else if ((path == "ensemble.ranges" || path == "ensemble.discs") && value.is_array()) {
        schema["type"] = "array";
        schema["items"] = schemaOf(value[0], path);
        schema["default"] = Json::array();
        return schema;
    } else if (path == "layers.source") {
        schema["type"] = Json::array({"string", "array"});
    } else if (path == "escape_radius") {
        schema["type"] = Json::array({"number", "string"});
    } else if (value.is_object()) {
        schema["type"] = "object";
        const bool open = path == "parameters" || path == "lists" || path == "slice.origin";
        if (!open) {
            schema["additionalProperties"] = false;
            for (auto item = value.begin(); item != value.end(); ++item)
                schema["properties"][item.key()] =
                    schemaOf(*item, path.empty() ? item.key() : path + "." + item.key());
        }
    } else {
        schema["type"] = value.is_array()            ? "array"
                         : value.is_string()         ? "string"
                         : value.is_boolean()        ? "boolean"
                         : value.is_number_integer() ? "integer"
                                                     : "number";
        if (Json allowed = allowedWords(path); !allowed.empty()) schema["enum"] = allowed;
    }
    if (!value.is_object() || path == "parameters") schema["default"] = value;
    return schema;
}

}  // namespace

Json sceneSchema() {
    // A map with a field and lists shows every section.
    Scene whole = sceneOf(*findMap("shape-modulus"));
    whole.layers.emplace_back();
    whole.ensemble.roots.emplace();
    whole.ensemble.ranges.emplace_back();
    whole.ensemble.discs.emplace_back();
    Json example = sceneToJson(whole);
    for (const char* number : {"alpha", "beta"})
        example["modulation"][number] = modulationToJson(ModulationSpec{});
    Json schema = schemaOf(example, "");
    Json result{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                {"title", "Versorium scene"}};
    schema["properties"]["assets"] = Json{
        {"type", "object"},
        {"description", "files that the scene needs, by SHA-256: {\"name\", \"data\" in base64}"}};
    schema["properties"]["formula"] =
        Json{{"type", "string"},
             {"description",
              "what the map \"formula\" does, such as \"z^2 + c\"; its names are the parameters"}};
    for (auto item = schema.begin(); item != schema.end(); ++item) result[item.key()] = *item;
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
