// SPDX-License-Identifier: MIT
#include <algorithm>

#include "base/base64.h"
#include "io/document.h"
#include "io/stb_png.h"
#include "workspace/workspace.h"

namespace versorium {
namespace {

constexpr const char* kLinkVersion = "v1:";
// A link that a stranger sends must not keep the page busy: what is dearer than this waits for the
// user's own hand.
constexpr int kLinkIterations = 100000;

// Drops the members of an object that have their default.
Json differences(const Json& value, const Json& standard) {
    Json result = Json::object();
    for (const auto& [key, member] : value.items()) {
        if (key == "versorium" || key == "map" || key == "formula") {
            result[key] = member;
            continue;
        }
        const auto found = standard.find(key);
        if (found != standard.end() && *found == member) continue;
        if (found != standard.end() && found->is_object() && member.is_object()) {
            bool removed = false;
            for (const auto& [name, unused] : found->items())
                removed = removed || !member.contains(name);
            result[key] = removed ? member : differences(member, *found);
        } else {
            result[key] = member;
        }
    }
    return result;
}

Json shortScene(const Scene& scene) {
    const Json whole = sceneToJson(scene);
    Json brief = differences(whole, sceneToJson(sceneOf(mapOf(scene))));
    const Expected<Scene> again = sceneFromJson(brief);
    return again && sceneToJson(*again) == whole ? brief : whole;
}

void readCircles(const Json& circles, ObjectReader& owner, Workspace& workspace) {
    if (!circles.is_array() || circles.size() > kMostCircles)
        return owner.fail("circles", "must be a list of at most 8 circles");
    for (std::size_t k = 0; k < circles.size(); ++k) {
        ObjectReader reader(circles[k], "circles[" + std::to_string(k) + "]");
        std::vector<double> centre(4, 0.0);
        Workspace::Circle circle;
        reader.numbers("center", centre, 4, 4).number("radius", circle.radius, 1e-15, 1e6);
        owner.fail(reader.finish());
        if (centre.size() == 4) std::copy(centre.begin(), centre.end(), circle.centre.begin());
        workspace.circles.push_back(circle);
    }
}

Status checkWelded(const Workspace& workspace) {
    const auto shared = [](const Scene& scene) {
        Json json = sceneToJson(scene);
        json["parameters"].erase(kAsPrinted);
        return json;
    };
    const Json first = shared(workspace.views[0]);
    for (std::size_t k = 1; k < workspace.views.size(); ++k) {
        const Json other = shared(workspace.views[k]);
        for (const char* key : {"map", "formula", "parameters", "lists", "shape", "modulation"})
            // Views of an analysis have places of their own.
            if (!(workspace.analysis() && key == std::string("parameters")) &&
                first.value(key, Json()) != other.value(key, Json()))
                return Status::data("views[" + std::to_string(k) + "]." + key +
                                    ": differs from the first view's");
    }
    return {};
}

}  // namespace

Json workspaceToJson(const Workspace& workspace) {
    Json json;
    json["views"] = Json::array();
    for (const Scene& scene : workspace.views) json["views"].push_back(shortScene(scene));
    json["focused"] = workspace.focused;
    if (workspace.maximised) json["maximised"] = true;
    json["point"] = workspace.point;
    json["orbit_steps"] = workspace.orbitSteps;
    if (workspace.orbitAt > 0) json["orbit_at"] = workspace.orbitAt;
    if (workspace.arrows) json["arrows"] = true;
    if (!workspace.pins.empty()) {
        json["pins"] = Json::array();
        for (const Pin& pin : workspace.pins) {
            Json values = Json::object();
            for (const auto& [name, value] : pin) values[name] = value;
            json["pins"].push_back(values);
        }
    }
    if (!workspace.motion.keys.empty()) {
        motionToJson(workspace.motion, json["motion"]);
        json["motion"]["view"] = workspace.motionView;
    }
    if (!workspace.compared.empty()) json["compared"] = workspace.compared;
    if (const Workspace::Study& study = workspace.study; !(study == Workspace::Study{}))
        json["study"] = {{"cycles", study.cycles},
                         {"most_period", study.mostPeriod},
                         {"manifolds", study.manifolds},
                         {"critical_curve", study.criticalCurve}};
    if (!workspace.showRoots) json["show_roots"] = false;
    if (workspace.basins) json["basins"] = true;
    for (const Workspace::Circle& circle : workspace.circles)
        json["circles"].push_back({{"center", circle.centre}, {"radius", circle.radius}});
    // A formula that is typed may have taken the number away.
    if (numberNamed(workspace.views[0], workspace.diagram.number))
        json["diagram"] = {{"number", workspace.diagram.number},
                           {"range", {workspace.diagram.left, workspace.diagram.right}}};
    if (workspace.strip != Workspace::Strip::series)
        json["strip"] = kStripWords[static_cast<std::size_t>(workspace.strip)];
    for (const auto& [name, range] : workspace.ranges) json["ranges"][name] = {range[0], range[1]};
    return json;
}

Expected<Workspace> workspaceFromJson(const Json& json) {
    Workspace workspace;
    ObjectReader reader(json, "");
    const Json* views = reader.child("views");
    if (!views || !views->is_array() ||
        (views->size() != 1 && views->size() != 2 && views->size() != 4 &&
         views->size() != kAnalysisViews))
        return Status::data("views: must be a list of 1, 2, 4 or 5 scenes");
    for (std::size_t k = 0; k < views->size(); ++k) {
        Expected<Scene> scene = sceneFromJson((*views)[k]);
        if (!scene) return scene.status().in("views[" + std::to_string(k) + "]");
        workspace.views.push_back(std::move(*scene));
    }
    if (Status status = checkWelded(workspace); !status.ok()) return status;
    const MapKernels& map = mapOf(workspace.views[0]);
    const std::size_t dimension = static_cast<std::size_t>(map.dimension);
    workspace.point.assign(dimension, 0.0);
    reader.integer("focused", workspace.focused, 0, static_cast<int>(views->size()) - 1)
        .boolean("maximised", workspace.maximised)
        .numbers("point", workspace.point, dimension, dimension)
        .integer("orbit_steps", workspace.orbitSteps, 0, kMostOrbitSteps)
        .integer("orbit_at", workspace.orbitAt, 0, kMostOrbitSteps)
        .boolean("arrows", workspace.arrows);
    if (workspace.orbitAt > workspace.orbitSteps)
        reader.fail("orbit_at", "must be at most orbit_steps");
    if (const Json* pins = reader.child("pins")) {
        if (!pins->is_array() || pins->size() > kMostPins) {
            reader.fail("pins", "must be a list of at most 4 settings");
        } else {
            for (std::size_t k = 0; k < pins->size(); ++k) {
                Pin pin;
                ObjectReader values((*pins)[k], "pins[" + std::to_string(k) + "]");
                for (const ParameterInfo& parameter : map.info.parameters) {
                    const auto width = static_cast<std::size_t>(widthOf(parameter.kind));
                    std::vector<double> value(parameter.value.begin(),
                                              parameter.value.begin() + widthOf(parameter.kind));
                    const std::string name(parameter.name);
                    values.numbers(name.c_str(), value, width, width);
                    pin[name] = value;
                }
                if (Status status = values.finish(); !status.ok()) return status;
                workspace.pins.push_back(pin);
            }
        }
    }
    if (const Json* motion = reader.child("motion")) {
        ObjectReader one(*motion, "motion");
        one.integer("view", workspace.motionView, 0, static_cast<int>(views->size()) - 1);
        const Scene& moving = workspace.views[static_cast<std::size_t>(workspace.motionView)];
        if (Status status = readMotion(one, moving, workspace.motion); !status.ok()) return status;
        if (Status status = one.finish(); !status.ok()) return status;
    }
    if (reader.child("compared"))
        reader.numbers("compared", workspace.compared, dimension, dimension);
    if (const Json* study = reader.child("study")) {
        ObjectReader one(*study, "study");
        one.boolean("cycles", workspace.study.cycles)
            .integer("most_period", workspace.study.mostPeriod, 1, kMostShownPeriod)
            .boolean("manifolds", workspace.study.manifolds)
            .boolean("critical_curve", workspace.study.criticalCurve);
        if (Status status = one.finish(); !status.ok()) return status;
    }
    reader.boolean("show_roots", workspace.showRoots).boolean("basins", workspace.basins);
    std::string strip = kStripWords[0];
    reader.text("strip", strip);
    const auto word = std::find(kStripWords.begin(), kStripWords.end(), strip);
    if (word == kStripWords.end())
        reader.fail("strip", "must be one of series, web, diagram, profile and motion");
    else
        workspace.strip = static_cast<Workspace::Strip>(word - kStripWords.begin());
    if (const Json* circles = reader.child("circles")) readCircles(*circles, reader, workspace);
    if (const Json* diagram = reader.child("diagram")) {
        ObjectReader one(*diagram, "diagram");
        std::vector<double> range;
        one.text("number", workspace.diagram.number).numbers("range", range, 2, 2);
        const auto number = numberNamed(workspace.views[0], workspace.diagram.number);
        if (!number || number->kind != NumberKind::parameter)
            one.fail("number", "must be the name of a parameter of the map");
        if (range.size() != 2 || !(range[0] < range[1]))
            one.fail("range", "must be two numbers, the lower one first");
        else
            workspace.diagram.left = range[0], workspace.diagram.right = range[1];
        if (Status status = one.finish(); !status.ok()) return status;
    }
    if (const Json* ranges = reader.child("ranges")) {
        if (!ranges->is_object() || ranges->size() > kMostRanges) {
            reader.fail("ranges", "must be an object of at most 256 ranges");
        } else {
            ObjectReader values(*ranges, "ranges");
            for (const auto& [name, unused] : ranges->items()) {
                std::vector<double> range;
                values.numbers(name.c_str(), range, 2, 2);
                if (range.size() != 2 || !(range[0] < range[1]))
                    values.fail(name.c_str(), "must be two numbers, the lower one first");
                else
                    workspace.ranges[name] = {range[0], range[1]};
            }
            if (Status status = values.finish(); !status.ok()) return status;
        }
    }
    if (Status status = reader.finish(); !status.ok()) return status;
    return workspace;
}

Expected<std::string> workspaceToLink(const Workspace& workspace) {
    std::size_t assets = 0;
    for (const auto& [hash, asset] : workspace.views[0].assets) assets += asset->bytes.size();
    if (assets > kLinkAssetBytes)
        return Status::usage("this scene carries a file of " + std::to_string(assets) +
                             " bytes, too much for a link: save the scene and send its file");
    const std::string text = workspaceToJson(workspace).dump();
    if (text.size() > kLinkBytes)
        return Status::usage("this scene is too long for a link: save it and send its file");
    const auto* bytes = reinterpret_cast<const unsigned char*>(text.data());
    std::string code = base64Encode(stb::deflate({bytes, text.size()}));
    std::replace(code.begin(), code.end(), '+', '-');
    std::replace(code.begin(), code.end(), '/', '_');
    while (!code.empty() && code.back() == '=') code.pop_back();
    return kLinkVersion + code;
}

Expected<Workspace> workspaceFromLink(const std::string& fragment) {
    const std::string version = kLinkVersion;
    if (fragment.compare(0, version.size(), version) != 0)
        return Status::data("this is not a link of Versorium, or of a newer version");
    std::string code = fragment.substr(version.size());
    if (code.size() > 2 * kLinkBytes) return Status::data("the link is too long");
    std::replace(code.begin(), code.end(), '-', '+');
    std::replace(code.begin(), code.end(), '_', '/');
    code.append((4 - code.size() % 4) % 4, '=');
    Expected<std::vector<unsigned char>> packed = base64Decode(code, 2 * kLinkBytes);
    if (!packed) return packed.status().in("the link is damaged");
    std::vector<unsigned char> text(kLinkBytes);
    const int size = stb::inflate(*packed, text);
    if (size < 0) return Status::data("the link is damaged: it was cut off, or changed on its way");
    Expected<Json> json =
        parseJson({reinterpret_cast<const char*>(text.data()), static_cast<std::size_t>(size)});
    if (!json) return json.status().in("link");
    Expected<Workspace> workspace = workspaceFromJson(*json);
    if (!workspace) return workspace.status().in("link");
    for (Scene& scene : workspace->views)
        scene.iterations = std::min(scene.iterations, kLinkIterations);
    return workspace;
}

}  // namespace versorium
