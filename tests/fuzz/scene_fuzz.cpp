// SPDX-License-Identifier: MIT
// Scenes as JSON and links of the studio: what is read is written so that it is read again.
#include <cstddef>
#include <string>

#include "scene/scene.h"
#include "workspace/workspace.h"

using namespace versorium;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    (void)workspaceFromLink(text);
    const Expected<Json> json = parseJson(text);
    if (!json) return 0;
    const Expected<Scene> scene = sceneFromJson(*json);
    if (!scene) {
        if (scene.status().message().empty()) __builtin_trap();
        return 0;
    }
    const Json written = sceneToJson(*scene);
    const Expected<Scene> again = sceneFromJson(written);
    if (!again || printJson(sceneToJson(*again)) != printJson(written)) __builtin_trap();
    return 0;
}
