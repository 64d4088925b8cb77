// SPDX-License-Identifier: MIT
#include "commands/open.h"

#include <algorithm>
#include <cstdio>

#include "io/known_formats.h"
#include "io/palette_files.h"

namespace versorium {
namespace {

bool looksLikeFile(const std::string& what) {
    if (what == "-" || hasEnding(what, {".json", ".png"})) return true;
    // Views of other programs, and what is refused by its name.
    if (hasEnding(what, {".xpf", ".par", ".kfr"}) || namesShapeFile(what) || namesPalette(what))
        return true;
    return what.find('/') != std::string::npos && !FormulaMap::make(what);
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
        if (looksLikeFormula(what)) {
            Expected<Scene> scene = sceneOfMap(what);
            if (!scene) return scene.status();
            return OpenedScene{std::move(*scene), {}};
        }
        return presetNamed(what).status();
    }
    Expected<Document> document = readDocument(what);
    if (!document) return document.status();
    switch (document->kind) {
        case DocumentKind::scene:
            break;
        case DocumentKind::plate:
            return Status::data(what + ": this is a plate; use \"versorium plate " + what + "\"");
        case DocumentKind::animation:
            return Status::data(what + ": this is an animation; use \"versorium animate " + what +
                                "\"");
    }
    Expected<Scene> scene = sceneWithAssets(document->body, document->assets);
    if (!scene) return scene.status().in(what);
    Expected<PictureOptions> options = pictureOptions(*document);
    if (!options) return options.status().in(what);
    if (!document->note.empty()) std::fprintf(stderr, "versorium: %s\n", document->note.c_str());
    return OpenedScene{std::move(*scene), *options};
}

}  // namespace

void addSceneOptions(CLI::App& command, SceneRequest& request) {
    command.add_option("SCENE", request.scene,
                       "preset, map, formula, scene file, PNG with a scene, or -");
    command.add_option("--map", request.map,
                       "a map of the catalogue, or a formula such as 'z^3 - a*z + c'; in place of "
                       "SCENE or of its map");
    command.add_option("--set", request.sets, "KEY=VALUE; may be given several times")
        ->take_all()
        ->allow_extra_args(false);
}

Expected<OpenedScene> openScene(const SceneRequest& request) {
    if (request.scene.empty() && request.map.empty())
        return Status::usage(
            "SCENE or --map is required: a preset, a map, a formula, a scene file, a PNG with a "
            "scene, or -");
    Expected<OpenedScene> opened = [&]() -> Expected<OpenedScene> {
        if (!request.scene.empty()) return open(request.scene);
        Expected<Scene> scene = sceneOfMap(request.map);
        if (!scene) return scene.status();
        return OpenedScene{std::move(*scene), {}};
    }();
    if (!opened) return opened.status();
    if (!request.scene.empty() && !request.map.empty())
        if (Status status = assign(opened->scene, {"map", request.map}); !status.ok())
            return status;
    for (const std::string& set : request.sets) {
        Expected<Assignment> assignment = parseAssignment(set);
        if (!assignment) return assignment.status();
        if (Status status = assign(opened->scene, *assignment); !status.ok()) return status;
    }
    return opened;
}

}  // namespace versorium
