// SPDX-License-Identifier: MIT
#pragma once
// The texts that scenes have for shapes: whether one can be read, and what it is called.

#include <string>

#include "scene/scene.h"

namespace versorium {

// Of ShapeSpec::source or ModulationSpec::shape: its text, the name of the file, or how many
// corners were drawn.
std::string shapeName(const Scene& scene, const std::string& source);

// Whether such a text is a built-in mesh, an analytic shape or an outline that can be read, or
// names a file that the scene should carry. ErrorKind::data with what is wrong.
Status checkShapeText(const std::string& source);
bool isBuiltInMesh(const std::string& source);

}  // namespace versorium
