// SPDX-License-Identifier: MIT
#include "plate/plate_picture.h"

#include <algorithm>

#include "base/embedded_json.h"
#include "io/png.h"
#include "plate/scene_panels.h"

namespace versorium {
namespace {

constexpr std::string_view kPlates = "plates/";

}  // namespace

std::vector<std::string> plateNames() { return embeddedJsonNames(kPlates); }

Expected<PlateDocument> plateFromDocument(const Document& document) {
    if (document.kind != DocumentKind::plate)
        return Status::data("a plate is expected, and this is a " +
                            std::string(wordOf(document.kind)));
    Expected<Plate> plate = plateFromJson(document.body, document.assets);
    if (!plate) return plate.status();
    PlateDocument result{std::move(*plate), {}};
    ObjectReader reader(document.render, "render");
    reader.number("width_mm", result.options.widthMillimetres, 60, 2000)
        .number("dpi", result.options.dotsPerInch, 50, 2400)
        .word("theme", result.options.theme, {"paper", "slide"})
        .boolean("title", result.options.title)
        .boolean("caption", result.options.caption);
    if (const Status status = reader.finish(); !status.ok()) return status;
    return result;
}

Expected<PlateDocument> plateNamed(const std::string& name) {
    const Json json = embeddedJson(kPlates, name);
    if (json.is_null())
        return Status::usage("no plate is named \"" + name +
                             "\"; there are: " + embeddedJsonList(kPlates));
    Expected<Document> document = documentFromJson(json);
    if (!document) return document.status().in("plate " + name);
    Expected<PlateDocument> plate = plateFromDocument(*document);
    return plate ? std::move(plate) : plate.status().in("plate " + name);
}

Document documentOfPlate(const PlateDocument& document) {
    Document carried;
    carried.kind = DocumentKind::plate;
    carried.body = plateToJson(document.plate);
    for (const PlatePanel& panel : document.plate.panels)
        if (panel.hasScene()) addAssets(panel.scene, carried.assets);
    carried.render = Json{{"width_mm", document.options.widthMillimetres},
                          {"dpi", document.options.dotsPerInch},
                          {"theme", document.options.theme},
                          {"title", document.options.title},
                          {"caption", document.options.caption}};
    return carried;
}

Status assign(PlateDocument& document, const Assignment& assignment) {
    const std::size_t dot = assignment.key.find('.');
    const std::string first = assignment.key.substr(0, dot);
    for (PlatePanel& panel : document.plate.panels)
        if (dot != std::string::npos && panel.name == first && panel.hasScene()) {
            const Assignment own{assignment.key.substr(dot + 1), assignment.value};
            if (!knowsKey(panel.scene, own.key))
                return Status::usage("--set " + assignment.key + ": the scene of panel " + first +
                                     " has no key \"" + own.key + "\"");
            return assign(panel.scene, own);
        }
    int reached = 0;
    for (PlatePanel& panel : document.plate.panels) {
        if (!panel.hasScene() || !knowsKey(panel.scene, assignment.key)) continue;
        if (Status status = assign(panel.scene, assignment); !status.ok()) return status;
        ++reached;
    }
    if (reached > 0) return {};
    std::string names;
    for (const PlatePanel& panel : document.plate.panels)
        names += (names.empty() ? "" : ", ") + panel.name;
    return Status::usage("--set " + assignment.key + ": no panel (" + names +
                         ") has such a key; \"versorium schema\" lists the keys of a scene");
}

Expected<PlateFile> renderPlate(CpuRenderer& renderer, const PlateDocument& document, Job& job) {
    const auto panels =
        std::count_if(document.plate.panels.begin(), document.plate.panels.end(),
                      [](const PlatePanel& panel) { return panel.kind == PanelKind::scene; });
    job.setPart(0, 0);  // until the first panel is drawn
    Expected<PlatePicture> picture =
        layoutPlate(document.plate, document.options,
                    scenePanels(renderer, Words(document.plate.language), job,
                                std::max(1, static_cast<int>(panels))));
    if (!picture) return picture.status();
    PngOptions png;
    png.dotsPerInch = picture->dotsPerInch;
    png.texts = {{"Software", "Versorium"},
                 {"Description", picture->alternativeText},
                 {kDocumentKeyword, printJson(documentToJson(documentOfPlate(document)))}};
    if (picture->alternativeText.empty()) png.texts.erase(png.texts.begin() + 1);
    Expected<std::vector<unsigned char>> bytes = encodePng(picture->pixels, png);
    if (!bytes) return bytes.status();
    return PlateFile{std::move(*bytes),
                     picture->captionText + "\n\n" + picture->alternativeText + "\n"};
}

}  // namespace versorium
