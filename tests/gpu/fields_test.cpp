// SPDX-License-Identifier: MIT
// The GPU measures what the CPU measures, to the precision of 24 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "gpu/gpu_picture.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {
namespace {

constexpr Size kSize{96, 96};

const std::vector<FieldName> kCarried = {
    FieldName::membership,     FieldName::solid,        FieldName::escapeStep,
    FieldName::smoothEscape,   FieldName::squaredNorm,  FieldName::logModulus,
    FieldName::attractionStep, FieldName::imageModulus, FieldName::versor,
    FieldName::argument,
};

bool isWhole(FieldName field) {
    return field == FieldName::membership || field == FieldName::solid ||
           field == FieldName::escapeStep || field == FieldName::attractionStep;
}

// `reference` is the CPU's value.
bool agree(FieldName field, double reference, double value) {
    // Squared norms beyond the range of 32 bits are infinite there, or undefined by ∞ - ∞.
    const double most = field == FieldName::logModulus ? 44.3 : 3e38;
    if (reference > most) return !(value <= 0.99 * most);
    if (std::isnan(reference) || std::isnan(value))
        return std::isnan(reference) && std::isnan(value);
    if (isWhole(field)) return reference == value;
    // Near 0 the logarithm shows rounding errors of the orbit itself: 1e-6 in the modulus.
    if (field == FieldName::logModulus && std::abs(std::exp(reference) - std::exp(value)) < 1e-6)
        return true;
    return std::abs(reference - value) <= 1e-3 * std::max(1.0, std::abs(reference));
}

// How far a start is moved to see whether its value can be asked of 24 bits at all.
constexpr double kShift = 1.0 / (1 << 22);
// Closer than this to the threshold, rounding decides which side a modulus is on (the roots that
// Newton's map ends in have modulus 1).
constexpr double kThreshold = 1e-5;

std::vector<Raster<double>> onProcessor(const Scene& scene, const std::vector<FieldName>& fields) {
    CpuRenderer cpu;
    Job job(1);
    std::vector<Raster<double>> rasters;
    const Status status = cpu.measure(scene, kSize, fields, {}, job, rasters);
    EXPECT_TRUE(status.ok()) << status.message();
    return rasters;
}

// A field agrees in at least `least` percent of the pixels that are well conditioned: those whose
// value the CPU itself keeps when all starts move by kShift. On a chaotic set errors double
// with every step, and 100 steps leave nothing of 24 bits.
void compare(const Scene& scene, double least, const std::vector<FieldName>& fields = kCarried) {
    GpuDevice gpu;
    GpuPicture picture(gpu);
    const Status started = picture.start(scene, kSize);
    ASSERT_TRUE(started.ok()) << scene.map << ": " << started.message();
    const Status finished = picture.finish();
    ASSERT_TRUE(finished.ok()) << scene.map << ": " << finished.message();
    std::vector<Raster<float>> ours;
    const Status read = picture.readFields(fields, ours);
    ASSERT_TRUE(read.ok()) << read.message();
    const auto theirs = onProcessor(scene, fields);
    const auto moduli = onProcessor(scene, {FieldName::logModulus});
    std::vector<std::vector<Raster<double>>> moved;
    // Several ways, since values of a field with few of them agree by chance.
    for (double way : {1.0, -1.0, 2.3, -2.3, 0.6, -0.6}) {
        Scene shifted = scene;
        for (std::size_t k = 0; k < 2; ++k)
            shifted.slice.centreLow[k] += way * (k == 0 ? kShift : 0.7 * kShift);
        moved.push_back(onProcessor(shifted, fields));
    }
    for (std::size_t f = 0; f < fields.size(); ++f) {
        ASSERT_EQ(ours[f].channels(), theirs[f].channels());
        const auto channels = static_cast<std::size_t>(ours[f].channels());
        const std::size_t pixels = ours[f].values().size() / channels;
        std::size_t same = 0, conditioned = 0;
        std::string example;
        for (std::size_t i = 0; i < pixels; ++i) {
            bool all = true, counts = true;
            for (std::size_t at = channels * i; at < channels * (i + 1); ++at) {
                const double reference = theirs[f].values()[at];
                all = all && agree(fields[f], reference, static_cast<double>(ours[f].values()[at]));
                for (const auto& other : moved)
                    counts = counts && agree(fields[f], reference, other[f].values()[at]);
            }
            if (fields[f] == FieldName::solid &&
                std::abs(moduli[0].values()[i] - scene.iso) < kThreshold)
                counts = false;
            if (!counts) continue;
            ++conditioned;
            if (!all && example.empty())
                example = "pixel " + std::to_string(i) + ": " +
                          std::to_string(theirs[f].values()[channels * i]) + " became " +
                          std::to_string(ours[f].values()[channels * i]);
            same += all;
        }
        const double share = 100.0 * static_cast<double>(same) / static_cast<double>(conditioned);
        const std::string name(infoOf(fields[f]).name);
        EXPECT_GE(share, least) << scene.map << ", " << name << ": " << example;
        // A test of hardly any pixels would be none.
        EXPECT_GE(conditioned, pixels / 3) << scene.map << ", " << name;
        if (std::getenv("VERSORIUM_SHOW_SHARES"))
            std::printf("%-36s %-16s %6.2f %% of %zu\n", scene.map.c_str(), name.c_str(), share,
                        conditioned);
    }
}

TEST(GpuFields, EveryMapAtHome) {
    for (const MapKernels& map : catalogue()) {
        Scene scene = sceneOf(map);
        scene.iterations = std::min(scene.iterations, 100);
        // All roots of Newton's map have modulus 1, which iso = 0 would lie upon.
        if (map.info.name == "newton") scene.iso = 0.1;
        compare(scene, 99);
    }
}

TEST(GpuFields, TypedFormulas) {
    for (const char* text :
         {"z^2 + c", "z^3 - a*z + conj(c); a = 0.6",
          "(abs(re(z)) + i*abs(im(z)))^2 + c; c = -0.5 - 0.3i",
          "x' = 1 - a*x^2 + y, y' = b*x; a = 1.2; b = 0.3", "q^2 + c; c = 0.2 + 0.3j"}) {
        Scene scene = *sceneOfMap(text);
        scene.iterations = 60;
        compare(scene, 99);
    }
    for (const char* text : {"shape(z^3 - a*z + c); a = 0.6", "shape(c*q^2 + q)"})
        compare(*sceneOfMap(text), 99);
    // The last step of a sine is an exponential, which no error of a start stands for: of an orbit
    // that has left, only when it left is compared.
    Scene sine = *sceneOfMap("c*sin(z); c = 1 + 0.2i");
    sine.iterations = 60;
    compare(sine, 99,
            {FieldName::membership, FieldName::escapeStep, FieldName::smoothEscape,
             FieldName::imageModulus, FieldName::versor, FieldName::argument});
}

}  // namespace
}  // namespace versorium
