// SPDX-License-Identifier: MIT
#pragma once
// Files as bytes. A file is read whole, up to a stated size; it is written so that whoever looks at
// its path sees the old content or the new one, never a part: the bytes go to a temporary file in
// the same folder, every write is checked, and the temporary takes the path's place at the end.
// The path "-" is standard input or standard output. Failures are ErrorKind::inputOutput.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace versorium {

using Bytes = std::vector<unsigned char>;

inline constexpr std::size_t kFileSize = std::size_t{1} << 31;  // a grid of 512³ is half of it

// Fails when the file is larger than `maxBytes`, before it is read where its size is known.
// A leading "~/" is the home folder, as shells have it, wherever a path is read or written.
std::string expandedPath(const std::string& path);

Expected<Bytes> readFile(const std::string& path, std::size_t maxBytes = kFileSize);

// Follows a symbolic link to its target. Devices and pipes are written to directly. On failure the
// old file stands as it was and no temporary is left; after a crash a temporary named
// ".<file>.<number>.partial" may remain, which can be deleted.
Status writeFileAtomically(const std::string& path, std::span<const unsigned char> bytes);
Status writeFileAtomically(const std::string& path, std::string_view text);

}  // namespace versorium
