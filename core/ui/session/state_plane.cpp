// SPDX-License-Identifier: MIT
#include "ui/session/state_plane.h"

#include <cmath>

#include "scene/numbers.h"

namespace versorium {
namespace {

using Point = StatePlane::Point;

double dot(const Point& a, const Point& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
    return sum;
}
Point plus(Point a, double t, const Point& b) {
    for (std::size_t k = 0; k < a.size(); ++k) a[k] += t * b[k];
    return a;
}

}  // namespace

Point StatePlane::at(double u, double v) const { return plus(plus(base, u, axis[0]), v, axis[1]); }

std::array<double, 2> StatePlane::coordinates(const Point& x) const {
    const Point from = plus(x, -1, base);
    const double aa = dot(axis[0], axis[0]), ab = dot(axis[0], axis[1]);
    const double bb = dot(axis[1], axis[1]), determinant = aa * bb - ab * ab;
    const double a = dot(from, axis[0]), b = dot(from, axis[1]);
    return {(bb * a - ab * b) / determinant, (aa * b - ab * a) / determinant};
}

double StatePlane::distance(const Point& x) const {
    const auto [u, v] = coordinates(x);
    const Point off = plus(x, -1, at(u, v));
    return std::sqrt(dot(off, off));
}

std::array<Point, 2> StatePlane::frame() const {
    const auto unit = [](const Point& a) { return plus(Point{}, 1 / std::sqrt(dot(a, a)), a); };
    const Point first = unit(axis[0]);
    return {first, unit(plus(axis[1], -dot(axis[1], first), first))};
}

std::optional<StatePlane> statePlaneOf(const Scene& scene) {
    const int dimension = mapOf(scene).dimension;
    if (scene.slice.axes.size() != 2 || scene.criticalStart || dimension < 2) return std::nullopt;
    StatePlane plane;
    plane.dimension = dimension;
    for (std::size_t k = 0; k < scene.start.size(); ++k) plane.base[k] = scene.start[k];
    for (std::size_t k = 0; k < 2; ++k)
        for (const auto& [name, weight] : scene.slice.axes[k].terms) {
            const std::optional<NumberRef> number = numberNamed(scene, name);
            if (!number || number->kind != NumberKind::state) return std::nullopt;
            const auto index = static_cast<std::size_t>(number->index);
            plane.axis[k][index] += weight;
            plane.base[index] = 0;
        }
    for (const auto& [name, value] : scene.slice.origin) {
        const std::optional<NumberRef> number = numberNamed(scene, name);
        if (number && number->kind == NumberKind::state)
            plane.base[static_cast<std::size_t>(number->index)] = value;
    }
    const double aa = dot(plane.axis[0], plane.axis[0]), ab = dot(plane.axis[0], plane.axis[1]);
    const double bb = dot(plane.axis[1], plane.axis[1]);
    if (!(aa * bb - ab * ab > 1e-12 * aa * bb)) return std::nullopt;
    return plane;
}

}  // namespace versorium
