// SPDX-License-Identifier: MIT
#pragma once
// Base64 (RFC 4648, with padding) for bytes inside JSON.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace versorium {

std::string base64Encode(std::span<const unsigned char> bytes);
// ErrorKind::data for other characters, a wrong length, or more than `limit` bytes.
Expected<std::vector<unsigned char>> base64Decode(std::string_view text, std::size_t limit);

}  // namespace versorium
