// SPDX-License-Identifier: MIT
#include "fields/field_names.h"

namespace versorium {
namespace {

// In the order of FieldName.
constexpr FieldInfo kFields[] = {
    {FieldName::membership, wordOf(FieldName::membership), "member of the set"},
    {FieldName::solid, wordOf(FieldName::solid), "solid set"},
    {FieldName::escapeStep, wordOf(FieldName::escapeStep), "escape step n"},
    {FieldName::smoothEscape, wordOf(FieldName::smoothEscape), "smoothed escape step ν"},
    {FieldName::squaredNorm, wordOf(FieldName::squaredNorm), "|z_{n}|^{2}"},
    {FieldName::attractionStep, wordOf(FieldName::attractionStep), "attraction step n"},
    {FieldName::logModulus, wordOf(FieldName::logModulus), "log-modulus ln|z_{n}|"},
    {FieldName::imageModulus, wordOf(FieldName::imageModulus), "modulus r = |f|"},
    {FieldName::versor, wordOf(FieldName::versor), "versor f/|f|"},
    {FieldName::argument, wordOf(FieldName::argument), "argument of f"},
    {FieldName::distance, wordOf(FieldName::distance), "distance to the boundary"},
    {FieldName::trap, wordOf(FieldName::trap), "least distance to the trap"},
    {FieldName::lyapunov, wordOf(FieldName::lyapunov), "Lyapunov exponent"},
    {FieldName::period, wordOf(FieldName::period), "period"},
    {FieldName::meanMembership, wordOf(FieldName::meanMembership), "mean membership"},
    {FieldName::standardError, wordOf(FieldName::standardError),
     "standard error of the mean membership"},
};

}  // namespace

std::span<const FieldInfo> allFields() { return kFields; }

const FieldInfo* findField(std::string_view name) {
    const std::optional<FieldName> field = fromWord<FieldName>(name);
    return field ? &infoOf(*field) : nullptr;
}

const FieldInfo& infoOf(FieldName field) { return kFields[static_cast<int>(field)]; }

}  // namespace versorium
