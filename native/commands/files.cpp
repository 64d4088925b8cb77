// SPDX-License-Identifier: MIT
#include <cstdio>

#include "base/embedded.h"
#include "commands/commands.h"
#include "io/document.h"
#include "io/files.h"
#include "io/grid_files.h"
#include "io/known_formats.h"
#include "render/bind.h"
#include "shape/outline.h"

namespace versorium {
namespace {

struct ShapeRequest {
    std::string source, output;
    int resolution = 100;
    double padding = 4;
    double threshold = 0.5;
    bool invert = false, byAlpha = false, json = false;
};

// An analytic shape on the nodes of the box [-1/2, 1/2]³.
Grid sampled(const ShapeTree& shape, int resolution, Job& job) {
    Grid grid;
    grid.resolution = glm::ivec3(resolution);
    const auto n = static_cast<std::size_t>(resolution);
    grid.values.resize(n * n * n);
    job.parallelFor(n, [&](std::size_t layer) {
        const auto at = [&](int i) { return -0.5 + i / static_cast<double>(resolution - 1); };
        const int z = static_cast<int>(layer);
        for (int y = 0; y < resolution; ++y)
            for (int x = 0; x < resolution; ++x)
                grid.at(x, y, z) = distance(shape, at(x), at(y), at(z));
    });
    return grid;
}

Expected<Grid> gridOf(const ShapeRequest& request, Job& job) {
    ShapeSpec spec;
    spec.resolution = request.resolution;
    spec.padding = request.padding;
    spec.threshold = request.threshold;
    spec.invert = request.invert;
    spec.byAlpha = request.byAlpha;
    const std::span<const unsigned char> mesh = embedded("meshes/" + request.source + ".obj");
    if (!mesh.empty()) {
        Job own(job.threads());  // a built-in mesh gives no warnings
        own.onProgress = job.onProgress;
        return gridFromBytes(mesh, request.source + ".obj", spec, own);
    }
    const bool file = namesShapeFile(request.source);
    if (!file && isOutline(request.source)) {
        Expected<std::vector<glm::dvec2>> corners = parseOutline(request.source);
        if (!corners) return corners.status();
        return outlineDistance(*corners, request.resolution, job);
    }
    if (!file && request.source.find('(') != std::string::npos) {
        Expected<ShapeTree> shape = parseShape(request.source);
        if (!shape) return shape.status();
        return sampled(*shape, request.resolution, job);
    }
    Expected<Bytes> bytes = readFile(request.source);
    if (!bytes) return bytes.status();
    Expected<Grid> grid = gridFromBytes(*bytes, request.source, spec, job);
    return grid ? std::move(grid) : grid.status().in(request.source);
}

Status makeGrid(const ShapeRequest& request, int threads) {
    Job job(threads);
    const ProgressLine progress(job, "distances");
    Expected<Grid> grid = gridOf(request, job);
    if (!grid) return grid.status();
    const std::vector<unsigned char> bytes = writeGrid(*grid);
    if (Status status = writeFileAtomically(request.output, bytes); !status.ok()) return status;
    if (!request.json || request.output == "-") return {};
    const auto [low, high] = std::minmax_element(grid->values.begin(), grid->values.end());
    Json report{
        {"output", request.output},
        {"nodes", Json::array({grid->resolution.x, grid->resolution.y, grid->resolution.z})},
        {"least", *low},
        {"greatest", *high}};
    reportWarnings(job, report);
    return print(printJson(report));
}

Status printScene(const std::string& path) {
    Expected<Document> document = readDocument(path);
    if (!document) return document.status();
    if (!document->note.empty()) std::fprintf(stderr, "versorium: %s\n", document->note.c_str());
    return print(printJson(documentToJson(*document)));
}

}  // namespace

void addFileCommands(CommandLine& line) {
    CLI::App* shape = line.add(
        "shape", "Turn a mesh, a picture or an analytic shape into a grid of signed distances.",
        "  versorium shape dragon.ply -o dragon.f3d --resolution 150\n"
        "  versorium shape bunny -o bunny.f3d\n"
        "  versorium shape logo.png -o logo.grid --by-alpha\n"
        "  versorium shape \"smooth_union(0.05, sphere(0.3), box(0.1, 0.4, 0.1))\" -o s.f3d\n"
        "  versorium shape \"polygon(-0.4, -0.3, 0.4, -0.3, 0, 0.5)\" -o triangle.grid\n"
        "The grid's box is exactly [-1/2, 1/2]^3: a mesh is centred and scaled to fit it. Scenes\n"
        "take grids of up to 32 MiB, which is --resolution 161 in space.\n");
    const auto request = std::make_shared<ShapeRequest>();
    shape
        ->add_option("SHAPE", request->source,
                     "mesh (OBJ, PLY, STL), picture, built-in mesh, shape expression or outline")
        ->required();
    shape->add_option("-o,--output", request->output, ".f3d file, or - for standard output")
        ->required();
    shape->add_option("--resolution", request->resolution, "nodes along each axis")
        ->check(CLI::Range(8, 1024))
        ->capture_default_str();
    shape->add_option("--padding", request->padding, "free cells around a mesh")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    shape
        ->add_option("--threshold", request->threshold,
                     "of a picture: inside is what is darker than this share of white")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    shape->add_flag("--invert", request->invert, "of a picture: inside is what is light");
    shape->add_flag("--by-alpha", request->byAlpha,
                    "of a picture: inside is what is at least as opaque as the threshold");
    shape->add_flag("--json", request->json, "report as JSON");
    line.run(shape, [request, &line] { return makeGrid(*request, line.threads); });

    CLI::App* scene =
        line.add("scene", "Print the scene or plate that a picture or a file carries, as JSON.",
                 "  versorium scene picture.png > scene.json\n"
                 "  versorium scene plate.png | versorium plate - -o again.png\n");
    const auto path = std::make_shared<std::string>();
    scene->add_option("FILE", *path, "PNG or JSON file, or -")->required();
    line.run(scene, [path] { return printScene(*path); });
}

}  // namespace versorium
