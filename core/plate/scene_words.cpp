// SPDX-License-Identifier: MIT
#include "plate/scene_words.h"

#include "scene/numbers.h"
#include "scene/shape_name.h"

namespace versorium {
namespace {

std::string complexNumber(double re, double im, const Words& words) {
    if (im == 0) return plateNumber(re, words);
    const double size = im < 0 ? -im : im;
    const std::string imaginary = size == 1 ? "i" : plateNumber(size, words) + "i";
    if (re == 0) return (im < 0 ? "\u2212" : "") + imaginary;
    return plateNumber(re, words) + (im < 0 ? " \u2212 " : " + ") + imaginary;
}

std::string valueText(const ParameterInfo& parameter, const std::vector<double>& value,
                      const Words& words) {
    if (parameter.kind == ParameterKind::complex) return complexNumber(value[0], value[1], words);
    if (value.size() == 1) return plateNumber(value[0], words);
    std::string text = "(";
    for (std::size_t k = 0; k < value.size(); ++k)
        text += (k > 0 ? words.separator() : "") + plateNumber(value[k], words);
    return text + ")";
}

// What the picture shows by its colours.
std::string colouringWords(const Colouring& colour, const Words& words) {
    if (colour.rule == ColourRule::gradient) return words.tr("coloured by the escape step");
    if (colour.rule == ColourRule::versor) return words.tr("coloured by the versor");
    if (colour.rule == ColourRule::phase) return words.tr("coloured by the argument");
    if (colour.rule == ColourRule::domain)
        return words.tr(
            "coloured by the argument, with edges where the modulus is a power of 2 and the "
            "argument a multiple of π/6");
    return words.tr("coloured by the field {1}", {std::string(wordOf(colour.field))});
}

}  // namespace

std::string plateNumber(double value, const Words& words) {
    std::string text = words.number(formatNumber(value, 6));
    if (!text.empty() && text[0] == '-') text.replace(0, 1, "\u2212");
    return text;
}

std::string axisText(const std::string& name, const Words& words) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) return name == "power" ? words.tr("exponent d") : name;
    std::string owner = name.substr(0, dot);
    const std::string part = name.substr(dot + 1);
    if (const std::size_t open = owner.find('['); open != std::string::npos)
        owner =
            owner.substr(0, open) + "_{" + owner.substr(open + 1, owner.find(']') - open - 1) + "}";
    if (part == "re") return "Re " + owner;
    if (part == "im") return "Im " + owner;
    if (owner == "g" || owner == "h") {
        if (part.size() == 2)
            return part.substr(0, 1) + "_{" + part.substr(1) + "}^{" + owner + "}";
        return part + "^{" + owner + "}";
    }
    if (owner == "q" || owner == "p") return part;
    return owner + "_{" + part + "}";
}

std::string axisText(const SliceAxis& axis, const Words& words) {
    std::string label;
    for (const auto& [name, weight] : axis.terms) {
        if (!label.empty()) label += weight < 0 ? " \u2212 " : " + ";
        const double size = label.empty() ? weight : weight < 0 ? -weight : weight;
        if (size != 1) label += plateNumber(size, words) + " ";
        label += axisText(name, words);
    }
    return label;
}

std::map<std::string, std::string> sceneFacts(const Scene& scene, const OrbitProgram& program,
                                              const Words& words) {
    std::map<std::string, std::string> facts;
    const MapInfo& info = program.map->info;
    facts["map"] = words.tr(info.title);
    facts["iterations"] = std::to_string(scene.iterations);
    facts["escape_radius"] = plateNumber(program.escapeRadius, words);
    facts["height"] = plateNumber(scene.slice.height, words);
    facts["iso"] = plateNumber(scene.iso, words);
    facts["shape"] = shapeName(scene, scene.shape.source);
    for (const ParameterInfo& parameter : info.parameters) {
        const std::string name(parameter.name);
        facts[name] = valueText(parameter, scene.parameters.at(name), words);
    }
    for (int k = 0; k < program.map->parameters; ++k)
        facts[parameterComponent(info, k)] =
            plateNumber(numberValue(scene, {NumberKind::parameter, k, {}, 0, 0, 0}), words);
    for (int k = 0; k < program.map->dimension; ++k)
        facts[stateComponent(info, k)] =
            plateNumber(scene.start[static_cast<std::size_t>(k)], words);
    for (const auto& [name, list] : scene.lists) facts[name] = std::to_string(list.roots.size());
    const EnsembleSpec& ensemble = scene.ensemble;
    facts["members"] = std::to_string(ensemble.count);
    facts["seed"] = std::to_string(ensemble.seed);
    if (ensemble.roots) {
        const RandomRoots& draw = ensemble.roots->draw;
        const auto range = [&](const std::string& least, const std::string& most) {
            return least == most ? least : words.tr("{1} to {2}", {least, most});
        };
        facts["drawn"] = range(std::to_string(draw.least), std::to_string(draw.most));
        facts["powers"] =
            range(plateNumber(draw.lowPower, words), plateNumber(draw.highPower, words));
    }
    return facts;
}

std::string sceneSentence(const Scene& scene, const Words& words) {
    const MapInfo& info = mapOf(scene).info;
    std::string text = words.tr(info.title) + ", " + words.tr(info.formula);
    std::string values;
    for (const ParameterInfo& parameter : info.parameters) {
        const std::string name(parameter.name);
        const auto& value = scene.parameters.at(name);
        bool zero = true;
        for (double part : value) zero = zero && part == 0;
        bool sliced = false;
        for (const SliceAxis& axis : scene.slice.axes)
            for (const auto& [term, weight] : axis.terms)
                sliced = sliced || term == name || term.starts_with(name + ".");
        if (!sliced && !zero)
            values += words.separator() + name + " = " + valueText(parameter, value, words);
    }
    if (info.field) values += "; " + words.tr("shape: {1}", {shapeName(scene, scene.shape.source)});
    for (const auto& [name, spec] :
         {std::pair{"alpha", &scene.alphaOverSpace}, std::pair{"beta", &scene.betaOverSpace}})
        if (info.field && spec->modulates())
            values += words.separator() +
                      (spec->discs.empty() ? words.tr("{1} differs over space", {name})
                                           : words.tr("{1} differs over space as painted", {name}));
    std::string axes;
    for (const SliceAxis& axis : scene.slice.axes) {
        const std::string label = axisText(axis, words);
        axes = axes.empty() ? label : words.tr("{1} and {2}", {axes, label});
    }
    text += values + "; " +
            words.tr("on the plane of {1}, height {2}",
                     {axes, plateNumber(scene.slice.height, words)}) +
            "; " + words.tr("{1} iterations", {std::to_string(scene.iterations)}) + "; " +
            colouringWords(scene.colour, words);
    if (scene.ensemble.varies())
        text += "; " + words.tr("an ensemble of {1} maps, seed {2}",
                                {std::to_string(scene.ensemble.count),
                                 std::to_string(scene.ensemble.seed)});
    return text + ".";
}

}  // namespace versorium
