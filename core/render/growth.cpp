// SPDX-License-Identifier: MIT
#include "render/growth.h"

#include <algorithm>

#include "dynamics/planar_system.h"
#include "trace/formula_growth.h"

namespace versorium {
namespace {

std::size_t parameterIndex(const MapInfo& info, std::string_view name) {
    std::size_t first = 0;
    for (const ParameterInfo& parameter : info.parameters) {
        if (parameter.name == name) return first;
        first += static_cast<std::size_t>(widthOf(parameter.kind));
    }
    return first;
}

// The largest power that roots and poles give: of a product their sum, of a sum the largest.
double growthOfRoots(const MapInfo& info, const OrbitProgram& program, const double* parameters) {
    const bool product = info.rootForm == RootForm::product;
    double total = 0;
    for (std::size_t list = 0; list < program.lists.size() && list < 2; ++list) {
        const double sign = list == 0 ? parameters[1] : -parameters[2];
        for (const RootList::Root& root : program.lists[list])
            total = product ? total + sign * root.power : std::max(total, sign * root.power);
    }
    return total;
}

// The degree of complex polynomials, of their conjugates, and of quadratic maps. What else has
// higher terms may grow differently in every direction.
double growthOfPlane(const double* numbers, const std::vector<bool>& varies) {
    PlanarNumbers known;
    for (std::size_t k = 0; k < known.size(); ++k) known[k] = varies[k] ? 1 : numbers[k];
    const int degree = planarDegree(known);
    if (degree == 2 || complexPolynomialOf(std::span(numbers, kPlanarNumbers)) ||
        complexPolynomialOf(conjugateOf(std::span(numbers, kPlanarNumbers))))
        return degree;
    return 0;
}

}  // namespace

double growthAtInfinity(const Scene& scene, const OrbitProgram& program) {
    const MapInfo& info = mapOf(scene).info;
    const auto dimension = static_cast<std::size_t>(program.map->dimension);
    const double* parameters = program.slice.origin.data() + dimension;
    std::vector<bool> varies;
    for (int k = 0; k < program.map->parameters; ++k)
        varies.push_back(program.slice.varies(dimension + static_cast<std::size_t>(k)));
    double growth = info.degree;
    if (scene.formula) {
        growth = growthOf(scene.formula->formula(), parameters, varies).value_or(0);
    } else if (info.field) {
        growth = 0;  // of a shape modulus it is exponential
    } else if (!info.degreeParameter.empty()) {
        const std::size_t index = parameterIndex(info, info.degreeParameter);
        growth = varies[index] ? 0 : parameters[index];
    } else if (info.rootForm == RootForm::product || info.rootForm == RootForm::sum) {
        const bool moves = varies[1] || varies[2] || !program.overrides.empty();
        growth = moves ? 0 : growthOfRoots(info, program, parameters);
    } else if (info.planarCoefficients) {
        growth = growthOfPlane(parameters, varies);
    }
    return growth > 1 ? growth : 0;
}

}  // namespace versorium
