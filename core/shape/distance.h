// SPDX-License-Identifier: MIT
#pragma once
// The signed distance of an analytic shape (shape/tree.h) at a point, over any number type R: it
// uses nothing but arithmetic, comparisons that give masks for `select`, and abs, sqrt, min and
// max, so R may be a double, lanes of them, a dual number or a number that records.
//
// Closed forms: a polygon's or circle's distance after folding the point by the shape's mirror
// symmetries. Folding is exact, since a point is never nearer to the mirror image of a boundary
// piece than to the piece on its own side.

#include "math/elementary.h"
#include "shape/tree.h"

namespace versorium {

template <class R>
R distance(const ShapeTree& shape, const R& x, const R& y, const R& z);

namespace shapes {

template <class R>
R length(const R& x, const R& y) {
    return sqrt(x * x + y * y);
}
template <class R>
R length(const R& x, const R& y, const R& z) {
    return sqrt(x * x + y * y + z * z);
}
template <class R>
R clamp(const R& value, const R& low, const R& high) {
    return min(max(value, low), high);
}

template <class R>
R box(const ShapeTree& shape, const R& x, const R& y, const R& z) {
    const std::vector<double>& half = shape.numbers();
    const R zero(0.0);
    const R dx = abs(x) - R(half[0]), dy = abs(y) - R(half[1]);
    if (half.size() == 2) return length(max(dx, zero), max(dy, zero)) + min(max(dx, dy), zero);
    const R dz = abs(z) - R(half[2]);
    return length(max(dx, zero), max(dy, zero), max(dz, zero)) + min(max(dx, max(dy, dz)), zero);
}

template <class R>
R capsule(const ShapeTree& shape, const R& x, const R& y, const R& z) {
    const R half(shape.numbers()[0]);
    return length(x, y - clamp(y, -half, half), z) - R(shape.numbers()[1]);
}

// Folded into one sector of angle π/n, the star is one segment from the outer corner on the axis to
// the inner corner on the sector's end.
template <class R>
R star(const ShapeTree& shape, const R& x, const R& y) {
    const std::vector<double>& line = shape.derived();
    // The first point stands up: the axis of the sector is y.
    R u = y, v = abs(x);
    std::size_t i = 0;
    for (; i + 2 < line.size(); i += 2) {
        const R cosine(line[i]), sine(line[i + 1]);
        const R beyond = max(v * cosine - u * sine, R(0.0));
        u = u + R(2.0) * beyond * sine;
        v = v - R(2.0) * beyond * cosine;
    }
    const double outer = shape.numbers()[1], inner = shape.numbers()[2];
    const double edgeU = inner * line[i] - outer, edgeV = inner * line[i + 1];
    const R du = u - R(outer);
    const R along =
        clamp((du * R(edgeU) + v * R(edgeV)) / R(edgeU * edgeU + edgeV * edgeV), R(0.0), R(1.0));
    const R away = length(du - along * R(edgeU), v - along * R(edgeV));
    // Left of the edge, seen from the outer corner, lies the centre.
    return select(R(edgeU) * v < R(edgeV) * du, away, -away);
}

// A square of side s stands on its corner; half-discs of diameter s sit on its upper sides. In the
// square's own axes u, v from the lowest corner, the mirror is u = v.
template <class R>
R heart(const ShapeTree& shape, const R& x, const R& y) {
    constexpr double kSqrtHalf = 0.70710678118654752440;
    const double side = shape.numbers()[0] * (2 - 2 * kSqrtHalf);
    // Height from the lowest corner to the lobes' top is s (3/4 √2 + 1/2).
    const R up = y + R(side * (0.75 * kSqrtHalf + 0.25));
    const R across = abs(x), half(0.5 * side), zero(0.0), whole(side);
    const R u = (up + across) * R(kSqrtHalf), v = (up - across) * R(kSqrtHalf);
    const R radial = length(u - whole, v - half) - half;
    const R edge = length(u - clamp(u, zero, whole), v);
    // The half-circle's nearest point is one of its ends, one of which is the edge's, for u < s.
    const R arc = select(u < whole, length(u - whole, v - whole), abs(radial));
    const R away = min(edge, arc);
    const R within = select(u < whole, -v, radial);
    return select(within < zero, -away, away);
}

template <class R>
R crescent(const ShapeTree& shape, const R& x, const R& y) {
    const R large(shape.numbers()[0]), small(shape.numbers()[1]), offset(shape.numbers()[2]);
    const R cuspX(shape.derived()[0]), cuspY(shape.derived()[1]), zero(0.0);
    const R v = abs(y), w = x - offset;
    const R toLarge = length(x, v) - large, toSmall = length(w, v) - small;
    const R toCusp = length(x - cuspX, v - cuspY);
    // Beyond the cusp's direction, seen from a circle's centre, the nearest point is on the arc.
    const R outerArc = select(cuspX * v < cuspY * x, toCusp, abs(toLarge));
    const R innerArc = select((cuspX - offset) * v < cuspY * w, toCusp, abs(toSmall));
    const R away = min(outerArc, innerArc);
    return select(max(toLarge, -toSmall) < zero, -away, away);
}

// Quadratic blend: exactly min(a, b) where they differ by k or more, at most k/4 below it.
template <class R>
R smoothUnion(const ShapeTree& shape, const R& x, const R& y, const R& z) {
    const R k(shape.numbers()[0]);
    const R a = distance(shape.children()[0], x, y, z), b = distance(shape.children()[1], x, y, z);
    const R overlap = max(k - abs(a - b), R(0.0));
    return min(a, b) - overlap * overlap / (R(4.0) * k);
}

template <class R>
R translate(const ShapeTree& shape, const R& x, const R& y, const R& z) {
    const std::vector<double>& by = shape.numbers();
    return distance(shape.children()[0], R(x - R(by[0])), R(y - R(by[1])),
                    by.size() == 3 ? R(z - R(by[2])) : z);
}

template <class R>
R rotate(const ShapeTree& shape, const R& x, const R& y, const R& z) {
    const R cosine(shape.derived()[0]), sine(shape.derived()[1]);
    return distance(shape.children()[0], R(x * cosine + y * sine), R(y * cosine - x * sine), z);
}

// The least (sign 1) or greatest (sign -1) of the parts.
template <class R>
R combine(const ShapeTree& shape, const R& x, const R& y, const R& z, bool least) {
    const std::vector<ShapeTree>& parts = shape.children();
    R value = distance(parts[0], x, y, z);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const R next = distance(parts[i], x, y, z);
        value = least ? min(value, next) : max(value, next);
    }
    return value;
}

}  // namespace shapes

template <class R>
R distance(const ShapeTree& shape, const R& x, const R& y, const R& z) {
    const std::vector<double>& n = shape.numbers();
    switch (shape.kind()) {
        case ShapeKind::disc:
            return shapes::length(x, y) - R(n[0]);
        case ShapeKind::sphere:
            return shapes::length(x, y, z) - R(n[0]);
        case ShapeKind::box:
            return shapes::box(shape, x, y, z);
        case ShapeKind::torus:
            return shapes::length(R(shapes::length(x, y) - R(n[0])), z) - R(n[1]);
        case ShapeKind::capsule:
            return shapes::capsule(shape, x, y, z);
        case ShapeKind::star:
            return shapes::star(shape, x, y);
        case ShapeKind::heart:
            return shapes::heart(shape, x, y);
        case ShapeKind::crescent:
            return shapes::crescent(shape, x, y);
        case ShapeKind::halfSpace: {
            const std::vector<double>& normal = shape.derived();
            return x * R(normal[0]) + y * R(normal[1]) + z * R(normal[2]) - R(n[3]);
        }
        case ShapeKind::unionOf:
            return shapes::combine(shape, x, y, z, true);
        case ShapeKind::intersection:
            return shapes::combine(shape, x, y, z, false);
        case ShapeKind::difference:
            return max(distance(shape.children()[0], x, y, z),
                       R(-distance(shape.children()[1], x, y, z)));
        case ShapeKind::smoothUnion:
            return shapes::smoothUnion(shape, x, y, z);
        case ShapeKind::translate:
            return shapes::translate(shape, x, y, z);
        case ShapeKind::rotate:
            return shapes::rotate(shape, x, y, z);
        case ShapeKind::scale: {
            const R factor(n[0]);
            return factor *
                   distance(shape.children()[0], R(x / factor), R(y / factor), R(z / factor));
        }
    }
    return x;  // every kind returned above
}

}  // namespace versorium
