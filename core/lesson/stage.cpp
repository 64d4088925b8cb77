// SPDX-License-Identifier: MIT
#include "lesson/stage.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>

#include "base/text.h"
#include "scene/properties.h"
#include "workspace/workspace_properties.h"

namespace versorium {
namespace {

// A number at `at` with the sign before it; moves `at` behind it.
std::optional<double> numberAt(const std::string& text, std::size_t& at) {
    std::size_t i = at;
    double sign = 1;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) sign = text[i++] == '-' ? -1 : 1;
    while (i < text.size() && text[i] == ' ') ++i;
    if (i < text.size() && text[i] == 'i') {
        at = i;
        return sign;
    }
    if (i >= text.size() || !(std::isdigit(static_cast<unsigned char>(text[i])) || text[i] == '.'))
        return {};
    char* end = nullptr;
    const double value = std::strtod(text.c_str() + i, &end);
    if (end == text.c_str() + i || !std::isfinite(value)) return {};
    at = static_cast<std::size_t>(end - text.c_str());
    return sign * value;
}

std::vector<double> complexNumber(const std::string& text) {
    double parts[2] = {};
    bool has[2] = {};
    std::size_t i = 0;
    while (i < text.size()) {
        while (i < text.size() && text[i] == ' ') ++i;
        const std::optional<double> number = numberAt(text, i);
        if (!number) return {};
        const bool imaginary = i < text.size() && text[i] == 'i';
        if (imaginary) ++i;
        if (has[imaginary]) return {};
        has[imaginary] = true;
        parts[imaginary] = *number;
        while (i < text.size() && text[i] == ' ') ++i;
        if (i < text.size() && text[i] != '+' && text[i] != '-') return {};
    }
    if (has[1]) return {parts[0], parts[1]};
    return has[0] ? std::vector<double>{parts[0]} : std::vector<double>{};
}

Json valueOf(const std::string& text) {
    if (Expected<Json> json = parseJson(text)) return std::move(*json);
    const std::vector<double> numbers = numbersOf(text);
    if (!numbers.empty()) return numbers;
    return text;
}

// The member at a path of keys with dots between them; a key may hold a dot itself ("g.a2").
Json* memberAt(Json& json, const std::string& path) {
    if (!json.is_object()) return nullptr;
    if (const auto whole = json.find(path); whole != json.end()) return &*whole;
    for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', dot + 1))
        if (const auto part = json.find(path.substr(0, dot)); part != json.end())
            if (Json* found = memberAt(*part, path.substr(dot + 1))) return found;
    return nullptr;
}

// A list of one number may be written without brackets; an object stands for itself ("start:
// {"critical": 0}").
Json suited(Json value, const Json& present) {
    if (present.is_array() && !value.is_array() && !value.is_object())
        return Json::array({std::move(value)});
    return value;
}

// What the key names, and its value with that change: a property by its path, else a member of one
// ("lists.roots.scale").
template <class Owner>
std::optional<std::pair<Property<Owner>, Json>> changeOf(const Owner& owner,
                                                         const PropertyTable<Owner>& table,
                                                         const std::string& key,
                                                         const std::string& value) {
    for (std::size_t end = key.size(); end != std::string::npos && end > 0;
         end = key.rfind('.', end - 1)) {
        const auto property =
            std::find_if(table.begin(), table.end(), [&](const Property<Owner>& one) {
                return std::string_view(one.path) == std::string_view(key).substr(0, end);
            });
        if (property == table.end()) continue;
        Json whole = property->get(owner);
        Json* member = end == key.size() ? &whole : memberAt(whole, key.substr(end + 1));
        if (!member) return std::nullopt;
        *member = suited(valueOf(value), *member);
        return std::pair{*property, std::move(whole)};
    }
    return std::nullopt;
}

class Change {
  public:
    explicit Change(const Workspace& before) : now_(before) {}

    Status apply(const StageLine& line) {
        Status status = set(line.key, line.value);
        return status.ok() ? status
                           : Status::data("line " + std::to_string(line.line) + ": " + line.key +
                                          ": " + status.message());
    }
    Workspace take() { return std::move(now_); }

  private:
    Workspace now_;

    Status set(const std::string& key, const std::string& value) {
        if (key == "preset" || key == "map") {
            Expected<Scene> scene = key == "map" ? sceneOfMap(value) : presetNamed(value);
            if (!scene) return scene.status();
            now_ = workspaceOf(*scene);
            return {};
        }
        if (key == "link") {
            Expected<Workspace> linked = workspaceFromLink(value);
            if (!linked) return linked.status();
            now_ = std::move(*linked);
            return {};
        }
        if (key == "views") return setViews(value);
        if (key == "point") return setPoint(value);
        if (key == "circle") return addCircle(value);
        if (isList(key)) return setList(key, value);
        if (key == "pin") {
            if (value == "none")
                now_.pins.clear();
            else if (value != "now")
                return Status::data("must be \"now\" or \"none\"");
            else if (now_.pins.size() >= kMostPins)
                return Status::data("there are four pins already");
            else
                now_.pins.push_back(now_.views[now_.speaker()].parameters);
            return {};
        }
        if (key == "shape") return changeScenes("shape.source", value, allViews());
        const std::size_t dot = key.find('.');
        const std::string head = key.substr(0, dot);
        if (dot != std::string::npos &&
            (head == "left" || head == "right" || (head.size() == 5 && head.starts_with("view")))) {
            const std::size_t view = head == "left"    ? 0
                                     : head == "right" ? 1
                                                       : static_cast<std::size_t>(head[4] - '1');
            if (view >= now_.views.size())
                return Status::data("there are only " + std::to_string(now_.views.size()) +
                                    " views");
            return changeScenes(key.substr(dot + 1), value, {view});
        }
        if (const ParameterInfo* parameter = parameterNamed(key))
            return setParameter(*parameter, value);
        if (numberNamed(now_.views[0], key)) {
            const std::vector<double> numbers = numbersOf(value);
            if (numbers.size() != 1) return Status::data("must be a number");
            setSharedNumber(now_, key, numbers[0]);
            return {};
        }
        if (changeOf(now_.views[0], propertiesOf(now_.views[0]), key, value))
            return changeScenes(key, value, allViews());
        return changeWorkspace(key, value);
    }

    // Of any map: it is told that this one has no such list.
    static bool isList(const std::string& name) {
        return findMapWhere([&](const MapInfo& info) {
            return std::find(info.lists.begin(), info.lists.end(), name) != info.lists.end();
        });
    }

    std::vector<std::size_t> allViews() const {
        std::vector<std::size_t> all;
        for (std::size_t k = 0; k < now_.views.size(); ++k) all.push_back(k);
        return all;
    }

    const ParameterInfo* parameterNamed(const std::string& name) const {
        for (const ParameterInfo& parameter : mapOf(now_.views[0]).info.parameters)
            if (parameter.name == name) return &parameter;
        return nullptr;
    }

    Status setParameter(const ParameterInfo& parameter, const std::string& value) {
        std::vector<double> numbers = numbersOf(value);
        const auto width = static_cast<std::size_t>(widthOf(parameter.kind));
        // A complex number may be real.
        if (numbers.size() == 1 && width > 1) numbers.resize(width, 0.0);
        if (numbers.size() != width)
            return Status::data("must be " + std::to_string(width) + " number" +
                                (width > 1 ? "s" : ""));
        setSharedParameter(now_, std::string(parameter.name), numbers);
        return {};
    }

    Status setViews(const std::string& value) {
        const Scene like = now_.views[now_.speaker()];
        if (value == "both") {
            setViewCount(now_, 2);
            now_.views[0] = homeView(ViewKind::parameters, like);
            now_.views[1] = homeView(ViewKind::startingPoints, like);
        } else if (const auto kind = fromWord<ViewKind>(value)) {
            now_.focused = 0;
            setViewCount(now_, 1);
            now_.views[0] = homeView(*kind, like);
        } else if (value == "1" || value == "2" || value == "4") {
            setViewCount(now_, value[0] - '0');
        } else {
            return Status::data("must be both, parameters, starts, 1, 2 or 4");
        }
        now_.focused = std::min(now_.focused, static_cast<int>(now_.views.size()) - 1);
        return {};
    }

    Status setPoint(const std::string& value) {
        std::vector<double> numbers = numbersOf(value);
        if (numbers.empty() || numbers.size() > now_.point.size())
            return Status::data("must be at most " + std::to_string(now_.point.size()) +
                                " numbers");
        numbers.resize(now_.point.size(), 0.0);
        now_.point = numbers;
        return {};
    }

    Status addCircle(const std::string& value) {
        const std::vector<double> numbers = numbersOf(value);
        if (value == "none") {
            now_.circles.clear();
            return {};
        }
        if (numbers.size() != 3 || !(numbers[2] > 0))
            return Status::data("must be \"none\", or three numbers: x, y, and a radius above 0");
        if (now_.circles.size() >= kMostCircles)
            return Status::data("there are eight circles already");
        now_.circles.push_back({{numbers[0], numbers[1], 0, 0}, numbers[2]});
        return {};
    }

    Status setList(const std::string& key, const std::string& value) {
        if (!now_.views[0].lists.contains(key))
            return Status::data("the map \"" + now_.views[0].map + "\" has no such list");
        const auto width = static_cast<std::size_t>(std::max(2, mapOf(now_.views[0]).dimension));
        RootList list;
        for (std::size_t begin = 0; begin <= value.size() && value != "none";) {
            const std::size_t end = std::min(value.find(';', begin), value.size());
            std::string item = trimmed(value.substr(begin, end - begin));
            std::replace(item.begin(), item.end(), ' ', ',');
            const std::vector<double> numbers = numbersOf(item);
            if (numbers.size() != width && numbers.size() != width + 1)
                return Status::data("\"" + item + "\" must be " + std::to_string(width) +
                                    " numbers, and perhaps a power");
            RootList::Root root;
            for (std::size_t k = 0; k < width; ++k) root.q[k] = numbers[k];
            if (numbers.size() > width) root.power = numbers[width];
            list.roots.push_back(root);
            begin = end + 1;
        }
        for (Scene& scene : now_.views) scene.lists[key].roots = list.roots;
        return {};
    }

    Status changeScenes(const std::string& key, const std::string& value,
                        const std::vector<std::size_t>& views) {
        for (const std::size_t k : views) {
            Scene& scene = now_.views[k];
            const auto change = changeOf(scene, propertiesOf(scene), key, value);
            if (!change) return unknownValue(scene, key);
            if (Status status = setProperty(scene, change->first, change->second); !status.ok())
                return status;
        }
        return {};
    }

    Status changeWorkspace(const std::string& key, const std::string& value) {
        const auto change = changeOf(now_, propertiesOf(now_), key, value);
        if (!change) return unknownValue(now_.views[0], key);
        Workspace next = now_;
        const auto& [property, json] = *change;
        if (Status status = property.set(next, json, property.path); !status.ok()) return status;
        if (next.orbitAt > next.orbitSteps)
            return Status::data("must be at most orbit_steps").in("orbit_at");
        now_ = std::move(next);
        return {};
    }
};

}  // namespace

std::vector<double> numbersOf(const std::string& text) {
    std::string inner = trimmed(text);
    if (inner.size() > 1 && inner.front() == '(' && inner.back() == ')')
        inner = inner.substr(1, inner.size() - 2);
    // A decimal comma is none of ours: commas part numbers.
    if (inner.find(',') == std::string::npos) return complexNumber(inner);
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= inner.size();) {
        const std::size_t end = std::min(inner.find(',', begin), inner.size());
        const std::vector<double> one = complexNumber(trimmed(inner.substr(begin, end - begin)));
        if (one.size() != 1) return {};
        numbers.push_back(one[0]);
        begin = end + 1;
    }
    return numbers;
}

std::string atLine(int line) { return "line " + std::to_string(line) + ": "; }

std::vector<std::string> splitWords(const std::string& text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : text + " ") {
        if (c != ' ' && c != ',' && c != '\n' && c != '\r' && c != '\t') {
            word += c;
        } else if (!word.empty()) {
            words.push_back(word);
            word.clear();
        }
    }
    return words;
}

Expected<std::vector<StageLine>> readLines(const std::string& text, int firstLine) {
    std::vector<StageLine> lines;
    int number = firstLine;
    for (std::size_t begin = 0; begin < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = trimmed(text.substr(begin, end - begin));
        begin = end + 1;
        if (line.empty() || line[0] == '#') continue;
        const std::size_t colon = line.find(':');
        const std::string key = trimmed(line.substr(0, colon));
        if (colon == std::string::npos || key.empty())
            return Status::data("line " + std::to_string(number) + ": \"" + line +
                                "\" must be \"key: value\"");
        lines.push_back({key, trimmed(line.substr(colon + 1)), number});
    }
    return lines;
}

Expected<Workspace> changed(const Workspace& before, const std::vector<StageLine>& lines) {
    Change change(before);
    for (const StageLine& line : lines)
        if (Status status = change.apply(line); !status.ok()) return status;
    return change.take();
}

}  // namespace versorium
