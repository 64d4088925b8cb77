// SPDX-License-Identifier: MIT
#include "ui/controls/access.h"

#include <algorithm>

#include "maps/critical.h"
#include "ui/controls/controls.h"
#include "ui/session/context.h"
#include "ui/session/values.h"

namespace versorium {
namespace {

// What changes nothing of the state is nobody's to lock.
constexpr const char* kFree[] = {"theme",        "language",      "renderer", "export.width",
                                 "begin export", "cancel export", "marked",   "maximised",
                                 "lesson step",  "teacher reset"};

// Parts of the workspace that no control holds whole.
void takeWholes(const StudioContext& context, const Workspace& wanted, Workspace& now) {
    const auto open = [&](const char* id) { return accessOf(context, id) == Access::open; };
    if (open("pins")) now.pins = wanted.pins;
    if (open("circles")) now.circles = wanted.circles;
    for (std::size_t k = 0; k < std::min(now.views.size(), wanted.views.size()); ++k) {
        SliceSpec& slice = now.views[k].slice;
        const SliceSpec& other = wanted.views[k].slice;
        if (slice.axes != other.axes || slice.centre.size() != other.centre.size()) continue;
        for (std::size_t j = 0; j < slice.centre.size(); ++j)
            if (open(j == 0 ? "slice.center[0]" : "slice.center[1]")) {
                slice.centre[j] = other.centre[j];
                slice.centreLow[j] = other.centreLow[j];
            }
        if (open("slice.height")) slice.height = other.height;
    }
    if (wanted.views.size() == now.views.size()) now.focused = wanted.focused;
    now.maximised = wanted.maximised;
    now.plot = wanted.plot;
    now.ranges = wanted.ranges;
}

}  // namespace

Access accessOf(const StudioContext& context, const std::string& id) {
    if (!context.teacher) return Access::open;
    const TeacherLink& link = *context.teacher;
    const MapInfo& info = mapOf(context.workspace.views[0]).info;
    for (const auto& [name, access] : link.named)
        if (namesControl(info, name, id)) return access;
    if (std::any_of(std::begin(kFree), std::end(kFree), [&](const char* one) { return id == one; }))
        return Access::open;
    if (link.byStep && context.lessons.now)
        for (const std::string& name : context.lessons.now->session.step().controls)
            if (namesControl(info, name, id)) return Access::open;
    return link.rest;
}

void keepLocks(StudioContext& context) {
    if (!isRestricted(context) || context.permitted.at == context.revision()) return;
    const Workspace wanted = context.workspace;
    const std::vector<Control> after = controlsOf(context);
    context.edit([&](Workspace& now) {
        now = context.permitted.workspace;
        takeWholes(context, wanted, now);
    });
    std::vector<Control> before = controlsOf(context);
    for (const Control& control : after) {
        if (control.kind == ControlKind::command || accessOf(context, control.id) != Access::open)
            continue;
        const auto same = std::find_if(before.begin(), before.end(), [&](const Control& other) {
            return other.id == control.id;
        });
        if (same == before.end() || same->value == control.value) continue;
        setControl(context, control.id, control.value);
        before = controlsOf(context);
    }
    if (workspaceKey(context.workspace) != workspaceKey(wanted))
        context.say("The link that opened this page has locked that");
    permit(context);
}

}  // namespace versorium
