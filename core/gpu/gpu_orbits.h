// SPDX-License-Identifier: MIT
#pragma once
// What the GPU takes of an OrbitProgram: the text of its program and the numbers
// that go in beside it; or the reason why the CPU has to draw this one. Numbers there have 24 bits.

#include <string>
#include <vector>

#include "fields/evaluate.h"
#include "gpu/gpu_device.h"
#include "image/raster.h"
#include "scene/scene.h"

namespace versorium {

// Which fields the GPU measures; `why` says what keeps it from one.
struct GpuField {
    FieldName field;
    bool carried;
    const char* why;
};
const GpuField& gpuField(FieldName field);
struct GpuOrbits {
    std::string shaderText;
    std::vector<float> numbers;  // for each number: at the middle, per pixel right, per pixel up, 0
    std::vector<float> shapeNumbers;
    int iterations = 0;
    bool bounded = true;  // whether a squared norm above squaredRadius escapes
    float squaredRadius = 4;
    OrbitProgram program;

    // Of an averaged map: how many members are counted, 24 bits at most; 0: one map's orbits.
    int members = 0;
    // Of a number of the slice: its place among `numbers`.
    std::vector<int> places;
    float squaredCapture = 0;  // orbits that come this near to 0 are in every set
    bool counts() const { return members > 0; }

    static Expected<GpuOrbits> make(const Scene& scene, const OrbitProgram& program, Size size,
                                    const GpuLimits& limits);
};
// OK, or which field the CPU has to measure and why.
Status carriesFields(const GpuOrbits& orbits, const std::vector<FieldName>& fields);
// Of more members the counts would not fit into 24 bits.
inline constexpr int kMostGpuMembers = 1 << 24;

}  // namespace versorium
