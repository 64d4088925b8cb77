// SPDX-License-Identifier: MIT
#pragma once
// One-parameter bifurcation diagrams: to each value of a parameter, from left to right, the points
// that an orbit visits after a transient, from bottom to top. The program's slice has one axis, the
// parameter; the orbit starts at the slice's start or at the program's critical point.

#include "dynamics/system.h"
#include "image/raster.h"
#include "jobs/job.h"

namespace versorium {

struct DiagramOptions {
    double left = 0, right = 1;  // of the slice's coordinate; pixel centres at +0.5
    double low = 0, high = 1;    // of the component that is shown
    int component = 0;           // of the state
    int transient = 2000;        // steps before anything is drawn
    int points = 1000;           // steps that are drawn, for each value of the parameter
    int across = 2;              // values of the parameter in each column, 1 … 16
};

struct BifurcationDiagram {
    // How often an orbit of the column visits a pixel in `points` steps, on the average; a visit
    // is shared by the two pixels whose centres it lies between.
    Raster<float> visits;
    // Of the attracting cycle at the middle of each column: 0 where the orbit is bounded and no
    // cycle of at most 4096 points is found, -1 where the orbit escapes.
    std::vector<int> periods;

    explicit BifurcationDiagram(Size size)
        : visits(size, 1), periods(static_cast<std::size_t>(size.width), 0) {}
};

// Fills the columns first … first + count - 1, and touches no others: a live view fills a few at a
// time. Values do not depend on how columns are split among calls. ErrorKind::usage for options
// that make no sense.
Status fillDiagram(const OrbitProgram& program, const DiagramOptions& options, int first, int count,
                   Job& job, BifurcationDiagram& diagram);

// Visits as ink from 0 to 1, so that thin curves are dark and the shading of chaotic bands shows:
// 1 - exp(-0.8 v), v = 1 where visits are spread evenly over the height.
Raster<float> inkOf(const BifurcationDiagram& diagram, const DiagramOptions& options);

}  // namespace versorium
