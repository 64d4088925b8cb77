// SPDX-License-Identifier: MIT
#pragma once
// The two fragment shaders that draw a scene: the orbits' from its map, its shape and the numbers
// that are 0 in all of the picture; the colours' is the same for all scenes (colour_shader.h). The
// GPU compiles these texts, and `versorium glsl` prints them.

#include <array>
#include <string>
#include <vector>

#include "fields/evaluate.h"
#include "scene/scene.h"

namespace versorium {

struct OrbitShader {
    std::string text;
    std::vector<float> shapeNumbers;  // uShape: the constants of an analytic shape
    std::size_t shapeNodes = 0;       // operations of its distance
};
OrbitShader orbitShader(const Scene& scene, const OrbitProgram& program);

// The middle of a scene's slice along its axes, as one double each.
std::array<double, 3> centreOf(const Scene& scene);
// The numbers of the slice that each member of an ensemble draws.
std::vector<std::size_t> drawnNumbers(const Ensemble& ensemble);

}  // namespace versorium
