// SPDX-License-Identifier: MIT
#include "ui/session/bound_programs.h"

#include "io/grid_files.h"

namespace versorium {

const OrbitProgram* BoundPrograms::bind(Bound& bound, const Scene& scene) {
    if (bound.revision != open_.revision()) {
        bound.revision = open_.revision();
        bound.program.reset();
        if (std::optional<Scene> missing = binder_.missingGrid(scene)) {
            askForGrid(std::move(*missing));
        } else {
            Job job(1);
            Expected<OrbitProgram> program = binder_.bind(scene, job);
            if (program) bound.program = std::move(*program);
        }
    }
    return bound.program ? &*bound.program : nullptr;
}

void BoundPrograms::askForGrid(Scene scene) {
    const auto same = [&](const ShapeSpec& shape) {
        ShapeSpec other = scene.shape;
        other.outside = shape.outside;
        return other == shape;
    };
    if ((gridFor_ && same(gridFor_->shape)) || gridRefused_ == scene.shape.source) return;
    gridFor_ = std::move(scene);
    ++gridAsked_;
    host_.requestWork(requestOf(gridAsked_, *gridFor_, GridJob{}));
}

bool BoundPrograms::takeGrid(const WorkAnswer& answer) {
    if (answer.id != gridAsked_ || !gridFor_) return false;
    Expected<Grid> grid = unpackGrid(std::get<GridResult>(answer.result).bytes);
    if (grid) {
        binder_.keep(*gridFor_, std::make_shared<const Grid>(std::move(*grid)));
        gridRefused_.clear();
    } else {
        gridRefused_ = gridFor_->shape.source;  // the pictures say why
    }
    gridFor_.reset();
    return true;
}

const OrbitProgram* BoundPrograms::program(int view) {
    return bind(bound_[static_cast<std::size_t>(view)],
                open_.now().views[static_cast<std::size_t>(view)]);
}

const OrbitProgram* BoundPrograms::orbitProgram() {
    return bind(bound_[kMostViews], orbitScene(open_.now()));
}

const std::vector<std::vector<double>>& BoundPrograms::orbit() {
    if (orbitRevision_ == open_.revision()) return orbit_;
    orbitRevision_ = open_.revision();
    orbit_.clear();
    if (const OrbitProgram* bound = orbitProgram()) {
        const Scene scene = orbitScene(open_.now());
        const double start[3] = {scene.slice.centre[0], scene.slice.centre[1], 0};
        orbit_ = orbitOf(*bound, start, open_.now().orbitSteps);
    }
    return orbit_;
}

}  // namespace versorium
