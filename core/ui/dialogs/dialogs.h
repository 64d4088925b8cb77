// SPDX-License-Identifier: MIT
#pragma once
// Dialogs: what stands over the views and takes the keys while it is open. They know widgets, the
// session and the tables of controls and commands; no panel, no view.

#include <string>

#include "lesson/teacher_link.h"
#include "ui/host/host.h"

namespace versorium {

struct StudioContext;

// What the dialogs remember (session/panel_states.h).
struct FileList {  // the studio's own, where the host has none
    Folder folder;
    std::string typed, problem;
    int chosen = 0;
};
struct GalleryPlace {
    int at = 0;  // the entry that the keys have come to: presets first, then recent ones
};
struct TeacherDialog {
    bool withLesson = true;
    TeacherLink link;
    std::string made;  // the last address
};

// All that are open.
void drawDialogs(StudioContext& context);

void drawFind(StudioContext& context);
void drawKeys(StudioContext& context);
void drawGallery(StudioContext& context);
void drawCandidates(StudioContext& context);
void drawOpenFile(StudioContext& context);
void drawExport(StudioContext& context);
void drawTeacherDialog(StudioContext& context);

// The address of the teacher's link as it is set up, or the snippet for a web page.
Expected<std::string> teacherAddress(StudioContext& context);
void copyTeacherLink(StudioContext& context, bool asFrame);

}  // namespace versorium
