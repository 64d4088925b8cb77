// SPDX-License-Identifier: MIT
#pragma once
// What can be measured along an orbit z_0, z_1, …, with N iterations and escape radius R. The step
// of escape is the least n >= 0 with !(|z_n|² <= R²); "last" is z_n there, or z_N.
//
//   membership      1 where the orbit has not escaped after N, else 0
//   solid           1 where log_modulus < iso, else 0: the set that is meshed. Not membership!
//   escape_step     n at escape, N where there is none
//   smooth_escape   n + 1 - log_d(ln|z_n| / ln R) within [n, n+1], d the degree; N inside
//   squared_norm    |last|²
//   attraction_step least n >= 1 with (|z_n|² - |z_{n-1}|²)² < 0.0005 (A 4.3.2), N where there is
//                   none, NaN where the orbit escapes
//   log_modulus     ln|last|
//   image_modulus   r = |f(z_0)|
//   versor          f(z_0) / |f(z_0)|, as many components as a state has
//   argument        angle of f(z_0) in its first two components, (-π, π]
//   distance        ½ |z| ln|z| / |∇|z|| at escape, ∇ by duals along the axes of the slice, in
//                   units of the slice; 0 where the orbit does not escape
//   trap            least distance of z_0 … last to the trap
//   lyapunov        largest exponent: mean of ln|Df v| along the orbit, v renormalised; NaN where
//                   the orbit escapes
//   mean_membership part of the scene's ensemble (fields/ensemble.h) whose set holds z_0; of a
//   scene
//                   without one, its membership
//   standard_error  of mean_membership, sqrt(p (1 - p) / (members - 1)); 0 without an ensemble
//   period          of the attracting cycle that z_N lies on, at most 4096; 0 where none is found

#include <span>
#include <string_view>

#include "base/words.h"

namespace versorium {

enum class FieldName {
    membership,
    solid,
    escapeStep,
    smoothEscape,
    squaredNorm,
    attractionStep,
    logModulus,
    imageModulus,
    versor,
    argument,
    distance,
    trap,
    lyapunov,
    period,
    meanMembership,
    standardError,
};

template <>
struct EnumWords<FieldName> {
    static constexpr std::array<std::string_view, 16> table{
        "membership",   "solid",           "escape_step",     "smooth_escape",
        "squared_norm", "attraction_step", "log_modulus",     "image_modulus",
        "versor",       "argument",        "distance",        "trap",
        "lyapunov",     "period",          "mean_membership", "standard_error"};
};

struct FieldInfo {
    FieldName field;
    std::string_view name;
    std::string_view label;  // for axes and colour bars, plate markup
};

std::span<const FieldInfo> allFields();
// Null when there is no such field.
const FieldInfo* findField(std::string_view name);
const FieldInfo& infoOf(FieldName field);

}  // namespace versorium
