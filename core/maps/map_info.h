// SPDX-License-Identifier: MIT
#pragma once
// What the rest of the program knows of a map: its name, its formula as text, its parameters with
// their ranges, where it escapes, and where it is worth looking.

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace versorium {

enum class Algebra { real, complex, plane, quaternion, bicomplex, space };

enum class ParameterKind {
    real,        // one number
    whole,       // one number that is meant to be whole
    complex,     // re, im
    quaternion,  // w, x, y, z
    space,       // x, y, z
};

struct ParameterInfo {
    std::string_view name;
    ParameterKind kind = ParameterKind::real;
    std::array<double, 4> value{};  // default
    double low = -4, high = 4;      // range of a slider; typed values may leave it
    std::string_view help;
};

struct MapInfo {
    std::string_view name;
    std::string_view title;
    std::string_view formula;
    Algebra algebra = Algebra::complex;
    std::span<const ParameterInfo> parameters;
    std::span<const std::string_view> lists = {};  // lists of roots that are bound to the map
    bool field = false;                            // looks into a distance field
    // Default escape radius; infinite where a map has none (only NaN and overflow escape then).
    double escapeRadius = 2;
    // Growth of |z| at infinity: |f(z)| ~ |z|^degree, for smoothed escape times.
    double degree = 2;
    // f(conj z; conj parameters) = conj f(z), to the bit.
    bool conjugation = false;
    // Centre of the home view of the dynamical plane and the height that it shows.
    std::array<double, 2> homeCentre{0, 0};
    double homeHeight = 4;
    std::string_view source;  // seed and equation
};

inline constexpr double kNoEscape = std::numeric_limits<double>::infinity();

constexpr int dimensionOf(Algebra algebra) {
    switch (algebra) {
        case Algebra::real:
            return 1;
        case Algebra::complex:
        case Algebra::plane:
            return 2;
        case Algebra::space:
            return 3;
        default:
            return 4;
    }
}
constexpr int widthOf(ParameterKind kind) {
    switch (kind) {
        case ParameterKind::complex:
            return 2;
        case ParameterKind::space:
            return 3;
        case ParameterKind::quaternion:
            return 4;
        default:
            return 1;
    }
}
constexpr int parameterSize(const MapInfo& info) {
    int size = 0;
    for (const ParameterInfo& parameter : info.parameters) size += widthOf(parameter.kind);
    return size;
}

// Names of the components of a state or of a parameter: "z.re", "q.w", "c.im", "power".
std::string stateComponent(const MapInfo& info, int component);
std::string parameterComponent(const MapInfo& info, int component);
// The names that users type for the state: z, q or p, by algebra.
std::string_view stateName(Algebra algebra);
std::string_view algebraName(Algebra algebra);

}  // namespace versorium
