// SPDX-License-Identifier: MIT
#include "colour/palette.h"
#include "commands/commands.h"
#include "plate/plate_picture.h"
#include "render/bind.h"
#include "render/glsl/shader.h"
#include "scene/scene.h"

namespace versorium {
namespace {

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size() + 2, width), ' ');
    return text;
}

Json mapJson(const MapKernels& map) {
    Json parameters = Json::array();
    for (const ParameterInfo& parameter : map.info.parameters) {
        Json value = Json::array();
        for (int k = 0; k < widthOf(parameter.kind); ++k)
            value.push_back(parameter.value[static_cast<std::size_t>(k)]);
        parameters.push_back(Json{{"name", std::string(parameter.name)},
                                  {"default", value.size() == 1 ? value[0] : value},
                                  {"range", Json::array({parameter.low, parameter.high})},
                                  {"help", std::string(parameter.help)}});
    }
    Json lists = Json::array();
    for (std::string_view list : map.info.lists) lists.push_back(std::string(list));
    return Json{{"name", std::string(map.info.name)},
                {"title", std::string(map.info.title)},
                {"formula", std::string(map.info.formula)},
                {"algebra", std::string(algebraName(map.info.algebra))},
                {"parameters", parameters},
                {"lists", lists},
                {"shape", map.info.field},
                {"escape_radius",
                 map.info.escapeRadius < kNoEscape ? Json(map.info.escapeRadius) : Json(nullptr)},
                {"source", std::string(map.info.source)}};
}

Status listMaps(bool json) {
    Json all = Json::array();
    std::string text;
    for (const MapKernels& map : catalogue()) {
        all.push_back(mapJson(map));
        text += padded(std::string(map.info.name), 36) + padded(std::string(map.info.formula), 44) +
                std::string(algebraName(map.info.algebra)) + "\n";
    }
    return print(json ? printJson(all) : text);
}

Status listNames(const std::vector<std::string>& names, bool json) {
    Json all = Json::array();
    std::string text;
    for (const std::string& name : names) {
        all.push_back(name);
        text += name + "\n";
    }
    return print(json ? printJson(all) : text);
}

Status listPalettes(bool json) {
    Json all = Json::array();
    std::string text;
    for (const std::string& name : paletteNames()) {
        const Expected<Palette> palette = paletteNamed(name);
        if (!palette) return palette.status();
        all.push_back(paletteToJson(*palette));
        text += padded(name, 16) + wordOf(palette->kind()) + "\n";
    }
    return print(json ? printJson(all) : text);
}

Status printGlsl(const std::string& name) {
    const MapKernels* map = findMap(name);
    if (!map)
        return Status::usage("no map is named \"" + name + "\"; \"versorium maps\" lists them");
    return print(escapeShader(map->trace()));
}

}  // namespace

void addListCommands(CommandLine& line) {
    const auto json = std::make_shared<bool>(false);
    const auto add = [&](const std::string& name, const std::string& help, Action action) {
        CLI::App* command =
            line.add(name, help, "  versorium " + name + "\n  versorium " + name + " --json\n");
        command->add_flag("--json", *json, "as JSON");
        line.run(command, std::move(action));
    };
    add("maps", "List the maps of the catalogue.", [json] { return listMaps(*json); });
    add("palettes", "List the palettes; with --json their stops, as palette files.",
        [json] { return listPalettes(*json); });
    add("plates", "List the built-in figure plates.",
        [json] { return listNames(plateNames(), *json); });
    add("presets", "List the presets that render, eval and orbit take.",
        [json] { return listNames(presetNames(), *json); });

    CLI::App* schema = line.add("schema", "Print the JSON Schema of scenes, with every default.",
                                "  versorium schema > scene.schema.json\n");
    schema->add_flag("--json", *json, "as JSON, which it is anyway");
    line.run(schema, [] { return print(printJson(sceneSchema())); });

    CLI::App* glsl =
        line.add("glsl", "Print a map as a GLSL ES 3.00 fragment shader, as its tape gives it.",
                 "  versorium glsl quadratic\n  versorium glsl mandelbulb > mandelbulb.frag\n");
    const auto name = std::make_shared<std::string>();
    glsl->add_option("MAP", *name, "name of a map")->required();
    line.run(glsl, [name] { return printGlsl(*name); });
}

}  // namespace versorium
