// SPDX-License-Identifier: MIT
// The graphics processor measures what the processor measures, to the precision of 24 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

bool agree(FieldName field, double one, double other) {
    if (std::isnan(one) || std::isnan(other)) return std::isnan(one) && std::isnan(other);
    // Beyond the range of 32 bits everything is infinite.
    if (std::abs(one) > 3e38 && std::abs(other) > 3e38) return (one > 0) == (other > 0);
    if (isWhole(field)) return one == other;
    return std::abs(one - other) <= 1e-3 * std::max(1.0, std::abs(one));
}

// Finishes, or fails the test.
void finish(GpuPicture& picture) {
    for (int i = 0; i < 100000 && !picture.advance(0.05); ++i) {
    }
    ASSERT_EQ(picture.state(), GpuPicture::State::finished) << picture.status().message();
}

// Share of the pixels where a field agrees, in percent; the least over all carried fields.
void compare(const Scene& scene, double least, const std::vector<FieldName>& fields = kCarried) {
    GpuRenderer gpu;
    GpuPicture picture(gpu);
    const Status started = picture.start(scene, kSize);
    ASSERT_TRUE(started.ok()) << scene.map << ": " << started.message();
    finish(picture);
    std::vector<Raster<float>> ours;
    const Status read = picture.readFields(fields, ours);
    ASSERT_TRUE(read.ok()) << read.message();
    CpuRenderer cpu;
    Job job(1);
    std::vector<Raster<double>> theirs;
    ASSERT_TRUE(cpu.measure(scene, kSize, fields, {}, job, theirs).ok());
    for (std::size_t f = 0; f < fields.size(); ++f) {
        ASSERT_EQ(ours[f].channels(), theirs[f].channels());
        const auto channels = static_cast<std::size_t>(ours[f].channels());
        const std::size_t pixels = ours[f].values().size() / channels;
        std::size_t same = 0;
        std::string example;
        for (std::size_t i = 0; i < pixels; ++i) {
            bool all = true;
            for (std::size_t c = 0; c < channels; ++c)
                all = all && agree(fields[f], theirs[f].values()[channels * i + c],
                                   static_cast<double>(ours[f].values()[channels * i + c]));
            if (!all && example.empty())
                example = "pixel " + std::to_string(i) + ": " +
                          std::to_string(theirs[f].values()[channels * i]) + " became " +
                          std::to_string(ours[f].values()[channels * i]);
            same += all;
        }
        const double share = 100.0 * static_cast<double>(same) / static_cast<double>(pixels);
        const std::string name(infoOf(fields[f]).name);
        EXPECT_GE(share, least) << scene.map << ", " << name << ": " << example;
        testing::Test::RecordProperty(scene.map + "." + name, std::to_string(share));
        if (std::getenv("VERSORIUM_SHOW_SHARES"))
            std::printf("%-32s %-16s %.2f %%\n", scene.map.c_str(), name.c_str(), share);
    }
}

TEST(GpuFields, EveryMapAtHome) {
    for (const MapKernels& map : catalogue()) {
        Scene scene = sceneOf(map);
        scene.iterations = std::min(scene.iterations, 100);
        compare(scene, 99);
    }
}

}  // namespace
}  // namespace versorium
