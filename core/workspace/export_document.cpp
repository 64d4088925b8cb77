// SPDX-License-Identifier: MIT
#include "workspace/export_document.h"

#include <algorithm>
#include <cmath>

#include "plate/markup.h"
#include "plate/plate.h"
#include "plate/plate_picture.h"
#include "plate/scene_panels.h"
#include "render/movie.h"

namespace versorium {
namespace {

Scene sceneOfView(const Workspace& workspace, std::size_t view,
                  const std::vector<double>& aspects) {
    Scene scene = workspace.views[view];
    scene.aspect = aspects[view];
    scene.slice.height = shownHeight(scene, scene.aspect);
    return scene;
}

// The map stands once, at the beginning; then what each panel shows.
std::string captionOf(const std::vector<Scene>& scenes, const Words& words) {
    const MapInfo& info = mapOf(scenes[0]).info;
    const std::string title = words.tr(info.title), formula = words.tr(info.formula);
    std::string text = "\\bold{" + escapeMarkup(title) + "}, " + escapeMarkup(formula);
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        std::string sentence = sceneSentence(scenes[k], words);
        const std::string known = title + ", " + formula;
        if (sentence.starts_with(known)) sentence = sentence.substr(known.size() + 2);
        if (scenes.size() > 1)
            text += std::string(k == 0 ? ". (" : " (") + static_cast<char>('a' + k) + ") ";
        else
            text += ": ";
        text += escapeMarkup(sentence);
    }
    return text;
}

PlateOptions plateOptions(const ExportOptions& options) {
    PlateOptions plate;
    plate.widthMillimetres = options.millimetres;
    plate.dotsPerInch = options.dotsPerInch;
    plate.theme = options.theme;
    plate.title = options.title;
    plate.caption = options.caption;
    return plate;
}

Expected<Document> builtInPlate(const ExportOptions& options) {
    Expected<PlateDocument> plate = plateNamed(options.builtIn);
    if (!plate) return plate.status();
    plate->options = plateOptions(options);
    return documentOfPlate(*plate);
}

}  // namespace

PlateDocument plateOfViews(const Workspace& workspace, const std::vector<double>& aspects, bool all,
                           const std::string& language) {
    const Words words(language);
    PlateDocument document;
    Plate& plate = document.plate;
    plate.language = language;
    std::vector<Scene> scenes;
    for (std::size_t k = 0; k < workspace.views.size(); ++k) {
        if (!all && static_cast<int>(k) != workspace.focused) continue;
        scenes.push_back(sceneOfView(workspace, k, aspects));
        PlatePanel panel;
        panel.name = static_cast<char>('a' + plate.panels.size());
        panel.title = words.tr(traitsOf(scenes.back()).title);
        panel.scene = scenes.back();
        plate.panels.push_back(std::move(panel));
    }
    const MapInfo& info = mapOf(scenes[0]).info;
    plate.title = escapeMarkup(words.tr(info.title));
    plate.caption = captionOf(scenes, words);
    plate.note = "Versorium · " + escapeMarkup(words.tr(info.source)) + " · " +
                 words.tr("scene embedded in this file");
    return document;
}

Document motionDocument(const Workspace& workspace) {
    const auto view = static_cast<std::size_t>(workspace.motionView);
    Scene scene = workspace.views[view];
    // A dynamical view shows the points, not where one of them starts.
    scene.parameters = workspace.views[workspace.speaker()].parameters;
    return documentOfMovie({{std::move(scene), workspace.motion}, {}});
}

Expected<Document> exportDocument(const Workspace& workspace, const std::vector<double>& aspects,
                                  const ExportOptions& options) {
    if (options.motion) {
        if (workspace.motion.keys.empty())
            return Status::usage("there is no motion yet: press R to record one");
        const auto view = static_cast<std::size_t>(workspace.motionView);
        Document document = motionDocument(workspace);
        const Size size{options.width,
                        std::max(1, static_cast<int>(std::lround(options.width / aspects[view])))};
        if (Status status = checkSize(workspace.views[view], size); !status.ok()) return status;
        document.body["scene"]["aspect"] = std::clamp(aspects[view], 0.1, 10.0);
        document.render =
            Json{{"width", size.width}, {"height", size.height}, {"flavour", "exact"}};
        return document;
    }
    if (options.plate) {
        const double pixels = options.millimetres / 25.4 * options.dotsPerInch;
        // A plate is seldom higher than wide; the layout itself checks the exact size.
        if (pixels * pixels > 2 * kPlatePixelLimit)
            return Status::usage("a plate of " + std::to_string(std::lround(pixels)) +
                                 " pixels in width is too large: take fewer pixels per inch");
        if (!options.builtIn.empty()) return builtInPlate(options);
        PlateDocument plate = plateOfViews(workspace, aspects, options.allViews, options.language);
        plate.options = plateOptions(options);
        return documentOfPlate(plate);
    }
    const auto view = static_cast<std::size_t>(workspace.focused);
    const Scene scene = sceneOfView(workspace, view, aspects);
    const Size size{options.width,
                    std::max(1, static_cast<int>(std::lround(options.width / aspects[view])))};
    if (Status status = checkSize(scene, size); !status.ok()) return status;
    Document document;
    document.body = sceneBody(scene);
    addAssets(scene, document.assets);
    document.render = Json{{"width", size.width}, {"height", size.height}, {"flavour", "exact"}};
    return document;
}

}  // namespace versorium
