// SPDX-License-Identifier: MIT
#include "plate/canvas.h"

#include <gtest/gtest.h>

#include <cmath>

namespace versorium {
namespace {

// White drawn on black: the sum of the light is the area covered.
double area(const Canvas& canvas) {
    double sum = 0;
    for (int y = 0; y < canvas.size().height; ++y)
        for (int x = 0; x < canvas.size().width; ++x)
            sum += static_cast<double>(canvas.pixels().at(x, y));
    return sum;
}
const Colour kWhite{1, 1, 1}, kBlack{0, 0, 0};

TEST(Canvas, RectanglesCoverTheirArea) {
    Canvas canvas({40, 40}, kBlack);
    canvas.fillRect({3.25, 4.5, 17.75, 20.125}, kWhite);
    // Float pixels: 24 bits each.
    EXPECT_NEAR(area(canvas), 14.5 * 15.625, 1e-3);
}

TEST(Canvas, DiscsAndPolygonsCoverTheirArea) {
    Canvas disc({60, 60}, kBlack);
    disc.disc({30.3, 29.6}, 20, kWhite);
    // Coverage is that of a half-plane: the curvature of a circle costs less than 1/1000.
    EXPECT_NEAR(area(disc), 3.14159265 * 400, 1.5);
    Canvas triangle({60, 60}, kBlack);
    triangle.polygon({{5, 5}, {50, 12}, {20, 44}}, kWhite);
    // Half the cross product; corners and slanted edges each lose a fraction of a pixel.
    EXPECT_NEAR(area(triangle), 0.5 * (45 * 39 - 15 * 7), 12);
}

TEST(Canvas, LinesHaveTheirWidth) {
    for (const double width : {0.4, 1.0, 2.5, 7.0}) {
        for (const Point end : {Point{90, 20}, Point{20, 90}, Point{80, 80}, Point{70, 45}}) {
            Canvas canvas({120, 120}, kBlack);
            canvas.polyline({{20, 20}, end}, width, kWhite);
            const double length = std::hypot(end.x - 20, end.y - 20);
            // Sides are exact; the round ends together π/4 w² and up to a pixel of blur.
            EXPECT_NEAR(area(canvas), length * width + 0.785 * width * width,
                        0.003 * length * width + 0.5 + 0.1 * width)
                << width << " to " << end.x << "," << end.y;
        }
    }
    Canvas crisp({10, 10}, kBlack);
    crisp.polyline({{-5, 5}, {15, 5}}, 2, kWhite);
    EXPECT_EQ(crisp.pixels().at(5, 4), 1);
    EXPECT_EQ(crisp.pixels().at(5, 6), 0);
}

TEST(Canvas, JointsAreNotDrawnTwice) {
    Canvas canvas({60, 60}, kBlack);
    canvas.polyline({{10, 30}, {30, 30}, {50, 30}}, 4, {1, 1, 1, 0.5});
    EXPECT_NEAR(static_cast<double>(canvas.pixels().at(30, 30)), 0.5, 1e-6);
}

TEST(Canvas, DashesLeaveGaps) {
    Canvas solid({220, 20}, kBlack), dashed({220, 20}, kBlack);
    solid.polyline({{10, 10}, {210, 10}}, 2, kWhite);
    dashed.polyline({{10, 10}, {60, 10}, {210, 10}}, 2, kWhite, {10, 10});
    // Ten dashes of 10 with round ends of together π against one line of 200.
    EXPECT_NEAR(area(dashed), 10 * (20 + 3.14), 6);
    EXPECT_NEAR(area(solid), 400 + 3.14, 3);
}

TEST(Canvas, PicturesAreCompositedInLinearLight) {
    Raster<float> half({2, 2}, 4, 0.5F);
    for (int i = 0; i < 4; ++i) half.values()[static_cast<std::size_t>(4 * i + 1)] = 1;
    Canvas canvas({4, 4}, kBlack);
    canvas.picture(3, -1, half);
    EXPECT_FLOAT_EQ(canvas.pixels().at(3, 0, 0), 0.25F);
    EXPECT_FLOAT_EQ(canvas.pixels().at(3, 0, 1), 0.5F);
    EXPECT_EQ(canvas.pixels().at(2, 0, 0), 0);
    EXPECT_EQ(canvas.encode().channels(), 3);
}

}  // namespace
}  // namespace versorium
