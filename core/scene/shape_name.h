// SPDX-License-Identifier: MIT
#pragma once
// What a shape is called where people read it.

#include <string>

#include "scene/scene.h"

namespace versorium {

// Of ShapeSpec::source or ModulationSpec::shape: its text, the name of the file, or how many
// corners were drawn.
std::string shapeName(const Scene& scene, const std::string& source);

}  // namespace versorium
