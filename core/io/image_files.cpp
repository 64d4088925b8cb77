// SPDX-License-Identifier: MIT
#include "io/image_files.h"

#include <cassert>
#include <climits>
#include <cstring>
#include <string>

#include "io/exif.h"
#include "io/jpeg_segments.h"
#include "io/known_formats.h"
#include "io/text_scanner.h"

namespace {

// An IDAT chunk without bytes makes stb_image copy nothing to nowhere, which memcpy forbids.
inline void* copyBytes(void* to, const void* from, std::size_t count) {
    return count == 0 ? to : std::memcpy(to, from, count);
}

}  // namespace

// Only what is needed of stb_image, and nothing that touches files or has a global name.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS 32768
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#define memcpy copyBytes
#include <stb/stb_image.h>
#undef memcpy
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace versorium {
namespace {

Status unreadable(std::span<const unsigned char> bytes) {
    if (Status status = foreignFault(bytes); !status.ok()) return status;
    return Status::data("not a picture that can be read here; PNG, JPEG and BMP can");
}

}  // namespace

Expected<Raster<unsigned char>> readImage(std::span<const unsigned char> given) {
    // The decoder also takes a JPEG after any number of bytes 255, which would pass the check.
    if (!looksLikePicture(given)) return unreadable(given);
    std::span<const unsigned char> bytes = given;
    std::vector<unsigned char> jpeg;
    if (textOf(given).starts_with("\xff\xd8")) {
        Expected<std::vector<unsigned char>> checked = checkedJpeg(given);
        if (!checked) return checked.status();
        jpeg = *std::move(checked);
        bytes = jpeg;
    }
    if (bytes.size() > INT_MAX)
        return Status::data("the picture has " + std::to_string(bytes.size()) +
                            " bytes; at most 2 GiB are read");
    const int length = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (bytes.empty() || !stbi_info_from_memory(bytes.data(), length, &width, &height, &channels))
        return unreadable(bytes);
    const bool sane = width > 0 && height > 0 && width <= kImageSide && height <= kImageSide;
    if (!sane || static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > kImagePixels)
        return Status::data("the picture claims " + std::to_string(width) + " × " +
                            std::to_string(height) + " pixels; at most " +
                            std::to_string(kImageSide) + " on a side and " +
                            std::to_string(kImagePixels) + " in all are read");
    int decodedWidth = 0, decodedHeight = 0;
    stbi_uc* pixels =
        stbi_load_from_memory(bytes.data(), length, &decodedWidth, &decodedHeight, &channels, 4);
    if (pixels == nullptr) {
        const char* reason = stbi_failure_reason();
        return Status::data(std::string("the picture is damaged: ") +
                            (reason != nullptr ? reason : "it cannot be decoded"));
    }
    if (decodedWidth != width || decodedHeight != height) {
        stbi_image_free(pixels);
        return Status::data("the picture is damaged: its size is not the one it claims");
    }
    Raster<unsigned char> image({width, height}, 4);
    std::memcpy(image.values().data(), pixels, image.values().size());
    stbi_image_free(pixels);
    return upright(std::move(image), exifOrientation(given));
}

Raster<unsigned char> shapeMask(const Raster<unsigned char>& image, const MaskOptions& options) {
    assert(image.channels() == 4);
    Raster<unsigned char> mask(image.size(), 1);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const double lightness = 0.2126 * image.at(x, y, 0) + 0.7152 * image.at(x, y, 1) +
                                     0.0722 * image.at(x, y, 2);
            const double alpha = image.at(x, y, 3) / 255.0;
            const double shown = lightness / 255.0 * alpha + (1.0 - alpha);
            const bool inside =
                options.byAlpha ? alpha >= options.threshold : shown < options.threshold;
            mask.at(x, y) = inside != options.invert ? 1 : 0;
        }
    return mask;
}

}  // namespace versorium
