// SPDX-License-Identifier: MIT
#pragma once
// The teacher's link that the studio was opened with (lesson/teacher_link.h).

#include <cstdint>

#include "lesson/teacher_link.h"
#include "workspace/workspace.h"

namespace versorium {

struct StudioContext;

// The state that the link's locks hold on to.
struct Permitted {
    Workspace workspace;
    std::uint64_t at = 0;  // the revision of it
};

// Whether anything is locked or hidden.
bool isRestricted(const StudioContext& context);
// Follows a link: its lesson or view, language, theme and locks. ErrorKind::data, and everything
// stays, where it cannot.
Status followTeacherLink(StudioContext& context, const TeacherLink& link);
// What is shown now is what locks hold on to.
void permit(StudioContext& context);

}  // namespace versorium
