// SPDX-License-Identifier: MIT
#include "image/leaf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "math/elementary.h"

namespace versorium {
namespace {

constexpr int kSamples = 3;     // along each side of a pixel
constexpr double kStalk = 0.1;  // of the height
constexpr double kVeinGap = 0.085;

// 1 at 0, 0 from `width` on.
double ridge(double distance, double width) {
    const double t = std::clamp(1 - std::abs(distance) / width, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

struct Sample {
    double r = 0, g = 0, b = 0, a = 0;
};

// Half the blade's width at t, 0 at the stalk and 1 at the tip.
double halfWidth(double t) {
    const double arch = sin(std::numbers::pi * pow(t, 0.72));
    const double teeth = 0.012 * (1 - std::abs(2 * (t * 19 - std::floor(t * 19)) - 1));
    return arch <= 0 ? 0 : 0.31 * pow(arch, 0.85) + teeth * arch;
}

// x to the right of the middle, y up from the bottom; the picture is 1 wide and 1 high.
Sample leafAt(double x, double y) {
    // The midrib is bent a little.
    const double bent = x - 0.03 * sin(2.6 * y);
    const double t = (y - kStalk) / (0.98 - kStalk);
    const double stalk = 0.011 - 0.004 * y;
    if (t < 0) {
        if (std::abs(bent) > stalk || y < 0.02) return {};
        return {0.16, 0.2, 0.05, 1};
    }
    if (t > 1) return {};
    const double half = halfWidth(t);
    if (std::abs(bent) > half) return {};
    const double out = std::abs(bent) / std::max(half, 1e-9);
    // Side veins leave the midrib upwards and bend towards the tip.
    const double rise = y - 0.62 * std::abs(bent) - 0.55 * bent * bent + (bent > 0 ? 0.03 : 0);
    const double place = rise / kVeinGap;
    const double veins = ridge((place - std::floor(place + 0.5)) * kVeinGap, 0.008) * (1 - out);
    const double fine = 9 * place + 5 * bent / kVeinGap;
    const double net = 0.5 + 0.5 * sin(2 * std::numbers::pi * fine);
    const double midrib = ridge(bent, 0.016 * (1.1 - t));
    const double light = std::max(midrib, 0.6 * veins);
    const double shade = (0.82 + 0.18 * (1 - out)) * (0.95 + 0.05 * net) * (bent > 0 ? 1 : 0.9);
    const std::array<double, 3> blade{0.07 + 0.05 * t, 0.27 + 0.05 * t, 0.035};
    const std::array<double, 3> bright{0.42, 0.55, 0.16};
    const double edge = ridge(1 - out, 0.12) * 0.35;
    const auto mixed = [&](std::size_t k) {
        const double base = blade[k] * shade * (1 - edge);
        return base + light * (bright[k] - base);
    };
    return {mixed(0), mixed(1), mixed(2), 1};
}

}  // namespace

Raster<float> leafImage(int side) {
    Raster<float> image({side, side}, 4);
    const double step = 1.0 / (side * kSamples);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            Sample sum;
            for (int i = 0; i < kSamples; ++i)
                for (int j = 0; j < kSamples; ++j) {
                    const Sample s = leafAt((column * kSamples + j + 0.5) * step - 0.5,
                                            1 - (row * kSamples + i + 0.5) * step);
                    sum.r += s.r * s.a, sum.g += s.g * s.a, sum.b += s.b * s.a, sum.a += s.a;
                }
            const double scale = sum.a > 0 ? 1 / sum.a : 0;
            float* pixel = &image.at(column, row);
            pixel[0] = static_cast<float>(sum.r * scale);
            pixel[1] = static_cast<float>(sum.g * scale);
            pixel[2] = static_cast<float>(sum.b * scale);
            pixel[3] = static_cast<float>(sum.a / (kSamples * kSamples));
        }
    return image;
}

}  // namespace versorium
