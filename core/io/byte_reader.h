// SPDX-License-Identifier: MIT
#pragma once
// Reads little- or big-endian numbers from bytes without ever passing their end: the first read
// that would sets `failed()`, and every later one returns 0. Counts of files are compared with
// `remaining()` before anything is allocated.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace versorium {

class ByteReader {
  public:
    explicit ByteReader(std::span<const unsigned char> bytes, bool bigEndian = false)
        : bytes_(bytes), bigEndian_(bigEndian) {}

    std::size_t remaining() const { return bytes_.size() - position_; }
    std::size_t position() const { return position_; }
    bool failed() const { return failed_; }

    // An arithmetic type of 1, 2, 4 or 8 bytes.
    template <class T>
    T read() {
        T value{};
        if (failed_ || remaining() < sizeof(T)) {
            failed_ = true;
            return value;
        }
        // Every machine that this is built for is little-endian.
        unsigned char raw[sizeof(T)];
        for (std::size_t i = 0; i < sizeof(T); ++i)
            raw[i] = bytes_[position_ + (bigEndian_ ? sizeof(T) - 1 - i : i)];
        std::memcpy(&value, raw, sizeof(T));
        position_ += sizeof(T);
        return value;
    }

    void skip(std::size_t count) {
        if (failed_ || remaining() < count) {
            failed_ = true;
            return;
        }
        position_ += count;
    }

  private:
    std::span<const unsigned char> bytes_;
    std::size_t position_ = 0;
    bool bigEndian_ = false;
    bool failed_ = false;
};

// Appends the bytes of a number, little-endian.
template <class T>
void appendLittleEndian(std::vector<unsigned char>& bytes, T value) {
    unsigned char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes.insert(bytes.end(), raw, raw + sizeof(T));
}

}  // namespace versorium
