// SPDX-License-Identifier: MIT
#pragma once
// Grids of numbers as files of the shape-modulus authors' programs, little-endian.
// .f3d: int32 nx, ny, nz; 3 float64 centre; 3 float64 lengths; nx·ny·nz float64 at the nodes.
// 2D:   int32 nx, ny; 2 float64 centre; 2 float64 lengths; nx·ny float64, x running fastest.
// Nodes stand on the corners: the first on the box's minimum, the last on its maximum.
//
// The box of a grid read from an .f3d is exactly [-½, ½]³, whatever the lengths in the file, as
// the authors' mesher takes it; the values are not rescaled. A 2D grid keeps the file's box.

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "geometry/grid.h"

namespace versorium {

struct GridFileOptions {
    // The authors' grid generator writes z running fastest, their mesher reads x fastest. What we
    // write is x fastest, and so is what is read unless this asks for the other.
    bool zFastest = false;
};

inline constexpr std::size_t kGridNodes = std::size_t{1} << 31;

// Either format, told apart by which one's length the bytes have exactly. Refuses counts that do
// not fit the bytes, fewer than two nodes along an axis, and values that are not finite.
Expected<Grid> readGrid(std::span<const unsigned char> bytes, const GridFileOptions& options = {});

// Whether the bytes have exactly the length of either.
bool looksLikeGrid(std::span<const unsigned char> bytes);

// A planar grid becomes a 2D file (zFastest does not matter then), any other an .f3d.
std::vector<unsigned char> writeGrid(const Grid& grid, const GridFileOptions& options = {});

// A grid as it is, box and all, for another instance of the program on the same machine.
std::vector<unsigned char> packGrid(const Grid& grid);
Expected<Grid> unpackGrid(std::span<const unsigned char> bytes);

}  // namespace versorium
