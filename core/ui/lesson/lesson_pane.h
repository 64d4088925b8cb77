// SPDX-License-Identifier: MIT
#pragma once
// The lesson that is open (session/lessons.h) as a pane of the window, and for a page that draws it
// by itself.

#include <string>

namespace versorium {

struct StudioContext;

// The pane, in what ImGui calls the present window.
void drawLessonPane(StudioContext& context);
// The same for a page, as JSON, and what its buttons do; false where there is no such thing to do.
std::string lessonText(StudioContext& context);
bool lessonDo(StudioContext& context, const std::string& action, const std::string& value);

}  // namespace versorium
