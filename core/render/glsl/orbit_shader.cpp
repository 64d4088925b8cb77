// SPDX-License-Identifier: MIT
#include "render/glsl/orbit_shader.h"

#include <algorithm>

#include "fields/ensemble.h"
#include "fields/observers.h"
#include "render/cpu/averaged_map.h"
#include "render/glsl/shader.h"
#include "trace/specialise.h"

namespace versorium {
namespace {

// The distance of an analytic shape; its constants become parameters.
Tape recordShape(const ShapeTree& shape, std::vector<float>& numbers) {
    Tape tape;
    tape.stateSize = 3;
    Expr at[3];
    for (int k = 0; k < 3; ++k) at[k] = {&tape, tape.add({.op = Op::state, .index = k})};
    const Expr value = distance(shape, at[0], at[1], at[2]);
    tape.outputs = {value.on(&tape)};
    for (Node& node : tape.nodes) {
        if (node.op != Op::constant) continue;
        numbers.push_back(static_cast<float>(node.constant));
        node = {.op = Op::parameter, .index = tape.parameterSize++};
    }
    return tape;
}

// A third axis is the same in all of a picture.
bool variesInPicture(const Slice& slice, std::size_t number) {
    for (std::size_t k = 0; k < slice.axes.size() && k < 2; ++k)
        if (slice.axes[k][number] != 0) return true;
    return false;
}

// The map's step without the terms whose coefficients are 0 in the whole picture, where that saves
// much: every other set of terms is a shader of its own, which takes time to compile.
Tape stepOf(const MapKernels& map, const Slice& slice, const std::array<double, 3>& middle,
            const std::vector<std::size_t>& drawn) {
    Tape whole = map.trace();
    std::vector<char> zero;
    for (int k = 0; k < map.parameters; ++k) {
        const auto index = static_cast<std::size_t>(map.dimension + k);
        zero.push_back(slice.at(index, middle.data()) == 0 && !variesInPicture(slice, index) &&
                       std::find(drawn.begin(), drawn.end(), index) == drawn.end());
    }
    Tape special = specialise(whole, zero);
    return 2 * special.nodes.size() < whole.nodes.size() ? special : whole;
}

}  // namespace

// The numbers of the slice that each member draws.
std::vector<std::size_t> drawnNumbers(const Ensemble& ensemble) {
    std::vector<std::size_t> drawn;
    for (const Ensemble::Range& range : ensemble.ranges) drawn.push_back(range.number);
    for (const Ensemble::Disc& disc : ensemble.discs) drawn.insert(drawn.end(), {disc.re, disc.im});
    return drawn;
}

std::array<double, 3> centreOf(const Scene& scene) {
    const SliceSpec& slice = scene.slice;
    std::array<double, 3> centre{};
    for (std::size_t axis = 0; axis < centre.size(); ++axis)
        centre[axis] = (axis < slice.centre.size() ? slice.centre[axis] : 0) +
                       (axis < slice.centreLow.size() ? slice.centreLow[axis] : 0);
    return centre;
}

OrbitShader orbitShader(const Scene& scene, const OrbitProgram& program) {
    OrbitShader shader;
    Tape shape;
    const bool analytic = program.field && program.field->shape();
    if (analytic) shape = recordShape(*program.field->shape(), shader.shapeNumbers);
    shader.shapeNodes = shape.nodes.size();
    const bool counts = showsEnsemble(scene);
    const auto drawn = counts ? drawnNumbers(*program.ensemble) : std::vector<std::size_t>{};
    const Tape step = stepOf(*program.map, program.slice, centreOf(scene), drawn);
    const Tape* shapeTape = analytic ? &shape : nullptr;
    shader.text = counts ? countingShader(step, shapeTape, static_cast<int>(drawn.size()))
                         : iterationShader(step, shapeTape, kAttractionDifference);
    return shader;
}

}  // namespace versorium
