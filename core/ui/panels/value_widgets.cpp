// SPDX-License-Identifier: MIT
#include "ui/panels/value_widgets.h"
#include "ui/panels/panels.h"

#include <algorithm>
#include <cmath>

#include "ui/panels/number_field.h"
#include "ui/panels/special_widgets.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

// True where the control was set: the list of them is of yesterday then.
bool drawNumber(StudioContext& context, const Control& control, bool slider = true) {
    double value = std::strtod(control.value.c_str(), nullptr);
    const bool slides = control.low < control.high;
    const double step = control.step > 0 ? control.step : 0.01;
    const NumberLook look{.help = control.help,
                          .low = slides ? control.low : value - 40 * step,
                          .high = slides ? control.high : value + 40 * step,
                          .home = control.home,
                          .whole = control.whole,
                          .slider = slides && slider,
                          .animated = control.moves,
                          .logarithmic = control.logarithmic && control.low > 0};
    if (!numberField(context, control.id, control.label, value, look)) return false;
    value = std::clamp(value, control.least, control.most);
    return setControl(context, control.id, formatNumber(value));
}

bool drawChoice(StudioContext& context, const Control& control) {
    std::string value = control.value;
    labelled(control.label.c_str());
    const auto said = [&](const std::string& option) {
        const auto at = std::find(control.options.begin(), control.options.end(), option);
        const auto k = static_cast<std::size_t>(at - control.options.begin());
        return k < control.shown.size() ? control.shown[k].c_str() : option.c_str();
    };
    const bool open = ImGui::BeginCombo("##choice", said(value));
    if (!open) explainBy(control.help);
    if (!open) return false;
    for (const std::string& option : control.options)
        if (ImGui::Selectable(said(option), option == control.value)) value = option;
    ImGui::EndCombo();
    return value != control.value && setControl(context, control.id, value);
}

bool drawText(StudioContext& context, const Control& control) {
    static char typed[4096];
    std::snprintf(typed, sizeof typed, "%s", control.value.c_str());
    labelled(control.label.c_str());
    const bool enter =
        ImGui::InputText("##text", typed, sizeof typed, ImGuiInputTextFlags_EnterReturnsTrue);
    explainBy(control.help);
    return enter && setControl(context, control.id, typed);
}

bool drawColour(StudioContext& context, const Control& control) {
    const Expected<Colour> read = colourFromHex(control.value);
    if (!read) return false;
    const DisplayColour now = displayFromColour(*read);
    float parts[3] = {static_cast<float>(now.r), static_cast<float>(now.g),
                      static_cast<float>(now.b)};
    labelled(control.label.c_str());
    const bool moved = ImGui::ColorEdit3("##colour", parts, ImGuiColorEditFlags_NoInputs);
    explainBy(control.help);
    DisplayColour next = now;
    next.r = parts[0], next.g = parts[1], next.b = parts[2];
    return moved && setControl(context, control.id, hexFromColour(colourFromDisplay(next)));
}

// A registered widget, or that of the value's kind.
bool drawAny(StudioContext& context, const Control& control) {
    ImGui::PushID(control.id.c_str());
    ImGui::BeginDisabled(control.locked);
    const SpecialWidget special = specialWidget(control.id);
    const bool set = special ? special(context, control) : drawControl(context, control);
    ImGui::EndDisabled();
    ImGui::PopID();
    return set;
}

}  // namespace

bool drawControl(StudioContext& context, const Control& control) {
    switch (control.kind) {
        case ControlKind::number:
            return drawNumber(context, control);
        case ControlKind::choice:
            return drawChoice(context, control);
        case ControlKind::text:
            return drawText(context, control);
        case ControlKind::colour:
            return drawColour(context, control);
        case ControlKind::toggle: {
            bool on = control.value == "on";
            const bool set = ImGui::Checkbox(control.label.c_str(), &on);
            explainBy(control.help);
            return set && setControl(context, control.id, on ? "on" : "off");
        }
        case ControlKind::command:
            break;
    }
    const bool pressed = ImGui::Button(control.label.c_str());
    explainBy(control.help);
    return pressed && setControl(context, control.id, "");
}

bool drawValue(StudioContext& context, const std::string& path) {
    std::optional<Control> control = controlOf(context, path);
    if (!control) return false;
    control->label = control->name;
    return drawAny(context, *control);
}

bool drawComponent(StudioContext& context, const std::string& path) {
    std::optional<Control> control = controlOf(context, path);
    if (!control) return false;
    control->label = path.substr(path.rfind('.') + 1);
    ImGui::BeginDisabled(control->locked);
    const bool set = drawNumber(context, *control, false);
    ImGui::EndDisabled();
    return set;
}

void drawValues(StudioContext& context, std::initializer_list<const char*> paths) {
    for (const char* path : paths) drawValue(context, path);
}

void drawGroup(StudioContext& context, const std::string& group) {
    for (Control& control : controlsIn(context, group)) {
        control.label = control.name;
        if (drawAny(context, control)) return;  // the list is of before
    }
}

}  // namespace versorium
