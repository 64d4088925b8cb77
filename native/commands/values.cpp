// SPDX-License-Identifier: MIT
// The table of a scene's values, for whoever writes --set, a scene file or a lesson.
#include <memory>

#include "commands/commands.h"
#include "commands/open.h"
#include "scene/properties.h"

namespace versorium {
namespace {

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size() + 2, width), ' ');
    return text;
}

bool isNumber(const ValueInfo& info) {
    return info.kind == ValueKind::number || info.kind == ValueKind::whole;
}

Json rowOf(const Scene& scene, const SceneProperty& property) {
    Json words = Json::array();
    for (const std::string& word : property.words) words.push_back(word);
    return Json{
        {"path", property.path},
        {"kind", std::string(wordOf(property.kind))},
        {"value", property.get(scene)},
        {"default", defaultOf(scene, property)},
        {"range", isNumber(property) ? Json::array({property.low, property.high}) : Json(nullptr)},
        {"words", words},
        {"unit", std::string(property.unit)},
        {"help", std::string(property.help)}};
}

std::string lineOf(const Scene& scene, const SceneProperty& property) {
    const Json value = property.get(scene);
    std::string shown = value.is_string() ? value.get<std::string>() : value.dump();
    constexpr std::size_t kLongest = 40;
    if (shown.size() > kLongest) shown = shown.substr(0, kLongest - 3) + "...";
    std::string allowed;
    for (const std::string& word : property.words)
        allowed += (allowed.empty() ? "" : "|") + (word.empty() ? "\"\"" : word);
    if (isNumber(property))
        allowed = formatNumber(property.low) + " to " + formatNumber(property.high);
    if (!property.unit.empty()) allowed += " " + std::string(property.unit);
    if (!allowed.empty()) allowed = " [" + allowed + "]";
    return padded(property.path, 32) + padded(shown, 16) + std::string(property.help) + allowed +
           "\n";
}

Status listValues(const SceneRequest& request, bool json) {
    SceneRequest asked = request;
    if (asked.scene.empty() && asked.map.empty()) asked.map = Scene().map;
    const Expected<OpenedScene> opened = openScene(asked);
    if (!opened) return opened.status();
    Json rows = Json::array();
    std::string text;
    for (const SceneProperty& property : propertiesOf(opened->scene)) {
        if (property.kind == ValueKind::group) continue;
        rows.push_back(rowOf(opened->scene, property));
        text += lineOf(opened->scene, property);
    }
    return print(json ? printJson(rows) : text);
}

}  // namespace

void addValuesCommand(CommandLine& line) {
    CLI::App* values =
        line.add("values", "List every value of a scene: its path for --set, value, range, help.",
                 "  versorium values                        # of the quadratic family\n"
                 "  versorium values henon\n"
                 "  versorium values picture.png --json\n"
                 "With --json each value has path, kind, value, default, range, words, unit and "
                 "help.\n");
    const auto request = std::make_shared<SceneRequest>();
    const auto json = std::make_shared<bool>(false);
    addSceneOptions(*values, *request);
    values->add_flag("--json", *json, "as JSON");
    line.run(values, [request, json] { return listValues(*request, *json); });
}

}  // namespace versorium
