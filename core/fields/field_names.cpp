// SPDX-License-Identifier: MIT
#include "fields/field_names.h"

namespace versorium {
namespace {

// In the order of FieldName.
constexpr FieldInfo kFields[] = {
    {FieldName::membership, "membership", "member of the set"},
    {FieldName::solid, "solid", "solid set"},
    {FieldName::escapeStep, "escape_step", "escape step n"},
    {FieldName::smoothEscape, "smooth_escape", "smoothed escape step ν"},
    {FieldName::squaredNorm, "squared_norm", "|z_{n}|^{2}"},
    {FieldName::attractionStep, "attraction_step", "attraction step n"},
    {FieldName::logModulus, "log_modulus", "log-modulus ln|z_{n}|"},
    {FieldName::imageModulus, "image_modulus", "modulus r = |f|"},
    {FieldName::versor, "versor", "versor f/|f|"},
    {FieldName::argument, "argument", "argument of f"},
    {FieldName::distance, "distance", "distance to the boundary"},
    {FieldName::trap, "trap", "least distance to the trap"},
    {FieldName::lyapunov, "lyapunov", "Lyapunov exponent"},
    {FieldName::period, "period", "period"},
    {FieldName::meanMembership, "mean_membership", "mean membership"},
    {FieldName::standardError, "standard_error", "standard error of the mean membership"},
};

}  // namespace

std::span<const FieldInfo> allFields() { return kFields; }

const FieldInfo* findField(std::string_view name) {
    for (const FieldInfo& info : kFields)
        if (info.name == name) return &info;
    return nullptr;
}

const FieldInfo& infoOf(FieldName field) { return kFields[static_cast<int>(field)]; }

}  // namespace versorium
