// SPDX-License-Identifier: MIT
#pragma once
// The same orbits for the program and for the oracle.

#include <cmath>
#include <memory>

#include "maps/samples.h"
#include "oracle/orbits.h"

namespace versorium {

inline constexpr double kRounding = 0x1p-52;

// The shape of TestBindings, written out: a ball and a box that is moved by (0.2, 0.1, 0).
inline oracle::Real testShape(oracle::Real x, oracle::Real y, oracle::Real z) {
    return std::fmin(oracle::sphere(x, y, z, 0.35L),
                     oracle::box(x - 0.2L, y - 0.1L, z, 0.1L, 0.3L, 0.2L));
}

inline oracle::Bound oracleBound(const TestBindings& bindings) {
    oracle::Bound bound;
    const BoundList* lists[2] = {&bindings.roots, &bindings.poles};
    for (int k = 0; k < 2; ++k)
        for (const RootList::Root& root : *lists[k])
            bound.lists[k].push_back({{root.q[0], root.q[1], root.q[2], root.q[3]}, root.power});
    bound.distance = testShape;
    return bound;
}

// `bound` is kept by reference.
inline oracle::Case caseOf(const MapKernels& map, const Sample& sample,
                           const oracle::Bound& bound) {
    oracle::Case c;
    c.step = &oracle::steps().at(std::string(map.info.name));
    c.bound = &bound;
    for (int k = 0; k < map.parameters; ++k) c.names.push_back(parameterComponent(map.info, k));
    c.start.assign(sample.state.begin(), sample.state.end());
    c.parameters.assign(sample.parameters.begin(), sample.parameters.end());
    c.degree = map.info.degree;
    return c;
}

}  // namespace versorium
