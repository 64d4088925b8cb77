// SPDX-License-Identifier: MIT
#pragma once
// Starting points, parameters and bound lists and fields for any map of the catalogue.

#include <cassert>
#include <string>
#include <vector>

#include "base/random.h"
#include "maps/catalogue.h"
#include "maps/formula_map.h"

namespace versorium {

struct Sample {
    std::vector<double> state, parameters;
};

// A typed formula as a map; it is kept by the last ones that were made.
inline const MapKernels& typedMap(const std::string& text) {
    const auto map = FormulaMap::make(text);
    assert(map.ok());
    return (*map)->kernels();
}

// The catalogue, and typed formulas of every kind.
inline std::vector<const MapKernels*> testedMaps() {
    std::vector<const MapKernels*> all;
    for (const MapKernels& map : catalogue()) all.push_back(&map);
    for (const char* text :
         {"z^2 + c", "z^3 - a*z + conj(c)", "c*sin(z)", "z^n + c; n = 2.5", "z^2 - 0.5 + 0.1i",
          "if(abs(z) < 1 and z.re > -2, z^2, z/c) + c", "log(z + 3)*c - tanh(z)/2",
          "(z^2 + c - 1)^2/(2z + c - 2)^2", "x' = 1 - a*x^2 + y, y' = b*x; a = 1.4; b = 0.3",
          "y, x*sin(a*y) - x^3/3", "q^2 + c", "c*exp(q) - q*c/2 + 0.2i", "q^a + c",
          "r*x*(1 - x); r = 3.7", "x' = r*max(x, 1 - x^n) - floor(x); n: whole = 3",
          "shape(z^3 - a*z + c); beta = 0.05", "shape(c*q^2 + q)"})
        all.push_back(&typedMap(text));
    return all;
}

// What is bound to every map under test: a few roots with whole and real powers, and a shape.
struct TestBindings {
    BoundList roots{{{0.3, 0.4, -0.1, 0.2}, 2},
                    {{-0.5, 0.1, 0.3, 0}, 1},
                    {{0.2, -0.6, 0, -0.3}, 1.5},
                    {{0, 0.25, -0.4, 0.1}, 3}};
    BoundList poles{{{0.7, -0.2, 0.1, 0.1}, 1}, {{-0.1, -0.8, 0.2, 0}, 0.5}};
    DistanceField field{
        *parseShape("union(sphere(0.35), translate(0.2, 0.1, 0, box(0.1, 0.3, 0.2)))")};

    template <class R>
    Environment<R> environment() const {
        Environment<R> result;
        result.lists[0] = &roots;
        result.lists[1] = &poles;
        result.field = &field;
        return result;
    }
};

inline std::vector<Sample> samples(const MapKernels& map, int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Sample> all;
    for (int i = 0; i < count; ++i) {
        Sample sample;
        for (int k = 0; k < map.dimension; ++k) sample.state.push_back(random.uniform(-1.2, 1.2));
        for (const ParameterInfo& parameter : map.info.parameters)
            for (int k = 0; k < widthOf(parameter.kind); ++k) {
                const double value = parameter.value[static_cast<std::size_t>(k)];
                // Every other sample keeps whole exponents; the rest moves everything a little.
                const bool moves = i % 2 == 1 && parameter.kind != ParameterKind::whole;
                sample.parameters.push_back(moves ? value + random.uniform(-0.3, 0.3) : value);
            }
        all.push_back(sample);
    }
    return all;
}

}  // namespace versorium
