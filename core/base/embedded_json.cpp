// SPDX-License-Identifier: MIT
#include "base/embedded_json.h"

#include <cassert>

#include "base/embedded.h"

namespace versorium {

std::vector<std::string> embeddedJsonNames(std::string_view folder) {
    constexpr std::string_view ending = ".json";
    std::vector<std::string> names;
    for (const std::string_view name : embeddedNames(folder))
        names.emplace_back(name.substr(folder.size(), name.size() - folder.size() - ending.size()));
    return names;
}

std::string embeddedJsonList(std::string_view folder) {
    std::string all;
    for (const std::string& name : embeddedJsonNames(folder))
        all += (all.empty() ? "" : ", ") + name;
    return all;
}

Json embeddedJson(std::string_view folder, const std::string& name) {
    const std::string_view text = embeddedText(std::string(folder) + name + ".json");
    if (text.empty()) return nullptr;
    Expected<Json> json = parseJson(text);
    assert(json);
    return json ? *std::move(json) : Json();
}

}  // namespace versorium
