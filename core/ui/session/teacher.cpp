// SPDX-License-Identifier: MIT
#include "ui/session/teacher.h"

#include "ui/session/context.h"

namespace versorium {

bool isRestricted(const StudioContext& context) {
    return context.teacher && context.teacher->restricts();
}

Status followTeacherLink(StudioContext& context, const TeacherLink& link) {
    for (const StudioTheme& theme : themes())
        if (theme.name == link.theme) {
            context.theme = static_cast<std::size_t>(&theme - themes().data());
            context.fontsChanged = true;
        }
    context.teacher.reset();
    // For this visit: what the learner chose is kept.
    if (!link.language.empty() && setLanguage(link.language)) context.fontsChanged = true;
    if (!link.lesson.empty()) {
        std::optional<std::size_t> step;
        if (link.step) step = static_cast<std::size_t>(*link.step);
        const Status status = openLesson(context, link.lesson, step);
        if (!status.ok()) return status;
        if (link.view) context.openStage(*link.view);
    } else if (link.view) {
        context.open(*link.view);
    }
    if (link.stays()) context.teacher = link;
    permit(context);
    return {};
}

void permit(StudioContext& context) {
    context.permitted.workspace = context.workspace;
    context.permitted.at = context.revision();
}

}  // namespace versorium
