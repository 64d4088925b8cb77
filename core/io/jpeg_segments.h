// SPDX-License-Identifier: MIT
#pragma once
// The segments of a JPEG, checked and put one after the other before a decoder sees them. The
// decoder believes the counts of Huffman tables, and a false one would have it write beyond them; a
// table that was never given is whatever its memory held.

#include <span>
#include <vector>

#include "base/status.h"

namespace versorium {

// The same picture without what stands between segments. Data after the first end of image is left
// out; a picture that is cut short stays so. Fails with ErrorKind::data on a Huffman table of more
// than 256 codes or beyond its segment, and on a scan whose tables were not given before.
Expected<std::vector<unsigned char>> checkedJpeg(std::span<const unsigned char> bytes);

}  // namespace versorium
