// SPDX-License-Identifier: MIT
#include "io/zip.h"

#include <algorithm>
#include <utility>

#include "base/hash.h"

namespace versorium {
namespace {

constexpr std::uint32_t kLocal = 0x04034b50, kCentral = 0x02014b50, kEnd = 0x06054b50;
constexpr std::uint32_t kVersion = 20;  // 2.0: folders and files as they are
constexpr std::uint32_t kUtf8 = 1u << 11;
constexpr std::uint32_t kNoDate = 0x00210000;  // 1 January 1980, midnight: the first there is

void put16(std::vector<unsigned char>& out, std::uint32_t value) {
    out.push_back(static_cast<unsigned char>(value & 0xff));
    out.push_back(static_cast<unsigned char>(value >> 8 & 0xff));
}
void put32(std::vector<unsigned char>& out, std::uint32_t value) {
    put16(out, value & 0xffff);
    put16(out, value >> 16);
}

// What a file's two headers have in common.
void putFacts(std::vector<unsigned char>& out, std::uint32_t crc, std::uint32_t size,
              const std::string& name) {
    put16(out, kVersion);
    put16(out, kUtf8);
    put16(out, 0);  // stored
    put32(out, kNoDate);
    put32(out, crc);
    put32(out, size);
    put32(out, size);
    put16(out, static_cast<std::uint32_t>(name.size()));
    put16(out, 0);
}

}  // namespace

Status ZipWriter::add(const std::string& name, std::span<const unsigned char> bytes) {
    if (name.empty() || name.size() > 65535) return Status::usage("an archive needs file names");
    if (std::any_of(entries_.begin(), entries_.end(),
                    [&](const Entry& entry) { return entry.name == name; }))
        return Status::usage("the archive has a file " + name + " already");
    // Room for the list at the end as well.
    if (entries_.size() >= kZipFiles ||
        bytes_.size() + bytes.size() + 512 > kZipBytes - entries_.size() * 512)
        return Status::usage("too much for one ZIP archive: give a folder, or fewer pictures");
    Entry entry{name, crc32(bytes), static_cast<std::uint32_t>(bytes.size()),
                static_cast<std::uint32_t>(bytes_.size())};
    put32(bytes_, kLocal);
    putFacts(bytes_, entry.crc, entry.size, name);
    bytes_.insert(bytes_.end(), name.begin(), name.end());
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    entries_.push_back(std::move(entry));
    return {};
}

std::vector<unsigned char> ZipWriter::finish() {
    const auto start = static_cast<std::uint32_t>(bytes_.size());
    for (const Entry& entry : entries_) {
        put32(bytes_, kCentral);
        put16(bytes_, kVersion);
        putFacts(bytes_, entry.crc, entry.size, entry.name);
        put16(bytes_, 0);  // comment
        put16(bytes_, 0);  // disk
        put16(bytes_, 0);
        put32(bytes_, 0);
        put32(bytes_, entry.at);
        bytes_.insert(bytes_.end(), entry.name.begin(), entry.name.end());
    }
    const auto size = static_cast<std::uint32_t>(bytes_.size()) - start;
    const auto count = static_cast<std::uint32_t>(entries_.size());
    put32(bytes_, kEnd);
    put32(bytes_, 0);
    put16(bytes_, count);
    put16(bytes_, count);
    put32(bytes_, size);
    put32(bytes_, start);
    put16(bytes_, 0);
    entries_.clear();
    return std::exchange(bytes_, {});
}

}  // namespace versorium
