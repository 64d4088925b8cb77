// SPDX-License-Identifier: MIT
#include "ui/session/open_file.h"

#include <algorithm>
#include <cctype>

#include "io/document.h"
#include "io/foreign_views.h"
#include "io/grid_files.h"
#include "io/image_files.h"
#include "io/known_formats.h"
#include "io/mesh_files.h"
#include "io/palette_files.h"
#include "io/root_files.h"
#include "io/shape_file_kind.h"
#include "plate/plate_picture.h"
#include "render/movie.h"
#include "shape/mesh_report.h"

namespace versorium {
namespace {

std::string fileName(const std::string& path) {
    const std::size_t slash = path.find_last_of("/\\");
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

// A motion of one view.
Status takeMotion(StudioContext& context, const std::string& name, const Document& document) {
    Expected<Movie> movie = movieFromDocument(document);
    if (!movie) return movie.status();
    context.openMotion(std::move(movie->animation));
    context.say(tr("Opened {1}: press Shift R to play it", {name}));
    return {};
}

Status openDocument(StudioContext& context, const std::string& name, const Document& document) {
    if (document.kind == DocumentKind::animation) return takeMotion(context, name, document);
    if (document.kind == DocumentKind::plate) {
        const Expected<PlateDocument> plate = plateFromDocument(document);
        return plate ? openPlate(context, name, *plate) : plate.status();
    }
    Expected<Scene> scene = sceneWithAssets(document.body, document.assets);
    if (!scene) return scene.status();
    context.open(workspaceOf(*scene));
    context.say(tr("Opened {1}", {name}) +
                (document.note.empty() ? "" : ". " + trMessage(document.note)));
    return {};
}

Status takePalette(StudioContext& context, const std::string& name,
                   std::span<const unsigned char> bytes) {
    const Expected<PaletteFile> file = readPaletteFile(bytes, name);
    if (!file) return file.status();
    const Palette* palette = &file->palette;
    context.edit([&](Workspace& w) {
        Colouring& colour = w.view().colour;
        colour.palette = palette->name();
        colour.ownPalette = paletteToJson(*palette);
        if (colour.rule != ColourRule::phase && colour.rule != ColourRule::domain)
            colour.rule = ColourRule::palette;
    });
    context.say(tr("{1} is the palette of the focused view", {name}) +
                (file->note.empty() ? "" : ". " + trMessage(file->note)));
    return {};
}

Status takeRoots(StudioContext& context, const std::string& name, const RootList& roots) {
    const MapInfo& info = mapOf(context.workspace.view()).info;
    if (info.lists.empty())
        return Status::usage("these are roots, and " + std::string(info.title) + " has none");
    if (roots.roots.size() > kMostRoots)
        return Status::data("more than " + std::to_string(kMostRoots) + " roots are too many");
    const std::string list(info.lists[0]);
    context.edit([&](Workspace& w) {
        for (Scene& scene : w.views) scene.lists[list] = roots;
    });
    context.say(tr("{1}: {2} roots", {name, std::to_string(roots.roots.size())}));
    return {};
}

// Views of starting points look at where the mesh is.
void frame(Scene& scene, const Mesh& mesh) {
    SliceSpec& slice = scene.slice;
    if (!traitsOf(scene).shape || mesh.vertices.empty()) return;
    double most = 0;
    std::vector<double> centre(slice.axes.size(), 0.0);
    for (std::size_t k = 0; k < slice.axes.size(); ++k) {
        if (slice.axes[k].terms.size() != 1) return;
        const std::optional<NumberRef> number = numberNamed(scene, slice.axes[k].terms[0].first);
        if (!number || number->kind != NumberKind::state || number->index > 2) return;
        const auto part = static_cast<std::size_t>(number->index);
        double low = mesh.vertices[0][part], high = low;
        for (const auto& vertex : mesh.vertices) {
            low = std::min(low, vertex[part]);
            high = std::max(high, vertex[part]);
        }
        centre[k] = 0.5 * (low + high);
        most = std::max(most, high - low);
    }
    slice.centre = centre;
    std::fill(slice.centreLow.begin(), slice.centreLow.end(), 0.0);
    slice.height = std::clamp(1.6 * most, kLeastHeight, kMostHeight);
}

Status checkShape(const std::string& name, std::span<const unsigned char> bytes) {
    const ShapeFileKind kind = shapeFileKindOf(bytes, name);
    if (kind == ShapeFileKind::mesh) return readMesh(bytes, name).status();
    if (kind == ShapeFileKind::grid) return readGrid(bytes).status();
    return readImage(bytes).status();
}

// What is doubtful about a mesh, as sentences to follow another.
std::string doubtsAbout(const Mesh& mesh) {
    const MeshReport report = reportOf(mesh);
    std::string text;
    const auto add = [&](std::size_t count, const char* sentence) {
        if (count > 0) text += ". " + tr(sentence, {std::to_string(count)});
    };
    add(report.openSides, trLater("It is open: {1} sides have no partner"));
    add(report.turnedSides, trLater("Some faces are turned: {1} sides run one way only"));
    add(report.doubledTriangles, trLater("{1} triangles stand twice"));
    add(report.emptyTriangles, trLater("{1} triangles have no area"));
    add(report.turned ? 1 : 0, trLater("It had its inside out and was turned"));
    return text;
}

Status takeShape(StudioContext& context, const std::string& name,
                 std::span<const unsigned char> bytes) {
    if (bytes.size() > kMostAssetBytes)
        return Status::usage("a scene carries no more than " +
                             std::to_string(kMostAssetBytes >> 20) + " MiB");
    if (Status status = checkShape(name, bytes); !status.ok()) return status;
    const std::string before(mapOf(context.workspace.view()).info.title);
    const bool fits = mapOf(context.workspace.view()).info.field;
    Workspace next = context.workspace;
    if (!fits) {
        Expected<Scene> scene = presetNamed("shape-modulus");
        if (!scene) return scene.status();
        next = workspaceOf(*scene);
    }
    for (Scene& scene : next.views) scene.shape = {};
    dropUnnamedAssets(next);
    const std::string source = addSharedAsset(next, {name, {bytes.begin(), bytes.end()}});
    if (source.empty())
        return Status::usage("a scene carries no more than " +
                             std::to_string(kMostAssetBytes >> 20) + " MiB");
    std::string doubts;
    for (Scene& scene : next.views) scene.shape.source = source;
    if (shapeFileKindOf(bytes, name) == ShapeFileKind::mesh) {
        const Expected<Mesh> mesh = readMesh(bytes, name);
        for (Scene& scene : next.views) frame(scene, *mesh);
        doubts = doubtsAbout(*mesh);
    }
    context.open(std::move(next));
    const MapInfo& info = mapOf(context.workspace.view()).info;
    context.say((fits ? tr("{1} is the shape of this scene now", {name})
                      : tr("{1} is the shape of {2} now: {3} takes none",
                           {name, tr(info.title), tr(std::string_view(before))})) +
                doubts);
    return {};
}

// "leaf-" of "leaf-017.png"; empty where the name does not end in a number.
std::string stemOf(const std::string& name) {
    const std::size_t dot = std::min(name.rfind('.'), name.size());
    std::size_t first = dot;
    while (first > 0 && std::isdigit(static_cast<unsigned char>(name[first - 1]))) --first;
    return first < dot ? name.substr(0, first) : std::string();
}

// An image of a numbered sequence goes to the others of its name, any other becomes a layer.
Status takeLayer(StudioContext& context, const std::string& name,
                 std::span<const unsigned char> bytes) {
    const Expected<Raster<unsigned char>> image = readImage(bytes);
    if (!image) return image.status();
    Workspace next = context.workspace;
    Scene& scene = next.view();
    const std::string source = addSharedAsset(next, {name, {bytes.begin(), bytes.end()}});
    if (source.empty())
        return Status::usage("the images of a scene may have " +
                             std::to_string(kMostAssetBytes >> 20) + " MiB together");
    const std::string stem = stemOf(name);
    for (Layer& layer : scene.layers) {
        const std::string& last = layer.sources.back();
        if (!last.starts_with("asset:") || stem.empty()) continue;
        const auto asset = scene.assets.find(last.substr(6));
        if (asset == scene.assets.end() || stemOf(asset->second->name) != stem ||
            layer.sources.size() >= kMostFrames)
            continue;
        // In the order of their names, however they come in.
        const auto after =
            std::find_if(layer.sources.begin(), layer.sources.end(), [&](const std::string& other) {
                const std::string& known = scene.assets.at(other.substr(6))->name;
                return std::pair(known.size(), known) > std::pair(name.size(), name);
            });
        layer.sources.insert(after, source);
        const std::string count = std::to_string(layer.sources.size());
        context.edit([&](Workspace& w) { w = std::move(next); });
        context.say(tr("{1} is one of {2} frames", {name, count}));
        return {};
    }
    if (scene.layers.size() >= kMostLayers)
        return Status::usage("there are " + std::to_string(kMostLayers) + " images already");
    scene.layers.push_back({.sources = {source}});
    context.edit([&](Workspace& w) { w = std::move(next); });
    context.say(tr("{1} lies behind the fractal", {name}));
    return {};
}

std::span<const unsigned char> bytesOf(const std::string& text) {
    return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

Status openJson(StudioContext& context, const std::string& name, const std::string& text) {
    Expected<Json> json = parseJson(text);
    if (!json) return json.status();
    if (json->is_object() && json->contains("stops"))
        return takePalette(context, name, bytesOf(text));
    if (json->is_object() && json->contains("roots") && !json->contains("map")) {
        const Expected<RootList> roots = readRootsJson(text);
        return roots ? takeRoots(context, name, *roots) : roots.status();
    }
    Expected<Document> document = documentFromJson(*json);
    if (!document) return document.status();
    return openDocument(context, name, *document);
}

Status openAny(StudioContext& context, const std::string& name,
               std::span<const unsigned char> bytes) {
    const bool picture = looksLikePicture(bytes);
    if (context.imagesAreLayers && (picture || namesPicture(name)))
        return takeLayer(context, name, bytes);
    if (isPng(bytes)) {
        const Expected<Document> document = documentFromBytes(bytes);
        // A picture without a scene is an image like any other.
        if (document) return openDocument(context, name, *document);
        return takeShape(context, name, bytes);
    }
    if (picture || namesShapeFile(name)) return takeShape(context, name, bytes);
    if (hasEnding(name, {".p4d"})) {
        const Expected<RootList> roots = readRootsBinary(bytes);
        return roots ? takeRoots(context, name, *roots) : roots.status();
    }
    const std::string text(bytes.begin(), bytes.end());
    if (hasEnding(name, {".md"})) return openLessonFile(context, name, text);
    if (looksLikeForeignView(bytes)) {
        const Expected<Document> document = documentFromBytes(bytes);
        return document ? openDocument(context, name, *document) : document.status();
    }
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first != std::string::npos && text[first] != '{' && looksLikePalette(bytes))
        return takePalette(context, name, bytes);
    if (Status status = foreignFault(bytes); !status.ok()) return status;
    return openJson(context, name, text);
}

}  // namespace

Status openPlate(StudioContext& context, const std::string& name, const PlateDocument& plate) {
    const auto& panels = plate.plate.panels;
    const auto ofKind = [&](PanelKind kind) {
        return std::find_if(panels.begin(), panels.end(),
                            [&](const PlatePanel& panel) { return panel.kind == kind; });
    };
    auto first = ofKind(PanelKind::scene);
    if (first == panels.end()) first = ofKind(PanelKind::diagram);
    if (first == panels.end()) return Status::data("this plate has no scene, only plots");
    Workspace workspace = workspaceOf(first->scene);
    if (first->kind == PanelKind::diagram) {
        const DiagramPlot& plot = first->diagram;
        workspace.diagram = {plot.parameter, plot.from, plot.to};
        workspace.plot = PlotPanel::diagram;
    }
    context.open(std::move(workspace));
    context.say(tr("Opened panel {1} of the plate {2}", {first->name, name}));
    return {};
}

bool mayOpen(const std::string& name) {
    // A .txt may be anything, so it is not offered, though a list of colours opens from one.
    return namesShapeFile(name) || (namesPalette(name) && !hasEnding(name, {".txt"})) ||
           hasEnding(name, {".json", ".p4d", ".md", ".xpf", ".par", ".kfr"});
}

Status openBytes(StudioContext& context, const std::string& path,
                 std::span<const unsigned char> bytes) {
    const std::string name = fileName(path);
    if (isRestricted(context))
        return Status::usage("the link that opened this page lets no files in");
    return openAny(context, name, bytes).in(name);
}

Status openFile(StudioContext& context, const std::string& path) {
    Expected<std::vector<unsigned char>> bytes = context.host.readFile(path);
    if (!bytes) return bytes.status();
    return openBytes(context, path, *bytes);
}

Status openText(StudioContext& context, const std::string& given) {
    const auto blank = [](unsigned char c) { return std::isspace(c) != 0; };
    auto first = std::find_if_not(given.begin(), given.end(), blank);
    auto last = std::find_if_not(given.rbegin(), std::make_reverse_iterator(first), blank).base();
    const std::string text(first, last);
    if (text.empty()) return Status::usage("there is nothing on the clipboard to open");
    if (isRestricted(context))
        return Status::usage("the link that opened this page lets nothing else in");
    const std::size_t link = text.starts_with("v1:") ? 0 : text.find("#v1:");
    if (link != std::string::npos) {
        Expected<Workspace> workspace = workspaceFromLink(text.substr(link ? link + 1 : 0));
        if (!workspace) return workspace.status();
        context.open(std::move(*workspace));
        context.say("Opened the link");
        return {};
    }
    if (const std::size_t hash = text.find('#');
        hash != std::string::npos && isTeacherLink(text.substr(hash + 1))) {
        const Expected<TeacherLink> read = parseTeacherLink(text.substr(hash + 1));
        return read ? followTeacherLink(context, *read) : read.status();
    }
    if (text.starts_with("---\n")) return openLessonFile(context, "pasted.en.md", text);
    if (text[0] == '{') {
        const std::string where = tr("the clipboard");
        return openJson(context, where, text).in(where);
    }
    if (looksLikePalette(bytesOf(text)))
        return takePalette(context, tr("the clipboard"), bytesOf(text));
    if (text.starts_with("file://")) return openFile(context, text.substr(7));
    if (text[0] == '/' && text.find('\n') == std::string::npos) return openFile(context, text);
    if (looksLikeFormula(text) && FormulaMap::make(text)) {
        context.welcome = false;
        return applyFormula(context, text);
    }
    return Status::usage(
        "what is on the clipboard is no link, no scene, no palette and no formula");
}

void addBuiltInLayer(Scene& scene, bool leaf) {
    const Layer white{.sources = {"#ffffff"}};
    if (leaf)
        scene.layers.push_back({});
    else
        scene.layers.insert(scene.layers.begin(), white);
}

}  // namespace versorium
