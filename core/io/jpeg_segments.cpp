// SPDX-License-Identifier: MIT
#include "io/jpeg_segments.h"

#include <string>

namespace versorium {
namespace {

using JpegBytes = std::span<const unsigned char>;

constexpr unsigned char kStartOfImage = 0xd8, kEndOfImage = 0xd9, kHuffmanTables = 0xc4,
                        kQuantTables = 0xdb, kStartOfScan = 0xda;

// Markers that stand alone: stuffing, restarts, and a start or "temporary" that says nothing here.
bool standsAlone(unsigned char marker) {
    return marker <= 0x01 || (marker >= 0xd0 && marker <= kStartOfImage);
}

Status damaged(const std::string& what) { return Status::data("the picture is damaged: " + what); }

// Which tables have been defined so far, and what the frame's components use.
class JpegTables {
  public:
    Status take(unsigned char marker, JpegBytes body) {
        if (marker == kHuffmanTables) return takeHuffman(body);
        if (marker == kQuantTables) return takeQuant(body);
        if (marker >= 0xc0 && marker <= 0xc2) return takeFrame(body, marker == 0xc2);
        return marker == kStartOfScan ? checkScan(body) : Status{};
    }

  private:
    // Sixteen counts of codes, and as many values as they say together.
    Status takeHuffman(JpegBytes tables) {
        while (!tables.empty()) {
            std::size_t codes = 0;
            for (std::size_t k = 1; k <= 16 && k < tables.size(); ++k) codes += tables[k];
            if (tables.size() < 17 + codes || codes > 256)
                return damaged("a Huffman table of the JPEG claims " + std::to_string(codes) +
                               " codes");
            huffman_[tables[0] >> 4 & 1] |= 1u << (tables[0] & 15);
            tables = tables.subspan(17 + codes);
        }
        return {};
    }
    Status takeQuant(JpegBytes tables) {
        while (!tables.empty()) {
            const std::size_t size = tables[0] >> 4 == 0 ? 65 : 129;
            if (tables.size() < size) return damaged("a JPEG's table is cut short");
            quant_ |= 1u << (tables[0] & 15);
            tables = tables.subspan(size);
        }
        return {};
    }
    Status takeFrame(JpegBytes frame, bool progressive) {
        progressive_ = progressive;
        components_.clear();
        for (std::size_t at = 6; at + 2 < frame.size(); at += 3)
            components_.push_back({frame[at], frame[at + 2]});
        return {};
    }
    // What a scan uses must be there: the decoder takes what its memory held before.
    Status checkScan(JpegBytes scan) const {
        const std::size_t count = scan.empty() ? 0 : scan[0];
        if (scan.size() != 4 + 2 * count) return damaged("a scan of the JPEG is cut short");
        const unsigned first = scan[1 + 2 * count], refined = scan[3 + 2 * count] >> 4;
        const bool needsDc = progressive_ ? first == 0 && refined == 0 : true;
        const bool needsAc = progressive_ ? first != 0 : true;
        for (std::size_t k = 0; k < count; ++k) {
            const unsigned id = scan[1 + 2 * k], tables = scan[2 + 2 * k];
            const bool dc = (huffman_[0] >> (tables >> 4) & 1) != 0;
            const bool ac = (huffman_[1] >> (tables & 15) & 1) != 0;
            bool quant = true;
            for (const Component& component : components_)
                if (component.id == id)
                    quant = quant && (quant_ >> (component.quant & 31) & 1) != 0;
            if ((needsDc && !dc) || (needsAc && !ac) || !quant)
                return damaged("a scan of the JPEG uses a table that is not there");
        }
        return {};
    }

    struct Component {
        unsigned id, quant;
    };
    unsigned huffman_[2] = {0, 0}, quant_ = 0;  // bits, one for each table of DC and AC
    std::vector<Component> components_;
    bool progressive_ = false;
};

// Where the data of a scan that begins at `at` ends: at a marker that is neither stuffing nor a
// restart.
std::size_t endOfScan(JpegBytes bytes, std::size_t at) {
    for (; at + 1 < bytes.size(); ++at) {
        const unsigned char next = bytes[at + 1];
        if (bytes[at] == 0xff && next != 0 && !(next >= 0xd0 && next <= 0xd7)) return at;
    }
    return bytes.size();
}

}  // namespace

Expected<std::vector<unsigned char>> checkedJpeg(JpegBytes bytes) {
    std::vector<unsigned char> checked{0xff, kStartOfImage};
    checked.reserve(bytes.size());
    JpegTables tables;
    std::size_t at = 2;
    while (true) {
        while (at + 1 < bytes.size() && (bytes[at] != 0xff || bytes[at + 1] == 0xff)) ++at;
        if (at + 1 >= bytes.size()) return checked;
        const unsigned char marker = bytes[at + 1];
        at += 2;
        if (standsAlone(marker)) continue;
        if (marker == kEndOfImage) {
            checked.insert(checked.end(), {0xff, kEndOfImage});
            return checked;
        }
        if (bytes.size() - at < 2) return checked;
        const std::size_t length = static_cast<std::size_t>(bytes[at]) << 8 | bytes[at + 1];
        if (length < 2 || length > bytes.size() - at) return checked;
        if (Status status = tables.take(marker, bytes.subspan(at + 2, length - 2)); !status.ok())
            return status;
        const std::size_t stop =
            marker == kStartOfScan ? endOfScan(bytes, at + length) : at + length;
        checked.insert(checked.end(), {0xff, marker});
        checked.insert(checked.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                       bytes.begin() + static_cast<std::ptrdiff_t>(stop));
        at = stop;
    }
}

}  // namespace versorium
