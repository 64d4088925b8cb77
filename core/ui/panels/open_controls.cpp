// SPDX-License-Identifier: MIT
// The controls that a lesson's step or a teacher's link leaves open, in place of the inspector.
#include "ui/controls/access.h"
#include "ui/controls/controls.h"
#include "ui/panels/panels.h"
#include "ui/panels/value_widgets.h"
#include "ui/session/context.h"
#include "ui/views/view.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
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
