// SPDX-License-Identifier: MIT
#pragma once
// What the rest of the program knows of a map: its name, its formula as text, its parameters with
// their ranges, where it escapes, where it is worth looking, and what is special about it. Nobody
// else compares names of maps: what other maps may have in common with one is a property here.

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "geometry/roots.h"

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
    std::string_view label = {};  // what the studio calls it; empty: its name
    // Views that share all other parameters have each their own value of this one.
    bool ofView = false;
};

// How the lists of a map give it, with tᵢ, Tᵢ of the first list and bᵢ, Bᵢ of the second one.
enum class RootForm {
    none,     // there are no lists, or they are taken in another way
    product,  // e^C Π (z - tᵢ)^(τ Tᵢ) / Π (z - bᵢ)^(β Bᵢ); parameters C, τ, β
    sum,      // e^C (Σ (z - tᵢ)^(τ Tᵢ) + Σ (z - bᵢ)^(-β Bᵢ)); parameters C, τ, β
    newton,   // z - a / Σ Tᵢ / (z - tᵢ); parameter a
};

inline constexpr RootList::Root kSpreadRoots[] = {{{0, 0, 0, 0}, 2},
                                                  {{0.45, 0.3, 0.1, 0}, 1},
                                                  {{-0.4, 0.35, -0.2, 0}, 1},
                                                  {{-0.1, -0.5, 0.3, 0}, 1}};

struct MapInfo {
    std::string_view name;
    std::string_view title;
    std::string_view formula;
    Algebra algebra = Algebra::complex;
    std::span<const ParameterInfo> parameters;
    std::span<const std::string_view> lists = {};  // lists of roots that are bound to the map
    // What the first list begins with; the others begin empty.
    std::span<const RootList::Root> homeRoots = kSpreadRoots;
    RootForm rootForm = RootForm::none;
    // Looks into a distance field, by the parameters of maps/shape_modulus.h.
    bool field = false;
    // A polynomial system of the real plane: the parameters are the 30 numbers of
    // PlanarCoefficients (maps/planar.h).
    bool planarCoefficients = false;
    // What stands before 1, z, z², … in a polynomial over numbers with |ab| = |a||b|: the name of a
    // parameter, "1", or nothing for 0. The term of a `degreeParameter` comes on top.
    std::span<const std::string_view> polynomial = {};
    // The parameter d of z^d, which escape times are smoothed with in place of `degree`.
    std::string_view degreeParameter = {};
    // Default escape radius; infinite where a map has none (only NaN and overflow escape then).
    double escapeRadius = 2;
    // Growth of |z| at infinity: |f(z)| ~ |z|^degree, for smoothed escape times. 0: it follows from
    // parameters and roots (render/growth.h).
    double degree = 2;
    // f(conj z; conj parameters) = conj f(z), to the bit.
    bool conjugation = false;
    // Centre of the home view of the dynamical plane and the height that it shows.
    std::array<double, 2> homeCentre{0, 0};
    double homeHeight = 4;
    // An interval of the real line that the map takes into itself and that is shown whole.
    std::array<double, 2> interval{0, 0};  // empty: there is none
    // The home view of the plane of parameters: its two numbers, where the usual choice
    // (workspace/workspace.h) is not meant, and its centre, where that is not 0.
    std::span<const std::string_view> parameterAxes = {};
    std::array<double, 2> parameterCentre{0, 0};
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
// Whether the exponents of a list count with the other sign.
constexpr bool isPoles(const MapInfo& info, std::string_view list) {
    return (info.rootForm == RootForm::product || info.rootForm == RootForm::sum) &&
           info.lists.size() > 1 && list == info.lists[1];
}
// The parameter c of a map z² + c; empty for other maps.
constexpr std::string_view quadraticConstant(const MapInfo& info) {
    const auto& k = info.polynomial;
    return k.size() == 3 && k[1].empty() && k[2] == "1" ? k[0] : std::string_view();
}

// Names of the components of a state or of a parameter: "z.re", "q.w", "c.im", "power".
std::string stateComponent(const MapInfo& info, int component);
std::string parameterComponent(const MapInfo& info, int component);
// Null where the map has no parameter of this name.
const ParameterInfo* findParameter(const MapInfo& info, std::string_view name);
// The names that users type for the state: z, q or p, by algebra.
std::string_view stateName(Algebra algebra);
std::string_view algebraName(Algebra algebra);

}  // namespace versorium
