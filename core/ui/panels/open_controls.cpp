// SPDX-License-Identifier: MIT
// The controls that a lesson's step or a teacher's link leaves open, in place of the inspector.
#include <algorithm>
#include <cmath>

#include "ui/controls/access.h"
#include "ui/controls/controls.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

// True where the control was set: the list of them is of yesterday then.
bool drawNumber(StudioContext& context, const Control& control) {
    double value = std::strtod(control.value.c_str(), nullptr);
    const bool slides = control.low < control.high;
    const NumberLook look{.help = control.label,
                          .low = slides ? control.low : value - 40 * control.step,
                          .high = slides ? control.high : value + 40 * control.step,
                          .whole = control.step >= 1,
                          .slider = slides,
                          .animated = control.id == control.label && control.step < 1};
    return numberField(context, control.id, control.label, value, look) &&
           setControl(context, control.id, formatNumber(value));
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
    if (!open) explain("open control");
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
    explain("open control");
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
    explain("open control");
    DisplayColour next = now;
    next.r = parts[0], next.g = parts[1], next.b = parts[2];
    return moved && setControl(context, control.id, hexFromColour(colourFromDisplay(next)));
}

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
            explain("open control");
            return set && setControl(context, control.id, on ? "on" : "off");
        }
        case ControlKind::command:
            break;
    }
    const bool pressed = ImGui::Button(control.label.c_str());
    explain("open control");
    return pressed && setControl(context, control.id, "");
}

}  // namespace

bool drawOpenControls(StudioContext& context) {
    const bool restricted = isRestricted(context) && context.teacher->rest != Access::open;
    if (!restricted && !stepNamesControls(context)) return false;
    const MapInfo& info = mapOf(context.workspace.views[0]).info;
    heading(std::string(info.title).c_str());
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("%s", std::string(info.formula).c_str());
    ImGui::PopTextWrapPos();
    if (!context.lessons.now && context.teacher && context.teacher->view) {
        if (ImGui::Button(tr("Reset"))) resetStep(context);
        explain("reset step");
    }
    std::string group;
    for (const Control& control : controlsOf(context)) {
        const bool shown = restricted ? control.kind != ControlKind::command || !control.locked
                                      : isOpenInStep(context, control.id);
        if (!shown) continue;
        if (control.group != group) heading((group = control.group).c_str());
        ImGui::PushID(control.id.c_str());
        ImGui::BeginDisabled(control.locked);
        const bool set = drawControl(context, control);
        ImGui::EndDisabled();
        ImGui::PopID();
        if (set) break;
    }
    heading("Under the pointer");
    drawProbe(context);
    return true;
}

}  // namespace versorium
