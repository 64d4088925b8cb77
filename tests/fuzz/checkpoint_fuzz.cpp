// SPDX-License-Identifier: MIT
// Counts of averaged maps, as render --averaged keeps them.
#include <cstddef>

#include "render/cpu/averaged_map.h"
#include "scene/scene.h"

using namespace versorium;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    static const Scene scene = *presetNamed("averaged-star");
    Expected<AveragedMap> map = AveragedMap::make(scene, {8, 8});
    if (!map) __builtin_trap();
    const Status status = map->restore({data, size});
    if (!status.ok() && status.message().empty()) __builtin_trap();
    if (!status.ok() && map->members() != 0) __builtin_trap();
    if (status.ok() && !map->restore(map->save()).ok()) __builtin_trap();
    return 0;
}
