// SPDX-License-Identifier: MIT
#pragma once
// Measures fields (fields/field_names.h) of many orbits at once.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/words.h"
#include "fields/field_names.h"
#include "maps/catalogue.h"
#include "view/slice.h"

namespace versorium {

struct Trap {
    enum class Kind { point, line, circle };
    Kind kind = Kind::point;
    double point[kMostDimension] = {};
    int components = 2;  // of a point trap; lines and circles lie in the first two
    double radius = 1, angle = 0;
};

template <>
struct EnumWords<Trap::Kind> {
    static constexpr std::array<std::string_view, 3> table{"point", "line", "circle"};
};

struct Ensemble;  // fields/ensemble.h

// Everything that orbits follow from. The slice's numbers are the state, the parameters, and one
// for each override, in this order.
struct OrbitProgram {
    const MapKernels* map = nullptr;
    std::shared_ptr<const void> keeps;  // what the map stands in, if not in the catalogue
    std::vector<BoundList> lists;
    std::shared_ptr<const DistanceField> field;
    Slice slice;
    struct ListNumber {
        int list, item, component;
    };
    std::vector<ListNumber> overrides;
    std::optional<int> critical;  // start at this critical point instead of the slice's state
    int iterations = 100;
    double escapeRadius = 2;
    bool onlyLastTested = false;  // A eq 12 read literally
    double iso = 0;
    // |f(z)| ~ |z|^degree for large z, for smoothed escape times; 0: it is measured along each
    // orbit.
    double degree = 2;
    bool measuresGrowth() const { return !(degree > 1); }
    Trap trap;
    std::shared_ptr<const Ensemble> ensemble;  // null: this map alone
};

// Whether a last iterate of this squared norm makes its start part of the solid set.
bool isSolid(const OrbitProgram& program, double squaredNorm);

// Channels of a field: the dimension of the state for the versor, else 1.
int channelCount(FieldName field, const OrbitProgram& program);

struct EvaluateOptions {
    Flavour flavour = Flavour::exact;
    bool shortcuts = true;
    // Of the members of an ensemble that were counted elsewhere (fields/ensemble.h): how many there
    // are, and one count for each point. Null: all members are counted.
    const std::uint32_t* counts = nullptr;
    std::uint64_t members = 0;
    std::function<bool()> stop =
        {};  // asked between members; values are of no use once it says true
};

// For `count` points with coordinates[axis][i], for each axis of the slice: one vector of count *
// channels numbers per field, channel after channel. Every NaN is the canonical one. Values do not
// depend on how points are split among calls.
std::vector<std::vector<double>> evaluateFields(const OrbitProgram& program, int count,
                                                const double* const* coordinates,
                                                std::span<const FieldName> fields,
                                                const EvaluateOptions& options = {});

// The orbit of one point: rows of dimension numbers, z_0 … at most z_steps; ends after the first
// iterate that is outside.
std::vector<std::vector<double>> orbitOf(const OrbitProgram& program, const double* coordinates,
                                         int steps);

}  // namespace versorium
