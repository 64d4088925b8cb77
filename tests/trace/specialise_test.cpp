// SPDX-License-Identifier: MIT
// Specialised tapes do the same work on fewer nodes.
#include "trace/specialise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "maps/samples.h"
#include "trace/glsl.h"
#include "trace/interpret.h"

namespace versorium {
namespace {

long countOf(const Tape& tape, Op op) {
    return std::count_if(tape.nodes.begin(), tape.nodes.end(),
                         [&](const Node& node) { return node.op == op; });
}
// NaN in both or the same number; 0 and -0 are one.
void expectSame(const Tape& a, const Tape& b, const Sample& sample, const TestBindings& bindings,
                std::string_view name) {
    double first[4], second[4];
    interpret(a, sample.state.data(), sample.parameters.data(), bindings.environment<double>(),
              first);
    interpret(b, sample.state.data(), sample.parameters.data(), bindings.environment<double>(),
              second);
    for (std::size_t k = 0; k < a.outputs.size(); ++k)
        EXPECT_TRUE(first[k] == second[k] || (std::isnan(first[k]) && std::isnan(second[k])))
            << name << ": " << first[k] << " and " << second[k];
}

// Every map, with each of its parameters put to 0 by turns.
TEST(Specialise, GivesTheSameNumbers) {
    const TestBindings bindings;
    for (const MapKernels& map : catalogue()) {
        const Tape tape = map.trace();
        for (int zeroed = -1; zeroed < map.parameters; ++zeroed) {
            std::vector<char> zero(static_cast<std::size_t>(map.parameters), 0);
            if (zeroed >= 0) zero[static_cast<std::size_t>(zeroed)] = 1;
            const Tape special = specialise(tape, zero);
            EXPECT_LE(special.nodes.size(), tape.nodes.size() + 1);
            EXPECT_EQ(special.parameterSize, tape.parameterSize);
            for (Sample sample : samples(map, 6, 21)) {
                if (zeroed >= 0) sample.parameters[static_cast<std::size_t>(zeroed)] = 0;
                // A product of 0 with an infinity is what a specialised tape leaves out.
                double out[4];
                interpret(tape, sample.state.data(), sample.parameters.data(),
                          bindings.environment<double>(), out);
                bool finite = true;
                for (std::size_t k = 0; k < tape.outputs.size(); ++k)
                    finite = finite && std::isfinite(out[k]);
                if (finite) expectSame(tape, special, sample, bindings, map.info.name);
            }
        }
    }
}

TEST(Specialise, LeavesTheTermsOfTheQuadraticFamily) {
    const MapKernels& map = *findMap("planar");
    const TestBindings bindings;
    Random random(4);
    const Tape tape = map.trace();
    const auto kept = [&](std::vector<std::string> names) {
        std::vector<char> zero(static_cast<std::size_t>(map.parameters), 1);
        for (int k = 0; k < map.parameters; ++k)
            for (const std::string& name : names)
                if (parameterComponent(map.info, k) == name) zero[static_cast<std::size_t>(k)] = 0;
        const Tape special = specialise(tape, zero);
        for (int i = 0; i < 20; ++i) {
            Sample sample;
            for (int k = 0; k < 2; ++k) sample.state.push_back(random.uniform(-2, 2));
            for (char isZero : zero)
                sample.parameters.push_back(isZero ? 0 : random.uniform(-2, 2));
            expectSame(tape, special, sample, bindings, "planar");
        }
        return special;
    };
    // a x² and b y² take two products each, c xy two more; nothing else is left.
    const Tape quadratic = kept({"g.a2", "g.b2", "g.d", "h.c1", "h.d"});
    EXPECT_EQ(countOf(quadratic, Op::multiply), 6);
    EXPECT_EQ(countOf(quadratic, Op::add), 3);
    EXPECT_EQ(countOf(quadratic, Op::parameter), 5);
    EXPECT_EQ(countOf(tape, Op::multiply), 28);  // by Horner, 14 in each component
    const Tape henon = kept({"g.a2", "g.b1", "g.d", "h.a1"});
    EXPECT_EQ(countOf(henon, Op::multiply), 4);
    EXPECT_EQ(countOf(henon, Op::add), 2);
    // The shader names no coefficient that is 0.
    EXPECT_EQ(glslStep(henon).find("parameters[0]"), std::string::npos);
    EXPECT_NE(glslStep(henon).find("parameters[1]"), std::string::npos);
    // All 0: two constants.
    EXPECT_EQ(kept({}).nodes.size(), 1u);
}

}  // namespace
}  // namespace versorium
