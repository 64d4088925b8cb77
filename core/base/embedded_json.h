// SPDX-License-Identifier: MIT
#pragma once
// JSON files that the build puts into the program: presets, plates, animations.

#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"

namespace versorium {

// Their names without the folder ("plates/") and ".json", in alphabetical order.
std::vector<std::string> embeddedJsonNames(std::string_view folder);
// The same as a text for messages, "one, two".
std::string embeddedJsonList(std::string_view folder);
// One of them; null where there is none of this name. The build's own files are right, as tests
// say.
Json embeddedJson(std::string_view folder, const std::string& name);

}  // namespace versorium
