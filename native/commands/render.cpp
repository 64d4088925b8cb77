// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>

#include "base/hash.h"
#include "commands/commands.h"
#include "commands/open.h"
#include "io/files.h"
#include "io/known_formats.h"
#include "io/npy.h"
#include "plate/plate_picture.h"

namespace versorium {
namespace {

// Of fields between the picture and their files; what takes more is measured twice.
constexpr std::size_t kMostKeptBytes = std::size_t{1} << 30;

struct RenderRequest {
    SceneRequest source;
    std::string output, size, flavour, averaged;
    std::vector<std::string> fields;
    int samples = 0;
    bool json = false;
};

struct FieldFile {
    const FieldInfo* field;
    std::string path;
};

Expected<std::vector<FieldFile>> fieldFiles(const std::vector<std::string>& texts) {
    std::vector<FieldFile> files;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        const FieldInfo* field =
            equals == std::string::npos ? nullptr : findField(text.substr(0, equals));
        if (!field || equals + 1 == text.size()) {
            std::string all;
            for (const FieldInfo& info : allFields())
                all += (all.empty() ? "" : ", ") + std::string(info.name);
            return Status::usage("--save-field " + text +
                                 ": NAME=FILE.npy is expected, NAME being one of " + all);
        }
        files.push_back({field, text.substr(equals + 1)});
    }
    return files;
}

Status saveFields(CpuRenderer& renderer, const Scene& scene, const PictureOptions& options,
                  const std::vector<FieldFile>& files, Job& job, Json& report) {
    std::vector<FieldName> names;
    for (const FieldFile& file : files) names.push_back(file.field->field);
    std::vector<Raster<double>> rasters;
    const RenderOptions render{options.flavour, options.shortcuts, 1};
    if (Status status =
            renderer.measure(scene, pictureSize(scene, options), names, render, job, rasters);
        !status.ok())
        return status;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::vector<unsigned char> bytes = writeNpy(rasters[i]);
        if (Status status = writeFileAtomically(files[i].path, bytes); !status.ok()) return status;
        report["fields"][std::string(files[i].field->name)] =
            Json{{"file", files[i].path}, {"sha256", sha256(bytes)}};
    }
    return {};
}

// Goes on with the counts in the file, if there is one, up to the scene's number of members; the
// file is written anew after each portion, so that little is lost where it is stopped.
Status countToFile(const std::string& path, const Scene& scene, const PictureOptions& options,
                   CpuRenderer& renderer, Job& job) {
    constexpr std::uint64_t kPortions = 20;
    Expected<AveragedMap> map = AveragedMap::make(scene, pictureSize(scene, options));
    if (!map) return map.status();
    if (std::filesystem::exists(path)) {
        Expected<Bytes> bytes = readFile(path);
        if (!bytes) return bytes.status();
        if (Status status = map->restore(*bytes); !status.ok()) return status.in(path);
    }
    const auto count = static_cast<std::uint64_t>(scene.ensemble.count);
    const std::uint64_t from = map->members();
    if (from > count)
        return Status::usage(path + ": " + std::to_string(from) +
                             " members are counted already; give --set ensemble.count=" +
                             std::to_string(from) + " or another file");
    const std::uint64_t portion = std::max<std::uint64_t>(16, count / kPortions);
    while (map->members() < count) {
        const std::uint64_t next = std::min(portion, count - map->members());
        const double span = static_cast<double>(count - from);
        job.setPart(static_cast<double>(map->members() - from) / span,
                    static_cast<double>(map->members() + next - from) / span);
        if (Status status =
                map->add(renderer.binder(), next, {options.flavour, options.shortcuts, 1}, job);
            !status.ok())
            return status;
        if (Status status = writeFileAtomically(path, map->save()); !status.ok()) return status;
    }
    renderer.useAveraged(std::make_shared<const AveragedMap>(std::move(*map)));
    return {};
}

Status renderScene(const RenderRequest& request, int threads) {
    Expected<OpenedScene> opened = openScene(request.source);
    if (!opened) return opened.status();
    auto& [scene, options] = *opened;
    if (!request.size.empty()) {
        Expected<Size> size = parseSize(request.size);
        if (!size) return size.status();
        options.size = *size;
    }
    if (!request.flavour.empty()) {
        Expected<Flavour> flavour = parseFlavour(request.flavour);
        if (!flavour) return flavour.status();
        options.flavour = *flavour;
    }
    if (request.samples > 0) scene.samples = request.samples;
    Expected<std::vector<FieldFile>> files = fieldFiles(request.fields);
    if (!files) return files.status();

    Job job(threads);
    const ProgressLine progress(job, "rendering");
    CpuRenderer renderer;
    if (!request.averaged.empty())
        if (Status status = countToFile(request.averaged, scene, options, renderer, job);
            !status.ok())
            return status;
    // One sample in each pixel is its centre, where fields are saved: both are measured at once.
    if (scene.samples == 1 && !files->empty()) {
        renderer.keepFields(kMostKeptBytes);
        for (const FieldFile& file : *files) options.also.push_back(file.field->field);
    }
    Expected<std::vector<unsigned char>> png = renderPicture(renderer, scene, options, job);
    if (!png) return png.status();
    const Size size = pictureSize(scene, options);
    Json report{{"output", request.output},
                {"width", size.width},
                {"height", size.height},
                {"map", scene.map},
                {"formula", std::string(mapOf(scene).info.formula)},
                {"sha256", sha256(*png)}};
    if (!files->empty())
        if (Status status = saveFields(renderer, scene, options, *files, job, report); !status.ok())
            return status;
    if (Status status = writeFileAtomically(request.output, *png); !status.ok()) return status;
    if (!request.json) return {};
    reportWarnings(job, report);
    // A picture on standard output leaves no room for a report there.
    if (request.output == "-") return std::fputs(printJson(report).c_str(), stderr), Status{};
    return print(printJson(report));
}

struct PlateRequest {
    std::string plate, output, theme;
    std::vector<std::string> sets;
    double width = 0, dpi = 0;
    bool noTitle = false, noCaption = false, json = false;
};

Expected<PlateDocument> openPlate(const std::string& what) {
    const bool file =
        what == "-" || what.find('/') != std::string::npos || hasEnding(what, {".json", ".png"});
    if (!file) return plateNamed(what);
    Expected<Document> document = readDocument(what);
    if (!document) return document.status();
    Expected<PlateDocument> plate = plateFromDocument(*document);
    return plate ? std::move(plate) : plate.status().in(what);
}

std::string textPath(const std::string& output) {
    const std::size_t dot = output.rfind('.');
    const std::size_t slash = output.rfind('/');
    const bool ending = dot != std::string::npos && (slash == std::string::npos || dot > slash);
    return (ending ? output.substr(0, dot) : output) + ".txt";
}

Status makePlate(const PlateRequest& request, int threads) {
    Expected<PlateDocument> plate = openPlate(request.plate);
    if (!plate) return plate.status();
    for (const std::string& set : request.sets) {
        Expected<Assignment> assignment = parseAssignment(set);
        if (!assignment) return assignment.status();
        if (Status status = assign(*plate, *assignment); !status.ok()) return status;
    }
    PlateOptions& options = plate->options;
    if (request.width != 0) options.widthMillimetres = request.width;
    if (request.dpi != 0) options.dotsPerInch = request.dpi;
    if (!request.theme.empty()) options.theme = request.theme;
    if (request.noTitle) options.title = false;
    if (request.noCaption) options.caption = false;

    Job job(threads);
    const ProgressLine progress(job, "plate " + request.plate);
    CpuRenderer renderer;
    Expected<PlateFile> file = renderPlate(renderer, *plate, job);
    if (!file) return file.status();
    if (Status status = writeFileAtomically(request.output, file->png); !status.ok()) return status;
    if (request.output != "-")
        if (Status status = writeFileAtomically(textPath(request.output), file->text); !status.ok())
            return status;
    if (!request.json || request.output == "-") return {};
    Json report{{"output", request.output},
                {"text", textPath(request.output)},
                {"sha256", sha256(file->png)}};
    reportWarnings(job, report);
    return print(printJson(report));
}

}  // namespace

void addRenderCommands(CommandLine& line) {
    CLI::App* render =
        line.add("render", "Render a scene to a PNG that carries it.",
                 "  versorium render mandelbrot -o m.png --size 1200x900 --samples 3\n"
                 "  versorium render julia -o j.png --set c=-0.8,0.156 --set palette=fire\n"
                 "  versorium render --map 'z^3 - a*z + c' -o f.png --set a=0.8,0.2\n"
                 "  versorium render henon -o h.png --save-field escape_step=n.npy --json\n"
                 "  versorium render m.png -o again.png\n");
    const auto request = std::make_shared<RenderRequest>();
    addSceneOptions(*render, request->source);
    render->add_option("-o,--output", request->output, "PNG file, or - for standard output")
        ->required();
    render->add_option("--size", request->size, "WIDTHxHEIGHT in pixels");
    render->add_option("--samples", request->samples, "samples along each side of a pixel")
        ->check(CLI::Range(1, kMostSamples));
    render->add_option("--save-field", request->fields, "NAME=FILE.npy: a field as numbers");
    render->add_option("--flavour", request->flavour,
                       "exact: the same bits everywhere; fast: for a first look");
    render->add_option("--averaged", request->averaged,
                       "file that keeps the counts of the scene's ensemble: a later run with more "
                       "members (--set ensemble.count=N) goes on from it");
    render->add_flag("--json", request->json, "report as JSON");
    line.run(render, [request, &line] { return renderScene(*request, line.threads); });

    CLI::App* plate =
        line.add("plate", "Make a figure plate: panels, axes, colour bars and a caption.",
                 "  versorium plate quadratic -o quadratic.png\n"
                 "  versorium plate shape-modulus-2 -o s2.png --width 89 --dpi 600 --set alpha=20\n"
                 "  versorium plate shape-modulus-6 -o s6.png --theme slide --set b.beta=0.05\n"
                 "  versorium plate my-plate.json -o - --no-caption > plate.png\n");
    const auto own = std::make_shared<PlateRequest>();
    plate->add_option("PLATE", own->plate, "name, plate file, PNG with a plate, or -")->required();
    plate->add_option("-o,--output", own->output, "PNG file, or - for standard output")->required();
    plate->add_option("--width", own->width, "width in millimetres (89 and 178 are usual)")
        ->check(CLI::Range(60.0, 2000.0));
    plate->add_option("--dpi", own->dpi, "pixels per inch")->check(CLI::Range(50.0, 2400.0));
    plate->add_option("--theme", own->theme, "paper or slide")
        ->check(CLI::IsMember({"paper", "slide"}));
    plate->add_option("--set", own->sets,
                      "KEY=VALUE in every panel that has the key, PANEL.KEY=VALUE in one");
    plate->add_flag("--no-title", own->noTitle, "leave the title out");
    plate->add_flag("--no-caption", own->noCaption, "leave caption and note out");
    plate->add_flag("--json", own->json, "report as JSON");
    line.run(plate, [own, &line] { return makePlate(*own, line.threads); });
}

}  // namespace versorium
