// SPDX-License-Identifier: MIT
#include <cmath>

#include "commands/commands.h"
#include "commands/open.h"
#include "io/files.h"
#include "io/text_scanner.h"
#include "scene/numbers.h"

namespace versorium {
namespace {

constexpr std::size_t kMostPoints = 20000000;

// Columns x, y, z, w of a table, in this order; other columns are passed over.
struct PointTable {
    int columns = 0;
    std::vector<std::vector<double>> points;
};

std::vector<std::string> splitLine(std::string_view line) {
    std::vector<std::string> cells;
    std::size_t start = 0;
    while (start <= line.size()) {
        const std::size_t comma = std::min(line.find(',', start), line.size());
        std::string cell(line.substr(start, comma - start));
        while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\r')) cell.pop_back();
        while (!cell.empty() && cell.front() == ' ') cell.erase(cell.begin());
        cells.push_back(cell);
        start = comma + 1;
    }
    return cells;
}

Expected<PointTable> readPoints(const std::string& path) {
    Expected<Bytes> bytes = readFile(path);
    if (!bytes) return bytes.status();
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    PointTable table;
    std::vector<std::size_t> places;
    std::size_t start = 0, number = 0, width = 0;
    while (start < text.size()) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const auto cells = splitLine(text.substr(start, end - start));
        start = end + 1;
        ++number;
        if (cells.size() == 1 && cells[0].empty()) continue;
        const std::string where = path + ", line " + std::to_string(number);
        if (places.empty()) {
            for (const char* name : {"x", "y", "z", "w"})
                for (std::size_t i = 0; i < cells.size(); ++i)
                    if (cells[i] == name) places.push_back(i);
            if (places.empty())
                return Status::data(where + ": a head line with columns x[,y[,z[,w]]] is expected");
            width = cells.size();
            continue;
        }
        if (cells.size() != width)
            return Status::data(where + ": " + std::to_string(cells.size()) + " columns, not " +
                                std::to_string(width));
        if (table.points.size() >= kMostPoints) return Status::data(where + ": too many points");
        table.points.emplace_back();
        for (std::size_t place : places) {
            const std::optional<double> value = parseDecimal(cells[place]);
            if (!value) return Status::data(where + ": \"" + cells[place] + "\" is not a number");
            table.points.back().push_back(*value);
        }
    }
    table.columns = static_cast<int>(places.size());
    return table;
}

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
    Expected<PointTable> table = readPoints(request.points);
    if (!table) return table.status();
    Job job(threads);
    const ProgressLine progress(job, "evaluating");
    CpuRenderer renderer;
    std::vector<std::vector<double>> rows;
    if (Status status = renderer.measureAt(opened->scene, table->points, fields, {}, job, rows);
        !status.ok())
        return status;
    std::string text;
    for (int k = 0; k < table->columns; ++k) text += std::string(k > 0 ? "," : "") + "xyzw"[k];
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
    if (Status status = writeFileAtomically(request.output, text); !status.ok()) return status;
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
        "Points are a table with a head line and columns x[,y[,z[,w]]]: the starting point.\n");
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
