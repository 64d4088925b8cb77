// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include "base/embedded_json.h"
#include "base/hash.h"

namespace versorium {
namespace {

constexpr std::string_view kPresets = "presets/";

RootList homeList(const MapInfo& info, std::string_view list) {
    if (list != info.lists[0]) return {};
    return {{info.homeRoots.begin(), info.homeRoots.end()}, 1};
}

}  // namespace

const MapKernels& mapOf(const Scene& scene) {
    if (scene.formula) return scene.formula->kernels();
    const MapKernels* map = findMap(scene.map);
    assert(map);
    return *map;
}

Scene sceneOf(const MapKernels& map) {
    Scene scene;
    scene.map = std::string(map.info.name);
    if (map.formula) scene.formula = map.formula->shared_from_this();
    for (const ParameterInfo& parameter : map.info.parameters)
        scene.parameters[std::string(parameter.name)].assign(
            parameter.value.begin(), parameter.value.begin() + widthOf(parameter.kind));
    scene.start.assign(static_cast<std::size_t>(map.dimension), 0.0);
    for (std::string_view list : map.info.lists)
        scene.lists[std::string(list)] = homeList(map.info, list);
    const int axes = map.dimension == 1 ? 1 : 2;
    for (int k = 0; k < axes; ++k) {
        scene.slice.axes.push_back({{{stateComponent(map.info, k), 1.0}}});
        scene.slice.centre.push_back(map.info.homeCentre[static_cast<std::size_t>(k)]);
        scene.slice.centreLow.push_back(0);
    }
    scene.slice.height = map.info.homeHeight;
    // A line has no second state: the picture shows it against its first parameter.
    if (axes == 1) {
        scene.slice.axes.insert(scene.slice.axes.begin(),
                                {{{parameterComponent(map.info, 0), 1.0}}});
        scene.slice.centre.insert(scene.slice.centre.begin(), map.info.parameters[0].value[0]);
        scene.slice.centreLow.push_back(0);
    }
    if (map.info.field) scene.iterations = 3;
    return scene;
}

Expected<Scene> sceneOfMap(const std::string& nameOrFormula) {
    if (const MapKernels* map = findMap(nameOrFormula)) return sceneOf(*map);
    const bool variable = nameOrFormula.size() == 1;
    if (!looksLikeFormula(nameOrFormula) && !variable)
        return Status::usage("no map is named \"" + nameOrFormula +
                             "\" (\"versorium maps\" lists them), and a formula looks like "
                             "z^2 + c");
    FormulaFault fault;
    Expected<std::shared_ptr<const FormulaMap>> map = FormulaMap::make(nameOrFormula, &fault);
    if (!map) return Status::usage("formula: " + withCaret(nameOrFormula, fault));
    return sceneOf((*map)->kernels());
}

std::string addAsset(Scene& scene, Asset asset) {
    const std::string name = sha256(asset.bytes);
    scene.assets[name] = std::make_shared<const Asset>(std::move(asset));
    return "asset:" + name;
}

std::vector<std::string> presetNames() { return embeddedJsonNames(kPresets); }

Expected<Scene> presetNamed(const std::string& name) {
    const Json json = embeddedJson(kPresets, name);
    if (json.is_null())
        return Status::usage("no preset is named \"" + name +
                             "\"; there are: " + embeddedJsonList(kPresets));
    Expected<Scene> scene = sceneFromJson(json);
    return scene ? std::move(scene) : scene.status().in("preset " + name);
}

}  // namespace versorium
