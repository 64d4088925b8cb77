// SPDX-License-Identifier: MIT
// One definition of the distance serves every number type: duals give its gradient, a recording
// number a tape with the same bits.
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "math/dual.h"
#include "shape/distance.h"
#include "shape/gallery.h"
#include "trace/expr.h"
#include "trace/interpret.h"

namespace versorium {
namespace {

std::vector<std::string> texts() {
    std::vector<std::string> list;
    for (const NamedShape& shape : shapeGallery()) list.push_back(shape.text);
    list.push_back("smooth_union(0.2, sphere(0.2), translate(0.3, 0, 0, torus(0.2, 0.05)))");
    list.push_back("difference(half_space(1, 2, 3, 0), rotate(0.4, scale(2, heart(0.3))))");
    list.push_back("intersection(box(0.4, 0.3), star(5, 0.4, 0.2), crescent(0.4, 0.3, 0.2))");
    return list;
}

TEST(EveryShape, DualsGiveTheGradient) {
    using Number = Dual<double>;
    for (const std::string& text : texts()) {
        const ShapeTree shape = *parseShape(text);
        Random random(12);
        int missed = 0;
        for (int i = 0; i < 300; ++i) {
            double p[3];
            for (double& value : p) value = random.uniform(-0.7, 0.7);
            double squared = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const auto seeded = [&](int k) { return Number(p[k], k == axis ? 1.0 : 0.0); };
                const Number d = distance(shape, seeded(0), seeded(1), seeded(2));
                EXPECT_EQ(d.value, distance(shape, p[0], p[1], p[2]));
                double q[3] = {p[0], p[1], p[2]}, r[3] = {p[0], p[1], p[2]};
                const double step = 1e-6;
                q[axis] += step;
                r[axis] -= step;
                const double slope =
                    (distance(shape, q[0], q[1], q[2]) - distance(shape, r[0], r[1], r[2])) /
                    (2 * step);
                // Rounding 1e-16/1e-6; a kink within the step is met by few points.
                missed += std::abs(d.slope - slope) > 1e-8 ? 1 : 0;
                squared += d.slope * d.slope;
            }
            EXPECT_LE(squared, 1 + 1e-12) << text;
        }
        EXPECT_LE(missed, 3) << text;
    }
}

TEST(EveryShape, TapeEqualsScalar) {
    for (const std::string& text : texts()) {
        const ShapeTree shape = *parseShape(text);
        Tape tape;
        tape.stateSize = 3;
        const auto coordinate = [&](int k) {
            return Expr(&tape, tape.add({.op = Op::state, .index = k}));
        };
        const Expr x = coordinate(0), y = coordinate(1), z = coordinate(2);
        tape.outputs = {distance(shape, x, y, z).on(&tape)};
        Random random(13);
        for (int i = 0; i < 200; ++i) {
            double p[3], out = 0;
            for (double& value : p) value = random.uniform(-0.7, 0.7);
            interpret<double>(tape, p, nullptr, NothingBound{}, &out);
            EXPECT_EQ(out, distance(shape, p[0], p[1], p[2])) << text;
        }
    }
}

}  // namespace
}  // namespace versorium
