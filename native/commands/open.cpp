// SPDX-License-Identifier: MIT
#include "commands/open.h"

#include <algorithm>

namespace versorium {
namespace {

bool looksLikeFile(const std::string& what) {
    return what == "-" || what.find('/') != std::string::npos || what.ends_with(".json") ||
           what.ends_with(".png");
}

Expected<OpenedScene> open(const std::string& what) {
    if (!looksLikeFile(what)) {
        const auto presets = presetNames();
        if (std::find(presets.begin(), presets.end(), what) != presets.end()) {
            Expected<Scene> scene = presetNamed(what);
            if (!scene) return scene.status();
            return OpenedScene{std::move(*scene), {}};
        }
        if (const MapKernels* map = findMap(what)) return OpenedScene{sceneOf(*map), {}};
        return presetNamed(what).status();
    }
    Expected<Document> document = readDocument(what);
    if (!document) return document.status();
    if (document->kind != "scene")
        return Status::data(what + ": this is a plate; use \"versorium plate " + what + "\"");
    Expected<Scene> scene = sceneWithAssets(document->body, document->assets);
    if (!scene) return scene.status().in(what);
    Expected<PictureOptions> options = pictureOptions(*document);
    if (!options) return options.status().in(what);
    return OpenedScene{std::move(*scene), *options};
}

}  // namespace

Expected<OpenedScene> openScene(const std::string& what, const std::vector<std::string>& sets) {
    Expected<OpenedScene> opened = open(what);
    if (!opened) return opened.status();
    for (const std::string& set : sets) {
        Expected<Assignment> assignment = parseAssignment(set);
        if (!assignment) return assignment.status();
        if (Status status = assign(opened->scene, *assignment); !status.ok()) return status;
    }
    return opened;
}

}  // namespace versorium
