// SPDX-License-Identifier: MIT
// The numbers that fix an orbit, as properties: parameters of the map, the starting point, lists of
// roots, and the slice that runs through them.
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
    property.label = parameter.name;
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

SceneProperty listProperty(const std::string& name) {
    SceneProperty property{
        {.path = name,
         .kind = ValueKind::other,
         .label = name == "poles" ? trLater("poles") : trLater("roots"),
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

Json axisToJson(const SliceAxis& axis) {
    Json terms = Json::object();
    for (const auto& [name, weight] : axis.terms) terms[name] = weight;
    return terms;
}

Status readAxis(const Json& json, const std::string& path, SliceAxis& axis) {
    if (!json.is_object() || json.empty())
        return Status::data(path + ": an object such as {\"z.re\": 1} is expected");
    SliceAxis read;
    for (auto item = json.begin(); item != json.end(); ++item) {
        if (!item->is_number() || item->get<double>() == 0 || !std::isfinite(item->get<double>()))
            return Status::data(path + "." + item.key() +
                                ": the weight must be a number other than 0");
        read.terms.emplace_back(item.key(), item->get<double>());
    }
    axis = std::move(read);
    return {};
}

Property<SliceSpec> axesProperty() {
    Property<SliceSpec> axes{
        {.path = "axes",
         .label = trLater("axes"),
         .help = trLater("1 to 3 directions, to the right and up first: weights of named "
                         "numbers."),
         .least = 1,
         .most = 3}};
    axes.get = [](const SliceSpec& slice) {
        Json json = Json::array();
        for (const SliceAxis& axis : slice.axes) json.push_back(axisToJson(axis));
        return json;
    };
    axes.set = [](SliceSpec& slice, const Json& json, const std::string& path) -> Status {
        if (!json.is_array() || json.empty() || json.size() > 3)
            return Status::data(path + ": a list of 1 to 3 directions is expected");
        std::vector<SliceAxis> read(json.size());
        for (std::size_t k = 0; k < read.size(); ++k)
            if (Status status = readAxis(json[k], path + "[" + std::to_string(k) + "]", read[k]);
                !status.ok())
                return status;
        slice.axes = std::move(read);
        if (slice.centre.size() != slice.axes.size()) {
            slice.centre.assign(slice.axes.size(), 0.0);
            slice.centreLow.assign(slice.axes.size(), 0.0);
        }
        return {};
    };
    axes.parts = [](const SliceSpec& slice) {
        PropertyTable<SliceSpec> all;
        for (std::size_t k = 0; k < slice.axes.size(); ++k) {
            const std::string number = std::to_string(k);
            Property<SliceSpec> one{
                {.path = "axes[" + number + "]",
                 .alias = k == 0   ? "axis0"
                          : k == 1 ? "axis1"
                                   : "axis2",
                 .label = k == 0   ? trLater("axis →")
                          : k == 1 ? trLater("axis ↑")
                                   : trLater("axis ⊙"),
                 .help = trLater("Which number runs along this axis of the view.")}};
            one.get = [k](const SliceSpec& of) { return axisToJson(of.axes[k]); };
            one.set = [k](SliceSpec& of, const Json& json, const std::string& path) {
                return readAxis(json, path, of.axes[k]);
            };
            all.push_back(std::move(one));
        }
        return all;
    };
    return axes;
}

Property<SliceSpec> originProperty() {
    return {{.path = "origin",
             .label = trLater("origin"),
             .help = trLater("Where numbers on an axis start from, if not from 0, such as "
                             "{\"c.re\": 0.3}.")},
            [](const SliceSpec& slice) {
                Json json = Json::object();
                for (const auto& [name, value] : slice.origin) json[name] = value;
                return json;
            },
            [](SliceSpec& slice, const Json& json, const std::string& path) -> Status {
                if (!json.is_object())
                    return Status::data(path + ": an object such as {\"c.re\": 0.3} is expected");
                std::map<std::string, double> read;
                for (auto item = json.begin(); item != json.end(); ++item) {
                    if (!item->is_number() || !std::isfinite(item->get<double>()))
                        return Status::data(path + ": " + item.key() + " must be a number");
                    read[item.key()] = item->get<double>();
                }
                slice.origin = std::move(read);
                return {};
            }};
}

// One number for each axis. The low part belongs to the centre: a new centre has none.
Property<SliceSpec> centreProperty(std::vector<double> SliceSpec::*member, ValueInfo info) {
    info.kind = ValueKind::numbers;
    info.least = 1;
    info.most = 3;
    return {info, [member](const SliceSpec& slice) { return numbersToJson(slice.*member); },
            [member](SliceSpec& slice, const Json& json, const std::string& path) {
                const std::size_t axes = slice.axes.size();
                return readNumbers(json, axes, axes, slice.*member).in(path);
            }};
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
        for (const auto& [name, list] : scene.lists) all.push_back(listProperty(name));
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

const PropertyTable<SliceSpec>& sliceTable() {
    static const PropertyTable<SliceSpec> table = [] {
        Property<SliceSpec> centre = centreProperty(
            &SliceSpec::centre,
            {.path = "center",
             .label = trLater("centre"),
             .help = trLater("Coordinates of the picture's centre along the axes.")});
        const auto part = [](const char* alias, const char* label) {
            return ValueInfo{.alias = alias,
                             .label = label,
                             .help = trLater("The middle of the view along this axis. Double "
                                             "click to type it."),
                             .low = -kLargest,
                             .high = kLargest,
                             .sliderLow = -2,
                             .sliderHigh = 2,
                             .moves = true};
        };
        centre.set = [set = centre.set](SliceSpec& slice, const Json& json,
                                        const std::string& path) {
            const Status status = set(slice, json, path);
            if (status.ok()) slice.centreLow.assign(slice.axes.size(), 0.0);
            return status;
        };
        return PropertyTable<SliceSpec>{
            axesProperty(),
            originProperty(),
            withComponents(
                centre, {part("centre0", trLater("centre →")), part("centre1", trLater("centre ↑")),
                         part("centre2", trLater("centre ⊙"))}),
            centreProperty(&SliceSpec::centreLow,
                           {.path = "center_low",
                            .label = trLater("centre, low part"),
                            .help = trLater("Low parts of the same, added for deep views.")}),
            numberOf(&SliceSpec::height,
                     {.path = "height",
                      .label = trLater("height"),
                      .help = trLater("What the view shows from bottom to top. Smaller is deeper."),
                      .low = 1e-300,
                      .high = 1e12,
                      .sliderLow = 1e-12,
                      .sliderHigh = 10,
                      .logarithmic = true,
                      .moves = true}),
        };
    }();
    return table;
}

}  // namespace versorium
