// SPDX-License-Identifier: MIT
#include "base/base64.h"

#include <cstdint>

namespace versorium {
namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64Encode(std::span<const unsigned char> bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t rest = bytes.size() - i;
        const std::uint32_t word = (std::uint32_t{bytes[i]} << 16) |
                                   (rest > 1 ? std::uint32_t{bytes[i + 1]} << 8 : 0) |
                                   (rest > 2 ? std::uint32_t{bytes[i + 2]} : 0);
        text += kDigits[word >> 18];
        text += kDigits[(word >> 12) & 63];
        text += rest > 1 ? kDigits[(word >> 6) & 63] : '=';
        text += rest > 2 ? kDigits[word & 63] : '=';
    }
    return text;
}

Expected<std::vector<unsigned char>> base64Decode(std::string_view text, std::size_t limit) {
    if (text.size() % 4 != 0)
        return Status::data("base64 text has a length that 4 does not divide");
    if (text.size() / 4 > limit / 3 + 1)
        return Status::data("more than " + std::to_string(limit) + " bytes of assets");
    std::vector<unsigned char> bytes;
    bytes.reserve(text.size() / 4 * 3);
    for (std::size_t i = 0; i < text.size(); i += 4) {
        std::uint32_t word = 0;
        int padding = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const char c = text[i + k];
            const std::size_t digit = kDigits.find(c);
            const bool last = i + 4 == text.size();
            if (c == '=' && last && k >= 2) {
                ++padding;
                word <<= 6;
            } else if (digit != std::string_view::npos && padding == 0) {
                word = (word << 6) | static_cast<std::uint32_t>(digit);
            } else {
                return Status::data("character " + std::to_string(i + k + 1) + " is not base64");
            }
        }
        bytes.push_back(static_cast<unsigned char>(word >> 16));
        if (padding < 2) bytes.push_back(static_cast<unsigned char>(word >> 8));
        if (padding < 1) bytes.push_back(static_cast<unsigned char>(word));
    }
    if (bytes.size() > limit)
        return Status::data("more than " + std::to_string(limit) + " bytes of assets");
    return bytes;
}

}  // namespace versorium
