// SPDX-License-Identifier: MIT
// The numbers that fix an orbit, as properties: parameters of the map, the starting point, and
// lists of roots.
#include <algorithm>
#include <cmath>

#include "scene/numbers.h"
#include "scene/properties.h"

namespace versorium {
namespace {

constexpr double kLargest = 1e300;
// What is typed or dragged in the studio.
constexpr double kRootStep = 0.05;

Status tooLarge(const std::string& path) {
    return Status::data(path + ": is not a finite number of moderate size");
}

// A number of the map by its name.
SceneProperty numberProperty(const std::string& name, ValueInfo info) {
    info.path = name;
    info.kind = info.kind == ValueKind::whole ? ValueKind::whole : ValueKind::number;
    info.low = -kLargest;
    info.high = kLargest;
    info.shared = true;
    SceneProperty property{info};
    property.get = [name](const Scene& scene) {
        return Json(numberValue(scene, *numberNamed(scene, name)));
    };
    property.set = [name](Scene& scene, const Json& json, const std::string& path) -> Status {
        double value = 0;
        if (Status status = readNumber(json, -kLargest, kLargest, value); !status.ok())
            return status.in(path);
        const std::optional<NumberRef> number = numberNamed(scene, name);
        if (!number) return Status::data(path + ": there is no number of this name");
        // A starting point that is given takes the place of a critical one.
        if (number->kind == NumberKind::state) scene.criticalStart.reset();
        setNumber(scene, *number, value);
        return {};
    };
    return property;
}

ValueInfo infoOf(const ParameterInfo& parameter) {
    const bool whole = parameter.kind == ParameterKind::whole;
    const bool wide = widthOf(parameter.kind) >= 2;
    ValueInfo info{.kind = whole ? ValueKind::whole : ValueKind::number,
                   .help = parameter.help.empty() ? trLater("A number that the map depends on.")
                                                  : parameter.help,
                   .sliderLow = wide ? std::max(parameter.low, -2.0) : parameter.low,
                   .sliderHigh = wide ? std::min(parameter.high, 2.0) : parameter.high,
                   .step = whole ? 1 : (parameter.high - parameter.low) / 400,
                   .moves = true};
    return info;
}

// A whole parameter, component by component: a number, or a list of them.
SceneProperty parameterProperty(const MapInfo& map, const ParameterInfo& parameter, int first) {
    const std::string name(parameter.name);
    const auto width = static_cast<std::size_t>(widthOf(parameter.kind));
    SceneProperty property{infoOf(parameter)};
    property.path = name;
    property.label = parameter.label.empty() ? parameter.name : parameter.label;
    property.shared = true;
    if (width == 1) return numberProperty(name, property);
    property.kind = ValueKind::numbers;
    property.least = property.most = width;
    property.moves = false;
    property.get = [name](const Scene& scene) { return numbersToJson(scene.parameters.at(name)); };
    property.set = [name, width](Scene& scene, const Json& json,
                                 const std::string& path) -> Status {
        std::vector<double> read;
        if (Status status = readNumbers(json, width, width, read); !status.ok())
            return status.in(path);
        for (double number : read)
            if (!(std::abs(number) <= kLargest)) return tooLarge(path);
        scene.parameters[name] = read;
        return {};
    };
    property.parts = [&map, parameter, first, width](const Scene&) {
        SceneProperties all;
        for (std::size_t k = 0; k < width; ++k)
            all.push_back(numberProperty(parameterComponent(map, first + static_cast<int>(k)),
                                         infoOf(parameter)));
        return all;
    };
    return property;
}

SceneProperties parameterProperties(const Scene& scene) {
    const MapInfo& map = mapOf(scene).info;
    SceneProperties all;
    int component = 0;
    for (const ParameterInfo& parameter : map.parameters) {
        all.push_back(parameterProperty(map, parameter, component));
        component += widthOf(parameter.kind);
    }
    return all;
}

// Of one list: its roots with their powers, and its scale.
Json listToJson(const RootList& list) {
    Json roots = Json::array();
    for (const RootList::Root& root : list.roots)
        roots.push_back(
            Json{{"q", numbersToJson({root.q.begin(), root.q.end()})}, {"power", root.power}});
    return Json{{"scale", list.scale}, {"roots", roots}};
}

Status readRoot(const Json& json, const std::string& path, RootList::Root& root) {
    ObjectReader reader(json, path);
    std::vector<double> q;
    reader.numbers("q", q, 1, 4).number("power", root.power, -kLargestRootPower, kLargestRootPower);
    std::copy(q.begin(), q.end(), root.q.begin());
    if (!reader.has("q")) reader.fail("\"q\": [w, x, y, z] is missing");
    return reader.finish();
}

Status readList(const Json& json, const std::string& path, RootList& list) {
    ObjectReader reader(json, path);
    RootList read;
    reader.number("scale", read.scale, -1000, 1000);
    const Json* roots = reader.child("roots");
    if (!roots || !roots->is_array() || roots->size() > kMostRoots) {
        reader.fail("roots", "a list of at most " + std::to_string(kMostRoots) +
                                 " roots {\"q\": […], \"power\": p} is expected");
        return reader.finish();
    }
    for (std::size_t i = 0; i < roots->size(); ++i) {
        read.roots.emplace_back();
        reader.fail(readRoot((*roots)[i], reader.pathOf("roots") + "[" + std::to_string(i) + "]",
                             read.roots.back()));
    }
    Status status = reader.finish();
    if (status.ok()) list = std::move(read);
    return status;
}

SceneProperty listProperty(const MapInfo& map, const std::string& name) {
    SceneProperty property{
        {.path = name,
         .kind = ValueKind::other,
         .label = isPoles(map, name) ? trLater("poles") : trLater("roots"),
         .help = trLater("Roots that are bound to the map: {\"scale\": s, \"roots\": [{\"q\": "
                         "[w, x, y, z], \"power\": p}]}."),
         .shared = true}};
    property.get = [name](const Scene& scene) { return listToJson(scene.lists.at(name)); };
    property.set = [name](Scene& scene, const Json& json, const std::string& path) {
        return readList(json, path, scene.lists[name]);
    };
    property.parts = [name](const Scene& scene) {
        SceneProperties all;
        const bool complex = mapOf(scene).info.algebra == Algebra::complex;
        const std::vector<std::string> parts =
            complex ? std::vector<std::string>{"re", "im", "power"}
                    : std::vector<std::string>{"w", "x", "y", "z", "power"};
        for (std::size_t k = 0; k < scene.lists.at(name).roots.size(); ++k)
            for (const std::string& part : parts) {
                const bool power = part == "power";
                all.push_back(numberProperty(
                    name + "[" + std::to_string(k) + "]." + part,
                    {.help = power ? trLater("The exponent of z - root. The wheel over the root "
                                             "changes it.")
                                   : trLater("Where the root lies. In a view it can be dragged."),
                     .sliderLow = power ? -10.0 : -2.0,
                     .sliderHigh = power ? 10.0 : 2.0,
                     .step = power ? 1 : kRootStep}));
            }
        return all;
    };
    return property;
}

}  // namespace

SceneProperty parametersProperty() {
    SceneProperty group{{.path = "parameters",
                         .kind = ValueKind::group,
                         .label = trLater("parameters"),
                         .help = trLater("Every parameter of the map, by name: a number, or a "
                                         "list of its components."),
                         .shared = true}};
    group.get = [](const Scene& scene) {
        Json json = Json::object();
        writeProperties(scene, parameterProperties(scene), json);
        return json;
    };
    group.set = [](Scene& scene, const Json& json, const std::string& path) -> Status {
        Scene next = scene;
        if (Status status = readObject(next, parameterProperties(scene), json, path); !status.ok())
            return status;
        scene.parameters = std::move(next.parameters);
        return {};
    };
    group.parts = parameterProperties;
    return group;
}

SceneProperty startProperty() {
    SceneProperty start{{.path = "start",
                         .kind = ValueKind::other,
                         .label = trLater("start"),
                         .help = trLater("The starting point, or {\"critical\": k}: the k-th "
                                         "critical point, solved for at each pixel.")}};
    start.get = [](const Scene& scene) {
        return scene.criticalStart ? Json{{"critical", *scene.criticalStart}}
                                   : numbersToJson(scene.start);
    };
    start.set = [](Scene& scene, const Json& json, const std::string& path) -> Status {
        const auto dimension = static_cast<std::size_t>(mapOf(scene).dimension);
        if (!json.is_object()) {
            const Status status = readNumbers(json, dimension, dimension, scene.start);
            if (status.ok()) scene.criticalStart.reset();
            return status.in(path);
        }
        ObjectReader reader(json, path);
        int critical = 0;
        reader.integer("critical", critical, 0, 63);
        if (!reader.has("critical"))
            reader.fail("{\"critical\": k} or a list of numbers is expected");
        const Status status = reader.finish();
        if (status.ok()) scene.criticalStart = critical;
        return status;
    };
    start.parts = [](const Scene& scene) {
        const MapKernels& map = mapOf(scene);
        SceneProperties all;
        for (int k = 0; k < map.dimension; ++k)
            all.push_back(numberProperty(stateComponent(map.info, k),
                                         {.help = trLater("A coordinate of the starting point."),
                                          .sliderLow = map.dimension == 1 ? 0.0 : -2.0,
                                          .sliderHigh = map.dimension == 1 ? 1.0 : 2.0,
                                          .step = 0.01,
                                          .moves = !scene.criticalStart}));
        return all;
    };
    return start;
}

SceneProperty listsProperty() {
    SceneProperty group{{.path = "lists",
                         .kind = ValueKind::group,
                         .label = trLater("roots and poles"),
                         .help = trLater("Lists of roots that are bound to the map, by name."),
                         .shared = true}};
    const auto tableOf = [](const Scene& scene) {
        SceneProperties all;
        const MapInfo& map = mapOf(scene).info;
        for (const auto& [name, list] : scene.lists) all.push_back(listProperty(map, name));
        return all;
    };
    group.get = [tableOf](const Scene& scene) {
        Json json = Json::object();
        writeProperties(scene, tableOf(scene), json);
        return json;
    };
    group.set = [tableOf](Scene& scene, const Json& json, const std::string& path) -> Status {
        Scene next = scene;
        if (Status status = readObject(next, tableOf(scene), json, path); !status.ok())
            return status;
        scene.lists = std::move(next.lists);
        return {};
    };
    group.parts = tableOf;
    group.applies = [](const Scene& scene) { return !scene.lists.empty(); };
    return group;
}

}  // namespace versorium
