// SPDX-License-Identifier: MIT
#include "render/cpu/cpu_renderer.h"

#include <algorithm>
#include <cmath>

#include "render/colouring.h"
#include "render/cpu/tiles.h"
#include "render/outline.h"

namespace versorium {
namespace {

constexpr int kPoints = 1024;  // points at once when there is no picture

EvaluateOptions optionsFor(const RenderOptions& options, const Job& job) {
    return {.flavour = options.flavour, .shortcuts = options.shortcuts, .stop = [&job] {
                return job.cancelled();
            }};
}

// With the counts of the tile's samples, where there are any.
EvaluateOptions withCounts(const AveragedMap* averaged, const Tile& tile, int perSide,
                           const RenderOptions& options, const Job& job,
                           std::vector<std::uint32_t>& counts) {
    EvaluateOptions all = optionsFor(options, job);
    if (!averaged) return all;
    counts = averaged->counts(tile.x * perSide, tile.y * perSide, tile.width * perSide,
                              tile.height * perSide);
    all.counts = counts.data();
    all.members = averaged->members();
    return all;
}

std::vector<std::vector<double>> evaluate(const OrbitProgram& program, const Samples& samples,
                                          const std::vector<FieldName>& fields,
                                          const EvaluateOptions& options) {
    const double* coordinates[3] = {samples.u.data(), samples.v.data(), samples.w.data()};
    return evaluateFields(program, static_cast<int>(samples.u.size()), coordinates, fields,
                          options);
}

// Of one tile that is kept, the fields in this order.
std::vector<std::vector<double>> valuesOf(const FieldTiles& kept, std::size_t tile,
                                          const std::vector<FieldName>& fields) {
    std::vector<std::vector<double>> values;
    for (const FieldName field : fields) {
        const auto at = std::find(kept.fields.begin(), kept.fields.end(), field);
        values.push_back(kept.tiles[tile][static_cast<std::size_t>(at - kept.fields.begin())]);
    }
    return values;
}

// Mean of the samples of each pixel of the tile: in linear light, colours weighted by alpha.
void average(const Tile& tile, int perSide, const std::vector<Colour>& colours, Frame& frame) {
    const int across = tile.width * perSide;
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            double r = 0, g = 0, b = 0, a = 0;
            for (int sy = 0; sy < perSide; ++sy)
                for (int sx = 0; sx < perSide; ++sx) {
                    const Colour& c = colours[static_cast<std::size_t>((y * perSide + sy) * across +
                                                                       x * perSide + sx)];
                    r += c.r * c.a;
                    g += c.g * c.a;
                    b += c.b * c.a;
                    a += c.a;
                }
            float* pixel = &frame.colour.at(tile.x + x, tile.y + y);
            const double scale = a > 0 ? 1 / a : 0;
            pixel[0] = static_cast<float>(r * scale);
            pixel[1] = static_cast<float>(g * scale);
            pixel[2] = static_cast<float>(b * scale);
            pixel[3] = static_cast<float>(a / (perSide * perSide));
        }
}

// The same map with the scene's parameters, also those that its picture varies, and the first
// components of the start as axes.
Scene dynamicalScene(Scene scene) {
    const MapInfo& info = mapOf(scene).info;
    scene.criticalStart.reset();
    scene.slice.axes.clear();
    scene.slice.origin.clear();
    for (int k = 0; k < std::min(3, dimensionOf(info.algebra)); ++k)
        scene.slice.axes.push_back({{{stateComponent(info, k), 1.0}}});
    return scene;
}

}  // namespace

CpuRenderer::Source CpuRenderer::sourceOf(const Scene& scene, Size size,
                                          const RenderOptions& options, const ColourPass& pass,
                                          const OrbitProgram& program) {
    Source source;
    source.fields = pass.fields();
    keptLast_ = false;
    // What is counted of an ensemble is kept as counts.
    const bool mayKeep = fields_.keeps() && !averagedOf(scene, size);
    if (mayKeep) {
        FieldTiles wanted = KeptFields::tilesFor(scene, size, options, source.fields);
        source.kept = fields_.find(wanted);
        if (source.kept) return source;
        for (const FieldName field : options.also)
            if (std::find(source.fields.begin(), source.fields.end(), field) == source.fields.end())
                source.fields.push_back(field);
        double numbers = 0;
        for (const FieldName field : source.fields) numbers += channelCount(field, program);
        numbers *= 1.0 * size.width * size.height * scene.samples * scene.samples;
        if (fields_.fits(numbers * sizeof(double))) {
            wanted.fields = source.fields;
            wanted.tiles.resize(tilesOf(size).size());
            source.keeping = std::move(wanted);
        }
    }
    ++measurements_;
    return source;
}

const AveragedMap* CpuRenderer::averagedOf(const Scene& scene, Size size) const {
    return averaged_ && averaged_->check(scene, size).ok() ? averaged_.get() : nullptr;
}

Status CpuRenderer::render(const Scene& scene, Size size, const RenderOptions& options, Job& job,
                           Frame& frame) {
    if (Status status = checkSize(scene, size); !status.ok()) return status;
    Expected<OrbitProgram> program = binder_.bind(scene, job);
    if (!program) return program.status();
    Expected<ColourPass> pass = ColourPass::make(scene, *program);
    if (!pass) return pass.status();

    const AveragedMap* averaged = averagedOf(scene, size);
    Source source = sourceOf(scene, size, options, *pass, *program);
    const int perSide = scene.samples;
    const Size sampled{size.width * perSide, size.height * perSide};
    const Viewport view = viewportOf(scene, sampled);
    frame.colour = Raster<float>(size, 4);
    Raster<unsigned char> sides;
    if (pass->hasLines()) sides = Raster<unsigned char>(sampled, 1);
    const std::vector<Tile> tiles = tilesOf(size);
    const bool done = job.parallelFor(tiles.size(), [&](std::size_t index) {
        const Tile& tile = tiles[index];
        std::vector<std::vector<double>> values;
        if (source.kept) {
            values = valuesOf(*source.kept, index, pass->fields());
        } else {
            const Samples samples = samplesOf(tile, perSide, view, thirdCoordinate(scene));
            std::vector<std::uint32_t> counts;
            const EvaluateOptions own = withCounts(averaged, tile, perSide, options, job, counts);
            values = evaluate(*program, samples, source.fields, own);
        }
        std::vector<Colour> colours(
            static_cast<std::size_t>(tile.width * tile.height * perSide * perSide));
        const int across = tile.width * perSide;
        for (std::size_t i = 0; i < colours.size(); ++i) {
            colours[i] = pass->colour(values, colours.size(), i);
            if (pass->hasLines())
                sides.at(tile.x * perSide + static_cast<int>(i) % across,
                         tile.y * perSide + static_cast<int>(i) / across) = pass->side(values, i);
        }
        average(tile, perSide, colours, frame);
        if (source.keeping) source.keeping->tiles[index] = std::move(values);
    });
    if (!done) return Status::cancelled();
    keptLast_ = source.kept || (source.keeping && fields_.put(std::move(*source.keeping)));
    if (pass->hasLines())
        drawOutline(sides, perSide, options.lineWidth * scene.colour.outlineWidth,
                    pass->outlineColour(), frame.colour);
    return composeLayers(scene, layerImages_, frame.colour);
}

Status CpuRenderer::measure(const Scene& scene, Size size, const std::vector<FieldName>& fields,
                            const RenderOptions& options, Job& job,
                            std::vector<Raster<double>>& rasters) {
    if (Status status = checkSize(scene, size); !status.ok()) return status;
    Expected<OrbitProgram> program = binder_.bind(scene, job);
    if (!program) return program.status();
    const AveragedMap* averaged = averagedOf(scene, size);
    const Viewport view = viewportOf(scene, size);
    std::shared_ptr<const FieldTiles> kept;
    if (fields_.keeps() && scene.samples == 1 && !averaged)
        kept = fields_.find(KeptFields::tilesFor(scene, size, options, fields));
    if (!kept) ++measurements_;
    rasters.clear();
    for (FieldName field : fields) rasters.emplace_back(size, channelCount(field, *program));
    const std::vector<Tile> tiles = tilesOf(size);
    const bool done = job.parallelFor(tiles.size(), [&](std::size_t index) {
        const Tile& tile = tiles[index];
        std::vector<std::vector<double>> values;
        if (kept) {
            values = valuesOf(*kept, index, fields);
        } else {
            const Samples samples = samplesOf(tile, 1, view, thirdCoordinate(scene));
            std::vector<std::uint32_t> counts;
            values = evaluate(
                *program, samples, fields,
                withCounts(scene.samples == 1 ? averaged : nullptr, tile, 1, options, job, counts));
        }
        const auto count = static_cast<std::size_t>(tile.width * tile.height);
        for (std::size_t f = 0; f < fields.size(); ++f)
            for (std::size_t i = 0; i < count; ++i)
                for (int c = 0; c < rasters[f].channels(); ++c)
                    rasters[f].at(tile.x + static_cast<int>(i) % tile.width,
                                  tile.y + static_cast<int>(i) / tile.width, c) =
                        values[f][static_cast<std::size_t>(c) * count + i];
    });
    return done ? Status{} : Status::cancelled();
}

Status CpuRenderer::measureAlong(const Scene& scene, const std::vector<std::vector<double>>& points,
                                 const std::vector<FieldName>& fields, const RenderOptions& options,
                                 Job& job, std::vector<std::vector<double>>& rows) {
    const Expected<OrbitProgram> program = binder_.bind(scene, job);
    if (!program) return program.status();
    const std::size_t axes = program->slice.axes.size();
    rows.assign(points.size(), {});
    const bool done =
        job.parallelFor((points.size() + kPoints - 1) / kPoints, [&](std::size_t part) {
            const std::size_t first = part * kPoints;
            const std::size_t count = std::min<std::size_t>(kPoints, points.size() - first);
            std::vector<std::vector<double>> coordinates(3, std::vector<double>(count, 0.0));
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t k = 0; k < axes && k < 3; ++k)
                    coordinates[k][i] = points[first + i][k];
            const double* pointers[3] = {coordinates[0].data(), coordinates[1].data(),
                                         coordinates[2].data()};
            const auto values = evaluateFields(*program, static_cast<int>(count), pointers, fields,
                                               optionsFor(options, job));
            for (std::size_t i = 0; i < count; ++i)
                for (const auto& channel : values)
                    for (std::size_t at = i; at < channel.size(); at += count)
                        rows[first + i].push_back(channel[at]);
        });
    return done ? Status{} : Status::cancelled();
}

Status CpuRenderer::measureAt(const Scene& scene, const std::vector<std::vector<double>>& points,
                              const std::vector<FieldName>& fields, const RenderOptions& options,
                              Job& job, std::vector<std::vector<double>>& rows) {
    Expected<OrbitProgram> bound = binder_.bind(dynamicalScene(scene), job);
    if (!bound) return bound.status();
    OrbitProgram& program = *bound;
    const auto dimension = static_cast<std::size_t>(program.map->dimension);
    const std::size_t axes = program.slice.axes.size();
    // A fourth component is set point by point.
    for (std::size_t k = axes; k < dimension; ++k) program.slice.origin[k] = scene.start[k];
    rows.assign(points.size(), {});
    const std::size_t parts = (points.size() + kPoints - 1) / kPoints;
    const bool done = job.parallelFor(parts, [&](std::size_t part) {
        const std::size_t first = part * kPoints;
        const std::size_t count = std::min<std::size_t>(kPoints, points.size() - first);
        std::vector<std::vector<double>> coordinates(3, std::vector<double>(count, 0.0));
        bool fourth = false;
        for (std::size_t i = 0; i < count; ++i) {
            const auto& point = points[first + i];
            for (std::size_t k = 0; k < axes; ++k)
                coordinates[k][i] = k < point.size() ? point[k] : scene.start[k];
            fourth = fourth || point.size() > 3;
        }
        const auto run = [&](const OrbitProgram& own, std::size_t from, std::size_t size) {
            const double* pointers[3] = {coordinates[0].data() + from, coordinates[1].data() + from,
                                         coordinates[2].data() + from};
            const auto values = evaluateFields(own, static_cast<int>(size), pointers, fields,
                                               optionsFor(options, job));
            for (std::size_t i = 0; i < size; ++i)
                for (const auto& channel : values)
                    for (std::size_t at = i; at < channel.size(); at += size)
                        rows[first + from + i].push_back(channel[at]);
        };
        if (!fourth) return run(program, 0, count);
        for (std::size_t i = 0; i < count; ++i) {
            OrbitProgram own = program;
            if (points[first + i].size() > 3) own.slice.origin[3] = points[first + i][3];
            run(own, i, 1);
        }
    });
    return done ? Status{} : Status::cancelled();
}

}  // namespace versorium
