// SPDX-License-Identifier: MIT
// Views of other programs, and files that are refused by their names.
#include <cstddef>

#include "io/foreign_views.h"
#include "io/known_formats.h"

using namespace versorium;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::span<const unsigned char> bytes(data, size);
    (void)looksLikePicture(bytes);
    (void)foreignFault(bytes);
    const bool looks = looksLikeForeignView(bytes);
    const Expected<ForeignView> view = readForeignView(bytes);
    if (!view && view.status().message().empty()) __builtin_trap();
    if (view && looks && !sceneFromJson(sceneToJson(view->scene))) __builtin_trap();
    return 0;
}
