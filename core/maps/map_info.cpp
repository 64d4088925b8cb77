// SPDX-License-Identifier: MIT
#include "maps/map_info.h"

#include <algorithm>
#include <cassert>

namespace versorium {
namespace {

std::string component(std::string_view name, int width, bool complex, int index) {
    if (width == 1) return std::string(name);
    constexpr std::string_view kComplex[] = {"re", "im"};
    constexpr std::string_view kSpace[] = {"x", "y", "z"};
    constexpr std::string_view kQuaternion[] = {"w", "x", "y", "z"};
    const auto* names = complex ? kComplex : width == 4 ? kQuaternion : kSpace;
    return std::string(name) + "." + std::string(names[index]);
}

}  // namespace

std::string_view stateName(Algebra algebra) {
    switch (algebra) {
        case Algebra::real:
            return "x";
        case Algebra::complex:
            return "z";
        case Algebra::quaternion:
        case Algebra::bicomplex:
            return "q";
        default:
            return "p";
    }
}

std::string_view algebraName(Algebra algebra) {
    switch (algebra) {
        case Algebra::real:
            return "real line";
        case Algebra::complex:
            return "complex plane";
        case Algebra::plane:
            return "real plane";
        case Algebra::quaternion:
            return "quaternions";
        case Algebra::bicomplex:
            return "bicomplex numbers";
        default:
            return "space";
    }
}

std::string stateComponent(const MapInfo& info, int index) {
    const int width = dimensionOf(info.algebra);
    assert(index >= 0 && index < width);
    return component(stateName(info.algebra), width, info.algebra == Algebra::complex, index);
}

std::string parameterComponent(const MapInfo& info, int index) {
    for (const ParameterInfo& parameter : info.parameters) {
        const int width = widthOf(parameter.kind);
        if (index < width)
            return component(parameter.name, width, parameter.kind == ParameterKind::complex,
                             index);
        index -= width;
    }
    assert(false);
    return {};
}

const ParameterInfo* findParameter(const MapInfo& info, std::string_view name) {
    const auto found =
        std::find_if(info.parameters.begin(), info.parameters.end(),
                     [&](const ParameterInfo& parameter) { return parameter.name == name; });
    return found == info.parameters.end() ? nullptr : &*found;
}

}  // namespace versorium
