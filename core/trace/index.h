// SPDX-License-Identifier: MIT
#pragma once
// Tapes and trees number their nodes by int, since -1 is none; the library's containers count by
// size_t.

#include <cstddef>

namespace versorium {

inline std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace versorium
