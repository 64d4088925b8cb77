// SPDX-License-Identifier: MIT
// Palettes of this program and of others: what is read is written so that it is read again.
#include <cstddef>

#include "io/palette_files.h"

using namespace versorium;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::span<const unsigned char> bytes(data, size);
    (void)looksLikePalette(bytes);
    for (const char* name : {"a.map", "a.cpt"}) {
        const Expected<PaletteFile> file = readPaletteFile(bytes, name);
        if (!file) {
            if (file.status().message().empty()) __builtin_trap();
            continue;
        }
        for (const double position : {0.0, 0.3, 1.0}) (void)file->palette.at(position);
        if (!paletteFromJson(paletteToJson(file->palette))) __builtin_trap();
    }
    return 0;
}
