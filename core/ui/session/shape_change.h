// SPDX-License-Identifier: MIT
#pragma once
// Another shape for a scene of the studio.

#include <string>
#include <vector>

#include "ui/session/context.h"

namespace versorium {

// The text of a shape: an analytic one, an outline or a built-in mesh. Where the map takes no shape
// the scene becomes a shape modulus, with roots drawn in the shape's box. ErrorKind::data with what
// is wrong in the text; then nothing has changed.
Status setShape(StudioContext& context, const std::string& source);
// The same, seen whole by the views of starting points.
Status setDrawnShape(StudioContext& context, const std::string& source);

// Shapes to begin with: their names and texts.
struct ShapeChoice {
    const char *name, *source;
};
const std::vector<ShapeChoice>& shapeChoices();

// Where φ is looked up for the point (u, v) of a view: the shape's own coordinates.
std::array<double, 3> shapePlace(const Scene& scene, const OrbitProgram& program, double u,
                                 double v);

// Four views of starting points (S Fig 2): r = |f|, its direction d, log |f_n| and membership, with
// the set outlined. For maps of the plane or the quaternions.
void showModulusAndVersor(StudioContext& context);
// Two views of starting points, with S eq 2 as it is printed (φ + β) in the second one.
void showAsPrinted(StudioContext& context);

}  // namespace versorium
