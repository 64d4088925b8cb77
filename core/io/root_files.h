// SPDX-License-Identifier: MIT
#pragma once
// Lists of roots as files: the binary .p4d of the shape-modulus authors' programs, and JSON:
// {"roots": [{"q": [w, x, y, z], "power": p}, …], "scale": s}, where "power" and "scale" are 1 when
// they are left out.
//
// .p4d, little-endian: int32 n; four blocks [int32 count, count × 4 float64] with the polynomial's
// coefficients (constant first), its first and second derivative's, and the n roots; int32 n and
// n float64 powers; float64 power scale. Only roots, powers and scale are used when it is read.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "geometry/roots.h"

namespace versorium {

inline constexpr std::size_t kRootCount = 10000;

Expected<RootList> readRootsBinary(std::span<const unsigned char> bytes);
Expected<RootList> readRootsJson(std::string_view text);
// By content: JSON begins with a brace.
Expected<RootList> readRoots(std::span<const unsigned char> bytes);

// The coefficients written are those of the monic polynomial with these roots, each taken once
// (without its power) and multiplied from the left, as the authors' program writes them.
std::vector<unsigned char> writeRootsBinary(const RootList& list);
std::string writeRootsJson(const RootList& list);

}  // namespace versorium
