// SPDX-License-Identifier: MIT
#include <cmath>

#include "colour/palette.h"
#include "commands/commands.h"
#include "maps/critical.h"
#include "plate/plate_picture.h"
#include "render/bind.h"
#include "render/glsl/colour_shader.h"
#include "render/glsl/orbit_shader.h"
#include "render/movie.h"
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
    text += padded("a formula of your own", 36) + padded("'z^3 - a*z + c', …", 44) +
            "see versorium formula --help\n";
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

Status printGlsl(const std::string& name, const std::string& pass) {
    Expected<Scene> scene = sceneOfMap(name);
    if (!scene) return scene.status();
    if (pass == "colours") return print(colourShader());
    if (pass != "orbits")
        return Status::usage("--pass must be orbits or colours, not \"" + pass + "\"");
    Binder binder;
    Job job(1);
    Expected<OrbitProgram> program = binder.bind(*scene, job);
    if (!program) return program.status();
    return print(orbitShader(*scene, *program).text);
}

std::string numberText(const double* value, int width) {
    std::string text;
    for (int k = 0; k < width; ++k) text += (k > 0 ? ", " : "") + formatNumber(value[k]);
    return text;
}

// What a formula was read as: its normal form, where it lives, its parameters and critical points.
Status explainFormula(const std::string& text, bool json) {
    FormulaFault fault;
    const auto map = FormulaMap::make(text, &fault);
    if (!map) return Status::usage("formula: " + withCaret(text, fault));
    const Formula& formula = (*map)->formula();
    const MapKernels& kernels = (*map)->kernels();
    std::vector<double> values;
    for (const ParameterInfo& parameter : kernels.info.parameters)
        values.insert(values.end(), parameter.value.begin(),
                      parameter.value.begin() + widthOf(parameter.kind));
    values.push_back(0);
    constexpr int kShown = 32;
    Json points = Json::array();
    std::string lines;
    for (int k = 0; k < kShown && hasCriticalPoints(kernels); ++k) {
        double point[kMostDimension] = {};
        if (!criticalPoint(kernels, k, values.data(), {}, point)) break;
        points.push_back(Json::array({point[0], point[1]}));
        lines += "critical point " + std::to_string(k) + "  " + numberText(point, 2) + "\n";
    }
    if (json) {
        Json report = mapJson(kernels);
        report["text"] = formula.text;
        report["degree"] = formula.degree;
        report["operations"] = formula.tape.nodes.size();
        report["critical_points"] = points;
        return print(printJson(report));
    }
    std::string out = formula.text + "\n" + std::string(algebraName(kernels.info.algebra)) + "\n";
    constexpr const char* kKinds[] = {"real", "whole", "complex", "quaternion"};
    for (const FormulaParameter& parameter : formula.parameters)
        out += padded(parameter.name, 8) + padded(kKinds[static_cast<int>(parameter.kind)], 12) +
               numberText(parameter.value.data(), widthOf(parameter.kind)) + "\n";
    return print(out + lines);
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

    add("animations", "List the animations that animate takes.",
        [json] { return listNames(animationNames(), *json); });

    CLI::App* schema = line.add("schema", "Print the JSON Schema of scenes, with every default.",
                                "  versorium schema > scene.schema.json\n");
    schema->add_flag("--json", *json, "as JSON, which it is anyway");
    line.run(schema, [] { return print(printJson(sceneSchema())); });

    CLI::App* glsl = line.add(
        "glsl", "Print the GLSL ES 3.00 fragment shaders that the studio draws a map with.",
        "  versorium glsl quadratic\n"
        "  versorium glsl mandelbulb > mandelbulb.frag\n"
        "  versorium glsl mandelbulb --pass colours\n\n"
        "The first pass iterates orbits a few steps at a time and keeps them; the second\n"
        "turns them into fields and colours, and is the same for all maps.\n");
    const auto name = std::make_shared<std::string>();
    const auto pass = std::make_shared<std::string>("orbits");
    glsl->add_option("MAP", *name, "name of a map, or a formula")->required();
    glsl->add_option("--pass", *pass, "which of the two: orbits (default) or colours");
    line.run(glsl, [name, pass] { return printGlsl(*name, *pass); });

    CLI::App* formula = line.add(
        "formula", "Check a formula of your own, and say what it was read as.",
        "  versorium formula 'z^3 - a*z + c'\n"
        "  versorium formula \"x' = 1 - a*x^2 + y, y' = b*x; a = 1.4; b = 0.3\" --json\n"
        "  versorium formula 'q^2 + c; c = 0.3 + 0.5*j'\n"
        "  versorium formula 'c*sin(z); c = 1 + 0.2*i'\n\n"
        "A formula speaks of z (complex), of q (quaternions), of x (real), or is the pair x', y'.\n"
        "Other names are its parameters; after a semicolon stand kinds, defaults and ranges:\n"
        "  z^n + c; n: whole = 3 in [2, 9]; c = -0.4 + 0.6*i\n"
        "Operators + - * / ^, comparisons, and, or, not, a ? b : c. Components z.re, z.im, q.w to "
        "q.z.\n"
        "Constants pi, e, i, and j, k of quaternions. Functions: exp log sqrt sin cos tan sinh "
        "cosh\n"
        "tanh asin acos atan asinh acosh atanh abs norm arg re im conj floor min max atan2 if.\n"
        "shape(p) around a whole formula of z or q is the shape modulus with the direction of p.\n"
        "render, eval, orbit and glsl take a formula wherever they take the name of a map.\n");
    const auto text = std::make_shared<std::string>();
    formula->add_option("FORMULA", *text, "the formula; quote it")->required();
    formula->add_flag("--json", *json, "as JSON");
    line.run(formula, [text, json] { return explainFormula(*text, *json); });
}

}  // namespace versorium
