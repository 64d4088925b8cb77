// SPDX-License-Identifier: MIT
// The inspector: the map with its formula, its parameters, what is seen and how it is coloured.
#include <algorithm>
#include <cmath>

#include "ui/context.h"

namespace versorium {
namespace {

void help(std::string_view text) {
    if (!text.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_DelayNormal))
        ImGui::SetTooltip("%.*s", static_cast<int>(text.size()), text.data());
}

void heading(const char* text) {
    ImGui::Spacing();
    ImGui::TextDisabled("%s", text);
    ImGui::Separator();
}

// A choice of words; true when another one was taken.
bool choose(const char* label, std::string& value, const std::vector<std::string>& words,
            const char* empty = "") {
    bool changed = false;
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 6.5f);
    if (ImGui::BeginCombo(label, value.empty() ? empty : value.c_str())) {
        for (const std::string& word : words) {
            const bool now = word == value;
            if (ImGui::Selectable(word.empty() ? empty : word.c_str(), now) && !now) {
                value = word;
                changed = true;
            }
            if (now) ImGui::SetItemDefaultFocus();
        }
        ImGui::EndCombo();
    }
    return changed;
}

// The plane of a complex number, with the other components below it.
bool pad(const char* id, double& x, double& y, double low, double high) {
    const float side = std::min(ImGui::GetContentRegionAvail().x * 0.42f, 130.0f);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(id, {side, side});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{corner.x + side, corner.y + side};
    list.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_FrameBg), 6);
    const ImU32 line = ImGui::GetColorU32(ImGuiCol_Border);
    const auto across = [&](double value) {
        return static_cast<float>((value - low) / (high - low)) * side;
    };
    list.AddLine({corner.x + across(0), corner.y}, {corner.x + across(0), end.y}, line);
    list.AddLine({corner.x, end.y - across(0)}, {end.x, end.y - across(0)}, line);
    list.PushClipRect(corner, end, true);
    drawMark(list, {corner.x + across(x), end.y - across(y)}, 6, MarkShape::ring,
             ImGui::GetColorU32(ImGuiCol_CheckMark));
    list.PopClipRect();
    help("Drag the point: right is the real part, up is i");
    if (!ImGui::IsItemActive()) return false;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto value = [&](float part) {
        return low + (high - low) * std::clamp(part / side, 0.0f, 1.0f);
    };
    const double u = value(mouse.x - corner.x), v = value(end.y - mouse.y);
    const bool changed = u != x || v != y;
    x = u;
    y = v;
    return changed;
}

bool number(const char* label, double& value, double low, double high, bool whole = false) {
    const double step = whole ? 1 : (high - low) / 4000;
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 6.5f);
    // Beyond the range by typing: Ctrl and a click, or a double click.
    const bool changed =
        ImGui::DragScalar(label, ImGuiDataType_Double, &value, static_cast<float>(step), nullptr,
                          nullptr, whole ? "%.0f" : "%.6g");
    if (!std::isfinite(value)) value = 0;
    if (whole) value = std::round(value);
    return changed;
}

void animateButton(StudioContext& context, const std::string& name, double low, double high) {
    StudioContext::Animation& animation = context.animation;
    ImGui::SameLine();
    const bool mine = animation.running && animation.number == name;
    ImGui::PushID(name.c_str());
    if (ImGui::SmallButton(mine ? "■" : "▲")) {
        if (mine) {
            animation.running = false;
        } else {
            animation = {.number = name, .low = low, .high = high};
            const double now = sharedNumber(context.workspace, name);
            animation.phase = std::acos(std::clamp(1 - 2 * (now - low) / (high - low), -1.0, 1.0));
            animation.running = true;
        }
    }
    help(mine ? "Stop" : "Let this number run to and fro through its range");
    ImGui::PopID();
}

void parameters(StudioContext& context) {
    Workspace& workspace = context.workspace;
    const MapInfo& info = mapOf(workspace.views[0]).info;
    int component = 0;
    for (const ParameterInfo& parameter : info.parameters) {
        const int width = widthOf(parameter.kind);
        const std::string name(parameter.name);
        std::vector<double> value = workspace.views[0].parameters[name];
        bool changed = false;
        ImGui::PushID(name.c_str());
        if (width >= 2) {
            changed |= pad("pad", value[0], value[1], std::max(parameter.low, -2.0),
                           std::min(parameter.high, 2.0));
            ImGui::SameLine();
            ImGui::BeginGroup();
        }
        for (int k = 0; k < width; ++k) {
            const std::string part = parameterComponent(info, component + k);
            changed |= number(part.c_str(), value[static_cast<std::size_t>(k)], parameter.low,
                              parameter.high, parameter.kind == ParameterKind::whole);
            help(parameter.help);
            if (parameter.kind != ParameterKind::whole)
                animateButton(context, part, std::max(parameter.low, -2.0),
                              std::min(parameter.high, 2.0));
        }
        if (width == 1) ImGui::SameLine();
        if (ImGui::SmallButton(width == 1 ? "←" : "reset")) {
            value.assign(parameter.value.begin(), parameter.value.begin() + width);
            changed = true;
        }
        help("Back to the map's own value");
        if (width >= 2) ImGui::EndGroup();
        ImGui::PopID();
        if (changed) {
            setSharedParameter(workspace, name, value);
            context.touch();
        }
        component += width;
    }
}

// All numbers that an axis may stand for.
std::vector<std::string> axisNames(const Scene& scene) {
    const MapKernels& map = mapOf(scene);
    std::vector<std::string> names;
    for (int k = 0; k < map.dimension; ++k) names.push_back(stateComponent(map.info, k));
    for (int k = 0; k < map.parameters; ++k) names.push_back(parameterComponent(map.info, k));
    return names;
}

void sliceControls(StudioContext& context) {
    Scene& scene = context.workspace.view();
    const std::vector<std::string> names = axisNames(scene);
    const char* labels[] = {"axis →", "axis ↑"};
    for (std::size_t k = 0; k < 2 && k < scene.slice.axes.size(); ++k) {
        auto& terms = scene.slice.axes[k].terms;
        std::string name = terms.size() == 1 ? terms[0].first : "";
        if (choose(labels[k], name, names, "several")) {
            const std::size_t other = 1 - k;
            // The same number on both axes would be a line: the axes change places instead.
            if (scene.slice.axes.size() > 1 && scene.slice.axes[other].terms.size() == 1 &&
                scene.slice.axes[other].terms[0].first == name) {
                std::swap(scene.slice.axes[0], scene.slice.axes[1]);
                std::swap(scene.slice.centre[0], scene.slice.centre[1]);
            } else {
                terms = {{name, 1.0}};
                scene.slice.centre[k] = sharedNumber(context.workspace, name);
            }
            scene.slice.origin.clear();
            if (!showsParameters(scene)) scene.criticalStart.reset();
            context.touch();
        }
        help("Which number runs along this axis of the view");
    }
    for (std::size_t k = 0; k < 2 && k < scene.slice.centre.size(); ++k)
        if (number(k == 0 ? "centre →" : "centre ↑", scene.slice.centre[k], -2, 2)) {
            scene.slice.centreLow[k] = 0;
            context.touch();
        }
    double height = scene.slice.height;
    if (number("height", height, 0, 4) && height > 1e-13 && height < 1e6) {
        scene.slice.height = height;
        context.touch();
    }
    help("What the view shows from bottom to top");
    if (mapOf(scene).criticalPoints > 0 && showsParameters(scene)) {
        bool critical = scene.criticalStart.has_value();
        if (ImGui::Checkbox("start at the critical point", &critical)) {
            if (critical)
                scene.criticalStart = 0;
            else
                scene.criticalStart.reset();
            context.touch();
        }
        help(
            "A map of Julia sets: each point of this plane asks what becomes of the critical "
            "point");
    }
}

void colourControls(StudioContext& context) {
    Scene& scene = context.workspace.view();
    Colouring& colour = scene.colour;
    bool changed = choose("colour by", colour.rule, {"palette", "gradient", "versor", "phase"});
    if (colour.rule == "palette") {
        std::vector<std::string> fields;
        for (const FieldInfo& field : allFields())
            if (field.field != FieldName::versor) fields.emplace_back(field.name);
        if (choose("field", colour.field, fields)) {
            colour.range.clear();
            colour.scale.clear();
            changed = true;
        }
        help("What is measured along each orbit");
    }
    if (colour.rule == "palette" || colour.rule == "phase") {
        changed |= choose("palette", colour.palette, paletteNames());
        changed |= ImGui::Checkbox("reversed", &colour.reverse);
    }
    if (colour.rule == "palette") {
        changed |=
            choose("scale", colour.scale, {"", "linear", "log", "truncated_log", "sqrt", "cyclic"},
                   "the field's own");
        bool inside = colour.interior == "membership";
        if (ImGui::Checkbox("the set in its own colour", &inside)) {
            colour.interior = inside ? "membership" : "none";
            changed = true;
        }
    }
    if (colour.rule == "gradient") {
        const auto gradient = [&](const char* what, Gradient& range) {
            ImGui::PushID(what);
            const auto edit = [&](const char* label, DisplayColour& c) {
                float v[4] = {static_cast<float>(c.r), static_cast<float>(c.g),
                              static_cast<float>(c.b), static_cast<float>(c.a)};
                if (ImGui::ColorEdit4(label, v, ImGuiColorEditFlags_NoInputs)) {
                    c = {v[0], v[1], v[2], v[3]};
                    changed = true;
                }
            };
            edit("fast", range.start);
            ImGui::SameLine();
            edit("slow", range.finish);
            ImGui::SameLine();
            ImGui::TextUnformatted(what);
            double exponent = range.exponent;
            if (number("exponent", exponent, 0, 4) && exponent >= 0.01) {
                range.exponent = exponent;
                changed = true;
            }
            ImGui::PopID();
        };
        gradient("escaped", colour.escaped);
        gradient("attracted", colour.attracted);
        changed |= choose("smoothing", colour.smoothing, {"none", "ratio", "log-log"});
    }
    changed |= choose("outline", colour.outline, {"none", "membership", "solid"});
    if (changed) context.touch();
}

}  // namespace

void drawInspector(StudioContext& context) {
    Workspace& workspace = context.workspace;
    const MapInfo& info = mapOf(workspace.views[0]).info;
    heading("Map");
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##map", std::string(info.title).c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const MapKernels& map : catalogue())
            if (ImGui::Selectable(std::string(map.info.title).c_str(),
                                  map.info.name == info.name) &&
                map.info.name != info.name) {
                context.newMap(std::string(map.info.name));
                break;
            }
        ImGui::EndCombo();
    }
    const MapInfo& shown = mapOf(workspace.views[0]).info;
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(shown.formula.data(), shown.formula.data() + shown.formula.size());
    ImGui::PopTextWrapPos();
    help(shown.source);
    if (ImGui::Button("Presets and maps … (Ctrl K)", {-1, 0})) context.searchOpen = true;

    heading("Parameters");
    parameters(context);

    heading("Under the pointer");
    drawProbe(context);

    heading("Orbits");
    Scene& scene = workspace.view();
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 6.5f);
    int iterations = scene.iterations;
    if (ImGui::DragInt("iterations", &iterations, 1 + static_cast<float>(iterations) / 200, 1,
                       1000000, "N = %d", ImGuiSliderFlags_AlwaysClamp)) {
        scene.iterations = iterations;
        context.touch();
    }
    help("An orbit that stays within the escape radius for N steps is counted as captured");
    double radius = scene.escapeRadius.value_or(automaticRadius(scene));
    if (std::isfinite(radius) && number("escape radius", radius, 0, 100) && radius > 0) {
        scene.escapeRadius = radius;
        context.touch();
    }
    help("Beyond it an orbit has escaped");

    heading(workspace.views.size() > 1 ? "Slice of the marked view" : "Slice");
    sliceControls(context);
    heading("Colours");
    colourControls(context);
}

}  // namespace versorium
