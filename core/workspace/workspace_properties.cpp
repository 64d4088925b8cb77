// SPDX-License-Identifier: MIT
#include "workspace/workspace_properties.h"

#include <algorithm>

namespace versorium {
namespace {

constexpr double kFarthestCircle = 1e150;

std::size_t dimensionOf(const Workspace& workspace) {
    return static_cast<std::size_t>(mapOf(workspace.views[0]).dimension);
}

// What is the same as ever is not written.
WorkspaceProperty unless(Json standard, WorkspaceProperty property) {
    property.omitted = [standard, get = property.get](const Workspace& workspace) {
        return get(workspace) == standard;
    };
    return property;
}

WorkspaceProperty focusedProperty() {
    return {{.path = "focused",
             .kind = ValueKind::whole,
             .label = trLater("focused view"),
             .help = trLater("The view that commands act on, from 0."),
             .low = 0,
             .high = kMostViews - 1,
             .step = 1},
            [](const Workspace& workspace) { return Json(workspace.focused); },
            [](Workspace& workspace, const Json& json, const std::string& path) {
                return readWhole(json, 0, static_cast<int>(workspace.views.size()) - 1,
                                 workspace.focused)
                    .in(path);
            }};
}

WorkspaceProperty pointProperty() {
    WorkspaceProperty point{{.path = "point",
                             .kind = ValueKind::numbers,
                             .label = trLater("starting point"),
                             .help = trLater("The starting point of the orbit that is drawn."),
                             .least = 1,
                             .most = 4}};
    point.get = [](const Workspace& workspace) { return numbersToJson(workspace.point); };
    point.set = [](Workspace& workspace, const Json& json, const std::string& path) {
        const std::size_t size = dimensionOf(workspace);
        return readNumbers(json, size, size, workspace.point).in(path);
    };
    return point;
}

Json pinsToJson(const Workspace& workspace) {
    Json json = Json::array();
    for (const Pin& pin : workspace.pins) {
        Json values = Json::object();
        for (const auto& [name, value] : pin) values[name] = value;
        json.push_back(values);
    }
    return json;
}

Status readPins(Workspace& workspace, const Json& json, const std::string& path) {
    if (!json.is_array() || json.size() > kMostPins)
        return Status::data(path + ": must be a list of at most 4 settings");
    std::vector<Pin> pins;
    for (std::size_t k = 0; k < json.size(); ++k) {
        Pin pin;
        ObjectReader values(json[k], path + "[" + std::to_string(k) + "]");
        for (const ParameterInfo& parameter : mapOf(workspace.views[0]).info.parameters) {
            const auto width = static_cast<std::size_t>(widthOf(parameter.kind));
            std::vector<double> value(parameter.value.begin(),
                                      parameter.value.begin() + widthOf(parameter.kind));
            const std::string name(parameter.name);
            values.numbers(name.c_str(), value, width, width);
            pin[name] = value;
        }
        if (Status status = values.finish(); !status.ok()) return status;
        pins.push_back(std::move(pin));
    }
    workspace.pins = std::move(pins);
    return {};
}

Json motionJson(const Workspace& workspace) {
    Json json;
    motionToJson(workspace.motion, json);
    json["view"] = workspace.motionView;
    return json;
}

Status readWorkspaceMotion(Workspace& workspace, const Json& json, const std::string& path) {
    ObjectReader reader(json, path);
    int view = 0;
    reader.integer("view", view, 0, static_cast<int>(workspace.views.size()) - 1);
    Motion motion;
    if (Status status = readMotion(reader, workspace.views[static_cast<std::size_t>(view)], motion);
        !status.ok())
        return status;
    if (Status status = reader.finish(); !status.ok()) return status;
    workspace.motion = std::move(motion);
    workspace.motionView = view;
    return {};
}

WorkspaceProperty comparedProperty() {
    WorkspaceProperty compared{
        {.path = "compared",
         .kind = ValueKind::numbers,
         .label = trLater("second start"),
         .help = trLater("The starting point of a second orbit in the time series. Empty: none."),
         .least = 0,
         .most = 4}};
    compared.get = [](const Workspace& workspace) { return numbersToJson(workspace.compared); };
    compared.set = [](Workspace& workspace, const Json& json, const std::string& path) {
        const std::size_t size = json.is_array() && json.empty() ? 0 : dimensionOf(workspace);
        return readNumbers(json, size, size, workspace.compared).in(path);
    };
    return unless(Json::array(), compared);
}

const PropertyTable<Workspace::Study>& studyTable() {
    using Study = Workspace::Study;
    static const PropertyTable<Study> table{
        toggleOf(&Study::cycles, {.path = "cycles",
                                  .label = trLater("cycles"),
                                  .help = trLater("Fixed points and cycles with their "
                                                  "eigenvalues, drawn and listed.")}),
        wholeOf(&Study::mostPeriod,
                {.path = "most_period",
                 .label = trLater("period, at most"),
                 .help = trLater("The longest period of cycles that are looked for."),
                 .low = 1,
                 .high = kMostShownPeriod,
                 .sliderLow = 1,
                 .sliderHigh = kMostShownPeriod,
                 .step = 1}),
        toggleOf(&Study::manifolds, {.path = "manifolds",
                                     .label = trLater("manifolds"),
                                     .help = trLater("Stable and unstable manifolds of saddles.")}),
        toggleOf(&Study::criticalCurve, {.path = "critical_curve",
                                         .label = trLater("critical curve"),
                                         .help = trLater("Where the map folds: det J = 0.")}),
    };
    return table;
}

const PropertyTable<Workspace::Circle>& circleTable() {
    using Circle = Workspace::Circle;
    static const PropertyTable<Circle> table = [] {
        Property<Circle> centre{{.path = "center",
                                 .kind = ValueKind::numbers,
                                 .label = trLater("centre"),
                                 .help = trLater("Where the circle's centre lies."),
                                 .least = 4,
                                 .most = 4}};
        centre.get = [](const Circle& circle) {
            return numbersToJson({circle.centre.begin(), circle.centre.end()});
        };
        centre.set = [](Circle& circle, const Json& json, const std::string& path) -> Status {
            std::vector<double> read;
            if (Status status = readNumbers(json, 4, 4, read); !status.ok()) return status.in(path);
            std::copy(read.begin(), read.end(), circle.centre.begin());
            return {};
        };
        const ValueInfo part{.help = trLater("Where the circle's centre lies."),
                             .low = -kFarthestCircle,
                             .high = kFarthestCircle,
                             .sliderLow = -2,
                             .sliderHigh = 2,
                             .step = 0.05};
        return PropertyTable<Circle>{
            withComponents(centre, {part, part, part, part}),
            numberOf(&Circle::radius, {.path = "radius",
                                       .label = trLater("radius"),
                                       .help = trLater("The radius of the circle."),
                                       .low = 1e-15,
                                       .high = 1e6,
                                       .sliderLow = 1e-3,
                                       .sliderHigh = 4,
                                       .step = 0.05,
                                       .logarithmic = true}),
        };
    }();
    return table;
}

Json diagramToJson(const Workspace& workspace) {
    return {{"number", workspace.diagram.number},
            {"range", {workspace.diagram.left, workspace.diagram.right}}};
}

Status readDiagram(Workspace& workspace, const Json& json, const std::string& path) {
    ObjectReader reader(json, path);
    Workspace::Diagram diagram;
    std::vector<double> range;
    reader.text("number", diagram.number).numbers("range", range, 2, 2);
    const auto number = numberNamed(workspace.views[0], diagram.number);
    if (!number || number->kind != NumberKind::parameter)
        reader.fail("number", "must be the name of a parameter of the map");
    if (range.size() != 2 || !(range[0] < range[1]))
        reader.fail("range", "must be two numbers, the lower one first");
    else
        diagram.left = range[0], diagram.right = range[1];
    const Status status = reader.finish();
    if (status.ok()) workspace.diagram = diagram;
    return status;
}

Json rangesToJson(const Workspace& workspace) {
    Json json = Json::object();
    for (const auto& [name, range] : workspace.ranges) json[name] = {range[0], range[1]};
    return json;
}

Status readRanges(Workspace& workspace, const Json& json, const std::string& path) {
    if (!json.is_object() || json.size() > kMostRanges)
        return Status::data(path + ": must be an object of at most 256 ranges");
    ObjectReader values(json, path);
    std::map<std::string, std::array<double, 2>> ranges;
    for (const auto& [name, unused] : json.items()) {
        std::vector<double> range;
        values.numbers(name.c_str(), range, 2, 2);
        if (range.size() != 2 || !(range[0] < range[1]))
            values.fail(name.c_str(), "must be two numbers, the lower one first");
        else
            ranges[name] = {range[0], range[1]};
    }
    const Status status = values.finish();
    if (status.ok()) workspace.ranges = std::move(ranges);
    return status;
}

WorkspaceProperty structure(const char* path, const char* label, const char* help,
                            Json (*get)(const Workspace&),
                            Status (*set)(Workspace&, const Json&, const std::string&),
                            bool (*omitted)(const Workspace&)) {
    WorkspaceProperty property{{.path = path, .label = label, .help = help}, get, set};
    property.omitted = omitted;
    return property;
}

}  // namespace

const PropertyTable<Workspace>& workspaceTable() {
    static const PropertyTable<Workspace> table{
        focusedProperty(),
        unless(false, toggleOf(&Workspace::maximised,
                               {.path = "maximised",
                                .label = trLater("only the focused view"),
                                .help = trLater("The focused view fills the window.")})),
        pointProperty(),
        wholeOf(&Workspace::orbitSteps,
                {.path = "orbit_steps",
                 .alias = "steps",
                 .label = trLater("steps that are drawn"),
                 .help = trLater("How many steps of the orbit are drawn. Drag, or double click to "
                                 "type."),
                 .low = 0,
                 .high = kMostOrbitSteps,
                 .sliderLow = 0,
                 .sliderHigh = 100,
                 .step = 1}),
        unless(0, wholeOf(&Workspace::orbitAt,
                          {.path = "orbit_at",
                           .alias = "marked step",
                           .label = trLater("chosen step"),
                           .help = trLater("The step of the orbit that is emphasised in the "
                                           "views."),
                           .low = 0,
                           .high = kMostOrbitSteps,
                           .sliderLow = 0,
                           .sliderHigh = 100,
                           .step = 1})),
        unless(false, toggleOf(&Workspace::arrows,
                               {.path = "arrows",
                                .label = trLater("arrows from points to their images"),
                                .help = trLater("Draws arrows from points x of the view to "
                                                "f(x). Key: A")})),
        structure("pins", trLater("pins"),
                  trLater("Settings of all parameters that were set aside, at most four."),
                  pinsToJson, readPins,
                  [](const Workspace& workspace) { return workspace.pins.empty(); }),
        structure("motion", trLater("motion"),
                  trLater("A recorded or written motion: key frames with their times."), motionJson,
                  readWorkspaceMotion,
                  [](const Workspace& workspace) { return workspace.motion.keys.empty(); }),
        comparedProperty(),
        [] {
            WorkspaceProperty study =
                groupOf(&Workspace::study, studyTable,
                        {.path = "study",
                         .label = trLater("overlays"),
                         .help = trLater("What is drawn over planes of starting points.")});
            study.omitted = [](const Workspace& workspace) {
                return workspace.study == Workspace::Study{};
            };
            return study;
        }(),
        unless(true, toggleOf(&Workspace::showRoots,
                              {.path = "show_roots",
                               .alias = "show roots",
                               .label = trLater("roots and poles in the views"),
                               .help = trLater("Zeros as circles with their powers, poles as "
                                               "crosses. Drag them. Key: V")})),
        unless(false, toggleOf(&Workspace::basins,
                               {.path = "basins",
                                .label = trLater("where capture or escape is certain"),
                                .help = trLater("Shades where orbits are surely captured, and "
                                                "where they surely escape. Key: B")})),
        [] {
            WorkspaceProperty circles =
                listOf(&Workspace::circles, circleTable,
                       {.path = "circles",
                        .label = trLater("circles"),
                        .help = trLater("Circles that were dropped on planes of starting points."),
                        .most = kMostCircles});
            circles.omitted = [](const Workspace& workspace) { return workspace.circles.empty(); };
            return circles;
        }(),
        structure("diagram", trLater("bifurcation diagram"),
                  trLater("The parameter of the bifurcation diagram and its range."), diagramToJson,
                  readDiagram,
                  [](const Workspace& workspace) {
                      // A formula that is typed may have taken the number away.
                      return !numberNamed(workspace.views[0], workspace.diagram.number);
                  }),
        unless("series", wordOfEnum(&Workspace::plot,
                                    {.path = "strip",
                                     .label = trLater("plot panel"),
                                     .help = trLater("What stands below the views: the orbit as a "
                                                     "time series or as a web, the bifurcation "
                                                     "diagram, the profile of the shape, or the "
                                                     "motion.")})),
        structure("ranges", trLater("ranges of sliders"),
                  trLater("The ranges of sliders that are not the program's own, by the number's "
                          "name."),
                  rangesToJson, readRanges,
                  [](const Workspace& workspace) { return workspace.ranges.empty(); }),
    };
    return table;
}

PropertyTable<Workspace> propertiesOf(const Workspace& workspace) {
    PropertyTable<Workspace> all;
    spread(workspace, workspaceTable(), all);
    return all;
}

std::optional<WorkspaceProperty> propertyNamed(const Workspace& workspace,
                                               const std::string& path) {
    for (WorkspaceProperty& property : propertiesOf(workspace))
        if (property.isCalled(path)) return std::move(property);
    return std::nullopt;
}

}  // namespace versorium
