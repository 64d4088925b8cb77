// SPDX-License-Identifier: MIT
#pragma once
// What a teacher's link lets the learner change (lesson/teacher_link.h). Whatever hand, key or file
// changes the workspace: only what is open stays changed.

#include <string>

#include "lesson/teacher_link.h"
#include "maps/map_info.h"

namespace versorium {

struct StudioContext;

// Whether a name of a lesson or a link means this control: its own id, the parameter that it is a
// number of ("c" of "c.re"), the list that it belongs to ("roots" of "roots[1].re"), or "point" for
// the numbers of the starting point.
bool namesControl(const MapInfo& info, const std::string& name, const std::string& id);

Access accessOf(const StudioContext& context, const std::string& id);
// Whether anything is locked or hidden.
bool isRestricted(const StudioContext& context);

// Follows a link: its lesson or view, language, theme and locks. ErrorKind::data, and everything
// stays, where it cannot.
Status followTeacherLink(StudioContext& context, const TeacherLink& link);
// What is shown now is what locks hold on to.
void permit(StudioContext& context);
// Takes back what was changed although it is locked.
void keepLocks(StudioContext& context);

// Draws the controls that the lesson's step or the link leaves open, and those that are locked;
// false where there is no such choice and the whole inspector is to be drawn.
bool drawOpenControls(StudioContext& context);

// The dialog that makes a teacher's link.
struct TeacherDialog {
    bool open = false;
    bool withLesson = true;
    TeacherLink link;
    std::string made;  // the last address
};
void openTeacherDialog(StudioContext& context);
void drawTeacherDialog(StudioContext& context);
// The address of the link as it is set up, or the snippet for a web page.
Expected<std::string> teacherAddress(StudioContext& context);
void copyTeacherLink(StudioContext& context, bool asFrame);

}  // namespace versorium
