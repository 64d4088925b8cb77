// SPDX-License-Identifier: MIT
#pragma once
// What a teacher's link lets the learner change (lesson/teacher_link.h). Whatever hand, key or file
// changes the workspace: only what is open stays changed.

#include <string>

#include "lesson/teacher_link.h"

namespace versorium {

struct StudioContext;

Access accessOf(const StudioContext& context, const std::string& id);
// Takes back what was changed although it is locked.
void keepLocks(StudioContext& context);

}  // namespace versorium
