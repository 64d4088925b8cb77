// SPDX-License-Identifier: MIT
#include "io/stb_png.h"

#include <cstdlib>

namespace {

void* boundedAllocate(std::size_t size) {
    return size > versorium::stb::kInflateLimit ? nullptr : std::malloc(size);
}
void* boundedReallocate(void* block, std::size_t size) {
    return size > versorium::stb::kInflateLimit ? nullptr : std::realloc(block, size);
}

}  // namespace

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_SIMD
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_MAX_DIMENSIONS (1 << 26)
#define STBI_MALLOC(size) boundedAllocate(size)
#define STBI_REALLOC(block, size) boundedReallocate(block, size)
#define STBI_FREE(block) std::free(block)
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace versorium::stb {
namespace {

std::vector<unsigned char> take(unsigned char* block, int size) {
    if (!block) return {};
    std::vector<unsigned char> bytes(block, block + size);
    std::free(block);
    return bytes;
}

}  // namespace

std::vector<unsigned char> writePng(const Raster<unsigned char>& pixels) {
    int size = 0;
    unsigned char* block =
        stbi_write_png_to_mem(pixels.values().data(), pixels.width() * pixels.channels(),
                              pixels.width(), pixels.height(), pixels.channels(), &size);
    return take(block, size);
}

std::vector<unsigned char> deflate(std::span<const unsigned char> bytes) {
    int size = 0;
    // The encoder only reads through this pointer.
    unsigned char* block = stbi_zlib_compress(const_cast<unsigned char*>(bytes.data()),
                                              static_cast<int>(bytes.size()), &size, 8);
    return take(block, size);
}

int inflate(std::span<const unsigned char> bytes, std::span<unsigned char> out) {
    return stbi_zlib_decode_buffer(
        reinterpret_cast<char*>(out.data()), static_cast<int>(out.size()),
        reinterpret_cast<const char*>(bytes.data()), static_cast<int>(bytes.size()));
}

}  // namespace versorium::stb
