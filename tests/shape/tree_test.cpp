// SPDX-License-Identifier: MIT
#include "shape/tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "shape/distance.h"
#include "shape/gallery.h"

namespace versorium {
namespace {

ShapeTree shapeOf(const std::string& text) {
    Expected<ShapeTree> shape = parseShape(text);
    EXPECT_TRUE(shape.ok()) << text << ": " << shape.status().message();
    return shape.ok() ? *shape : *ShapeTree::make(ShapeKind::disc, {1.0});
}

double at(const ShapeTree& shape, double x, double y, double z = 0) {
    return distance(shape, x, y, z);
}
double at(const char* text, double x, double y, double z = 0) { return at(shapeOf(text), x, y, z); }

// Values are of order 1 and made of fewer than 100 rounded operations.
constexpr double kRounding = 1e-14;

TEST(Shape, ClosedForms) {
    EXPECT_NEAR(at("disc(0.4)", 0.3, 0.4, 7), 0.1, kRounding);
    EXPECT_NEAR(at("sphere(0.4)", 2, 3, 6), 6.6, kRounding);
    EXPECT_NEAR(at("box(1, 2)", 4, 6, 9), 5, kRounding);
    EXPECT_NEAR(at("box(1, 2)", 0.5, 0, 9), -0.5, kRounding);
    EXPECT_NEAR(at("box(1, 2, 3)", 3, 4, 4), 3, kRounding);
    EXPECT_NEAR(at("box(1, 2, 3)", 0, 0, 0), -1, kRounding);
    EXPECT_NEAR(at("torus(1, 0.25)", 0, -1, 0.5), 0.25, kRounding);
    EXPECT_NEAR(at("torus(1, 0.25)", 0, 0, 0), 0.75, kRounding);
    EXPECT_NEAR(at("capsule(1, 0.5)", 0, 4, 4), 4.5, kRounding);
    EXPECT_NEAR(at("capsule(1, 0.5)", 0.25, 0.7, 0), -0.25, kRounding);
    EXPECT_NEAR(at("half_space(0, 2, 0, 0.5)", 9, 2, 9), 1.5, kRounding);
    EXPECT_NEAR(at("translate(1, 2, 3, sphere(1))", 1, 2, 5), 1, kRounding);
    EXPECT_NEAR(at("scale(3, sphere(1))", 0, 6, 0), 3, kRounding);
    // A quarter turn takes the long side to y.
    EXPECT_NEAR(at("rotate(1.5707963267948966, box(2, 1))", 0, 2.5), 0.5, kRounding);
    EXPECT_NEAR(at("difference(disc(2), disc(1))", 0.5, 0), 0.5, kRounding);
    EXPECT_NEAR(at("smooth_union(0.4, disc(1), disc(1))", 1, 0), -0.1, kRounding);
}

TEST(Shape, StarHeartAndCrescentAtTheirCorners) {
    const double outer = 0.45, inner = 0.2;
    for (int k = 0; k < 10; ++k) {
        const double angle = M_PI / 2 + k * M_PI / 5, radius = k % 2 == 0 ? outer : inner;
        EXPECT_NEAR(at("star(5, 0.45, 0.2)", radius * std::cos(angle), radius * std::sin(angle)), 0,
                    kRounding);
        // Straight out of a point of the star, the point is the nearest.
        if (k % 2 == 0) {
            EXPECT_NEAR(at("star(5, 0.45, 0.2)", std::cos(angle), std::sin(angle)), 1 - outer,
                        kRounding);
        }
    }
    // A star of equal radii is a regular polygon: at its centre the distance is the apothem.
    EXPECT_NEAR(at("star(3, 1, 1)", 0, 0), -std::cos(M_PI / 6), kRounding);
    const double side = 2 - std::sqrt(2.0), height = side * (0.75 * std::sqrt(2.0) + 0.5);
    EXPECT_NEAR(at("heart(1)", 0, -height / 2), 0, kRounding);
    EXPECT_NEAR(at("heart(1)", 0, -height / 2 + side * std::sqrt(2.0)), 0, kRounding);
    EXPECT_NEAR(at("heart(1)", 0, -height / 2 - 0.3), 0.3, kRounding);
    EXPECT_NEAR(at("crescent(1, 1, 1)", 0.5, std::sqrt(0.75)), 0, kRounding);
    EXPECT_NEAR(at("crescent(1, 1, 1)", -0.5, 0), -0.5, kRounding);
    EXPECT_NEAR(at("crescent(1, 1, 1)", 1, 0), 1.0, kRounding);
}

// A heart of width 1 touches the box [-½, ½] × [-h/2, h/2] and stays within.
TEST(Shape, HeartFillsItsBox) {
    const double side = 2 - std::sqrt(2.0), top = side * (0.75 * std::sqrt(2.0) + 0.5) / 2;
    double left = 1, highest = 1;
    const ShapeTree heart = shapeOf("heart(1)");
    for (int i = 0; i <= 2000; ++i) {
        const double t = -0.5 + i / 2000.0;
        left = std::min(left, at(heart, -0.5, t));
        highest = std::min(highest, at(heart, t, top));
        EXPECT_GE(at(heart, t, top), -kRounding);
        EXPECT_GE(at(heart, t, -top), -kRounding);
        EXPECT_GE(at(heart, 0.5, t), -kRounding);
    }
    // The extreme points lie between samples 1/2000 apart on arcs of radius 0.29: the gap is below
    // (1/2000)² / (2 · 0.29).
    EXPECT_NEAR(left, 0, 5e-7);
    EXPECT_NEAR(highest, 0, 5e-7);
}

// Nothing changes faster than the point moves, and the boundary separates the signs.
TEST(EveryShape, IsOneLipschitz) {
    const char* more[] = {"union(disc(0.3), translate(0.2, 0.1, box(0.1, 0.2)))",
                          "smooth_union(0.2, sphere(0.2), translate(0.3, 0, 0, torus(0.2, 0.05)))",
                          "difference(box(0.4, 0.4, 0.4), capsule(0.3, 0.2))",
                          "intersection(star(7, 0.5, 0.2), rotate(0.3, scale(0.5, heart(1))))",
                          "half_space(1, 2, 3, 0.1)"};
    std::vector<std::string> texts;
    for (const NamedShape& shape : shapeGallery()) texts.push_back(shape.text);
    texts.insert(texts.end(), std::begin(more), std::end(more));
    for (const std::string& text : texts) {
        const ShapeTree shape = shapeOf(text);
        Random random(11);
        for (int i = 0; i < 2000; ++i) {
            double p[3], q[3], length = 0;
            for (int k = 0; k < 3; ++k) {
                p[k] = random.uniform(-0.8, 0.8);
                q[k] = p[k] + random.uniform(-0.1, 0.1);
                length += (q[k] - p[k]) * (q[k] - p[k]);
            }
            const double change = at(shape, p[0], p[1], p[2]) - at(shape, q[0], q[1], q[2]);
            EXPECT_LE(std::abs(change), std::sqrt(length) + kRounding) << text;
        }
    }
}

// Where the value is exact, the ball of that radius touches the boundary: walking along the
// gradient by the distance ends on it.
TEST(EveryShape, ReachesItsBoundaryWhereItIsExact) {
    for (const NamedShape& entry : shapeGallery()) {
        const ShapeTree shape = shapeOf(entry.text);
        const ShapeExactness exact = exactness(shape);
        EXPECT_TRUE(exact.outside && exact.inside) << entry.name;
        Random random(5);
        int missed = 0;
        for (int i = 0; i < 500; ++i) {
            double p[3], gradient[3];
            for (double& value : p) value = random.uniform(-0.6, 0.6);
            const double d = at(shape, p[0], p[1], p[2]), step = 1e-6;
            for (int k = 0; k < 3; ++k) {
                double q[3] = {p[0], p[1], p[2]}, r[3] = {p[0], p[1], p[2]};
                q[k] += step;
                r[k] -= step;
                gradient[k] =
                    (at(shape, q[0], q[1], q[2]) - at(shape, r[0], r[1], r[2])) / (2 * step);
            }
            for (int k = 0; k < 3; ++k) p[k] -= d * gradient[k];
            // Central differences are right to about 1e-9 there.
            if (!(std::abs(at(shape, p[0], p[1], p[2])) <= 1e-7)) ++missed;
        }
        // The gradient jumps within 1e-6 of the medial surface, which few points meet.
        EXPECT_LE(missed, 2) << entry.name;
    }
}

TEST(Shape, ExactnessFollowsTheRules) {
    const ShapeExactness both = exactness(shapeOf("union(disc(1), box(1, 1))"));
    EXPECT_TRUE(both.outside);
    EXPECT_FALSE(both.inside);
    const ShapeExactness cut = exactness(shapeOf("intersection(disc(1), box(1, 1))"));
    EXPECT_FALSE(cut.outside);
    EXPECT_TRUE(cut.inside);
    const ShapeExactness hole =
        exactness(shapeOf("rotate(1, difference(disc(1), union(disc(1))))"));
    EXPECT_FALSE(hole.outside);
    EXPECT_TRUE(hole.inside);
}

TEST(Shape, BlanksAndFormsOfNumbersDoNotCount) {
    EXPECT_EQ(shapeOf(" union ( disc( +3e-1 ) ,\n disc(.5))"),
              shapeOf("union(disc(0.3), disc(0.5))"));
    EXPECT_NE(shapeOf("union(disc(0.3), disc(0.5))"), shapeOf("union(disc(0.5), disc(0.3))"));
}

std::string faultOf(const std::string& text) {
    const Expected<ShapeTree> shape = parseShape(text);
    return shape.ok() ? "" : shape.status().message();
}

TEST(Shape, FaultsNameThePlace) {
    EXPECT_EQ(faultOf("union(disc(0.3), disk(0.2))"),
              "shape, character 18: a shape such as disc(0.4) or union(…) is expected, found 'd'");
    EXPECT_EQ(faultOf("disc(0.3"),
              "shape, character 9: ',' or ')' as in disc(r) is expected, the text ends");
    EXPECT_EQ(faultOf("disc(-1)"), "shape, character 1: disc: -1 must be positive, at least 1e-06");
    EXPECT_EQ(faultOf("disc(0.3) x"), "shape, character 11: the end is expected, found 'x'");
    for (const char* text : {"",
                             "(",
                             "disc",
                             "disc()",
                             "disc(nan)",
                             "disc(1e999)",
                             "disc(0x1)",
                             "disc(1, 2)",
                             "union()",
                             "union(1)",
                             "difference(disc(1))",
                             "translate(1, disc(1))",
                             "translate(1, 2, 3, 4, disc(1))",
                             "crescent(1, 0.2, 0.1)",
                             "star(2.5, 1, 1)",
                             "star(1001, 1, 1)",
                             "half_space(0, 0, 0, 1)",
                             "scale(0, disc(1))",
                             "disc(1e-300)",
                             "smooth_union(1, disc(1), disc(1), disc(1))",
                             "disc(1),",
                             "disc(1e)",
                             "disc(.)"})
        EXPECT_NE(faultOf(text).find("shape, character "), std::string::npos) << text;
}

TEST(Shape, DepthAndPartsAreCapped) {
    const auto nested = [](int depth) {
        std::string text;
        for (int i = 1; i < depth; ++i) text += "scale(1, ";
        return text + "disc(1)" + std::string(static_cast<std::size_t>(depth - 1), ')');
    };
    EXPECT_EQ(faultOf(nested(kShapeDepth)), "");
    EXPECT_NE(faultOf(nested(kShapeDepth + 1)), "");
    EXPECT_NE(faultOf(nested(50000)), "");
    const auto wide = [](int parts) {
        std::string text = "union(disc(1)";
        for (int i = 2; i < parts; ++i) text += ",disc(1)";
        return text + ")";
    };
    EXPECT_EQ(faultOf(wide(kShapeNodes)), "");
    EXPECT_NE(faultOf(wide(kShapeNodes + 1)), "");
}

// Lanes run the same operations in the same order without contraction, so no tolerance is owed.
TEST(EveryShape, LanesEqualScalars) {
    using Batch = Lanes<double>;
    for (const NamedShape& entry : shapeGallery()) {
        const ShapeTree shape = shapeOf(entry.text);
        Random random(3);
        for (int i = 0; i < 200; ++i) {
            const double x = random.uniform(-1, 1), y = random.uniform(-1, 1),
                         z = random.uniform(-1, 1);
            const Batch value = distance(shape, Batch(x), Batch(y), Batch(z));
            EXPECT_EQ(lane(value, 0), at(shape, x, y, z)) << entry.name;
        }
    }
}

}  // namespace
}  // namespace versorium
