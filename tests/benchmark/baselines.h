// SPDX-License-Identifier: MIT
#pragma once
// The loops that a textbook would write, compiled with the flags of the project's own code: what
// every speed is measured against.

#include <cstdint>
#include <vector>

#include "geometry/roots.h"
#include "shape/field.h"

namespace versorium::textbook {

// Escape steps of z² + c from 0 on a square of side `height` about `centre`, row after row.
template <class T>
std::int64_t mandelbrot(int side, int iterations, std::vector<std::int32_t>& steps);
extern template std::int64_t mandelbrot<float>(int, int, std::vector<std::int32_t>&);
extern template std::int64_t mandelbrot<double>(int, int, std::vector<std::int32_t>&);

// A eq 10 as printed: base vectors and dot products. `k` are the 30 coefficients of the catalogue's
// planar map.
std::int64_t planarDotProducts(int side, double height, int iterations, double squaredRadius,
                               const double* k, std::vector<std::int32_t>& steps);

// Averaged membership (S Fig 8 top): for every pixel of a square picture of this height, how many
// of the members keep it. A member is a list of roots; φ is `shape`. Orbits end beyond 20.
void averagedMembership(int side, double height, int iterations, double alpha,
                        const DistanceField& shape,
                        const std::vector<std::vector<RootList::Root>>& members,
                        std::vector<std::uint32_t>& counts);

// Multiply-adds as fast as the CPU does them, for each instruction set; returns how many
// floating-point operations were done (two for each multiply-add).
double fmaPeakV3(int rounds);
double fmaPeakV4(int rounds);

}  // namespace versorium::textbook
