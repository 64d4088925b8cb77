// SPDX-License-Identifier: MIT
#include "ui/controls/control_list.h"

#include <algorithm>
#include <cmath>

#include "render/bind.h"
#include "scene/numbers.h"
#include "ui/controls/access.h"

namespace versorium {
namespace {

// Where a number's slider has no range of its own.
constexpr double kStepsOfSlider = 400;

std::string textOf(const ValueInfo& info, const Json& value) {
    if (value.is_number()) return formatNumber(value.get<double>());
    if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
    if (value.is_string())
        return value.get<std::string>().empty() ? std::string(info.unsaid)
                                                : value.get<std::string>();
    std::string text;
    if (!value.is_array()) return value.dump();
    for (const Json& item : value)
        text += (text.empty() ? "" : ", ") +
                (item.is_number() ? formatNumber(item.get<double>()) : item.dump());
    return text;
}

// Numbers with commas, semicolons or spaces between them; null where that is no such list.
Json listFromText(std::string text) {
    Json list = Json::array();
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
    for (std::size_t at = text.find_first_not_of(' '); at != std::string::npos;
         at = text.find_first_not_of(' ', at)) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::optional<double> number = parseShownNumber(text.substr(at, end - at));
        if (!number) return {};
        list.push_back(*number);
        at = end;
    }
    return list;
}

// The JSON that a control's text means; null where it means nothing.
Json jsonOf(const ValueInfo& info, const Json& now, const std::string& text) {
    switch (info.kind) {
        case ValueKind::number:
        case ValueKind::whole: {
            const std::optional<double> number = parseShownNumber(text);
            return number ? Json(*number) : Json();
        }
        case ValueKind::toggle:
            return text == "on" ? Json(true) : text == "off" ? Json(false) : Json();
        case ValueKind::word:
            return !info.unsaid.empty() && text == info.unsaid ? Json("") : Json(text);
        case ValueKind::numbers:
            return listFromText(text);
        case ValueKind::colour: {
            if (now.is_string()) return text;
            const Expected<Colour> colour = colourFromHex(text);
            if (!colour) return {};
            const DisplayColour c = displayFromColour(*colour);
            return numbersToJson({c.r, c.g, c.b, now[3].get<double>()});
        }
        default:
            return text;
    }
}

ControlKind kindOf(ValueKind kind) {
    switch (kind) {
        case ValueKind::number:
        case ValueKind::whole:
            return ControlKind::number;
        case ValueKind::toggle:
            return ControlKind::toggle;
        case ValueKind::word:
            return ControlKind::choice;
        case ValueKind::colour:
            return ControlKind::colour;
        default:
            return ControlKind::text;
    }
}

// What a value is called within its own section.
std::string nameOf(const ValueInfo& info) {
    return info.label.empty() || info.label == info.path ? info.path : tr(info.label);
}

// "escaped: fast": a value within a part of a section is called by the part as well.
std::string labelOf(const ValueInfo& info) {
    const std::string label = nameOf(info);
    if (info.label.empty()) return label;
    if (info.path.starts_with("colour.escaped.")) return tr(std::string("escaped")) + ": " + label;
    if (info.path.starts_with("colour.attracted."))
        return tr(std::string("attracted")) + ": " + label;
    if (info.path.starts_with("modulation.alpha.")) return "α, " + label;
    if (info.path.starts_with("modulation.beta.")) return "β, " + label;
    if (const std::size_t open = info.path.find('['); open != std::string::npos) {
        const std::size_t close = info.path.find("].", open);
        if (close != std::string::npos) return info.path.substr(0, close + 1) + ": " + label;
    }
    return label;
}

// What a hand may set: less than what a file may hold, so that nothing is lost out of sight.
std::array<double, 2> studioLimits(const ValueInfo& info) {
    constexpr double kFarthest = 1e6, kFar = 1e12;
    constexpr int kMostShownIterations = 1000000;
    if (info.path == "slice.height") return {kLeastHeight, kMostHeight};
    if (info.path == "iterations") return {1, kMostShownIterations};
    const bool far = info.high >= kFar;
    return {far && info.low < 0 ? -kFarthest : info.low, far ? kFarthest : info.high};
}

bool isAllowed(const ValueInfo& info, const Json& value) {
    if (!value.is_number() || !(info.low < info.high)) return true;
    const std::array<double, 2> limits = studioLimits(info);
    return value.get<double>() >= limits[0] && value.get<double>() <= limits[1];
}

Control described(const StudioContext& context, const ValueInfo& info, const Json& value,
                  const std::string& group) {
    Control control;
    control.id = info.path;
    control.group = group;
    control.label = labelOf(info);
    control.name = info.path.starts_with("colour.") ? control.label : nameOf(info);
    control.help = tr(info.help);
    control.kind = kindOf(info.kind);
    control.value = textOf(info, value);
    if (control.kind == ControlKind::colour && !value.is_string()) {
        const DisplayColour opaque{value[0].get<double>(), value[1].get<double>(),
                                   value[2].get<double>(), 1};
        control.value = hexFromColour(colourFromDisplay(opaque));
    }
    control.whole = info.kind == ValueKind::whole;
    control.logarithmic = info.logarithmic;
    if (info.low < info.high) {
        const std::array<double, 2> limits = studioLimits(info);
        control.least = limits[0], control.most = limits[1];
    }
    control.low = info.sliderLow, control.high = info.sliderHigh;
    if (const auto own = context.workspace.ranges.find(info.path);
        own != context.workspace.ranges.end())
        control.low = own->second[0], control.high = own->second[1];
    control.step = info.step > 0 ? info.step : (control.high - control.low) / kStepsOfSlider;
    for (const std::string& word : info.words) {
        control.options.push_back(word.empty() ? std::string(info.unsaid) : word);
        control.shown.push_back(tr(std::string_view(control.options.back())));
    }
    // Names of palettes are names.
    if (info.path == "colour.palette") control.shown = control.options;
    return control;
}

// Some numbers are chosen by the program until somebody sets them.
Json shownValue(const Scene& scene, const SceneProperty& property) {
    Json value = property.get(scene);
    if (property.path == "escape_radius" && value.is_string()) return automaticRadius(scene);
    if (property.path == "colour.palette" && value.is_object()) return scene.colour.palette;
    return value;
}

Json shownValue(const StudioContext& context, const SceneProperty& property) {
    const Workspace& workspace = context.workspace;
    return numberNamed(workspace.views[0], property.path)
               ? Json(sharedNumber(workspace, property.path))
               : shownValue(workspace.view(), property);
}

Control controlFrom(const StudioContext& context, const SceneProperty& property,
                    const std::string& group) {
    const Scene& scene = context.workspace.view();
    Control control = described(context, property, shownValue(context, property), group);
    if (control.kind != ControlKind::number) return control;
    const bool number = numberNamed(scene, property.path).has_value();
    control.moves = number && !control.whole;
    if (property.path == "slice.height") control.step = scene.slice.height / 10;
    if (property.path.starts_with("slice.center[")) control.step = scene.slice.height / 20;
    if (property.path == "escape_radius")
        control.home = automaticRadius(scene);
    else if (const Json home = defaultOf(scene, property); home.is_number())
        control.home = home.get<double>();
    if (property.path.starts_with("slice.") && property.path != "slice.height") {
        const SliceSpec there = homeOf(scene);
        const std::size_t k = property.path.back() == ']' ? property.path[13] - '0' : 0;
        if (property.path.starts_with("slice.center[") && k < there.centre.size())
            control.home = there.centre[k];
    }
    if (property.path == "slice.height") control.home = homeOf(scene).height;
    return control;
}

bool hasNoMeaning(const Scene& scene, const SceneProperty& property) {
    return property.path == "escape_radius" && !std::isfinite(automaticRadius(scene)) &&
           !scene.escapeRadius;
}

}  // namespace

namespace {

// A control over a property whose value is `now`, by `set` where another one is wanted.
template <class P>
ControlEntry entryOf(StudioContext* c, Control control, const P& property,
                     std::function<Json(const StudioContext&)> now,
                     std::function<Status(StudioContext&, const Json&)> set) {
    return {std::move(control), [c, property, now, set](const std::string& text) {
                const Json before = now(*c);
                const Json wanted = jsonOf(property, before, text);
                if (wanted.is_null() || !isAllowed(property, wanted)) return false;
                if (wanted == before) return true;
                const Status status = set(*c, wanted);
                c->report(status);
                return status.ok();
            }};
}

bool isSingle(const ValueInfo& info) {
    return info.kind != ValueKind::group && info.kind != ValueKind::other;
}

}  // namespace

void ControlList::value(const SceneProperty& property) {
    if (!isSingle(property) || hasNoMeaning(context_.workspace.view(), property)) return;
    entries.push_back(entryOf(
        &context_, controlFrom(context_, property, group_), property,
        [property](const StudioContext& c) { return shownValue(c, property); },
        [property](StudioContext& c, const Json& json) { return setValue(c, property, json); }));
}

void ControlList::value(const WorkspaceProperty& property) {
    if (!isSingle(property)) return;
    entries.push_back(entryOf(
        &context_, described(context_, property, property.get(context_.workspace), group_),
        property, [property](const StudioContext& c) { return property.get(c.workspace); },
        [property](StudioContext& c, const Json& json) { return setValue(c, property, json); }));
}

void ControlList::value(const StudioProperty& property) {
    Control control = described(context_, property, property.get(context_), group_);
    if (property.path == "language") {
        control.shown.clear();
        for (const Language& language : languages()) control.shown.push_back(language.name);
    }
    entries.push_back(entryOf(
        &context_, std::move(control), property,
        [property](const StudioContext& c) { return property.get(c); },
        [property](StudioContext& c, const Json& json) {
            c.host.wake();
            return property.set(c, json, property.path);
        }));
}

void ControlList::values(std::initializer_list<const char*> paths) {
    for (const char* path : paths) {
        const Scene& scene = context_.workspace.view();
        if (const auto property = propertyNamed(scene, path); property && property->path == path) {
            if (!property->shownWhen || property->shownWhen(scene)) value(*property);
        } else if (const auto own = propertyNamed(context_.workspace, path);
                   own && own->path == path) {
            value(*own);
        } else if (const StudioProperty* studio = studioPropertyNamed(path)) {
            value(*studio);
        }
    }
}

void ControlList::group(const std::string& path) {
    for (const SceneProperty& property : shownProperties(context_.workspace.view(), path))
        value(property);
}

std::optional<Control> controlOf(StudioContext& context, const std::string& path) {
    ControlList list(context);
    list.values({path.c_str()});
    if (list.entries.empty()) return std::nullopt;
    Control control = std::move(list.entries[0].control);
    const Access access = accessOf(context, control.id);
    if (access == Access::hidden) return std::nullopt;
    control.locked = access == Access::locked;
    return control;
}

std::vector<Control> controlsIn(StudioContext& context, const std::string& group) {
    ControlList list(context);
    list.group(group);
    std::vector<Control> controls;
    for (ControlEntry& entry : list.entries) {
        const Access access = accessOf(context, entry.control.id);
        if (access == Access::hidden) continue;
        entry.control.locked = access == Access::locked;
        controls.push_back(std::move(entry.control));
    }
    return controls;
}

}  // namespace versorium
