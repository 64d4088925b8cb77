// SPDX-License-Identifier: MIT
#pragma once
// SHA-256 (FIPS 180-4), which names an asset by its content, and CRC-32 as PNG chunks carry it.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace versorium {

// 64 lower-case hexadecimal digits.
std::string sha256(std::span<const unsigned char> bytes);
std::string sha256(std::string_view text);

// The CRC of ISO 3309 / ITU-T V.42 with the PNG's initial and final inversion.
std::uint32_t crc32(std::span<const unsigned char> bytes);

}  // namespace versorium
