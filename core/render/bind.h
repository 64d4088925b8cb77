// SPDX-License-Identifier: MIT
#pragma once
// Makes of a scene what orbits are computed from: names become numbers, lists are bound, and the
// shape becomes a distance field. Grids made of meshes and pictures are kept, since they take
// seconds and several panels of a plate share them.

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "fields/evaluate.h"
#include "jobs/job.h"
#include "scene/scene.h"

namespace versorium {

class Binder {
  public:
    Expected<OrbitProgram> bind(const Scene& scene, Job& job);

    // The grid of the scene's own shape, which must need one; made where it is not kept yet.
    Expected<std::shared_ptr<const Grid>> grid(const Scene& scene, Job& job);
    // A grid that bind() would have to make first, as a scene with its shape; none where bind()
    // takes no time.
    std::optional<Scene> missingGrid(const Scene& scene);
    // Keeps a grid that another binder made of the same scene.
    void keep(const Scene& scene, std::shared_ptr<const Grid> grid);

  private:
    Expected<std::shared_ptr<DistanceField>> field(const Scene& scene, Job& job);
    // Of alpha or beta; null where it is the same everywhere.
    Expected<std::shared_ptr<const Modulation>> modulation(const Scene& scene,
                                                           const ModulationSpec& spec, Job& job);

    std::mutex mutex_;
    std::map<std::string, std::shared_ptr<const Grid>> grids_;
};

// Whether a scene's shape, or one that alpha or beta follows, is a mesh, a stored grid or a
// picture, and not analytic.
bool needsGrid(const Scene& scene);

// The mesh, grid or picture in these bytes as a grid of signed distances. The content says what
// they are, and the ending of `name` where that is open. What is doubtful is told by job.warn().
Expected<Grid> gridFromBytes(std::span<const unsigned char> bytes, const std::string& name,
                             const ShapeSpec& spec, Job& job);

// The escape radius that a scene's map takes by itself: for the quadratic families with one c
// (1 + sqrt(1 + 4|c|))/2 where that is above 2, which bounds every filled Julia set.
double automaticRadius(const Scene& scene);

}  // namespace versorium
