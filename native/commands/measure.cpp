// SPDX-License-Identifier: MIT
#include <cmath>

#include "commands/commands.h"
#include "commands/open.h"
#include "commands/points.h"
#include "io/files.h"
#include "scene/numbers.h"

namespace versorium {
namespace {

struct EvalRequest {
    SceneRequest source;
    std::string points, output = "-";
    std::vector<std::string> fields;
    bool json = false;
};

Status evalPoints(const EvalRequest& request, int threads) {
    Expected<OpenedScene> opened = openScene(request.source);
    if (!opened) return opened.status();
    std::vector<FieldName> fields;
    for (const std::string& name : request.fields) {
        const FieldInfo* field = findField(name);
        if (!field) {
            std::string all;
            for (const FieldInfo& info : allFields())
                all += (all.empty() ? "" : ", ") + std::string(info.name);
            return Status::usage("--field " + name + ": the fields are " + all);
        }
        fields.push_back(field->field);
    }
    Expected<PointTable> table = readPoints(request.points, opened->scene);
    if (!table) return table.status();
    Job job(threads);
    const ProgressLine progress(job, "evaluating");
    CpuRenderer renderer;
    std::vector<std::vector<double>> rows;
    const Status status =
        table->start ? renderer.measureAt(table->scene, table->points, fields, {}, job, rows)
                     : renderer.measureAlong(table->scene, table->points, fields, {}, job, rows);
    if (!status.ok()) return status;
    std::string text;
    for (const std::string& name : table->names) text += (text.empty() ? "" : ",") + name;
    const int dimension = mapOf(opened->scene).dimension;
    for (FieldName field : fields)
        if (field == FieldName::versor)
            for (int k = 0; k < dimension; ++k) text += ",versor." + std::to_string(k);
        else
            text += "," + std::string(infoOf(field).name);
    text += "\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t k = 0; k < table->points[i].size(); ++k)
            text += (k > 0 ? "," : "") + formatNumber(table->points[i][k]);
        for (double value : rows[i]) text += "," + formatNumber(value);
        text += "\n";
    }
    if (Status written = writeFileAtomically(request.output, text); !written.ok()) return written;
    if (!request.json || request.output == "-") return {};
    return print(printJson(Json{{"output", request.output}, {"points", rows.size()}}));
}

struct OrbitRequest {
    SceneRequest source;
    std::vector<double> at;
    int steps = 20;
    bool csv = false, json = false;
};

Status printOrbit(const OrbitRequest& request) {
    Expected<OpenedScene> opened = openScene(request.source);
    if (!opened) return opened.status();
    Scene& scene = opened->scene;
    const MapKernels& map = mapOf(scene);
    if (request.at.size() > static_cast<std::size_t>(map.dimension))
        return Status::usage("--at: the map \"" + scene.map + "\" has points of " +
                             std::to_string(map.dimension) + " numbers");
    for (std::size_t k = 0; k < request.at.size(); ++k) {
        if (!std::isfinite(request.at[k])) return Status::usage("--at: a number is not finite");
        scene.start[k] = request.at[k];
    }
    Job job(1);
    sayWarnings(job);
    CpuRenderer renderer;
    Expected<OrbitProgram> program = renderer.binder().bind(scene, job);
    if (!program) return program.status();
    program->critical.reset();
    for (std::size_t k = 0; k < scene.start.size(); ++k) program->slice.origin[k] = scene.start[k];
    // Parameters on an axis of the slice take the values that the scene gives them.
    for (int k = 0; k < map.parameters; ++k)
        program->slice.origin[static_cast<std::size_t>(map.dimension + k)] =
            numberValue(scene, {NumberKind::parameter, k, {}, 0, 0, 0});
    for (auto& axis : program->slice.axes) std::fill(axis.begin(), axis.end(), 0.0);
    const double origin[3] = {};
    const auto orbit = orbitOf(*program, origin, request.steps);
    Json rows = Json::array();
    std::string csv = "n", table;
    for (int k = 0; k < map.dimension; ++k) csv += "," + stateComponent(map.info, k);
    csv += ",norm\n";
    for (std::size_t n = 0; n < orbit.size(); ++n) {
        double square = 0;
        Json point = Json::array();
        csv += std::to_string(n);
        for (double part : orbit[n]) {
            square += part * part;
            point.push_back(part);
            csv += "," + formatNumber(part);
        }
        csv += "," + formatNumber(std::sqrt(square)) + "\n";
        rows.push_back(Json{{"n", n}, {"point", point}, {"norm", std::sqrt(square)}});
    }
    const bool escaped = static_cast<int>(orbit.size()) <= request.steps;
    if (request.json)
        return print(printJson(Json{{"map", scene.map}, {"escaped", escaped}, {"orbit", rows}}));
    if (!request.csv)
        for (char& c : csv)
            if (c == ',') c = '\t';
    return print(csv);
}

}  // namespace

void addMeasureCommands(CommandLine& line) {
    CLI::App* eval = line.add(
        "eval", "Measure fields at given points, in double precision.",
        "  versorium eval mandelbrot --points points.csv --field smooth_escape -o out.csv\n"
        "  versorium eval shape-modulus --set shape=grid.f3d --set roots=poly.p4d \\\n"
        "      --set alpha=6 --field log_modulus --points points.csv -o out.csv\n"
        "Points are a table with a head line. Columns x,y are coordinates along the axes of the\n"
        "scene's slice: c of the Mandelbrot set. Columns may be named as numbers of the scene:\n"
        "z.re,z.im are starting points, c.re,c.im parameters. Of maps with three or four\n"
        "dimensions x,y,z[,w] are the starting point. Other columns are passed over.\n");
    const auto request = std::make_shared<EvalRequest>();
    addSceneOptions(*eval, request->source);
    eval->add_option("--points", request->points, "CSV file, or - for standard input")->required();
    eval->add_option("-o,--output", request->output, "CSV file, or - for standard output")
        ->capture_default_str();
    eval->add_option("--field", request->fields, "name of a field; may be given several times")
        ->required();
    eval->add_flag("--json", request->json, "report as JSON");
    line.run(eval, [request, &line] { return evalPoints(*request, line.threads); });

    CLI::App* orbit =
        line.add("orbit", "Print the orbit of a point, up to the first iterate that is outside.",
                 "  versorium orbit julia --at 0.12,0.28 -n 24\n"
                 "  versorium orbit logistic --at 0.5 --set r=3.83 -n 12 --csv\n"
                 "  versorium orbit \"x' = 1 - a*x^2 + y, y' = b*x; a = 1.4; b = 0.3\" --at 0,0\n"
                 "  versorium orbit henon --at 0,0 -n 100 --json\n");
    const auto own = std::make_shared<OrbitRequest>();
    addSceneOptions(*orbit, own->source);
    orbit->add_option("--at", own->at, "starting point x[,y[,z[,w]]]")->delimiter(',')->required();
    orbit->add_option("-n,--steps", own->steps, "number of steps")
        ->check(CLI::Range(0, kMostIterations))
        ->capture_default_str();
    orbit->add_flag("--csv", own->csv, "comma-separated");
    orbit->add_flag("--json", own->json, "as JSON");
    line.run(orbit, [own] { return printOrbit(*own); });
}

}  // namespace versorium
