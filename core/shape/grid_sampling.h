// SPDX-License-Identifier: MIT
#pragma once
// A grid as a function of space: trilinear between its nodes, bilinear on a planar grid, which has
// the same values for every z. With u = clamp((p - min) / span, 0, 1) · (nodes - 1) along each
// axis, a point outside the box gets the value of the nearest border point; optionally the
// distance to the box is added, so that a distance field goes on growing.

#include "geometry/grid.h"
#include "math/elementary.h"

namespace versorium {

enum class GridOutside {
    border,    // the value at the nearest point of the box
    distance,  // that plus the distance to the box
};

// The value with its derivatives by x, y and z. Along an axis on which the point is outside, the
// interpolant is constant. On a face between cells it is the derivative of the upper cell.
template <class R>
struct GridSample {
    R value{};
    R gradient[3]{};
};

namespace sampling {

// Where a coordinate falls among the nodes of one axis.
template <class R>
struct AxisPlace {
    int lower = 0, upper = 0;  // the nodes of its cell
    R fraction{};              // from lower to upper
    R slope{};                 // d fraction / d coordinate: 0 outside and on an axis of one node
    R outside{};               // signed distance beyond the box, 0 within
};

template <class R>
AxisPlace<R> placeOnAxis(double minimum, double maximum, int nodes, R coordinate) {
    AxisPlace<R> place;
    if (nodes < 2) return place;
    const R low = static_cast<R>(minimum), high = static_cast<R>(maximum);
    const R span = high - low;
    const R share = (coordinate - low) / span;
    // Written so that NaN goes to the lower border instead of to an index.
    const R clamped = share > R(0) ? (share < R(1) ? share : R(1)) : R(0);
    const R scaled = clamped * static_cast<R>(nodes - 1);
    const int cell = static_cast<int>(scaled);
    place.lower = cell < nodes - 2 ? cell : nodes - 2;
    place.upper = place.lower + 1;
    place.fraction = scaled - static_cast<R>(place.lower);
    if (coordinate < low) {
        place.outside = coordinate - low;
    } else if (coordinate > high) {
        place.outside = coordinate - high;
    } else {
        place.slope = static_cast<R>(nodes - 1) / span;
    }
    return place;
}

template <class R>
R mix(R a, R b, R fraction) {
    return a + fraction * (b - a);
}

}  // namespace sampling

// R is float or double. The grid needs at least one node along each axis. NaN coordinates give the
// value at the lower border.
template <class R>
GridSample<R> sampleGridWithGradient(const Grid& grid, R x, R y, R z, GridOutside outside) {
    using sampling::mix;
    const auto px = sampling::placeOnAxis(grid.minimum.x, grid.maximum.x, grid.resolution.x, x);
    const auto py = sampling::placeOnAxis(grid.minimum.y, grid.maximum.y, grid.resolution.y, y);
    const auto pz = sampling::placeOnAxis(grid.minimum.z, grid.maximum.z, grid.resolution.z, z);
    // Corner values as c[z][y][x], then the edges along x, the lines along y, the point.
    R corner[2][2][2], alongX[2][2], alongY[2];
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j) {
            const int row = j == 0 ? py.lower : py.upper, layer = k == 0 ? pz.lower : pz.upper;
            corner[k][j][0] = static_cast<R>(grid.at(px.lower, row, layer));
            corner[k][j][1] = static_cast<R>(grid.at(px.upper, row, layer));
            alongX[k][j] = mix(corner[k][j][0], corner[k][j][1], px.fraction);
        }
    for (int k = 0; k < 2; ++k) alongY[k] = mix(alongX[k][0], alongX[k][1], py.fraction);

    GridSample<R> sample;
    sample.value = mix(alongY[0], alongY[1], pz.fraction);
    const auto slopeX = [&](int k, int j) { return corner[k][j][1] - corner[k][j][0]; };
    sample.gradient[0] = px.slope * mix(mix(slopeX(0, 0), slopeX(0, 1), py.fraction),
                                        mix(slopeX(1, 0), slopeX(1, 1), py.fraction), pz.fraction);
    sample.gradient[1] =
        py.slope * mix(alongX[0][1] - alongX[0][0], alongX[1][1] - alongX[1][0], pz.fraction);
    sample.gradient[2] = pz.slope * (alongY[1] - alongY[0]);
    if (outside == GridOutside::border) return sample;

    const R beyond =
        sqrt(px.outside * px.outside + py.outside * py.outside + pz.outside * pz.outside);
    sample.value += beyond;
    if (beyond > R(0)) {
        sample.gradient[0] += px.outside / beyond;
        sample.gradient[1] += py.outside / beyond;
        sample.gradient[2] += pz.outside / beyond;
    }
    return sample;
}

// The value alone, by the same operations.
template <class R>
R sampleGrid(const Grid& grid, R x, R y, R z, GridOutside outside) {
    using sampling::mix;
    const auto px = sampling::placeOnAxis(grid.minimum.x, grid.maximum.x, grid.resolution.x, x);
    const auto py = sampling::placeOnAxis(grid.minimum.y, grid.maximum.y, grid.resolution.y, y);
    const auto pz = sampling::placeOnAxis(grid.minimum.z, grid.maximum.z, grid.resolution.z, z);
    const auto edge = [&](int row, int layer) {
        return mix(static_cast<R>(grid.at(px.lower, row, layer)),
                   static_cast<R>(grid.at(px.upper, row, layer)), px.fraction);
    };
    const auto line = [&](int layer) {
        return mix(edge(py.lower, layer), edge(py.upper, layer), py.fraction);
    };
    const R value = grid.planar() ? line(0) : mix(line(pz.lower), line(pz.upper), pz.fraction);
    if (outside == GridOutside::border) return value;
    return value +
           sqrt(px.outside * px.outside + py.outside * py.outside + pz.outside * pz.outside);
}

}  // namespace versorium
