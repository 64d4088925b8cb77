// SPDX-License-Identifier: MIT
#include <algorithm>

#include "base/base64.h"
#include "io/document.h"
#include "io/stb_png.h"
#include "scene/parts.h"
#include "workspace/workspace_properties.h"

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

Status checkWelded(const Workspace& workspace) {
    const auto shared = [](const Scene& scene) {
        Json json = sceneBody(scene);
        for (const ParameterInfo& parameter : mapOf(scene).info.parameters)
            if (parameter.ofView) json["parameters"].erase(std::string(parameter.name));
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

// With the views as `sceneJson` writes them.
Json toJson(const Workspace& workspace, Json (*sceneJson)(const Scene&)) {
    Json json;
    json["views"] = Json::array();
    for (const Scene& scene : workspace.views) json["views"].push_back(sceneJson(scene));
    writeProperties(workspace, workspaceTable(), json);
    return json;
}

}  // namespace

Json workspaceToJson(const Workspace& workspace) { return toJson(workspace, shortScene); }
Json workspaceKey(const Workspace& workspace) { return toJson(workspace, sceneKey); }

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
    workspace.point.assign(static_cast<std::size_t>(mapOf(workspace.views[0]).dimension), 0.0);
    readProperties(reader, workspace, workspaceTable());
    if (workspace.orbitAt > workspace.orbitSteps)
        reader.fail("orbit_at", "must be at most orbit_steps");
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
