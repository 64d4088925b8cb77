// SPDX-License-Identifier: MIT
// Grids of distances and lists of roots: what is read is written so that it is read again.
#include <cstddef>
#include <string_view>

#include "io/grid_files.h"
#include "io/root_files.h"

using namespace versorium;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::span<const unsigned char> bytes(data, size);
    for (const bool zFastest : {false, true})
        if (const Expected<Grid> grid = readGrid(bytes, {.zFastest = zFastest})) {
            const Expected<Grid> again =
                readGrid(writeGrid(*grid, {.zFastest = zFastest}), {.zFastest = zFastest});
            if (!again || again->values != grid->values) __builtin_trap();
        }
    (void)unpackGrid(bytes);
    const Expected<RootList> roots = readRoots(bytes);
    if (roots && !readRootsJson(writeRootsJson(*roots))) __builtin_trap();
    (void)readRootsBinary(bytes);
    (void)readRootsJson({reinterpret_cast<const char*>(data), size});
    return 0;
}
