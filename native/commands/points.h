// SPDX-License-Identifier: MIT
#pragma once
// The points that `eval` measures at: a table with a head line (io/csv.h) whose columns are placed
// by their names.
//
//   x,y          coordinates along the axes of the scene's slice, one column for each axis
//   c.re,c.im    numbers of the scene by their names, up to three; the others keep their values
//   z.re,z.im    a starting point, in the same way
//   x,y,z[,w]    of maps with three or four dimensions: the components of the starting point
//
// Capitals do not matter. Other columns are passed over.

#include <string>
#include <vector>

#include "scene/scene.h"

namespace versorium {

struct PointTable {
    std::vector<std::string> names;  // of the columns that count, as the head line has them
    std::vector<std::vector<double>> points;
    Scene scene;         // with the columns on its axes, where they are no components of the start
    bool start = false;  // components of the starting point (CpuRenderer::measureAt)
};

// ErrorKind::data with the file and the line where a column is missing, stands twice or could mean
// two things.
Expected<PointTable> readPoints(const std::string& path, const Scene& scene);

}  // namespace versorium
