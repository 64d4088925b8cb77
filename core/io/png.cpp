// SPDX-License-Identifier: MIT
#include "io/png.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string_view>

#include "base/hash.h"
#include "io/stb_png.h"

namespace versorium {
namespace {

using Bytes = std::vector<unsigned char>;
using View = std::span<const unsigned char>;

constexpr unsigned char kSignature[8] = {137, 'P', 'N', 'G', '\r', '\n', 26, '\n'};
constexpr std::size_t kHeaderChunk = 8 + 25;  // signature and IHDR
constexpr std::size_t kCompressFrom = 1024;   // shorter texts stay readable in the file
constexpr std::size_t kPlainAscii = 1 << 16;  // longer texts of ASCII are packed
// Deflate packs at most 258 bytes into two bits.
constexpr long long kDeflateRatio = 1032;

void putBig32(Bytes& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(static_cast<unsigned char>(value >> shift));
}

std::uint32_t get32(View bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) << 24 |
           static_cast<std::uint32_t>(bytes[at + 1]) << 16 |
           static_cast<std::uint32_t>(bytes[at + 2]) << 8 | bytes[at + 3];
}

void putChunk(Bytes& out, std::string_view type, View data) {
    putBig32(out, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = out.size();
    out.insert(out.end(), type.begin(), type.end());
    out.insert(out.end(), data.begin(), data.end());
    putBig32(out, crc32(View(out).subspan(start)));
}

bool validUtf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const int length = lead < 0x80   ? 1
                           : lead < 0xc2 ? 0
                           : lead < 0xe0 ? 2
                           : lead < 0xf0 ? 3
                           : lead < 0xf5 ? 4
                                         : 0;
        if (length == 0 || i + static_cast<std::size_t>(length) > text.size()) return false;
        for (int k = 1; k < length; ++k)
            if ((static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]) & 0xc0) != 0x80)
                return false;
        i += static_cast<std::size_t>(length);
    }
    return true;
}

Status checkKeyword(std::string_view keyword) {
    bool good =
        !keyword.empty() && keyword.size() <= 79 && keyword.front() != ' ' && keyword.back() != ' ';
    for (const char c : keyword) good = good && c >= ' ' && c <= '~';
    if (good) return {};
    return Status::usage("a keyword of a PNG text has 1 to 79 printable ASCII characters");
}

bool isAscii(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= 0 && c < 127; });
}

Status putPacked(Bytes& out, View plain) {
    const Bytes stream = stb::deflate(plain);
    if (stream.empty()) return Status::inputOutput("out of memory while packing a PNG text");
    out.insert(out.end(), stream.begin(), stream.end());
    return {};
}

// tEXt, which image editors keep where they drop the others; zTXt where it is long.
Status putAscii(Bytes& out, const PngText& text, View plain) {
    Bytes data(text.keyword.begin(), text.keyword.end());
    data.push_back(0);
    if (plain.size() <= kPlainAscii) {
        data.insert(data.end(), plain.begin(), plain.end());
        putChunk(out, "tEXt", data);
        return {};
    }
    data.push_back(0);  // deflate
    if (Status status = putPacked(data, plain); !status.ok()) return status;
    putChunk(out, "zTXt", data);
    return {};
}

Status putText(Bytes& out, const PngText& text) {
    if (Status status = checkKeyword(text.keyword); !status.ok()) return status;
    if (text.text.size() > kPngTextLimit)
        return Status::usage("the text \"" + text.keyword +
                             "\" is too long for a PNG: " + std::to_string(text.text.size()) +
                             " bytes, the limit is " + std::to_string(kPngTextLimit));
    if (!validUtf8(text.text) || text.text.find('\0') != std::string::npos)
        return Status::usage("the text \"" + text.keyword + "\" is not plain UTF-8");
    Bytes data(text.keyword.begin(), text.keyword.end());
    const View plain(reinterpret_cast<const unsigned char*>(text.text.data()), text.text.size());
    if (isAscii(text.text)) return putAscii(out, text, plain);
    const bool packed = plain.size() > kCompressFrom;
    // Zero, compression flag and method, empty language and translated keyword.
    for (const int value : {0, packed ? 1 : 0, 0, 0, 0})
        data.push_back(static_cast<unsigned char>(value));
    if (packed) {
        if (Status status = putPacked(data, plain); !status.ok()) return status;
    } else {
        data.insert(data.end(), plain.begin(), plain.end());
    }
    putChunk(out, "iTXt", data);
    return {};
}

Status torn(std::size_t at) {
    return Status::data("the PNG is torn at byte " + std::to_string(at) +
                        ": the file is incomplete, fetch or write it again");
}

using ChunkVisitor = std::function<Status(std::string_view type, View data)>;

// Walks over all chunks of the file with lengths and CRCs checked.
Status walkChunks(View bytes, const ChunkVisitor& visit) {
    const std::size_t head = std::min(bytes.size(), sizeof kSignature);
    if (!std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(head), kSignature))
        return Status::data("not a PNG: the file begins otherwise");
    if (head < sizeof kSignature)
        return bytes.empty() ? Status::data("not a PNG: the file is empty") : torn(bytes.size());
    std::size_t at = sizeof kSignature;
    bool first = true;
    while (true) {
        if (bytes.size() - at < 12) return torn(bytes.size());
        const std::uint32_t length = get32(bytes, at);
        if (length > 0x7fffffffU)
            return Status::data("the PNG is wrong at byte " + std::to_string(at) +
                                ": a chunk claims " + std::to_string(length) + " bytes");
        if (length > bytes.size() - at - 12) return torn(bytes.size());
        const View body = bytes.subspan(at + 4, std::size_t{4} + length);
        if (crc32(body) != get32(bytes, at + 8 + length))
            return Status::data("the PNG is damaged: wrong CRC of the chunk at byte " +
                                std::to_string(at));
        const std::string_view type(reinterpret_cast<const char*>(body.data()), 4);
        if (first && (type != "IHDR" || length != 13))
            return Status::data("the PNG is wrong at byte 8: it must begin with IHDR");
        first = false;
        if (Status status = visit(type, body.subspan(4)); !status.ok()) return status;
        if (type == "IEND") return {};
        at += std::size_t{12} + length;
    }
}

// Unpacks a stream of unknown length: buffers that double, up to what deflate or the limit allow.
Expected<std::string> unpack(View stream, const std::string& keyword) {
    const std::size_t most =
        std::min(kPngTextLimit, stream.size() * static_cast<std::size_t>(kDeflateRatio) + 64);
    std::size_t size = std::min(most, std::max<std::size_t>(4096, stream.size() * 4));
    std::string text;
    while (true) {
        text.resize(size);
        const int used =
            stb::inflate(stream, {reinterpret_cast<unsigned char*>(text.data()), text.size()});
        if (used >= 0) {
            text.resize(static_cast<std::size_t>(used));
            return text;
        }
        if (size == most)
            return Status::data("the PNG text \"" + keyword +
                                "\" cannot be unpacked: it is damaged or longer than " +
                                std::to_string(kPngTextLimit) + " bytes");
        size = std::min(most, size * 2);
    }
}

// The bytes before the next zero, which is dropped as well.
bool takeUntilZero(View& data, std::string& out) {
    const auto zero = std::find(data.begin(), data.end(), 0);
    if (zero == data.end()) return false;
    out.assign(data.begin(), zero);
    data = data.subspan(static_cast<std::size_t>(zero - data.begin()) + 1);
    return true;
}

// What is no UTF-8 is Latin-1, as the standard has it.
std::string utf8FromLatin1(std::string text) {
    if (validUtf8(text)) return text;
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            result += c;
        } else {
            result += static_cast<char>(0xc0 | byte >> 6);
            result += static_cast<char>(0x80 | (byte & 0x3f));
        }
    }
    return result;
}

// tEXt: a keyword, a zero and the text; zTXt has a method before the text and packs it.
Expected<PngText> readLatinText(View data, bool packed) {
    PngText text;
    const std::string wrong = std::string("a ") + (packed ? "zTXt" : "tEXt") +
                              " chunk of the PNG does not follow the standard";
    if (!takeUntilZero(data, text.keyword) || !checkKeyword(text.keyword).ok())
        return Status::data(wrong);
    if (packed) {
        if (data.empty() || data[0] != 0) return Status::data(wrong);
        Expected<std::string> plain = unpack(data.subspan(1), text.keyword);
        if (!plain) return plain.status();
        text.text = utf8FromLatin1(*std::move(plain));
        return text;
    }
    if (data.size() > kPngTextLimit) return Status::data(wrong);
    text.text = utf8FromLatin1(std::string(data.begin(), data.end()));
    return text;
}

Expected<PngText> readText(View data) {
    const Status wrong = Status::data("an iTXt chunk of the PNG does not follow the standard");
    PngText text;
    std::string ignored;
    if (!takeUntilZero(data, text.keyword) || !checkKeyword(text.keyword).ok()) return wrong;
    if (data.size() < 2 || data[0] > 1 || data[1] != 0) return wrong;
    const bool packed = data[0] == 1;
    data = data.subspan(2);
    if (!takeUntilZero(data, ignored) || !takeUntilZero(data, ignored)) return wrong;
    if (packed) {
        Expected<std::string> plain = unpack(data, text.keyword);
        if (!plain) return plain.status();
        text.text = *std::move(plain);
    } else {
        if (data.size() > kPngTextLimit) return wrong;
        text.text.assign(data.begin(), data.end());
    }
    if (!validUtf8(text.text))
        return Status::data("the PNG text \"" + text.keyword + "\" is not UTF-8");
    return text;
}

// Refuses sizes that are beyond the limits or that the packed bytes cannot possibly fill.
}  // namespace

Expected<Bytes> encodePng(const Raster<unsigned char>& pixels, const PngOptions& options) {
    const int channels = pixels.channels();
    if (pixels.width() < 1 || pixels.height() < 1 || channels == 2 || channels > 4)
        return Status::usage("a PNG needs at least one pixel and 1, 3 or 4 channels");
    if ((static_cast<long long>(pixels.width()) * channels + 1) * pixels.height() > kPngByteLimit)
        return Status::usage(
            "the picture is too large for a PNG: " + std::to_string(pixels.width()) + " x " +
            std::to_string(pixels.height()) + " pixels");
    const Bytes plain = stb::writePng(pixels);
    if (plain.size() < kHeaderChunk)
        return Status::inputOutput("out of memory while packing a PNG");

    Bytes out(plain.begin(), plain.begin() + kHeaderChunk);
    const unsigned char perceptual[1] = {0};
    putChunk(out, "sRGB", perceptual);
    if (options.dotsPerInch > 0 && options.dotsPerInch < 1e6) {
        const auto perMetre =
            static_cast<std::uint32_t>(std::floor(options.dotsPerInch / 0.0254 + 0.5));
        Bytes data;
        putBig32(data, perMetre);
        putBig32(data, perMetre);
        data.push_back(1);  // the unit is the metre
        putChunk(out, "pHYs", data);
    }
    for (const PngText& text : options.texts)
        if (Status status = putText(out, text); !status.ok()) return status;
    out.insert(out.end(), plain.begin() + kHeaderChunk, plain.end());
    return out;
}

Expected<std::vector<PngText>> decodePngText(View bytes) {
    std::vector<PngText> texts;
    Status status = walkChunks(bytes, [&](std::string_view type, View data) -> Status {
        if (type != "iTXt" && type != "tEXt" && type != "zTXt") return {};
        Expected<PngText> text =
            type == "iTXt" ? readText(data) : readLatinText(data, type == "zTXt");
        if (!text) return text.status();
        // Some programs end a text with a zero.
        text->text.resize(std::min(text->text.find('\0'), text->text.size()));
        texts.push_back(*std::move(text));
        return {};
    });
    if (!status.ok()) return status;
    return texts;
}

}  // namespace versorium
