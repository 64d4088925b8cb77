// SPDX-License-Identifier: MIT
// What the analysis of shape-modulus sets takes: roots drawn at random, a sheet of candidates, and
// the mean of the distance field over circles.
#include "commands/commands.h"
#include "commands/open.h"
#include "fields/ensemble.h"
#include "io/files.h"
#include "io/known_formats.h"
#include "io/root_files.h"
#include "plate/plate_picture.h"
#include "render/shape_profile.h"
#include "shape/bounds.h"

namespace versorium {
namespace {

struct RootsRequest {
    SceneRequest source;
    std::vector<double> count{10}, power{1, 3}, half, centre;
    std::string powers = "whole", arrangement = "even", region = "box", output, sheet;
    std::uint64_t seed = 1;
    int clusters = 3, candidates = 4;
    double clusterRadius = 0.15;
};

// Options as the scene's ensemble states them, so that both have the same words and checks.
Json ensembleRoots(const RootsRequest& request, const std::string& list) {
    const auto whole = [](double value) { return static_cast<std::int64_t>(value); };
    const double least = request.count.front(), most = request.count.back();
    return Json{{"list", list},
                {"count", Json::array({whole(least), whole(most)})},
                {"region", request.region},
                {"half", request.half},
                {"center", request.centre},
                {"power", Json::array({request.power.front(), request.power.back()})},
                {"powers", request.powers},
                {"arrangement", request.arrangement},
                {"clusters", request.clusters},
                {"cluster_radius", request.clusterRadius}};
}

// A plate of the scene with each candidate, in panels of one size.
Status writeSheet(const RootsRequest& request, const Scene& scene, const std::string& list,
                  const std::vector<RootList>& candidates, int threads) {
    PlateDocument document;
    document.plate.title = "Candidates for the versor d";
    document.plate.caption =
        "\\bold{" + std::to_string(candidates.size()) +
        " sets} of roots drawn at random for the same shape and α, β. The title of each panel is "
        "the seed that gives its roots: versorium roots --seed.";
    document.plate.columns = candidates.size() <= 4 ? 2 : 3;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        Scene own = scene;
        own.lists[list] = candidates[i];
        PlatePanel panel;
        panel.name = static_cast<char>('a' + i);
        panel.title = "seed " + std::to_string(request.seed + i);
        panel.keys = i == 0;
        panel.scene = std::move(own);
        document.plate.panels.push_back(std::move(panel));
    }
    Job job(threads);
    const ProgressLine progress(job, "candidates");
    CpuRenderer renderer;
    Expected<PlateFile> file = renderPlate(renderer, document, job);
    if (!file) return file.status();
    return writeFileAtomically(request.sheet, file->png);
}

Status makeRoots(RootsRequest request, int threads) {
    if (request.source.scene.empty() && request.source.map.empty())
        request.source.scene = "shape-modulus";
    if (request.output.empty() && request.sheet.empty()) request.output = "-";
    Expected<OpenedScene> opened = openScene(request.source);
    if (!opened) return opened.status();
    Scene& scene = opened->scene;
    if (scene.lists.empty())
        return Status::usage("the map \"" + scene.map + "\" has no list of roots");
    const std::string list(mapOf(scene).info.lists[0]);
    Json json = sceneToJson(scene);
    json["ensemble"] = Json{{"roots", ensembleRoots(request, list)}};
    Expected<Scene> with = sceneFromJson(json);
    if (!with) return Status::usage(with.status().message());
    Job job(threads);
    sayWarnings(job);
    Binder binder;
    Expected<OrbitProgram> program = binder.bind(*with, job);
    if (!program) return program.status();
    const RandomRoots& options = program->ensemble->roots;
    if (!request.output.empty()) {
        const RootList roots = randomRoots(options, request.seed);
        const Status status = hasEnding(request.output, {".p4d"})
                                  ? writeFileAtomically(request.output, writeRootsBinary(roots))
                                  : writeFileAtomically(request.output, writeRootsJson(roots));
        if (!status.ok()) return status;
    }
    if (request.sheet.empty()) return {};
    std::vector<RootList> candidates;
    for (int i = 0; i < request.candidates; ++i)
        candidates.push_back(randomRoots(options, request.seed + static_cast<std::uint64_t>(i)));
    return writeSheet(request, scene, list, candidates, threads);
}

struct ProfileRequest {
    SceneRequest source;
    double to = 0;
    int radii = 257;
    std::string output = "-";
    bool json = false;
};

Status writeProfile(const ProfileRequest& request, int threads) {
    Expected<OpenedScene> opened = openScene(request.source);
    if (!opened) return opened.status();
    Job job(threads);
    sayWarnings(job);
    Binder binder;
    Expected<RadialProfile> profile =
        shapeProfile(binder, opened->scene, request.to, request.radii, job);
    if (!profile) return profile.status();
    if (!request.json) return writeFileAtomically(request.output, profileCsv(*profile));
    return writeFileAtomically(request.output, printJson(Json{{"capture", profile->capture},
                                                              {"escape", profile->escape},
                                                              {"radius", profile->radius},
                                                              {"mean_phi", profile->mean},
                                                              {"low", profile->low},
                                                              {"high", profile->high},
                                                              {"modulus", profile->modulus}}));
}

}  // namespace

void addShapeCommands(CommandLine& line) {
    CLI::App* roots =
        line.add("roots", "Draw the roots of a versor at random, or a sheet of candidates.",
                 "  versorium roots --count 12 --seed 3 --power 1,4 -o roots.json\n"
                 "  versorium roots shape-modulus --arrangement clustered --sheet sheet.png\n"
                 "  versorium render shape-modulus --set roots=roots.json -o s.png\n"
                 "The region is the box of the scene's shape, unless --half gives another.\n");
    const auto request = std::make_shared<RootsRequest>();
    addSceneOptions(*roots, request->source);
    roots->add_option("--count", request->count, "number of roots, or LEAST,MOST")
        ->delimiter(',')
        ->expected(1, 2)
        ->check(CLI::Range(1, kMostRandomRoots));
    roots->add_option("--seed", request->seed, "of the random numbers")->capture_default_str();
    roots->add_option("--power", request->power, "LEAST,MOST power")
        ->delimiter(',')
        ->expected(1, 2);
    roots->add_option("--powers", request->powers, "whole or real")
        ->check(CLI::IsMember({"whole", "real"}));
    roots->add_option("--arrangement", request->arrangement, "even, clustered or spread")
        ->check(CLI::IsMember({"even", "clustered", "spread"}));
    roots->add_option("--clusters", request->clusters, "number of clusters")
        ->check(CLI::Range(1, kMostRandomRoots));
    roots->add_option("--cluster-radius", request->clusterRadius, "in half extents of the region");
    roots->add_option("--region", request->region, "box, or ball: the ellipsoid within it")
        ->check(CLI::IsMember({"box", "ball"}));
    roots->add_option("--half", request->half, "half extents of the region")->delimiter(',');
    roots->add_option("--center", request->centre, "centre of the region")->delimiter(',');
    roots->add_option("-o,--output", request->output, "JSON or .p4d file, or -");
    roots->add_option("--sheet", request->sheet, "PNG plate of candidates, seed by seed");
    roots->add_option("--candidates", request->candidates, "how many of them")
        ->check(CLI::Range(1, 24))
        ->capture_default_str();
    line.run(roots, [request, &line] { return makeRoots(*request, line.threads); });

    CLI::App* profile = line.add(
        "profile", "Mean of a shape's distance field over circles or spheres, against the radius.",
        "  versorium profile shape-modulus -o profile.csv\n"
        "  versorium profile --map shape-modulus-quadratic --set shape='disc(0.6)' --to 2 --json\n"
        "low and high bound the field on the whole circle; capture and escape (JSON) are the\n"
        "radii below and above which the modulus alone decides.\n");
    const auto own = std::make_shared<ProfileRequest>();
    addSceneOptions(*profile, own->source);
    profile->add_option("--to", own->to, "largest radius; else past the shape")
        ->check(CLI::Range(1e-9, 1e6));
    profile->add_option("--radii", own->radii, "how many, from 0")
        ->check(CLI::Range(2, kMostRadii))
        ->capture_default_str();
    profile->add_option("-o,--output", own->output, "CSV or JSON file, or -")
        ->capture_default_str();
    profile->add_flag("--json", own->json, "as JSON");
    line.run(profile, [own, &line] { return writeProfile(*own, line.threads); });
}

}  // namespace versorium
