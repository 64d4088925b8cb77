// SPDX-License-Identifier: MIT
#include "shape/radial_profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shape/bounds.h"

namespace versorium {
namespace {

DistanceField fieldOf(const char* text) { return DistanceField(*parseShape(text)); }

RadialProfile profileOf(const DistanceField& field, RadialOptions options) {
    Job job(1);
    Expected<RadialProfile> profile = radialProfile(field, options, job);
    EXPECT_TRUE(profile.ok()) << profile.status().message();
    return std::move(*profile);
}

TEST(RadialProfile, OfADiscAndASphereIsTheRadiusLessTheirs) {
    const RadialProfile disc = profileOf(fieldOf("disc(0.7)"), {.to = 3, .radii = 31});
    const RadialProfile ball =
        profileOf(fieldOf("sphere(0.7)"), {.dimensions = 3, .to = 3, .radii = 31, .points = 1024});
    for (std::size_t i = 0; i < disc.radius.size(); ++i) {
        EXPECT_NEAR(disc.mean[i], disc.radius[i] - 0.7, 1e-12);
        EXPECT_NEAR(ball.mean[i], ball.radius[i] - 0.7, 1e-12);
        EXPECT_NEAR(disc.modulus[i], std::exp(8 * (disc.radius[i] - 0.7)), 1e-11 * disc.modulus[i]);
    }
}

// Inside, φ = max(|x|, |y|) - a, whose mean on the circle is 2√2 r/π - a; outside, quadrature.
TEST(RadialProfile, OfASquare) {
    const double a = 0.5;
    const RadialProfile profile = profileOf(fieldOf("box(0.5, 0.5)"), {.to = 2, .radii = 41});
    for (std::size_t i = 0; i < profile.radius.size(); ++i) {
        const double r = profile.radius[i];
        double expected = 2 * std::sqrt(2.0) * r / M_PI - a;
        // Only the sides' own part of the circle is inside; from r = a on, other formulas hold.
        if (r > a) {
            const int count = 400000;
            expected = 0;
            for (int k = 0; k < count; ++k) {
                const double t = (k + 0.5) * M_PI / 4 / count;
                const double dx = r * std::cos(t) - a, dy = r * std::sin(t) - a;
                expected += dx > 0 && dy > 0 ? std::hypot(dx, dy) : std::max(dx, dy);
            }
            expected /= count;
        }
        // 4096 midpoints; the integrand has corners: an error of a few r / 4096².
        EXPECT_NEAR(profile.mean[i], expected, 1e-6) << r;
        EXPECT_LE(profile.low[i], expected + 1e-12);
        EXPECT_GE(profile.high[i], r - a - 1e-12);
    }
    // While the circle lies in the square's circumscribed circle the first formula holds, since
    // max(|x|, |y|) - a is the distance wherever one of |x|, |y| is at most a.
    const RadialProfile near =
        profileOf(fieldOf("box(0.5, 0.5)"), {.to = std::sqrt(2.0) * a, .radii = 41});
    for (std::size_t i = 0; i < near.radius.size(); ++i)
        EXPECT_NEAR(near.mean[i], 2 * std::sqrt(2.0) * near.radius[i] / M_PI - a, 1e-6);
}

// The fixed points of r -> e^{α(r - a)} part capture from escape.
TEST(RadialProfile, CertainRadiiOfADiscAreTheFixedPoints) {
    const double alpha = 8, a = 0.7;
    const RadialProfile profile =
        profileOf(fieldOf("disc(0.7)"), {.alpha = alpha, .to = 2, .radii = 2001});
    double upper = 1;
    for (int i = 0; i < 200; ++i) upper = a + std::log(upper) / alpha;
    // A gap of 2/2000 and one of 20/4096 between the radii that are looked at.
    EXPECT_LE(profile.capture, upper);
    EXPECT_GT(profile.capture, upper - 0.005);
    EXPECT_GE(profile.escape, upper);
    EXPECT_LT(profile.escape, upper + 0.02);
    // No trap: e^{α(φ - β)} > r everywhere.
    EXPECT_EQ(profileOf(fieldOf("disc(0.1)"), {}).capture, 0);
}

TEST(RadialProfile, ShiftsWithTheShapeAndRefusesNonsense) {
    const RadialProfile profile =
        profileOf(fieldOf("disc(0.7)"), {.shift = {0.4, 0, 0}, .to = 1, .radii = 11});
    EXPECT_NEAR(profile.mean[0], 0.4 - 0.7, 1e-12);  // a sum of 4096
    Job job(1);
    const DistanceField disc = fieldOf("disc(0.7)");
    for (const RadialOptions& bad :
         {RadialOptions{.dimensions = 4}, RadialOptions{.alpha = NAN}, RadialOptions{.to = 0},
          RadialOptions{.radii = 1}, RadialOptions{.points = -1}})
        EXPECT_EQ(radialProfile(disc, bad, job).status().kind(), ErrorKind::usage);
    job.cancel();
    EXPECT_EQ(radialProfile(disc, {}, job).status().kind(), ErrorKind::cancelled);
}

TEST(ShapeBounds, HoldTheShape) {
    const ShapeBounds box = boundsOf(fieldOf("translate(1, 2, 3, box(0.5, 0.25, 1))"), 3);
    const double low[3] = {0.5, 1.75, 2}, high[3] = {1.5, 2.25, 4};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_LE(box.low[k], low[k]);
        EXPECT_GE(box.high[k], high[k]);
        // Two cells of 1/24 of the box, which is twice the shape's largest extent at most.
        EXPECT_GT(box.low[k], low[k] - 0.25);
        EXPECT_LT(box.high[k], high[k] + 0.25);
    }
    // A prism has no end along z.
    EXPECT_EQ(boundsOf(fieldOf("disc(2)"), 3).high[2], 0.5);
    EXPECT_GE(boundsOf(fieldOf("disc(2)"), 2).high[0], 2);
    EXPECT_TRUE(boundsOf(fieldOf("intersection(disc(0.1), translate(3, 0, disc(0.1)))"), 2).empty);
}

}  // namespace
}  // namespace versorium
