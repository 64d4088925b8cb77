// SPDX-License-Identifier: MIT
#pragma once
// What the graphics processor takes of an OrbitProgram: the text of its program and the numbers
// that go in beside it; or the reason why the CPU has to draw this one. Numbers there have 24 bits.

#include <string>
#include <vector>

#include "fields/evaluate.h"
#include "gpu/gpu_renderer.h"
#include "image/raster.h"
#include "scene/scene.h"

namespace versorium {

// Which fields the graphics processor measures; `why` says what keeps it from one.
struct GpuField {
    FieldName field;
    bool carried;
    const char* why;
};
const GpuField& gpuField(FieldName field);
// OK, or which field the CPU has to measure and why.
Status carriesFields(const OrbitProgram& program, const std::vector<FieldName>& fields);

struct GpuOrbits {
    std::string shaderText;
    std::vector<float> numbers;  // for each number: at the middle, per pixel right, per pixel up, 0
    std::vector<float> shapeNumbers;
    int iterations = 0;
    bool bounded = true;  // whether a squared norm above squaredRadius escapes
    float squaredRadius = 4;
    OrbitProgram program;

    static Expected<GpuOrbits> make(const Scene& scene, const OrbitProgram& program, Size size,
                                    const GpuLimits& limits);
};

}  // namespace versorium
