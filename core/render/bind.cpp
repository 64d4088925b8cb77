// SPDX-License-Identifier: MIT
#include "render/bind.h"

#include <algorithm>
#include <cmath>

#include "base/embedded.h"
#include "fields/ensemble.h"
#include "io/grid_files.h"
#include "io/image_files.h"
#include "io/mesh_files.h"
#include "io/shape_file_kind.h"
#include "render/critical_start.h"
#include "render/growth.h"
#include "render/root_region.h"
#include "render/shape_profile.h"
#include "scene/numbers.h"
#include "scene/shape_name.h"
#include "shape/image_distance.h"
#include "shape/mesh_distance.h"
#include "shape/mesh_report.h"
#include "shape/outline.h"

namespace versorium {
namespace {

constexpr std::string_view kMeshes = "meshes/", kAsset = "asset:";
// An outline's grid has no third side, so it may be so much finer than a mesh's.
constexpr int kOutlineNodes = 4;

std::string meshFile(const Scene& scene) {
    return std::string(kMeshes) + scene.shape.source + ".obj";
}

struct NamedBytes {
    std::span<const unsigned char> bytes;
    std::string name;
};
Expected<NamedBytes> shapeFile(const Scene& scene) {
    const std::string& source = scene.shape.source;
    if (!source.starts_with(kAsset)) return NamedBytes{embedded(meshFile(scene)), source + ".obj"};
    const auto found = scene.assets.find(source.substr(kAsset.size()));
    if (found == scene.assets.end())
        return Status::data("shape: the scene names the asset " + source.substr(kAsset.size()) +
                            " but does not carry it; give the file again with --set shape=FILE");
    return NamedBytes{found->second->bytes, found->second->name};
}

// All that a grid follows from.
std::string gridKey(const Scene& scene) {
    return scene.shape.source + "/" + std::to_string(scene.shape.resolution) + "/" +
           formatNumber(scene.shape.padding) + (scene.shape.zFastest ? "/z" : "/x") + "/" +
           formatNumber(scene.shape.threshold) + (scene.shape.byAlpha ? "a" : "l") +
           (scene.shape.invert ? "i" : "");
}

// A scene of the same map with that shape, without all that its grid does not follow from.
Scene withShape(const Scene& scene, const std::string& source) {
    Scene one = sceneOf(mapOf(scene));
    one.shape = scene.shape;
    one.shape.source = source;
    if (source.starts_with(kAsset))
        if (const auto asset = scene.assets.find(source.substr(kAsset.size()));
            asset != scene.assets.end())
            one.assets.insert(*asset);
    return one;
}

// One scene for each shape that this scene looks into.
std::vector<Scene> shapesOf(const Scene& scene) {
    std::vector<Scene> all;
    if (!mapOf(scene).info.field) return all;
    all.push_back(withShape(scene, scene.shape.source));
    for (const ModulationSpec* spec : {&scene.alphaOverSpace, &scene.betaOverSpace})
        if (!spec->shape.empty()) all.push_back(withShape(scene, spec->shape));
    return all;
}

bool isGridded(const Scene& scene) {
    return isOutline(scene.shape.source) || scene.shape.source.starts_with(kAsset) ||
           isBuiltInMesh(scene.shape.source);
}

std::size_t numberIndex(const Scene& scene, const NumberRef& ref, OrbitProgram& program) {
    const MapKernels& map = mapOf(scene);
    if (ref.kind == NumberKind::state) return static_cast<std::size_t>(ref.index);
    if (ref.kind == NumberKind::parameter)
        return static_cast<std::size_t>(map.dimension + ref.index);
    std::size_t k = 0;
    for (; k < program.overrides.size(); ++k) {
        const auto& known = program.overrides[k];
        if (known.list == ref.listIndex && known.item == ref.item &&
            known.component == ref.component)
            break;
    }
    if (k == program.overrides.size())
        program.overrides.push_back({ref.listIndex, ref.item, ref.component});
    return static_cast<std::size_t>(map.dimension + map.parameters) + k;
}

std::size_t numberIndex(const Scene& scene, const std::string& name, OrbitProgram& program) {
    return numberIndex(scene, *numberNamed(scene, name), program);
}

// Where nothing but the roots differs, orbits near enough to the origin of the plane are kept by
// every member.
double captureOf(const Scene& scene, const OrbitProgram& program, double escapeRadius, Job& job) {
    const EnsembleSpec& spec = scene.ensemble;
    bool fixed = program.map->info.field && spec.roots && spec.ranges.empty() &&
                 spec.discs.empty() && program.map->info.algebra == Algebra::complex;
    for (const SliceAxis& axis : scene.slice.axes)
        for (const auto& [name, weight] : axis.terms)
            fixed = fixed && numberNamed(scene, name)->kind == NumberKind::state;
    for (const auto& [name, value] : scene.slice.origin)
        fixed = fixed && numberNamed(scene, name)->kind == NumberKind::state;
    if (!fixed) return 0;
    RadialOptions options = radialOptions(scene, escapeRadius);
    options.outward = false;
    options.points = 512;
    options.radii = 257;
    options.to = std::min(escapeRadius, shapeReach(*program.field, options));
    Job own(job.threads());  // the progress shown is that of the picture
    Expected<RadialProfile> profile = radialProfile(*program.field, options, own);
    return profile ? profile->capture : 0;
}

// What the ensemble draws must have its numbers in the slice before the slice is bound.
std::shared_ptr<const Ensemble> ensembleOf(const Scene& scene, OrbitProgram& program, Job& job) {
    const EnsembleSpec& spec = scene.ensemble;
    const auto ensemble = std::make_shared<Ensemble>();
    ensemble->count = static_cast<std::uint64_t>(spec.count);
    ensemble->seed = static_cast<std::uint64_t>(spec.seed);
    ensemble->solid = spec.set == AveragedSet::solid;
    ensemble->capture =
        captureOf(scene, program, scene.escapeRadius.value_or(program.map->info.escapeRadius), job);
    if (spec.roots) {
        const auto& names = program.map->info.lists;
        ensemble->list = static_cast<int>(std::find(names.begin(), names.end(), spec.roots->list) -
                                          names.begin());
        ensemble->roots = spec.roots->draw;
        if (spec.roots->shapeBox) takeShapeBox(scene, *program.field, ensemble->roots);
    }
    for (const EnsembleRange& range : spec.ranges)
        ensemble->ranges.push_back({numberIndex(scene, range.name, program), range.from, range.to});
    for (const EnsembleDisc& disc : spec.discs)
        ensemble->discs.push_back({numberIndex(scene, disc.name + ".re", program),
                                   numberIndex(scene, disc.name + ".im", program), disc.centreRe,
                                   disc.centreIm, disc.radius});
    return ensemble;
}

// Lists on axes first, so that the number of numbers is known.
Status bindSlice(const Scene& scene, OrbitProgram& program) {
    const MapKernels& map = mapOf(scene);
    std::vector<std::pair<std::size_t, double>> named;
    std::vector<std::vector<std::pair<std::size_t, double>>> axes;
    for (const SliceAxis& axis : scene.slice.axes) {
        axes.emplace_back();
        for (const auto& [name, weight] : axis.terms)
            axes.back().emplace_back(numberIndex(scene, *numberNamed(scene, name), program),
                                     weight);
    }
    for (const auto& [name, value] : scene.slice.origin)
        named.emplace_back(numberIndex(scene, *numberNamed(scene, name), program), value);
    if (program.overrides.size() > kMostOverrides)
        return Status::usage("slice: at most " + std::to_string(kMostOverrides) +
                             " components of lists may be on axes");

    std::vector<double>& origin = program.slice.origin;
    for (int k = 0; k < map.dimension; ++k)
        origin.push_back(numberValue(scene, {NumberKind::state, k, {}, 0, 0, 0}));
    for (int k = 0; k < map.parameters; ++k)
        origin.push_back(numberValue(scene, {NumberKind::parameter, k, {}, 0, 0, 0}));
    for (const auto& number : program.overrides) {
        const auto& list = program.lists[static_cast<std::size_t>(number.list)];
        const RootList::Root& root = list[static_cast<std::size_t>(number.item)];
        origin.push_back(number.component == 4
                             ? root.power
                             : root.q[static_cast<std::size_t>(number.component)]);
    }
    for (const auto& terms : axes) {
        program.slice.axes.emplace_back(origin.size(), 0.0);
        for (const auto& [number, weight] : terms) {
            program.slice.axes.back()[number] += weight;
            origin[number] = 0;
        }
    }
    for (const auto& [number, value] : named) origin[number] = value;
    return {};
}

Trap trapOf(const TrapSpec& spec) {
    Trap trap;
    trap.kind = spec.kind;
    for (std::size_t k = 0; k < spec.point.size(); ++k) trap.point[k] = spec.point[k];
    trap.components = static_cast<int>(spec.point.size());
    trap.radius = spec.radius;
    trap.angle = spec.angle;
    return trap;
}

}  // namespace

double automaticRadius(const Scene& scene) {
    const MapInfo& info = mapOf(scene).info;
    const std::string constant(quadraticConstant(info));
    if (constant.empty()) return info.escapeRadius;
    const std::string component = constant + ".";
    for (const SliceAxis& axis : scene.slice.axes)
        for (const auto& [name, weight] : axis.terms)
            if (name.starts_with(component)) return info.escapeRadius;
    double square = 0;
    for (double part : scene.parameters.at(constant)) square = square + part * part;
    // The radius is one for all members of an ensemble.
    for (const EnsembleRange& range : scene.ensemble.ranges) {
        const double most = std::max(std::abs(range.from), std::abs(range.to));
        if (range.name.starts_with(component)) square = square + most * most;
    }
    for (const EnsembleDisc& disc : scene.ensemble.discs) {
        const double most = std::abs(disc.centreRe) + std::abs(disc.centreIm) + disc.radius;
        if (disc.name == constant) square = std::max(square, most * most);
    }
    return std::max(info.escapeRadius, (1 + std::sqrt(1 + 4 * std::sqrt(square))) / 2);
}

namespace {

Expected<Grid> gridOfPicture(std::span<const unsigned char> bytes, const ShapeSpec& spec,
                             Job& job) {
    Expected<Raster<unsigned char>> image = readImage(bytes);
    if (!image) return image.status();
    const Raster<unsigned char> mask =
        shapeMask(*image, {spec.threshold, spec.invert, spec.byAlpha});
    const auto& values = mask.values();
    const bool inside = values[0] != 0;
    if (std::all_of(values.begin(), values.end(),
                    [&](unsigned char value) { return (value != 0) == inside; }))
        return Status::data(
            std::string("nothing of the picture is ") + (inside ? "outside" : "inside") +
            " where " + (spec.byAlpha ? "opacity" : "lightness") + " at " +
            formatNumber(spec.threshold) +
            " decides; take another shape.threshold from 0 to 1, shape.invert=true for a light "
            "figure, or shape.by_alpha=true for one on a transparent ground");
    return imageDistance(mask, job);
}

Expected<Grid> gridOfMesh(const Mesh& mesh, const ShapeSpec& spec, Job& job) {
    Expected<MeshDistance> made =
        meshDistance(mesh, {.resolution = spec.resolution, .padding = spec.padding}, job);
    if (!made) return made.status();
    const std::vector<double>& values = made->grid.values;
    if (std::none_of(values.begin(), values.end(), [](double phi) { return phi < 0; }))
        return Status::data(
            "the mesh encloses nothing that its grid sees: it is open, or thinner than a cell; "
            "close it, or raise shape.resolution");
    if (made->uncertainNodes > 0)
        job.warn(std::to_string(made->uncertainNodes) + " of " + std::to_string(values.size()) +
                 " nodes of the mesh's grid have an uncertain side, near holes or turned faces");
    return std::move(made->grid);
}

}  // namespace

Expected<Grid> gridFromBytes(std::span<const unsigned char> bytes, const std::string& name,
                             const ShapeSpec& spec, Job& job) {
    const ShapeFileKind kind = shapeFileKindOf(bytes, name);
    if (kind == ShapeFileKind::grid) return readGrid(bytes, {.zFastest = spec.zFastest});
    if (kind == ShapeFileKind::picture) return gridOfPicture(bytes, spec, job);
    Expected<Mesh> mesh = readMesh(bytes, name);
    if (!mesh) return mesh.status();
    for (const std::string& text : warningsOf(reportOf(*mesh))) job.warn(text);
    return gridOfMesh(*mesh, spec, job);
}

namespace {

Expected<Grid> gridOf(const Scene& scene, Job& job) {
    if (isOutline(scene.shape.source)) {
        Expected<std::vector<glm::dvec2>> corners = parseOutline(scene.shape.source);
        if (!corners) return corners.status();
        return outlineDistance(*corners, kOutlineNodes * scene.shape.resolution, job);
    }
    Expected<NamedBytes> file = shapeFile(scene);
    if (!file) return file.status();
    Job own(job.threads());  // its warnings get the file's name; a built-in mesh gives none
    own.onProgress = job.onProgress;
    Expected<Grid> made = gridFromBytes(file->bytes, file->name, scene.shape, own);
    if (!made) return made.status().in(file->name);
    if (scene.shape.source.starts_with(kAsset))
        for (const std::string& text : own.warnings()) job.warn(file->name + ": " + text);
    return made;
}

}  // namespace

bool needsGrid(const Scene& scene) {
    for (const Scene& one : shapesOf(scene))
        if (isGridded(one)) return true;
    return false;
}

Expected<std::shared_ptr<const Grid>> Binder::grid(const Scene& scene, Job& job) {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<const Grid>& kept = grids_[gridKey(scene)];
    if (!kept) {
        Expected<Grid> made = gridOf(scene, job);
        if (!made) return made.status().in("shape");
        kept = std::make_shared<const Grid>(std::move(*made));
    }
    return kept;
}

std::optional<Scene> Binder::missingGrid(const Scene& scene) {
    const std::lock_guard lock(mutex_);
    for (Scene& one : shapesOf(scene)) {
        const auto found = grids_.find(gridKey(one));
        if (isGridded(one) && (found == grids_.end() || !found->second)) return std::move(one);
    }
    return std::nullopt;
}

void Binder::keep(const Scene& scene, std::shared_ptr<const Grid> grid) {
    const std::lock_guard lock(mutex_);
    grids_[gridKey(scene)] = std::move(grid);
}

Expected<std::shared_ptr<DistanceField>> Binder::field(const Scene& scene, Job& job) {
    if (!isGridded(scene)) {
        Expected<ShapeTree> tree = parseShape(scene.shape.source);
        if (!tree) return tree.status().in("shape");
        return std::make_shared<DistanceField>(std::move(*tree));
    }
    Expected<std::shared_ptr<const Grid>> made = grid(scene, job);
    if (!made) return made.status();
    const bool stored =
        !isOutline(scene.shape.source) &&
        shapeFileKindOf(shapeFile(scene)->bytes, shapeFile(scene)->name) == ShapeFileKind::grid;
    const Outside outside =
        scene.shape.outside.value_or(stored ? Outside::border : Outside::distance);
    return std::make_shared<DistanceField>(*made, outside);
}

Expected<std::shared_ptr<const Modulation>> Binder::modulation(const Scene& scene,
                                                               const ModulationSpec& spec,
                                                               Job& job) {
    if (!spec.modulates()) return std::shared_ptr<const Modulation>();
    std::optional<ModulatingShape> shape;
    if (!spec.shape.empty()) {
        Expected<std::shared_ptr<DistanceField>> made = field(withShape(scene, spec.shape), job);
        if (!made) return made.status().in("modulation");
        shape = ModulatingShape{std::move(*made), spec.from, spec.to, spec.value};
    }
    const bool planar = mapOf(scene).info.algebra == Algebra::complex;
    return std::make_shared<const Modulation>(std::move(shape), spec.discs, planar);
}

Expected<OrbitProgram> Binder::bind(const Scene& scene, Job& job) {
    const MapKernels& map = mapOf(scene);
    OrbitProgram program;
    program.map = &map;
    program.keeps = scene.formula;
    for (std::string_view name : map.info.lists) {
        const RootList& list = scene.lists.at(std::string(name));
        program.lists.push_back(list.roots);
        for (RootList::Root& root : program.lists.back()) root.power *= list.scale;
    }
    if (map.info.field) {
        Expected<std::shared_ptr<DistanceField>> made = field(scene, job);
        if (!made) return made.status();
        auto alpha = modulation(scene, scene.alphaOverSpace, job);
        if (!alpha) return alpha.status();
        auto beta = modulation(scene, scene.betaOverSpace, job);
        if (!beta) return beta.status();
        (*made)->modulate(std::move(*alpha), std::move(*beta));
        program.field = std::move(*made);
    }
    program.ensemble = ensembleOf(scene, program, job);
    if (Status status = bindSlice(scene, program); !status.ok()) return status;
    program.critical = scene.criticalStart;
    program.iterations = scene.iterations;
    program.escapeRadius = scene.escapeRadius.value_or(automaticRadius(scene));
    program.onlyLastTested = scene.escapeTest == EscapeTest::last;
    program.iso = scene.iso;
    program.degree = growthAtInfinity(scene, program);
    program.trap = trapOf(scene.trap);
    if (Status status = checkCriticalStart(scene, program); !status.ok()) return status;
    return program;
}

}  // namespace versorium
