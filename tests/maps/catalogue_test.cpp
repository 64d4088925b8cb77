// SPDX-License-Identifier: MIT
#include "maps/catalogue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>

#include "maps/samples.h"
#include "trace/interpret.h"

namespace versorium {
namespace {

template <class T>
bool sameBits(T a, T b) {
    return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

// Orbits of the samples in arrays, as kernels take them.
struct BatchOfSamples {
    OrbitBatch<double> batch;
    std::vector<std::vector<double>> state, parameters, slope;

    BatchOfSamples(const MapKernels& map, const std::vector<Sample>& all,
                   const TestBindings& bindings) {
        batch.count = static_cast<int>(all.size());
        batch.capacity = (batch.count + kBatchPadding - 1) / kBatchPadding * kBatchPadding;
        const auto row = [&](auto component) {
            std::vector<double> values(static_cast<std::size_t>(batch.capacity), 0.0);
            for (std::size_t i = 0; i < all.size(); ++i) values[i] = component(all[i]);
            return values;
        };
        for (std::size_t k = 0; k < static_cast<std::size_t>(map.dimension); ++k) {
            state.push_back(row([&](const Sample& s) { return s.state[k]; }));
            slope.push_back(row([&](const Sample&) { return k == 0 ? 1.0 : 0.5; }));
        }
        for (std::size_t k = 0; k < static_cast<std::size_t>(map.parameters); ++k)
            parameters.push_back(row([&](const Sample& s) { return s.parameters[k]; }));
        for (std::size_t k = 0; k < state.size(); ++k) batch.state[k] = state[k].data();
        for (std::size_t k = 0; k < slope.size(); ++k) batch.slope[k] = slope[k].data();
        for (std::size_t k = 0; k < parameters.size(); ++k)
            batch.parameters[k] = {parameters[k].data(), true};
        batch.lists[0] = &bindings.roots;
        batch.lists[1] = &bindings.poles;
        batch.field = &bindings.field;
        batch.program = map.program();
    }
};

template <class T>
std::vector<T> as(const std::vector<double>& values) {
    return std::vector<T>(values.begin(), values.end());
}

TEST(EveryMap, HasANameOfItsOwn) {
    std::set<std::string_view> names;
    for (const MapKernels& map : catalogue())
        EXPECT_TRUE(names.insert(map.info.name).second) << map.info.name;
    EXPECT_EQ(findMap("quadratic")->info.title, "Quadratic family");
    EXPECT_EQ(findMap("no-such-map"), nullptr);
}

TEST(EveryMap, BatchEqualsScalarInTheExactFlavour) {
    const TestBindings bindings;
    for (const MapKernels* tested : testedMaps())
        for (const KernelTarget& target : kernelTargets()) {
            if (target.flavour != Flavour::exact) continue;
            const MapKernels& map = *tested;
            const auto all = samples(map, 50, 7);
            BatchOfSamples batch(map, all, bindings);
            target.advance[map.index](batch.batch);
            for (std::size_t i = 0; i < all.size(); ++i) {
                // Same operations in the same order and no contraction: no tolerance is owed.
                auto z = all[i].state;
                map.step(z.data(), all[i].parameters.data(), bindings.environment<double>());
                for (std::size_t k = 0; k < z.size(); ++k) {
                    EXPECT_TRUE(sameBits(batch.state[k][i], z[k]))
                        << map.info.name << " " << map.info.formula << " on " << target.name
                        << ", sample " << i << ": " << batch.state[k][i] << " and " << z[k];
                }
            }
        }
}

TEST(EveryMap, TapeEqualsScalar) {
    const TestBindings bindings;
    for (const MapKernels* tested : testedMaps()) {
        const MapKernels& map = *tested;
        const Tape tape = map.trace();
        for (const Sample& sample : samples(map, 50, 8)) {
            auto z = sample.state;
            map.step(z.data(), sample.parameters.data(), bindings.environment<double>());
            std::vector<double> out(z.size());
            interpret(tape, sample.state.data(), sample.parameters.data(),
                      bindings.environment<double>(), out.data());
            for (std::size_t k = 0; k < z.size(); ++k)
                EXPECT_TRUE(sameBits(out[k], z[k]))
                    << map.info.name << ": " << out[k] << " and " << z[k];
        }
    }
}

TEST(EveryMap, TapeOfAnEmptyListEqualsScalar) {
    TestBindings bindings;
    bindings.roots.clear();
    bindings.poles.clear();
    const MapKernels& map = *findMap("quaternion-rational");
    const Tape tape = map.trace();
    const Sample sample = samples(map, 1, 8)[0];
    auto z = sample.state;
    map.step(z.data(), sample.parameters.data(), bindings.environment<double>());
    double out[4];
    interpret(tape, sample.state.data(), sample.parameters.data(), bindings.environment<double>(),
              out);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(out[k], z[k]);
    EXPECT_EQ(out[0], 1);  // the empty product
}

TEST(EveryMap, DualEqualsFiniteDifferences) {
    const TestBindings bindings;
    for (const MapKernels* tested : testedMaps())
        for (const Sample& sample : samples(*tested, 30, 9)) {
            const MapKernels& map = *tested;
            const std::size_t inputs = sample.state.size() + sample.parameters.size();
            for (std::size_t input = 0; input < inputs; ++input) {
                const bool ofState = input < sample.state.size();
                const std::size_t own = ofState ? input : input - sample.state.size();
                // Whole exponents and switches are not differentiated (math/power.h).
                if (!ofState) {
                    const std::string name = parameterComponent(map.info, static_cast<int>(own));
                    if (name == "power" || name == "tau" || name == "exponent_beta" ||
                        name == "drop" || name == "as_printed")
                        continue;
                }
                std::vector<DualNumber> z, p;
                for (double value : sample.state) z.push_back({value, 0.0});
                for (double value : sample.parameters) p.push_back({value, 0.0});
                (ofState ? z[own] : p[own]).slope = 1;
                map.stepDual(z.data(), p.data(), bindings.environment<DualNumber>());

                const double h = 1e-6;
                std::vector<double> ends[2];
                for (int side = 0; side < 2; ++side) {
                    auto state = sample.state;
                    auto parameters = sample.parameters;
                    (ofState ? state[own] : parameters[own]) += side == 0 ? -h : h;
                    map.step(state.data(), parameters.data(), bindings.environment<double>());
                    ends[side] = state;
                }
                for (std::size_t k = 0; k < z.size(); ++k) {
                    const double difference = (ends[1][k] - ends[0][k]) / (2 * h);
                    // Third derivatives times h² and rounding over h, both well below this; a jump
                    // of a derivative between the two ends (|x|, the nearest face of a shape) is a
                    // rare exception that the scale of the second half lets pass by.
                    const double scale = 1 + std::abs(difference) + std::abs(z[k].value);
                    EXPECT_NEAR(z[k].slope, difference, 2e-6 * scale * scale)
                        << map.info.name << " by input " << input << ", output " << k;
                }
            }
        }
}

TEST(EveryMap, IsSymmetricUnderConjugationWhereItSaysSo) {
    const TestBindings bindings;
    const auto conjugate = [](double* numbers, int width) {
        for (int k = 1; k < width; ++k) numbers[k] = -numbers[k];
    };
    int symmetric = 0;
    for (const MapKernels& map : catalogue()) {
        if (!map.info.conjugation) continue;
        ++symmetric;
        for (const Sample& sample : samples(map, 50, 10)) {
            auto z = sample.state;
            map.step(z.data(), sample.parameters.data(), bindings.environment<double>());
            conjugate(z.data(), map.dimension);
            auto mirrored = sample.state;
            auto parameters = sample.parameters;
            conjugate(mirrored.data(), map.dimension);
            double* at = parameters.data();
            for (const ParameterInfo& parameter : map.info.parameters) {
                conjugate(at, widthOf(parameter.kind));
                at += widthOf(parameter.kind);
            }
            map.step(mirrored.data(), parameters.data(), bindings.environment<double>());
            for (std::size_t k = 0; k < z.size(); ++k)
                EXPECT_EQ(mirrored[k], z[k]) << map.info.name;
        }
    }
    EXPECT_GE(symmetric, 5);
}

// A eq 7: the planar form of z² + c, and a cubic z³ + a z + b written out.
TEST(Planar, OneStepIsTheComplexMaps) {
    const MapKernels &planar = *findMap("planar"), &cubic = *findMap("cubic");
    const TestBindings bindings;
    Random random(12);
    for (int i = 0; i < 200; ++i) {
        double z[2], a[2], b[2];
        for (double* pair : {z, a, b})
            for (int k = 0; k < 2; ++k) pair[k] = random.uniform(-1.5, 1.5);
        const double complexParameters[] = {a[0], a[1], b[0], b[1]};
        double expected[2] = {z[0], z[1]};
        cubic.step(expected, complexParameters, bindings.environment<double>());

        // (x + iy)³ = x³ - 3xy² + i (3x²y - y³); (a + ia')(x + iy) = ax - a'y + i (a'x + ay).
        std::vector<double> k(30, 0.0);
        k[0] = a[0], k[2] = 1, k[4] = -a[1], k[10] = -3, k[12] = b[0];
        k[15] = a[1], k[19] = a[0], k[21] = -1, k[24] = 3, k[27] = b[1];
        double found[2] = {z[0], z[1]};
        planar.step(found, k.data(), bindings.environment<double>());
        // A handful of roundings of terms up to about 30.
        for (int c = 0; c < 2; ++c) EXPECT_NEAR(found[c], expected[c], 30 * 8 * 1.2e-16);
    }
}

TEST(Quaternions, RestrictedToAPlaneAreTheComplexMaps) {
    const TestBindings bindings;
    const struct {
        const char *quaternion, *complex;
        bool hasPower;
    } pairs[] = {{"quaternion-quadratic", "quadratic", false},
                 {"bicomplex-quadratic", "quadratic", false},
                 {"quaternion-cubic", "power", true}};
    Random random(13);
    for (const auto& pair : pairs)
        for (int i = 0; i < 100; ++i) {
            double z[4] = {random.uniform(-1, 1), random.uniform(-1, 1), 0, 0};
            const double c[4] = {random.uniform(-1, 1), random.uniform(-1, 1), 0, 0};
            double w[2] = {z[0], z[1]};
            const double complexParameters[] = {pair.hasPower ? 3 : c[0],
                                                pair.hasPower ? c[0] : c[1], c[1]};
            findMap(pair.complex)->step(w, complexParameters, bindings.environment<double>());
            findMap(pair.quaternion)->step(z, c, bindings.environment<double>());
            // The same polynomial with its terms in another order: a few roundings of numbers
            // up to 10.
            EXPECT_NEAR(z[0], w[0], 1e-14) << pair.quaternion;
            EXPECT_NEAR(z[1], w[1], 1e-14) << pair.quaternion;
            EXPECT_EQ(z[2], 0);
            EXPECT_EQ(z[3], 0);
        }
}

TEST(Quaternions, RationalMapRestrictedToAPlaneIsTheComplexOne) {
    TestBindings bindings;
    for (BoundList* list : {&bindings.roots, &bindings.poles})
        for (auto& root : *list) root.q[2] = root.q[3] = 0;
    const MapKernels &q = *findMap("quaternion-rational"), &c = *findMap("complex-rational");
    Random random(14);
    for (int i = 0; i < 200; ++i) {
        const double parameters[] = {random.uniform(-1, 1), 1, 1};
        // Both real powers use principal branches; quaternions see the imaginary part's sign in
        // the direction of the vector part, so the two agree on the whole plane.
        double z[4] = {random.uniform(-1, 1), random.uniform(-1, 1), 0, 0};
        double w[2] = {z[0], z[1]};
        q.step(z, parameters, bindings.environment<double>());
        c.step(w, parameters, bindings.environment<double>());
        const double size = 1 + std::abs(w[0]) + std::abs(w[1]);
        EXPECT_NEAR(z[0], w[0], 1e-12 * size);
        EXPECT_NEAR(z[1], w[1], 1e-12 * size);
    }
}

// Mandelbulb with exponent 1 is p + c, and whole exponents agree with the angles of R eq 1.
TEST(Mandelbulb, MultipliesTheAngles) {
    const MapKernels& map = *findMap("mandelbulb");
    const TestBindings bindings;
    Random random(15);
    for (double exponent : {1.0, 2.0, 3.0, 8.0, 2.5}) {
        for (int i = 0; i < 100; ++i) {
            double p[3];
            for (double& x : p) x = random.uniform(-1, 1);
            const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            const double theta = std::atan2(std::hypot(p[0], p[1]), p[2]);
            const double phi = std::atan2(p[1], p[0]);
            const double scale = std::pow(r, exponent);
            const double expected[] = {
                scale * std::sin(exponent * theta) * std::cos(exponent * phi),
                scale * std::sin(exponent * theta) * std::sin(exponent * phi),
                scale * std::cos(exponent * theta)};
            const double parameters[] = {exponent, 0, 0, 0};
            map.step(p, parameters, bindings.environment<double>());
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(p[k], expected[k], 1e-13 * (1 + scale)) << exponent;
        }
    }
    double axis[3] = {0, 0, 0.5};
    const double parameters[] = {8, 0, 0, 0};
    map.step(axis, parameters, bindings.environment<double>());
    EXPECT_EQ(axis[0], 0);
    EXPECT_EQ(axis[2], 1.0 / 256);
}

// |f| is the modulus that the field asks for, whatever the direction does (S eq 3).
TEST(ShapeModulus, HasTheModulusOfTheShape) {
    const TestBindings bindings;
    int seen = 0;
    for (const MapKernels& map : catalogue()) {
        if (!map.info.field) continue;
        ++seen;
        for (const Sample& sample : samples(map, 50, 16)) {
            auto z = sample.state;
            auto parameters = sample.parameters;
            parameters[2] = 0;
            map.step(z.data(), parameters.data(), bindings.environment<double>());
            double x[4] = {};
            for (std::size_t k = 0; k < z.size(); ++k) x[k] = sample.state[k] - parameters[3 + k];
            const double phi = bindings.field.at(x[0], x[1], map.dimension == 2 ? 0.0 : x[2]);
            double norm = 0;
            for (double part : z) norm += part * part;
            EXPECT_NEAR(std::sqrt(norm), std::exp(parameters[0] * (phi - parameters[1])),
                        1e-13 * std::sqrt(norm))
                << map.info.name;
        }
    }
    EXPECT_GE(seen, 5);
}

}  // namespace
}  // namespace versorium
