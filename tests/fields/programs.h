// SPDX-License-Identifier: MIT
#pragma once
// Orbit programs for tests: a map with given parameters, sliced along numbers by their names.

#include <cassert>

#include "fields/evaluate.h"

namespace versorium {

inline std::size_t numberAt(const MapKernels& map, const std::string& name) {
    for (int k = 0; k < map.dimension; ++k)
        if (stateComponent(map.info, k) == name) return static_cast<std::size_t>(k);
    for (int k = 0; k < map.parameters; ++k)
        if (parameterComponent(map.info, k) == name)
            return static_cast<std::size_t>(map.dimension + k);
    assert(false);
    return 0;
}

// Starts at 0 with the map's default parameters; `values` and `axes` are by name, an axis may move
// several numbers at once ("p.z+c.z").
inline OrbitProgram programOf(const char* mapName,
                              const std::vector<std::pair<std::string, double>>& values,
                              const std::vector<std::vector<std::string>>& axes, int iterations,
                              double radius) {
    OrbitProgram program;
    const MapKernels& map = *findMap(mapName);
    program.map = &map;
    program.slice.origin.assign(static_cast<std::size_t>(map.dimension), 0.0);
    for (const ParameterInfo& parameter : map.info.parameters)
        for (int k = 0; k < widthOf(parameter.kind); ++k)
            program.slice.origin.push_back(parameter.value[static_cast<std::size_t>(k)]);
    for (const auto& [name, value] : values) program.slice.origin[numberAt(map, name)] = value;
    for (const auto& axis : axes) {
        program.slice.axes.emplace_back(program.slice.origin.size(), 0.0);
        for (const std::string& name : axis) {
            program.slice.axes.back()[numberAt(map, name)] = 1;
            program.slice.origin[numberAt(map, name)] = 0;
        }
    }
    program.lists.resize(map.info.lists.size());
    program.iterations = iterations;
    program.escapeRadius = radius;
    program.degree = map.info.degree;
    return program;
}

inline double valueAt(const OrbitProgram& program, FieldName field, double u = 0, double v = 0,
                      const EvaluateOptions& options = {}) {
    const double w = 0;
    const double* coordinates[3] = {&u, &v, &w};
    const FieldName fields[] = {field};
    return evaluateFields(program, 1, coordinates, fields, options)[0][0];
}

}  // namespace versorium
