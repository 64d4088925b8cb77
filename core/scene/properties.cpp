// SPDX-License-Identifier: MIT
#include "scene/properties.h"

#include <algorithm>
#include <limits>

#include "maps/critical.h"
#include "scene/numbers.h"

namespace versorium {
namespace {

// Sections whose values go by their last name alone, in this order.
constexpr std::string_view kSections[] = {"slice", "shape", "colour", "trap"};

bool hasField(const Scene& scene) { return mapOf(scene).info.field; }

// A group that only maps with a shape have.
SceneProperty ofShapes(SceneProperty property) {
    property.applies = hasField;
    property.shared = true;
    return property;
}

SceneProperty modulationProperty() {
    struct Over {
        const char* name;
        ModulationSpec Scene::*member;
        const char* help;
    };
    static constexpr Over kOver[] = {
        {"alpha", &Scene::alphaOverSpace, trLater("Another value of alpha in some places.")},
        {"beta", &Scene::betaOverSpace, trLater("Another value of beta in some places.")}};
    const auto table = [](const Scene&) {
        SceneProperties all;
        for (const auto& [name, member, help] : kOver) {
            SceneProperty one = groupOf(
                member, modulationTable,
                {.path = name, .label = trLater("over space"), .help = help, .shared = true});
            one.omitted = [member = member](const Scene& scene) {
                return scene.*member == ModulationSpec{};
            };
            all.push_back(std::move(one));
        }
        return all;
    };
    SceneProperty group{{.path = "modulation",
                         .kind = ValueKind::group,
                         .label = trLater("over space"),
                         .help = trLater("alpha and beta over space; elsewhere they are the "
                                         "parameters."),
                         .shared = true}};
    group.get = [table](const Scene& scene) {
        Json json = Json::object();
        writeProperties(scene, table(scene), json);
        return json;
    };
    group.set = [table](Scene& scene, const Json& json, const std::string& path) {
        return readObject(scene, table(scene), json, path);
    };
    group.parts = [table](const Scene& scene) {
        SceneProperties all;
        for (SceneProperty& one : table(scene)) {
            const std::string name = one.path;
            ModulationSpec Scene::*member =
                name == "alpha" ? &Scene::alphaOverSpace : &Scene::betaOverSpace;
            one.path = "modulation." + name;
            one.parts = [member, path = one.path](const Scene&) {
                return liftedTable<Scene, ModulationSpec>(
                    modulationTable(), path,
                    [member](Scene& owner) -> ModulationSpec& { return owner.*member; }, true);
            };
            all.push_back(std::move(one));
        }
        return all;
    };
    group.applies = hasField;
    group.omitted = [](const Scene& scene) {
        return scene.alphaOverSpace == ModulationSpec{} && scene.betaOverSpace == ModulationSpec{};
    };
    return group;
}

SceneProperty escapeRadiusProperty() {
    return {{.path = "escape_radius",
             .alias = "radius",
             .kind = ValueKind::number,
             .label = trLater("escape radius"),
             .help = trLater("Beyond this an orbit has escaped. auto: the map's own."),
             .low = 0,
             .high = 1e150,
             .sliderLow = 0.5,
             .sliderHigh = 100,
             .step = 0.5,
             .logarithmic = true},
            [](const Scene& scene) {
                return scene.escapeRadius ? Json(*scene.escapeRadius) : Json("auto");
            },
            [](Scene& scene, const Json& json, const std::string& path) -> Status {
                if (json.is_string() && json.get<std::string>() == "auto") {
                    scene.escapeRadius.reset();
                    return {};
                }
                if (!json.is_number())
                    return Status::data(path + ": a number or \"auto\" is expected");
                double radius = 0;
                const Status status = readNumber(json, 0, 1e150, radius);
                if (status.ok()) scene.escapeRadius = radius;
                return status.in(path);
            }};
}

bool isListed(const SceneProperty& property, std::string_view name) {
    return property.path.size() > name.size() && property.path.starts_with(name) &&
           (property.path[name.size()] == '.' || property.path[name.size()] == '[');
}

// Depth first, and only into groups whose path begins the name.
std::optional<SceneProperty> atPath(const Scene& scene, const SceneProperties& table,
                                    std::string_view path) {
    for (const SceneProperty& property : table) {
        if (property.applies && !property.applies(scene)) continue;
        if (property.path == path) return property;
        if (!property.parts) continue;
        const std::string_view begin = property.path;
        const bool within = path.size() > begin.size() && path.starts_with(begin) &&
                            (path[begin.size()] == '.' || path[begin.size()] == '[');
        // Numbers of the map go by their own names.
        const bool numbers = begin == "parameters" || begin == "start" || begin == "lists";
        if (!within && !numbers) continue;
        if (auto found = atPath(scene, property.parts(scene), path)) return found;
    }
    return std::nullopt;
}

// The least number of letters to change, add or take away (Levenshtein 1966).
std::size_t distanceBetween(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t corner = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t kept = corner + (a[i - 1] == b[j - 1] ? 0 : 1);
            corner = row[j];
            row[j] = std::min({kept, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

}  // namespace

const SceneProperties& sceneTable() {
    static const SceneProperties table = [] {
        SceneProperty ensemble =
            groupOf(&Scene::ensemble, ensembleTable,
                    {.path = "ensemble",
                     .label = trLater("average"),
                     .help = trLater("Maps that differ in numbers drawn at random, for the field "
                                     "mean_membership.")});
        ensemble.omitted = [](const Scene& scene) { return scene.ensemble == EnsembleSpec{}; };
        SceneProperty layers =
            listOf(&Scene::layers, layerTable,
                   {.path = "layers",
                    .label = trLater("images"),
                    .help = trLater("Images behind and in front, from the bottom up."),
                    .most = kMostLayers});
        layers.omitted = [](const Scene& scene) { return scene.layers.empty(); };
        return SceneProperties{
            parametersProperty(),
            startProperty(),
            listsProperty(),
            ofShapes(groupOf(&Scene::shape, shapeTable,
                             {.path = "shape",
                              .label = trLater("shape"),
                              .help = trLater("The distance field of shape-modulus maps."),
                              .shared = true})),
            modulationProperty(),
            groupOf(&Scene::slice, sliceTable,
                    {.path = "slice",
                     .label = trLater("slice"),
                     .help = trLater("Which points of starting points × parameters the picture "
                                     "shows.")}),
            wholeOf(&Scene::iterations,
                    {.path = "iterations",
                     .label = trLater("max steps N"),
                     .help = trLater("How many steps an orbit is followed, at most."),
                     .low = 0,
                     .high = kMostIterations,
                     .sliderLow = 1,
                     .sliderHigh = 10000,
                     .step = 50,
                     .logarithmic = true,
                     .moves = true}),
            escapeRadiusProperty(),
            wordOfEnum(&Scene::escapeTest,
                       {.path = "escape_test",
                        .alias = "escape test",
                        .label = trLater("escape test"),
                        .help = trLater("first: an orbit has escaped with its first point outside. "
                                        "last: only the N-th point counts (A eq 12).")}),
            numberOf(&Scene::iso, {.path = "iso",
                                   .label = trLater("solid below"),
                                   .help = trLater("The field solid is 1 where log_modulus is "
                                                   "below this."),
                                   .low = -1e6,
                                   .high = 1e6,
                                   .sliderLow = -4,
                                   .sliderHigh = 4,
                                   .step = 0.05,
                                   .moves = true}),
            groupOf(&Scene::trap, trapTable,
                    {.path = "trap",
                     .label = trLater("trap"),
                     .help = trLater("What the field trap measures the distance to.")}),
            groupOf(&Scene::colour, colourTable,
                    {.path = "colour",
                     .label = trLater("colours"),
                     .help = trLater("How fields become colours.")}),
            ensemble,
            layers,
            numberOf(&Scene::aspect, {.path = "aspect",
                                      .label = trLater("width / height"),
                                      .help = trLater("Of an exported picture."),
                                      .low = 0.1,
                                      .high = 10,
                                      .sliderLow = 0.5,
                                      .sliderHigh = 2,
                                      .step = 0.1}),
            wholeOf(&Scene::samples,
                    {.path = "samples",
                     .label = trLater("samples"),
                     .help = trLater("Samples along each side of a pixel, averaged in linear "
                                     "light: 4 is very smooth."),
                     .low = 1,
                     .high = kMostSamples,
                     .sliderLow = 1,
                     .sliderHigh = kMostSamples,
                     .step = 1}),
        };
    }();
    return table;
}

SceneProperties propertiesOf(const Scene& scene) {
    SceneProperties all;
    spread(scene, sceneTable(), all);
    return all;
}

SceneProperties shownProperties(const Scene& scene, const std::string& group) {
    // An item of a list ("layers[1]") is what its list has below that path.
    const bool item = group.ends_with("]");
    const std::string whole = item ? group.substr(0, group.rfind('[')) : group;
    SceneProperties all;
    if (const auto found = atPath(scene, sceneTable(), whole); found && found->parts)
        spread(scene, found->parts(scene), all, true);
    if (item)
        std::erase_if(all, [&](const SceneProperty& property) {
            return !property.path.starts_with(group + ".");
        });
    return all;
}

std::optional<SceneProperty> propertyNamed(const Scene& scene, const std::string& name) {
    // The shape is its source; its grid's options go by their paths.
    if (name == "shape") return atPath(scene, sceneTable(), "shape.source");
    if (auto found = atPath(scene, sceneTable(), name)) return found;
    for (std::string_view section : kSections)
        if (auto found = atPath(scene, sceneTable(), std::string(section) + "." + name))
            return found;
    // "parameters.c" and "lists.roots" as the JSON has them.
    for (std::string_view section : {"parameters.", "lists."})
        if (name.starts_with(section))
            if (auto found = atPath(scene, sceneTable(), name.substr(section.size()))) return found;
    for (SceneProperty& property : propertiesOf(scene))
        if (property.isCalled(name)) return std::move(property);
    return std::nullopt;
}

std::vector<std::string> nearestNames(const Scene& scene, const std::string& name) {
    std::vector<std::pair<std::size_t, std::string>> near;
    for (const SceneProperty& property : propertiesOf(scene)) {
        if (property.kind == ValueKind::group) continue;
        const std::size_t distance = std::min(distanceBetween(name, property.path),
                                              distanceBetween(name, property.shortName()));
        // Half of the letters may differ.
        if (2 * distance <= std::max<std::size_t>(2, name.size()))
            near.emplace_back(distance, property.path);
    }
    std::stable_sort(near.begin(), near.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> names;
    for (std::size_t k = 0; k < std::min<std::size_t>(3, near.size()); ++k)
        names.push_back(near[k].second);
    return names;
}

Json defaultOf(const Scene& scene, const SceneProperty& property) {
    if (property.home && !isListed(property, "slice")) return *property.home;
    const Scene home = sceneOf(mapOf(scene));
    if (const auto there = atPath(home, sceneTable(), property.path)) return there->get(home);
    return property.home ? *property.home : Json();
}

// Words of other programs for what has another name here.
std::string_view ownNameOf(std::string_view name) {
    constexpr std::pair<std::string_view, std::string_view> kWords[] = {
        {"zoom", "slice.height"},
        {"magnification", "slice.height"},
        {"radius", "slice.height"},
        {"size", "slice.height"},
        {"width", "slice.height"},
        {"maxiter", "iterations"},
        {"max_iterations", "iterations"},
        {"iter", "iterations"},
        {"depth", "iterations"},
        {"N", "iterations"},
        {"n", "iterations"},
        {"bailout", "escape_radius"},
        {"palette", "colour.palette"},
        {"antialiasing", "samples"},
        {"supersampling", "samples"}};
    for (const auto& [word, own] : kWords)
        if (word == name) return own;
    return {};
}

Status unknownValue(const Scene& scene, const std::string& name) {
    // What other maps have is said to be theirs.
    std::string owners;
    int count = 0;
    for (const MapKernels& map : catalogue())
        if (propertyNamed(sceneOf(map), name) && ++count <= 3)
            owners += (owners.empty() ? "" : ", ") + std::string(map.info.name);
    if (count > 0)
        return Status::data("the map \"" + scene.map + "\" has no \"" + name +
                            "\"; maps that have it are " + owners +
                            (count > 3 ? " and others" : ""));
    if (const std::string_view own = ownNameOf(name); !own.empty())
        return Status::data("there is no such key; did you mean " + std::string(own) + "?");
    const std::vector<std::string> near = nearestNames(scene, name);
    if (near.empty())
        return Status::data("the map \"" + scene.map + "\" has no such key; its numbers are " +
                            numberNames(scene));
    std::string all = near[0];
    for (std::size_t k = 1; k < near.size(); ++k)
        all += (k + 1 == near.size() ? " or " : ", ") + near[k];
    return Status::data("the map \"" + scene.map + "\" has no such key; did you mean " + all + "?");
}

Status setProperty(Scene& scene, const SceneProperty& property, const Json& value) {
    Scene next = scene;
    if (Status status = property.set(next, value, property.path); !status.ok()) return status;
    if (Status status = checkScene(next); !status.ok()) return status;
    scene = std::move(next);
    return {};
}

Status checkScene(const Scene& scene) {
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
    if (scene.criticalStart && !hasCriticalPoints(mapOf(scene)))
        return Status::data("start: the map \"" + scene.map +
                            "\" has no critical points; give the start as numbers");
    if (scene.criticalStart)
        for (const SliceAxis& axis : scene.slice.axes)
            for (const auto& [name, weight] : axis.terms)
                if (numberNamed(scene, name)->kind == NumberKind::state)
                    return Status::data("start: a critical point and an axis through \"" + name +
                                        "\" exclude each other; give the start as numbers");
    if (const Status status = checkEnsemble(scene); !status.ok()) return status;
    return checkModulation(scene);
}

}  // namespace versorium
