// SPDX-License-Identifier: MIT
#pragma once
// A grid as a function of space, over any number type: trilinear between its nodes, bilinear on a
// planar grid, which has the same values for every z. With u = clamp((p - min) / span, 0, 1) ·
// (nodes - 1) along each axis, a point outside the box gets the value of the nearest border point;
// optionally the distance to the box is added, so that a distance field goes on growing. NaN goes
// to the lower border. The gradient is that of the interpolant: constant along an axis on which the
// point is outside, and on a face between cells that of the upper cell.

#include "base/words.h"
#include "geometry/grid.h"
#include "math/dual.h"

namespace versorium {

enum class Outside {
    border,    // the value at the nearest point of the box
    distance,  // that plus the distance to the box
};

template <>
struct EnumWords<Outside> {
    static constexpr std::array<std::string_view, 2> table{"border", "distance"};
};

namespace sampling {

template <class R>
struct GridSample {
    R value, dx, dy, dz;
};

// Where a coordinate falls: the cell's first node, the fraction inside of it, how far it lies
// beyond the border, and the derivatives of both.
template <class R>
struct Along {
    R cell, fraction, beyond, slope, beyondSlope;
};

template <class R>
Along<R> locate(const R& position, double minimum, double maximum, int nodes) {
    using T = ScalarOf<R>;
    if (nodes < 2) return {R(T(0)), R(T(0)), R(T(0)), R(T(0)), R(T(0))};
    const T span = static_cast<T>(maximum - minimum);
    const T last = static_cast<T>(nodes - 1);
    const R relative = (position - R(static_cast<T>(minimum))) / R(span);
    // The order of the arguments sends NaN to the first node.
    const R clamped = min(max(R(T(0)), relative), R(T(1)));
    const R u = clamped * R(last);
    const R cell = min(floor(u), R(last - T(1)));
    const auto inside = clamped == relative;
    const R low = R(static_cast<T>(minimum)) - position;
    const R high = position - R(static_cast<T>(maximum));
    const R beyond = max(R(T(0)), max(low, high));
    const R sign = select(high > low, R(T(1)), R(T(-1)));
    return {cell, u - cell, beyond, select(inside, R(last / span), R(T(0))),
            select(beyond > R(T(0)), sign, R(T(0)))};
}

template <PlainReal R>
R mix(const R& a, const R& b, const R& t) {
    return a + (b - a) * t;
}

template <PlainReal R>
GridSample<R> sampleGrid(const Grid& grid, Outside outside, const R& x, const R& y, const R& z) {
    using T = ScalarOf<R>;
    const Along<R> ax = locate(x, grid.minimum.x, grid.maximum.x, grid.resolution.x);
    const Along<R> ay = locate(y, grid.minimum.y, grid.maximum.y, grid.resolution.y);
    const Along<R> az = locate(z, grid.minimum.z, grid.maximum.z, grid.resolution.z);
    R corner[8];
    const std::ptrdiff_t stepX = grid.resolution.x > 1 ? 1 : 0;
    const std::ptrdiff_t stepY = grid.resolution.y > 1 ? grid.resolution.x : 0;
    const std::ptrdiff_t stepZ =
        grid.planar() ? 0 : std::ptrdiff_t{grid.resolution.x} * grid.resolution.y;
    for (int i = 0; i < kLaneCount<R>; ++i) {
        const std::size_t at =
            grid.index(static_cast<int>(lane(ax.cell, i)), static_cast<int>(lane(ay.cell, i)),
                       static_cast<int>(lane(az.cell, i)));
        const double* first = grid.values.data() + at;
        for (int k = 0; k < 8; ++k)
            setLane(corner[k], i,
                    static_cast<T>(
                        first[(k & 1 ? stepX : 0) + (k & 2 ? stepY : 0) + (k & 4 ? stepZ : 0)]));
    }
    const R x00 = mix(corner[0], corner[1], ax.fraction);
    const R x10 = mix(corner[2], corner[3], ax.fraction);
    const R x01 = mix(corner[4], corner[5], ax.fraction);
    const R x11 = mix(corner[6], corner[7], ax.fraction);
    const R y0 = mix(x00, x10, ay.fraction), y1 = mix(x01, x11, ay.fraction);
    GridSample<R> sample;
    sample.value = mix(y0, y1, az.fraction);
    const R d0 = mix(corner[1] - corner[0], corner[3] - corner[2], ay.fraction);
    const R d1 = mix(corner[5] - corner[4], corner[7] - corner[6], ay.fraction);
    sample.dx = mix(d0, d1, az.fraction) * ax.slope;
    sample.dy = mix(x10 - x00, x11 - x01, az.fraction) * ay.slope;
    sample.dz = (y1 - y0) * az.slope;
    if (outside == Outside::distance) {
        const R away = sqrt(ax.beyond * ax.beyond + ay.beyond * ay.beyond + az.beyond * az.beyond);
        const R scale = select(away > R(T(0)), R(T(1)) / away, R(T(0)));
        sample.value = sample.value + away;
        sample.dx = sample.dx + ax.beyond * ax.beyondSlope * scale;
        sample.dy = sample.dy + ay.beyond * ay.beyondSlope * scale;
        sample.dz = sample.dz + az.beyond * az.beyondSlope * scale;
    }
    return sample;
}

template <PlainReal R>
R gridValue(const Grid& grid, Outside outside, const R& x, const R& y, const R& z) {
    return sampleGrid(grid, outside, x, y, z).value;
}
template <class R>
Dual<R> gridValue(const Grid& grid, Outside outside, const Dual<R>& x, const Dual<R>& y,
                  const Dual<R>& z) {
    const GridSample<R> s = sampleGrid(grid, outside, x.value, y.value, z.value);
    return {s.value, s.dx * x.slope + s.dy * y.slope + s.dz * z.slope};
}

}  // namespace sampling

}  // namespace versorium
