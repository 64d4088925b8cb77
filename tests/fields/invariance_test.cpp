// SPDX-License-Identifier: MIT
// What must never change a field: shortcuts, and how points are split among calls.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/random.h"
#include "fields/programs.h"
#include "maps/samples.h"

namespace versorium {
namespace {

using enum FieldName;

constexpr FieldName kEscapeFields[] = {membership,  solid,      escapeStep, smoothEscape,
                                       squaredNorm, logModulus, period};
// Without those that need the last iterate of orbits inside.
constexpr FieldName kStepFields[] = {membership, escapeStep, smoothEscape};

bool sameBits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), 8 * a.size()) == 0;
}

struct Points {
    std::vector<double> u, v, w;
    Points(int count, double centreU, double centreV, double reach, std::uint64_t seed) {
        Random random(seed);
        for (int i = 0; i < count; ++i) {
            u.push_back(centreU + random.uniform(-reach, reach));
            v.push_back(centreV + random.uniform(-reach, reach));
            w.push_back(random.uniform(-reach, reach));
        }
        // Also points where shortcuts take hold at once, and such that only just do not.
        u[0] = -1, v[0] = 0, u[1] = 0, v[1] = 0, u[2] = 0.25, v[2] = 0, u[3] = -0.75, v[3] = 0;
    }
    std::vector<std::vector<double>> evaluate(const OrbitProgram& program,
                                              std::span<const FieldName> fields,
                                              const EvaluateOptions& options) const {
        const double* pointers[3] = {u.data(), v.data(), w.data()};
        return evaluateFields(program, static_cast<int>(u.size()), pointers, fields, options);
    }
};

TEST(Shortcuts, NeverChangeAField) {
    std::vector<OrbitProgram> programs{
        programOf("quadratic", {}, {{"c.re"}, {"c.im"}}, 0, 2),
        programOf("quadratic", {{"z.re", 0.1}}, {{"c.re"}, {"c.im"}}, 0, 2),
        programOf("quadratic", {{"c.re", -1}, {"c.im", 0}}, {{"z.re"}, {"z.im"}}, 0, 2),
        programOf("quadratic", {}, {{"z.re"}, {"z.im"}}, 0, 2),
        programOf("quadratic", {}, {{"z.re", "c.im"}, {"c.re"}}, 0, 2),
        programOf("quaternion-quadratic", {}, {{"c.w"}, {"c.x"}, {"q.y"}}, 0, 2),
        programOf("real-quadratic", {}, {{"c"}, {"x"}}, 0, 2),
        programOf("cubic", {}, {{"a.re"}, {"b.im"}}, 0, 4),
    };
    OrbitProgram critical = programs[0];
    critical.critical = 0;
    programs.push_back(critical);
    const Points points(160, -0.6, 0, 1.2, 61);
    for (std::size_t p = 0; p < programs.size(); ++p)
        for (double radius : {2.0, 4.0, 100.0, 1.5})
            for (int iterations : {0, 1, 2, 63, 64, 65, 131, 500, 3001})
                for (const bool last : {true, false}) {
                    OrbitProgram program = programs[p];
                    program.escapeRadius = radius;
                    program.iterations = iterations;
                    const auto fields = last ? std::span<const FieldName>(kEscapeFields)
                                             : std::span<const FieldName>(kStepFields);
                    const auto with = points.evaluate(program, fields, {Flavour::exact, true});
                    const auto without = points.evaluate(program, fields, {Flavour::exact, false});
                    for (std::size_t f = 0; f < fields.size(); ++f)
                        EXPECT_TRUE(sameBits(with[f], without[f]))
                            << "program " << p << ", R " << radius << ", N " << iterations << ", "
                            << infoOf(fields[f]).name << (last ? " and last iterates" : "");
                }
}

TEST(Fields, DoNotDependOnHowPointsAreSplit) {
    std::vector<FieldName> fields;
    for (const FieldInfo& info : allFields()) fields.push_back(info.field);
    const TestBindings bindings;
    const Points points(131, 0, 0, 1, 62);
    for (const MapKernels& map : catalogue()) {
        const Sample sample = samples(map, 2, 63)[1];
        OrbitProgram program;
        program.map = &map;
        for (std::size_t k = 0; k < map.info.lists.size(); ++k)
            program.lists.push_back(k == 0 ? bindings.roots : bindings.poles);
        program.field = std::make_shared<const DistanceField>(bindings.field);
        program.slice.origin = sample.state;
        program.slice.origin.insert(program.slice.origin.end(), sample.parameters.begin(),
                                    sample.parameters.end());
        // A component of a root lies on an axis where there are roots.
        if (!program.lists.empty()) {
            program.overrides.push_back({0, 1, 0});
            program.slice.origin.push_back(0.25);
        }
        program.slice.axes.assign(2, std::vector<double>(program.slice.origin.size(), 0.0));
        program.slice.axes[0][0] = 1;
        program.slice.axes[1].back() = 0.5;
        program.iterations = 9;
        program.escapeRadius = std::isinf(map.info.escapeRadius) ? 5 : map.info.escapeRadius;
        program.degree = map.info.degree;
        const auto whole = points.evaluate(program, fields, {});
        for (const std::size_t part : {std::size_t{1}, std::size_t{50}}) {
            std::vector<std::vector<double>> joined(fields.size());
            for (std::size_t f = 0; f < fields.size(); ++f) joined[f].resize(whole[f].size());
            for (std::size_t first = 0; first < points.u.size(); first += part) {
                const std::size_t size = std::min(part, points.u.size() - first);
                const double* pointers[3] = {points.u.data() + first, points.v.data() + first,
                                             points.w.data() + first};
                const auto own =
                    evaluateFields(program, static_cast<int>(size), pointers, fields, {});
                for (std::size_t f = 0; f < fields.size(); ++f)
                    for (std::size_t k = 0; k < own[f].size(); ++k)
                        joined[f][k / size * points.u.size() + first + k % size] = own[f][k];
            }
            for (std::size_t f = 0; f < fields.size(); ++f)
                EXPECT_TRUE(sameBits(joined[f], whole[f]))
                    << map.info.name << ", " << infoOf(fields[f]).name << ", by " << part;
        }
        // A field is the same whatever else is asked for.
        for (std::size_t f = 0; f < fields.size(); ++f) {
            const FieldName alone[] = {fields[f]};
            EXPECT_TRUE(sameBits(points.evaluate(program, alone, {})[0], whole[f]))
                << map.info.name << ", " << infoOf(fields[f]).name << " alone";
        }
    }
}

TEST(Fields, KnowOneNan) {
    OrbitProgram program = programOf("quadratic", {}, {{"z.re"}, {"z.im"}}, 20, 2);
    Points points(8, 0, 0, 1, 64);
    points.u[5] = -std::nan(""), points.u[6] = HUGE_VAL, points.u[7] = 1e200;
    std::vector<FieldName> fields;
    for (const FieldInfo& info : allFields()) fields.push_back(info.field);
    const double canonical = std::numeric_limits<double>::quiet_NaN();
    for (const auto& field : points.evaluate(program, fields, {}))
        for (double value : field)
            EXPECT_TRUE(!std::isnan(value) || std::memcmp(&value, &canonical, 8) == 0);
}

}  // namespace
}  // namespace versorium
