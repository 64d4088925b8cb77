// SPDX-License-Identifier: MIT
#pragma once
// Files in one ZIP archive (APPNOTE 6.3), stored as they are: pictures are compressed already. The
// same files always give the same bytes; the archive carries no dates.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/status.h"

namespace versorium {

inline constexpr std::size_t kZipFiles = 65535;
inline constexpr std::size_t kZipBytes = std::size_t{1} << 31;  // of a whole archive

class ZipWriter {
  public:
    // `name` is UTF-8 with '/' between folders. ErrorKind::usage where the archive would be larger
    // than a ZIP without extensions may be, or where the name is there already.
    Status add(const std::string& name, std::span<const unsigned char> bytes);
    // The archive's bytes; the writer is empty after it.
    std::vector<unsigned char> finish();

  private:
    struct Entry {
        std::string name;
        std::uint32_t crc = 0, size = 0, at = 0;
    };
    std::vector<Entry> entries_;
    std::vector<unsigned char> bytes_;
};

}  // namespace versorium
